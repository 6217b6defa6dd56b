#pragma once

#include <string>

#include "figures.hpp"
#include "report/text.hpp"

namespace vectrix::cli {

/// Pixels with one decimal.
inline std::string pixel(double x) {
  return with_decimals(x, 1);
}
/// The kinds are classes of the style of the page, which has the colours.
inline std::string svg_line(double x1, double y1, double x2, double y2, const std::string& kind) {
  return element(
      "line", {{"class", kind}, {"x1", pixel(x1)}, {"y1", pixel(y1)}, {"x2", pixel(x2)}, {"y2", pixel(y2)}},
      "");
}
inline std::string svg_text(double x, double y, const std::string& kind, const std::string& words) {
  return element("text", {{"class", kind}, {"x", pixel(x)}, {"y", pixel(y)}}, escaped(words));
}
inline std::string svg_path(const char* shape, const std::string& points, const std::string& kind) {
  return element(shape, {{"class", kind}, {"points", points}}, "");
}
/// A line; of a single point a dot, as its ends are round.
inline std::string svg_polyline(const std::string& points, const std::string& kind) {
  const bool is_point = points.find(' ') == std::string::npos;
  return svg_path("polyline", is_point ? points + " " + points : points, kind);
}
/// One more point of a polyline or polygon.
inline void add_point(std::string& points, double x, double y) {
  points += (points.empty() ? "" : " ") + pixel(x) + "," + pixel(y);
}
/// A drawing that is as wide as the page lets it be.
inline std::string svg(const std::string& kind, double width, double height, const std::string& title,
                       const std::string& inside) {
  return element("svg",
                 {{"class", kind},
                  {"role", "img"},
                  {"viewBox", "0 0 " + with_decimals(width, 0) + " " + with_decimals(height, 0)}},
                 element("title", escaped(title)) + inside);
}

}  // namespace vectrix::cli
