#include "report/axis.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "figures.hpp"

namespace vectrix::cli {

Ticks ticks(double from, double to, int most) {
  const double least = (to - from) / most;
  const double decade = std::pow(10.0, std::floor(std::log10(least)));
  double step = 10.0 * decade;
  for (const double factor : {5.0, 2.0, 1.0})
    if (factor * decade >= least) step = factor * decade;
  constexpr double rounding = 1e-9;
  Ticks found{{}, static_cast<int>(std::max(0.0, -std::floor(std::log10(step) + rounding)))};
  const double first = std::ceil(from / step - rounding);
  for (int k = 0; k <= most; ++k)
    if (const double value = (first + k) * step; value <= to + rounding * step) found.values.push_back(value);
  return found;
}

std::vector<double> text_places(const std::vector<double>& lines, double top) {
  constexpr double above = 4.0, height = 14.0, ascent = 11.0;
  std::vector<double> places;
  for (const double line : lines)
    places.push_back(places.empty() ? line - above : std::min(line - above, places.back() - height));
  double highest = top + ascent;
  for (auto place = places.rbegin(); place != places.rend(); ++place, highest += height)
    highest = *place = std::max(*place, highest);
  return places;
}

std::string tick_text(double value, int decimals) {
  constexpr int most_decimals = 5;
  if (decimals <= most_decimals) return with_decimals(value, decimals);
  char text[32];
  std::snprintf(text, sizeof text, "%.12g", value);
  return text;
}

}  // namespace vectrix::cli
