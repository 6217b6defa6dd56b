#include "svg.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace pictures {

std::string decimal(double x, int decimals) {
  const double unit = std::pow(10.0, -decimals);
  std::array<char, 64> digits{};
  std::snprintf(digits.data(), digits.size(), "%.*f", decimals, std::abs(x) < unit / 2 ? 0.0 : x);
  return digits.data();
}

namespace {

std::string place(double x) {
  return decimal(x, 1);
}
std::string attribute(std::string_view name, std::string_view value) {
  return " " + std::string(name) + "=\"" + std::string(value) + "\"";
}
std::string escaped(std::string_view words) {
  std::string result;
  for (const char c : words) {
    if (c == '<') {
      result += "&lt;";
    } else if (c == '&') {
      result += "&amp;";
    } else {
      result += c;
    }
  }
  return result;
}

}  // namespace

Svg::Svg(double width, double height, std::string_view title) {
  const std::string w = decimal(width, 0), h = decimal(height, 0);
  text_ = "<svg xmlns=\"http://www.w3.org/2000/svg\"" + attribute("viewBox", "0 0 " + w + " " + h) +
          attribute("width", w) + attribute("height", h) +
          " font-family=\"Helvetica, Arial, sans-serif\" fill=\"none\">\n<title>" + escaped(title) +
          "</title>\n<rect" + attribute("width", w) + attribute("height", h) +
          " rx=\"8\" fill=\"#fdfdfb\"/>\n";
}

void Svg::line(const std::vector<Point>& points, const Stroke& stroke) {
  text_ += "<polyline" + attribute("stroke", stroke.colour) + attribute("stroke-width", place(stroke.width)) +
           (stroke.dashes.empty() ? "" : attribute("stroke-dasharray", stroke.dashes)) +
           " stroke-linejoin=\"round\" points=\"";
  const char* between = "";
  for (const Point& p : points) {
    text_ += between + place(p.x) + "," + place(p.y);
    between = " ";
  }
  text_ += "\"/>\n";
}

void Svg::disc(const Point& centre, double radius, std::string_view fill, const Stroke& rim) {
  text_ += "<circle" + attribute("cx", place(centre.x)) + attribute("cy", place(centre.y)) +
           attribute("r", place(radius)) + attribute("fill", fill) + attribute("stroke", rim.colour) +
           attribute("stroke-width", place(rim.width)) + "/>\n";
}

void Svg::text(const Point& at, std::string_view words, const Font& font) {
  const std::string x = place(at.x), y = place(at.y);
  text_ += "<text" + attribute("x", x) + attribute("y", y) + attribute("fill", font.colour) +
           attribute("font-size", place(font.size)) + attribute("text-anchor", font.anchor) +
           (font.bold ? attribute("font-weight", "bold") : "") +
           (font.upwards ? attribute("transform", "rotate(-90 " + x + " " + y + ")") : "") + ">" +
           escaped(words) + "</text>\n";
}

}  // namespace pictures
