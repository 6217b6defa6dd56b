#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace pictures {

/// A position in a picture, in pixels from its upper left corner; or a pair of numbers to be drawn.
struct Point {
  double x, y;
};

/// Line colours for the light background that every picture has, so that it is readable on light and dark
/// pages.
namespace colour {
inline constexpr std::string_view ink = "#222222";
inline constexpr std::string_view grey = "#8a8a8a";
inline constexpr std::string_view pale = "#dddddd";
inline constexpr std::string_view blue = "#0072b2";
inline constexpr std::string_view orange = "#d55e00";
inline constexpr std::string_view green = "#007a5a";
inline constexpr std::string_view purple = "#a3478c";
inline constexpr std::string_view brown = "#8c6d1f";
}  // namespace colour

struct Stroke {
  std::string_view colour = colour::ink;
  double width = 2.0;
  std::string_view dashes = "";
};

struct Font {
  std::string_view colour = colour::ink;
  double size = 13.0;
  std::string_view anchor = "start";  // or middle, end
  bool bold = false;
  bool upwards = false;
};

/// A picture in SVG. Coordinates are rounded to a tenth of a pixel, so that the same program writes the same
/// file.
class Svg {
 public:
  Svg(double width, double height, std::string_view title);

  void line(const std::vector<Point>& points, const Stroke& stroke);
  void disc(const Point& centre, double radius, std::string_view fill, const Stroke& rim = {"none", 0.0});
  void text(const Point& at, std::string_view words, const Font& font = {});

  std::string text() const { return text_ + "</svg>\n"; }

 private:
  std::string text_;
};

/// x with the given number of decimals, without a minus sign before zero.
std::string decimal(double x, int decimals);

}  // namespace pictures
