#include "report/plot.hpp"

#include <algorithm>
#include <cmath>

#include "report/axis.hpp"
#include "report/svg.hpp"
#include "report/thinning.hpp"

namespace vectrix::cli {
namespace {

constexpr double plot_width = 720.0, plot_height = 220.0;
constexpr double plot_left = 72.0, plot_right = 706.0, plot_top = 10.0, plot_bottom = 178.0;

// Of all curves and limits, with a margin.
DrawnAxis value_axis(const Report::Plot& plot) {
  double low = HUGE_VAL, high = -HUGE_VAL;
  const auto include = [&](double x) {
    low = std::fmin(low, x);
    high = std::fmax(high, x);
  };
  for (const auto& curve : plot.curves) std::for_each(curve.values.begin(), curve.values.end(), include);
  for (const auto& limit : plot.limits) include(limit.value);
  if (low > high) low = high = 0.0;  // gaps only
  constexpr double margin = 0.05, least = 1e-10;
  const double pad = std::max({margin * (high - low), least * std::abs(high), high == low ? 1e-3 : 0.0});
  return {low - pad, high + pad, plot_bottom, plot_top};
}

std::string polylines(const std::vector<double>& seconds, const Report::Curve& curve, const DrawnAxis& x,
                      const DrawnAxis& y, const TimeAxis& time, std::size_t place) {
  constexpr auto two_for_a_pixel = static_cast<std::size_t>(2.0 * (plot_right - plot_left));
  std::string text, points;
  const auto finish = [&] {
    if (!points.empty()) text += svg_polyline(points, "curve " + curve_class(place));
    points.clear();
  };
  for (const std::size_t i : kept_samples({&curve, 1}, two_for_a_pixel)) {
    if (std::isnan(curve.values[i])) {
      finish();
      continue;
    }
    add_point(points, x.at(time.in_unit(seconds[i])), y.at(curve.values[i]));
  }
  finish();
  return text;
}

std::string limit_lines(std::vector<Report::Limit> limits, const DrawnAxis& y) {
  std::sort(limits.begin(), limits.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
  std::vector<double> lines;
  for (const auto& limit : limits) lines.push_back(y.at(limit.value));
  const auto places = text_places(lines, plot_top);
  std::string text;
  for (std::size_t i = 0; i < limits.size(); ++i)
    text += svg_line(plot_left, lines[i], plot_right, lines[i], "limit") +
            svg_text(plot_right - 4.0, places[i], "limit side", limits[i].name);
  return text;
}

}  // namespace

std::string heading_of(const Report::Plot& plot) {
  return plot.title + (plot.axes.empty() ? "" : ", in the axes of " + plot.axes) +
         (plot.unit.empty() ? "" : ", " + plot.unit);
}

std::string curve_class(std::size_t place) {
  constexpr std::size_t colours = 8;
  return "c" + detail::text(place % colours);
}

std::string plot_svg(const Report::Plot& plot, const TimeAxis& time, const std::string& start) {
  const double first = time.in_unit(time.first), last = time.in_unit(time.last);
  const DrawnAxis x{first, last > first ? last : first + 1.0, plot_left, plot_right}, y = value_axis(plot);
  std::string text;
  const auto along = ticks(x.from, x.to, 9), up = ticks(y.from, y.to, 6);
  for (const double value : along.values) {
    text += svg_line(x.at(value), plot_top, x.at(value), plot_bottom, "grid");
    text += svg_text(x.at(value), plot_bottom + 16.0, "tick", tick_text(value, along.decimals));
  }
  for (const double value : up.values) {
    text += svg_line(plot_left, y.at(value), plot_right, y.at(value), "grid");
    text += svg_text(plot_left - 8.0, y.at(value) + 4.0, "tick side", tick_text(value, up.decimals));
  }
  text += svg_text(0.5 * (plot_left + plot_right), plot_bottom + 34.0, "tick", time.unit + " since " + start);
  for (std::size_t i = 0; i < plot.curves.size(); ++i)
    text += polylines(plot.seconds, plot.curves[i], x, y, time, i);
  text += limit_lines(plot.limits, y);
  return svg("still", plot_width, plot_height, heading_of(plot), text);
}

}  // namespace vectrix::cli
