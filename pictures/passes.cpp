// The Space Station over a day: its ground track, a pass over a place, and the Sun.
#include <cmath>
#include <vectrix/space.hpp>

#include "chart.hpp"
#include "pictures.hpp"

namespace pictures {
namespace {

using namespace vectrix;
using earth::Itrf;

struct Place : east_north_up_frame {};
struct Station : moving_frame {};

Quantity<si::angle> degrees(double angle) {
  return convert<si::angle>(angle * si::degree);
}
Quantity<si::time> minutes(double time) {
  return 60.0 * time * si::second;
}

constexpr double longest = 270.0;  // min, three revolutions
constexpr double lowest = 10.0;    // deg, of a pass

// Draws the curve in pieces, where the numbers that follow are near each other.
void draw(Chart& chart, const std::vector<Point>& points, const Stroke& stroke, double longest_step) {
  std::vector<Point> piece;
  for (const Point& p : points) {
    if (!piece.empty() && std::abs(p.x - piece.back().x) > longest_step) {
      chart.curve(piece, stroke, false);
      piece.clear();
    }
    piece.push_back(p);
  }
  chart.curve(piece, stroke, false);
}

}  // namespace

std::string passes() {
  const auto set =
      TwoLineElements::parse("1 25544U 98067A   08264.51782528 -.00002182  00000-0 -11606-4 0  2927",
                             "2 25544  51.6416 247.4627 0006703 130.5360 325.0288 15.72125391563537");
  const Sgp4<Station> orbit(set, at_most(convert<si::time>(72.0 * si::hour)));
  EarthOrientationParameters observed{};  // IERS, 20 September 2008; the pole is left out: 10 m
  observed.ut1_minus_tai = (-0.4810 - 33.0) * si::second;
  const Geodetic place{GeodeticLatitude(degrees(48.08)), degrees(11.28), 600.0 * si::metre};
  const auto graph =
      frame_graph(edge([=](const Epoch& t) { return coincident(teme_from_itrf(t, observed)); }),
                  edge([=](const Epoch& t) { return coincident(earth_rotation(t, observed)); }), edge(orbit),
                  rigid_edge(east_north_up(from<Place>, place)));
  const auto look = [&](const Epoch& t) {
    return look_angles(graph.at(t).position(of<Station>, relative_to<Place>, in<Place>));
  };
  const auto above = [&](const Epoch& t) { return look(t).elevation - degrees(lowest); };
  const auto day = from_until(set.epoch(), minutes(1440.0));
  const auto pass = intervals(day, minutes(1.0), above).at(1);
  const auto start = pass.start() - minutes(0.5 * longest);
  const auto shown = from_until(start, minutes(longest));
  const Ephemeris<sky::Sun> sun(day);

  std::vector<Point> track, seen_track, sky, light, dark;
  for (const Epoch& t : every(minutes(0.25), shown)) {
    const auto now = graph.at(t);
    const auto r_itrf = now.position(of<Station>, relative_to<Itrf>, in<Itrf>);
    const Geodetic below = wgs84::geodetic(r_itrf);
    const Point at{below.longitude.in(si::degree), below.latitude.angle.in(si::degree)};
    track.push_back(at);
    if (look(t).elevation > degrees(0.0)) seen_track.push_back(at);
  }
  for (const Epoch& t : every(minutes(2.0), day)) {
    const auto now = graph.at(t);
    const auto r_itrf = now.position(of<Station>, relative_to<Itrf>, in<Itrf>);
    const auto to_sun = sun.line_of_sight(now, seen_from<Station>, apparent, in<Itrf>);
    const Point at{(t - day.start()).value() / 3600.0,
                   angle_between(to_sun.vector(), r_itrf.vector()).in(si::degree)};
    light.push_back(at);
    if (wgs84::visible_sun(to_sun, -r_itrf) < 0.5) dark.push_back(at);
  }
  const auto margin = 20.0 * si::second;
  const auto near_pass = from_until(pass.start() - margin, pass.end() + margin);
  for (const Epoch& t : every(5.0 * si::second, near_pass)) {
    sky.push_back({(t - pass.start()).value(), look(t).elevation.in(si::degree)});
  }

  Svg svg(960, 640, "The Space Station: ground track, a pass, and the Sun");
  Chart ground(svg, {78, 40}, {932, 300}, "Ground track of three revolutions",
               steps("longitude, deg east", -180, 180, 30, 0), steps("latitude, deg north", -60, 60, 20, 0));
  constexpr double date_line = 180.0;
  draw(ground, track, {colour::blue}, date_line);
  draw(ground, seen_track, {colour::orange, 3.5}, 20.0);
  ground.curve({{place.longitude.in(si::degree), place.latitude.angle.in(si::degree)}}, {colour::ink});
  ground.label({place.longitude.in(si::degree), place.latitude.angle.in(si::degree)}, "place",
               {colour::ink, 12.0}, {-4, -9});

  Chart elevation(svg, {78, 390}, {468, 580}, "The pass of " + pass.start().utc(0) + " UTC",
                  steps("seconds since it rose above 10 deg", -50, 400, 50, 0),
                  steps("elevation, deg", 0, 90, 15, 0));
  elevation.curve(sky, {colour::orange}, false);
  elevation.curve({{-50.0, lowest}, {400.0, lowest}}, {colour::grey, 1.0, "4 4"}, false);

  Chart sunlight(svg, {552, 390}, {932, 580}, "The Sun from the zenith", steps("time, h", 0, 24, 3, 0),
                 steps("angle, deg", 0, 180, 30, 0));
  sunlight.curve(light, {colour::orange}, false);
  draw(sunlight, dark, {colour::ink, 3.0}, 0.1);
  sunlight.label({0.0, 0.0}, "black: hidden by the Earth", {colour::ink, 12.0}, {12, -10});
  return svg.text();
}

}  // namespace pictures
