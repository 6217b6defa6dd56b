#include "chart.hpp"

#include <array>
#include <cmath>

namespace pictures {
namespace {

std::string power_of_ten(int exponent) {
  static constexpr std::array<const char*, 10> raised{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) text += raised[std::size_t(digit - '0')];
  return text;
}

}  // namespace

double Axis::along(double value) const {
  return logarithmic ? std::log(value / from) / std::log(to / from) : (value - from) / (to - from);
}

Axis decades(std::string label, int first, int last, int every) {
  Axis axis{std::move(label), std::pow(10.0, first), std::pow(10.0, last), true, {}};
  for (int n = first; n <= last; ++n) {
    axis.ticks.emplace_back(std::pow(10.0, n), (n - first) % every == 0 ? power_of_ten(n) : "");
  }
  return axis;
}

Axis steps(std::string label, double from, double to, double step, int decimals) {
  Axis axis{std::move(label), from, to, false, {}};
  const int count = static_cast<int>(std::lround((to - from) / step));
  for (int n = 0; n <= count; ++n)
    axis.ticks.emplace_back(from + n * step, decimal(from + n * step, decimals));
  return axis;
}

Axis round_steps(std::string label, double least, double most) {
  constexpr double count = 8.0, almost = 1e-9;
  const double size = (most - least) / count, decade = std::floor(std::log10(size)),
               unit = std::pow(10.0, decade);
  double step = 10.0 * unit;
  for (const double times : {5.0, 2.0, 1.0})
    if (times * unit >= size * (1.0 - almost)) step = times * unit;
  const int decimals =
      step >= 1.0 ? 0 : static_cast<int>(std::lround(-std::floor(std::log10(step) + almost)));
  return steps(std::move(label), step * std::floor(least / step + almost),
               step * std::ceil(most / step - almost), step, decimals);
}

Chart::Chart(Svg& svg, const Point& upper_left, const Point& lower_right, std::string_view title, Axis x,
             Axis y)
    : svg_(svg), upper_left_(upper_left), lower_right_(lower_right), x_(std::move(x)), y_(std::move(y)) {
  const auto& [left, top] = upper_left_;
  const auto& [right, bottom] = lower_right_;
  const Stroke grid{colour::pale, 1.0}, frame{colour::grey, 1.0};
  const Font number{colour::ink, 12.0, "middle"}, beside{colour::ink, 12.0, "end"};
  for (const auto& [value, words] : x_.ticks) {
    const double x_pixel = left + (right - left) * x_.along(value);
    svg_.line({{x_pixel, top}, {x_pixel, bottom}}, grid);
    if (!words.empty()) svg_.text({x_pixel, bottom + 17}, words, number);
  }
  for (const auto& [value, words] : y_.ticks) {
    const double y_pixel = bottom - (bottom - top) * y_.along(value);
    svg_.line({{left, y_pixel}, {right, y_pixel}}, grid);
    if (!words.empty()) svg_.text({left - 7, y_pixel + 4}, words, beside);
  }
  svg_.line({{left, top}, {right, top}, {right, bottom}, {left, bottom}, {left, top}}, frame);
  svg_.text({(left + right) / 2, top - 10}, title, {colour::ink, 13.0, "middle", true});
  svg_.text({(left + right) / 2, bottom + 38}, x_.label, {colour::ink, 13.0, "middle"});
  svg_.text({left - 46, (top + bottom) / 2}, y_.label, {colour::ink, 13.0, "middle", false, true});
}

Point Chart::at(const Point& numbers) const {
  return {upper_left_.x + (lower_right_.x - upper_left_.x) * x_.along(numbers.x),
          lower_right_.y - (lower_right_.y - upper_left_.y) * y_.along(numbers.y)};
}

void Chart::curve(const std::vector<Point>& numbers, const Stroke& stroke, bool dots) {
  std::vector<Point> pixels;
  for (const Point& p : numbers) pixels.push_back(at(p));
  svg_.line(pixels, stroke);
  if (!dots) return;
  for (const Point& p : pixels) svg_.disc(p, 2.5, stroke.colour);
}

void Chart::label(const Point& numbers, std::string_view words, const Font& font, const Point& moved) {
  const Point p = at(numbers);
  svg_.text({p.x + moved.x, p.y + moved.y}, words, font);
}

}  // namespace pictures
