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

/// An instant, kept as a Julian date in International Atomic Time (TAI) to about 1e-11 s.
///     TT = TAI + 32.184 s        TAI = UTC + leap seconds (ERFA's table)
/// Differences are SI seconds, leap seconds included. An instant of the graph: graph.at(epoch).
///
/// UTC is known from 1960 on; earlier is BadInput. In years that ERFA's table of leap seconds does not cover
/// yet, UTC is taken with the last leap second it knows; from_tt() depends on no table.
class VECTRIX_EXPORT Epoch {
 public:
  /// From "2022-04-14T10:22:11.874999", with up to 12 decimals or none, 'Z' or nothing at the end. The second
  /// 60 exists where there is a leap second. Throws BadInput for any other text and for dates that do not
  /// exist.
  static Epoch from_utc(std::string_view text);
  /// From the same text, meant in Terrestrial Time; no 'Z'.
  static Epoch from_tt(std::string_view text);
  /// From a modified Julian day of UTC and the elapsed part of that day, in [0, 1) of its own length: a day
  /// with a leap second has 86401 s. Throws BadInput when the part is outside.
  static Epoch from_utc_mjd(int day, double part = 0.0);

  /// The text of the instant, rounded to 0 to 9 decimals. utc() throws BadInput before 1960.
  [[nodiscard]] std::string utc(int decimals = 6) const;
  [[nodiscard]] std::string tt(int decimals = 6) const;

  [[nodiscard]] const JulianDate& tai() const { return tai_; }
  [[nodiscard]] JulianDate tt_date() const;
  /// Leap seconds in force. Throws BadInput before 1960.
  [[nodiscard]] Quantity<si::time> tai_minus_utc() const;

  friend auto operator<=>(const Epoch&, const Epoch&) = default;

 private:
  explicit Epoch(const JulianDate& tai) : tai_(tai) {}
  friend VECTRIX_EXPORT Epoch operator+(const Epoch& epoch, const Quantity<si::time>& duration);

  JulianDate tai_;
};

/// The SI seconds from the second epoch to the first.
VECTRIX_EXPORT Quantity<si::time> operator-(const Epoch& end, const Epoch& start);
/// Throws BadInput when the duration is not finite.
VECTRIX_EXPORT Epoch operator+(const Epoch& epoch, const Quantity<si::time>& duration);
VECTRIX_EXPORT Epoch operator-(const Epoch& epoch, const Quantity<si::time>& duration);

/// In UTC, "2022-04-14T10:22:11.874999 UTC"; before 1960 in TT.
VECTRIX_EXPORT std::ostream& operator<<(std::ostream& out, const Epoch& epoch);

}  // namespace vectrix
