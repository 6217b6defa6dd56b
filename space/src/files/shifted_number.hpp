#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace vectrix::detail {

/// The number times 10^shift, of which the text gives the number: kilometres are read as metres, shift = 3,
/// and rounded once. Nothing if the text is no finite number or longer than 100 characters.
std::optional<double> parse_shifted(std::string_view text, int shift);
/// The same for a number at the begin of a text, and where it ends there. Nothing also for some that
/// parse_shifted reads, of many digits for example.
struct ScannedNumber {
  double value;
  const char* end;
};
std::optional<ScannedNumber> scan_shifted(const char* at, const char* end, int shift);
/// Whether the text is a finite number, of any size and length.
bool is_finite_number(std::string_view text);
/// What to do about a number of Fortran, such as 1.5D-03; empty for another text.
const char* exponent_fault(std::string_view text);
/// Why parse_shifted gives nothing for the text and the shift.
const char* number_fault(std::string_view text, int shift);
/// The shortest text of the number times 10^-shift that parse_shifted reads as the same number, with the
/// decimal point that CCSDS wants behind the first digit: 6.8e+03, 8.0e-01.
std::string shifted_text(double value, int shift);

}  // namespace vectrix::detail
