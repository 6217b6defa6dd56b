#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <vectrix/frames/errors.hpp>
#include <vectrix/frames/export.hpp>
#include <vectrix/space/orbit/mean_elements.hpp>

namespace vectrix {
namespace detail {

class ElementLine;

}  // namespace detail

/// One set of two-line elements, the form in which the mean elements of SGP4 are published:
///     1 00005U 58002B   00179.78495062  .00000023  00000-0  28098-4 0  4753
///     2 00005  34.2682 348.7242 1859667 331.7664  19.3264 10.82419157413667
/// Every column is checked, and the sum in column 69. What follows column 69 is ignored. Catalogue numbers
/// have five digits, or a letter in place of the first two of six: A0000 is 100000, Z9999 is 339999, without
/// I and O (Alpha-5). Years 57 to 99 are of the 20th century, 00 to 56 of the 21st. The day of the year is in
/// UTC, the fraction of the day's own length; UTC starts in 1960, and epochs before are refused. So are sets
/// of another theory, by the type in column 63 of line 1: it may be blank, 0, 2 or 3. And so is what no orbit
/// has: a mean motion not in (0, 17] rev/day, a B* beyond 100, half its rate or a sixth of the second
/// beyond 1.
class VECTRIX_EXPORT TwoLineElements {
 public:
  using SecondRate = Quantity<unit_quotient<si::angular_acceleration, si::time>>;

  /// Throws BadInput with line, columns and what was found there.
  static TwoLineElements parse(std::string_view line1, std::string_view line2);
  /// With a title line before, in which "0 " at the beginning is no part of the title.
  static TwoLineElements parse(std::string_view title, std::string_view line1, std::string_view line2);
  /// All sets of a file, each with or without a title line. Lines that begin with '#' are comments, and blank
  /// lines are skipped. Throws BadInput with file, line, columns and what was found there; also if the file
  /// cannot be read or has no set.
  static std::vector<TwoLineElements> read(const std::filesystem::path& file);

  /// Empty if there was none.
  [[nodiscard]] const std::string& title() const { return title_; }
  [[nodiscard]] int catalogue_number() const { return catalogue_number_; }
  /// 'U' unclassified, 'C' classified, 'S' secret; ' ' if there was none.
  [[nodiscard]] char classification() const { return classification_; }
  /// Of the launch, as written: "58002B"; empty if there was none.
  [[nodiscard]] const std::string& designator() const { return designator_; }
  [[nodiscard]] int element_set_number() const { return element_set_number_; }
  /// Of the orbit at the epoch.
  [[nodiscard]] int revolution_number() const { return revolution_number_; }
  [[nodiscard]] const Epoch& epoch() const { return elements_.epoch; }
  [[nodiscard]] const MeanElements& mean_elements() const { return elements_; }
  /// The derivatives of the mean motion: twice what is in columns 34-43 of line 1, and six times what is in
  /// columns 45-52. SGP4 does not use them.
  [[nodiscard]] const Quantity<si::angular_acceleration>& mean_motion_rate() const {
    return mean_motion_rate_;
  }
  [[nodiscard]] const SecondRate& mean_motion_second_rate() const { return mean_motion_second_rate_; }

 private:
  TwoLineElements(std::string_view title, const MeanElements& elements)
      : title_(title), elements_(elements) {}

  static TwoLineElements of(std::string_view title, const detail::ElementLine& first,
                            const detail::ElementLine& second);

  std::string title_;
  int catalogue_number_ = 0;
  char classification_ = ' ';
  std::string designator_;
  int element_set_number_ = 0, revolution_number_ = 0;
  MeanElements elements_;
  Quantity<si::angular_acceleration> mean_motion_rate_{};
  SecondRate mean_motion_second_rate_{};
};

}  // namespace vectrix
