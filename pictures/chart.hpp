#pragma once

#include <utility>

#include "svg.hpp"

namespace pictures {

/// An axis: its label with the unit, its first and last value, and the numbers written beside it.
struct Axis {
  std::string label;
  double from, to;
  bool logarithmic;
  std::vector<std::pair<double, std::string>> ticks;

  /// From 0 at the start of the axis to 1 at its end.
  double along(double value) const;
};

/// Powers of ten from 10^first to 10^last, each `every`-th with its number.
Axis decades(std::string label, int first, int last, int every = 1);
/// Multiples of the step.
Axis steps(std::string label, double from, double to, double step, int decimals);
/// Some eight steps of 1, 2 or 5 times a power of ten, from the multiple before `least` to that after `most`.
Axis round_steps(std::string label, double least, double most);

/// Two axes and a title on a rectangle, with curves inside.
class Chart {
 public:
  Chart(Svg& svg, const Point& upper_left, const Point& lower_right, std::string_view title, Axis x, Axis y);

  void curve(const std::vector<Point>& numbers, const Stroke& stroke, bool dots = true);
  /// Text next to a point of the chart, moved by the given number of pixels.
  void label(const Point& numbers, std::string_view words, const Font& font, const Point& moved = {7, 4});

 private:
  Point at(const Point& numbers) const;

  Svg& svg_;
  Point upper_left_, lower_right_;
  Axis x_, y_;
};

}  // namespace pictures
