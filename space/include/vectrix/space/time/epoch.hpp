#pragma once

#include <compare>
#include <iosfwd>
#include <string>
#include <string_view>

#include <vectrix/frames/export.hpp>
#include <vectrix/frames/units.hpp>

namespace vectrix {

/// A Julian date in two parts: `day` ends in .5 (midnight), `fraction` is in [0, 1) day.
struct JulianDate {
  double day;
  double fraction;

  friend auto operator<=>(const JulianDate&, const JulianDate&) = default;
};

/// An instant, stored as a Julian date in International Atomic Time (TAI) to about 1e-11 s.
///     TT = TAI + 32.184 s        TAI = UTC + leap seconds (ERFA's table)
/// Differences are SI seconds and include leap seconds. An instant of the graph: graph.at(epoch).
///
/// UTC starts in 1960; an earlier date is BadInput. In years after the end of ERFA's table of leap seconds,
/// UTC uses the last leap second of the table; from_tt() does not depend on the table.
class VECTRIX_EXPORT Epoch {
 public:
  /// From "2022-04-14T10:22:11.874999", with 0 to 12 decimals and an optional 'Z' at the end. The second 60
  /// is accepted where there is a leap second. Throws BadInput for any other text and for dates that do not
  /// exist.
  static Epoch from_utc(std::string_view text);
  /// From the same text, in Terrestrial Time; without 'Z'.
  static Epoch from_tt(std::string_view text);
  /// From a modified Julian day of UTC and the elapsed fraction of that day, in [0, 1). The fraction is of
  /// the day's own length: a day with a leap second has 86401 s. Throws BadInput if the fraction is outside.
  static Epoch from_utc_mjd(int day, double part = 0.0);

  /// The text of the instant, rounded to the given number of decimals, 0 to 9. utc() throws BadInput before
  /// 1960.
  [[nodiscard]] std::string utc(int decimals = 6) const;
  [[nodiscard]] std::string tt(int decimals = 6) const;

  [[nodiscard]] const JulianDate& tai() const { return tai_; }
  [[nodiscard]] JulianDate tt_date() const;
  /// Leap seconds at this instant. Throws BadInput before 1960.
  [[nodiscard]] Quantity<si::time> tai_minus_utc() const;

  friend auto operator<=>(const Epoch&, const Epoch&) = default;

  // Friends are no candidates where no epoch stands, and so not in the compiler's words on other operands.

  /// The SI seconds from the second epoch to the first.
  friend VECTRIX_EXPORT Quantity<si::time> operator-(const Epoch& end, const Epoch& start);
  /// Throws BadInput if the duration is not finite.
  friend VECTRIX_EXPORT Epoch operator+(const Epoch& epoch, const Quantity<si::time>& duration);
  friend VECTRIX_EXPORT Epoch operator-(const Epoch& epoch, const Quantity<si::time>& duration);

  /// In UTC, "2022-04-14T10:22:11.874999 UTC"; before 1960 in TT.
  friend VECTRIX_EXPORT std::ostream& operator<<(std::ostream& out, const Epoch& epoch);

 private:
  explicit Epoch(const JulianDate& tai) : tai_(tai) {}

  JulianDate tai_;
};

}  // namespace vectrix
