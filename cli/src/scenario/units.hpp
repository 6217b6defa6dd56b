#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <vectrix/frames/errors.hpp>

namespace vectrix::cli {

enum class Dimension { angle, duration, length, share, rate, proper_motion };
/// "an angle"
std::string name_of(Dimension dimension);
/// The names of its units, the usual one first.
std::vector<std::string_view> units_of(Dimension dimension);

/// One number or several with one unit, as they were written: "0.5 deg", "[6, -5, 7] deg".
class Amount {
 public:
  /// Throws AmountError for anything else than so many finite numbers and a unit of the dimension.
  static Amount parse(std::string_view text, Dimension dimension, std::size_t count = 1);

  [[nodiscard]] const std::string& text() const { return text_; }
  /// In another unit of the same dimension: without rounding if it is the one that was written.
  [[nodiscard]] double in(std::string_view unit, std::size_t i = 0) const;

 private:
  std::string text_;
  std::vector<double> numbers_;
  std::string_view unit_;
};

/// A text that is no such amount, and the character at which it is wrong, counted from 0.
class AmountError : public BadInput {
 public:
  AmountError(const std::string& why, std::size_t at) : BadInput(why), at_(at) {}
  [[nodiscard]] std::size_t at() const { return at_; }

 private:
  std::size_t at_;
};

/// Reads "[6, -5, 7]", from the place `at`, which moves behind it. Throws AmountError.
std::vector<double> parse_numbers(std::string_view text, std::size_t& at, std::size_t count);

}  // namespace vectrix::cli
