#include <vectrix/space/time/exact_text.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>

#include <vectrix/frames/errors.hpp>

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

// A text has four digits for the year.
bool is_text(const std::string& text) {
  return text[0] != '-' && text[4] == '-';
}

// The epoch in the nanosecond that begins with the text.
std::string text_within(const std::string& begin, const Epoch& epoch, const TimeScale& scale) {
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

}  // namespace

std::string exact_text(const Epoch& epoch, const TimeScale& scale) {
  std::string text;
  for (const int decimals : {3, 6, static_cast<int>(nine)}) {
    text = epoch.text(scale, decimals);
    if (is_text(text) && Epoch::from(scale, text) == epoch) return text;
  }
  // A text that was rounded up is one nanosecond too late; the first epochs of a scale have none before them.
  constexpr Quantity<si::time> to_the_one_before = 0.6e-9 * si::second;
  std::string begin = text;
  const Epoch rounded = is_text(text) ? Epoch::from(scale, text) : epoch;
  if (!is_text(text) || epoch < rounded)
    begin = (rounded - to_the_one_before).text(scale, static_cast<int>(nine));
  if (!is_text(begin))
    throw BadInput("the epoch " + text + " " + scale.name() + " is not of the years 0 to 9999");
  return text_within(begin, epoch, scale);
}

}  // namespace vectrix
