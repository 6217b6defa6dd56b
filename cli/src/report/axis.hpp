#pragma once

#include <string>
#include <vector>

namespace vectrix::cli {

/// An axis of a drawing: values from..to at the pixels low..high.
struct DrawnAxis {
  double from, to, low, high;

  [[nodiscard]] double at(double value) const { return low + (value - from) / (to - from) * (high - low); }
};

/// Multiples of 1, 2 or 5 times a power of ten, at most `most` of them, and the decimals that they need.
struct Ticks {
  std::vector<double> values;
  int decimals;
};
Ticks ticks(double from, double to, int most);
/// The number at a tick; if it needs more than five decimals, with an exponent.
std::string tick_text(double value, int decimals);

/// Where texts stand that belong to lines at these pixels, the lowest line first: just above their
/// lines, moved so that none covers another and none is above `top`.
std::vector<double> text_places(const std::vector<double>& lines, double top);

}  // namespace vectrix::cli
