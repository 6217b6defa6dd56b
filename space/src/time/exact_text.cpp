#include <vectrix/space/time/exact_text.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

namespace vectrix {
namespace {

constexpr std::size_t nine = 9;

constexpr std::int64_t finer = 1000;  // picoseconds in a nanosecond

// The text of nine decimals, with twelve, so many picoseconds later. Within the second.
std::string later_text(const std::string& text, std::int64_t picoseconds) {
  const std::string whole = text.substr(0, text.size() - nine);
  std::int64_t decimals = 0;
  std::from_chars(text.data() + whole.size(), text.data() + text.size(), decimals);
  const auto later = std::clamp<std::int64_t>(decimals * finer + picoseconds, 0, 999'999'999'999);
  const std::string digits = std::to_string(later);
  return whole + std::string(nine + 3 - digits.size(), '0') + digits;
}

}  // namespace

std::string exact_text(const Epoch& epoch, const TimeScale& scale) {
  for (const int decimals : {3, 6, static_cast<int>(nine)}) {
    std::string text = epoch.text(scale, decimals);
    if (Epoch::from(scale, text) == epoch) return text;
  }
  // The nanosecond in which the epoch is, then the picosecond.
  const std::string begin = (epoch - 0.5e-9 * si::second).text(scale, static_cast<int>(nine));
  const auto picoseconds = std::llround((epoch - Epoch::from(scale, begin)).value() * 1e12);
  constexpr std::int64_t around = 30;  // an epoch is rounded to 10 ps, a text within a day to 15 ps
  for (std::int64_t off = 0; off <= around; ++off) {
    for (const std::int64_t ahead : {off, -off}) {
      std::string text = later_text(begin, picoseconds + ahead);
      if (Epoch::from(scale, text) == epoch) return text;
    }
  }
  return later_text(begin, picoseconds);
}

}  // namespace vectrix
