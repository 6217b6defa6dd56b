#include <cmath>

#include "report/axis.hpp"
#include "report/scene.hpp"
#include "report/svg.hpp"
#include "report/thinning.hpp"

namespace vectrix::cli {
namespace {

constexpr double track_width = 480.0, track_height = 252.0;
constexpr DrawnAxis longitudes{-180.0, 180.0, 44.0, 456.0}, latitudes{-90.0, 90.0, 214.0, 8.0};

std::string degrees_of(int value, char positive, char negative) {
  if (value == 0) return "0";
  return detail::text(std::abs(value)) + "\u00b0" + (value > 0 ? positive : negative);
}

std::string graticule() {
  std::string text;
  for (int value = -180; value <= 180; value += 60) {
    const double x = longitudes.at(value);
    text += svg_line(x, latitudes.high, x, latitudes.low, "grid");
    text += svg_text(x, latitudes.low + 15.0, "tick", degrees_of(value, 'E', 'W'));
  }
  for (int value = -90; value <= 90; value += 30) {
    const double y = latitudes.at(value);
    text += svg_line(longitudes.low, y, longitudes.high, y, "grid");
    if (std::abs(value) < 90)
      text += svg_text(longitudes.low - 6.0, y + 4.0, "tick side", degrees_of(value, 'N', 'S'));
  }
  return text + svg_text(0.5 * (longitudes.low + longitudes.high), latitudes.low + 32.0, "tick",
                         "longitude; geodetic latitude");
}

}  // namespace

std::string ground_track_svg(const std::vector<Eigen::Vector2d>& track) {
  std::string text = graticule(), points;
  const auto finish = [&] {
    if (!points.empty()) text += svg_path("polyline", points, "curve c0");
    points.clear();
  };
  constexpr std::size_t most_points = 3000;
  constexpr double half_turn = 180.0;
  double before = 0.0;
  std::vector<bool> are_gaps;
  for (const auto& place : track) are_gaps.push_back(!place.allFinite());
  for (const std::size_t i : even_samples(are_gaps, most_points)) {
    const double longitude = track[i].y();
    if (!track[i].allFinite() || std::abs(longitude - before) > half_turn) finish();  // over the date line
    if (track[i].allFinite()) add_point(points, longitudes.at(longitude), latitudes.at(track[i].x()));
    before = longitude;
  }
  finish();
  // The script moves it with the time, from the edges of the map. Where there is no place it is out of sight.
  const bool is_there = track.front().allFinite();
  text += element("circle",
                  {{"class", "place"},
                   {"cx", pixel(is_there ? longitudes.at(track.front().y()) : -track_width)},
                   {"cy", pixel(is_there ? latitudes.at(track.front().x()) : -track_width)},
                   {"r", "5"},
                   {"data-edges", pixel(longitudes.low) + " " + pixel(longitudes.high) + " " +
                                      pixel(latitudes.low) + " " + pixel(latitudes.high)}},
                  "");
  return svg("track", track_width, track_height, "Ground track", text);
}

}  // namespace vectrix::cli
