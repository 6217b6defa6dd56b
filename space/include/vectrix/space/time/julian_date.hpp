#pragma once

#include <compare>
#include <concepts>
#include <vectrix/frames/operators.hpp>
#include <vectrix/space/time/time_scale.hpp>

namespace vectrix {

class Epoch;

/// A Julian date in two parts, in one scale: `day` ends in .5 (midnight), `fraction` is in [0, 1) day. A
/// double of a whole Julian date would be rounded to 40 microseconds; the two parts are rounded to 1e-11 s.
/// It is no instant: dates of two scales do not compare, and a difference of dates is no duration.
template <std::derived_from<TimeScale> Scale> struct JulianDate {
  double day;
  double fraction;

  /// The modified Julian day, which begins at midnight: day - 2400000.5.
  [[nodiscard]] constexpr double modified_day() const { return day - 2400000.5; }

  // Members: the left operand alone says the scale, so that the compiler finds few candidates for two scales.
  bool operator==(const JulianDate& other) const = default;
  std::partial_ordering operator<=>(const JulianDate& other) const = default;
  template <class Other>
    requires(!std::same_as<Other, JulianDate> && !std::same_as<Other, Epoch>)
  auto operator==(const Other&) const -> bool = delete;  // dates of one scale compare; else the epochs
  template <class Other>
    requires(!std::same_as<Other, JulianDate> && !std::same_as<Other, Epoch>)
  auto operator<=>(const Other&) const  // dates of one scale compare; else the epochs
      -> std::partial_ordering = delete;
};

/// A date in UT1 follows from an observed UT1-TAI, which it keeps. Another table gives another date for the
/// same instant, so these dates do not compare.
template <> struct JulianDate<scale::Ut1> {
  double day;
  double fraction;
  scale::Ut1 scale;  ///< with the UT1-TAI, or UT1-UTC, of this date

  JulianDate(double whole_day, double of_day, const scale::Ut1& difference)
      : day(whole_day), fraction(of_day), scale(difference) {}
  JulianDate(double, double) = delete;  // UT1 needs UT1-TAI: {day, fraction, scale::Ut1::minus_tai(...)}

  [[nodiscard]] constexpr double modified_day() const { return day - 2400000.5; }

  template <class Other>
    requires(!std::same_as<Other, Epoch>)
  auto operator==(const Other&) const -> bool = delete;  // UT1 is as its table has it: compare the epochs
  template <class Other>
    requires(!std::same_as<Other, Epoch>)
  auto operator<=>(const Other&) const  // UT1 is as its table has it: compare the epochs
      -> std::partial_ordering = delete;
};

namespace detail {

template <class Scale> JulianDate<Scale> date_by(const Scale&, double day, double fraction) {
  return {day, fraction};
}
inline JulianDate<scale::Ut1> date_by(const scale::Ut1& scale, double day, double fraction) {
  return {day, fraction, scale};
}
template <class Scale> Scale scale_of(const JulianDate<Scale>&) {
  return {};
}
inline const scale::Ut1& scale_of(const JulianDate<scale::Ut1>& date) {
  return date.scale;
}

}  // namespace detail

// Its sums and differences are refused.
template <class Scale> inline constexpr bool detail::is_framed<JulianDate<Scale>> = true;

}  // namespace vectrix
