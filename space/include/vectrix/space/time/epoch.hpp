#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>

#include <vectrix/frames/export.hpp>
#include <vectrix/frames/units.hpp>
#include <vectrix/space/time/date_text.hpp>
#include <vectrix/space/time/gps_time.hpp>
#include <vectrix/space/time/julian_date.hpp>

namespace vectrix {
namespace detail {
class EpochReader;
}

/// An instant, stored as a Julian date in International Atomic Time (TAI) to about 1e-11 s. Scales are ways
/// to read and to write it; TimeScale lists them. Differences are SI seconds and include leap seconds; as one
/// double they are rounded, over a century to 2.4e-7 s. An instant of the graph: graph.at(epoch).
///
/// UTC starts in 1960, and GPS time in 1980; an earlier date is BadInput. In years after the end of the
/// table of leap seconds, UTC uses its last one; the other scales do not depend on it. See leap_seconds.hpp
/// for a newer table.
class VECTRIX_EXPORT Epoch {
 public:
  template <class Given>
  explicit Epoch(  // Epoch::from_utc(text), from(scale, text), from_julian_date(scale, day, fraction), ...
      const Given&) = delete;
  template <class Scale>
  Epoch(  // a date is no instant, and no operand of one: Epoch::from_julian_date(date)
      const JulianDate<Scale>&) = delete;
  template <class S>
  Epoch(  // a duration is no instant: start + 60.0 * si::second
      const Quantity<si::time, S>&) = delete;
  template <class Scale>
  Epoch(  // a text is no instant: Epoch::from(scale, text)
      const DateText<Scale>&) = delete;

  /// From "2022-04-14T10:22:11.874999" or, by the day of the year, "2022-104T10:22:11.874999", with 0 to 12
  /// decimals; the name of the scale may follow, " UTC", " TT", or in UTC a 'Z'. The second 60 is accepted
  /// where UTC has a leap second. Throws BadInput for any other text, also if it names or was written in
  /// another scale, in UT1 also with another UT1-TAI, and for dates that do not exist.
  static Epoch from(const TimeScale& scale, AnyDateText text);
  /// Epoch::from(scale::utc, text), Epoch::from(scale::tt, text)
  static Epoch from_utc(DateTextView<scale::Utc> text) { return from(scale::utc, text); }
  static Epoch from_tt(DateTextView<scale::Tt> text) { return from(scale::tt, text); }
  /// From a text that names its scale, as << writes it: "2022-04-14T10:22:11.874999 TT", or UTC, TAI, TDB,
  /// GPS; a 'Z' at the end is UTC.
  static Epoch from(std::string_view text);
  template <ScaleType Scale, class Written>
    requires(!std::same_as<Scale, Written>)
  static auto from(  // a text is read in the scale in which it was written
      const Scale&, const DateText<Written>&) -> Epoch = delete;

  /// From a Julian date in two parts, split in any way: (2459683.5, 0.25) or (2459683.75, 0.0). Nothing is
  /// lost between the parts; a single double is rounded to 40 microseconds, of a modified Julian date to 1.
  /// Throws BadInput if a part is not finite; for a Julian date outside the years 0 to 9999, as a modified
  /// one would be; and for a modified one outside the years 0 to 6570, as a Julian date since the year 0
  /// would be.
  static Epoch from_julian_date(const TimeScale& scale, double day, double fraction = 0.0);
  static Epoch from_modified_julian_date(const TimeScale& scale, double day, double fraction = 0.0);
  /// From a date that has its scale in its type: JulianDate<scale::Tt>{2459683.5, 0.25}.
  template <class Scale> static Epoch from_julian_date(const JulianDate<Scale>& date) {
    return from_julian_date(detail::scale_of(date), date.day, date.fraction);
  }
  template <class Given, class... More>
    requires(!std::derived_from<Given, TimeScale> || sizeof...(More) == 0)
  static Epoch from_julian_date(  // the scale first, (scale::tt, day, fraction); or a JulianDate
      const Given&, const More&...) = delete;
  template <class Given, class... More>
    requires(!std::derived_from<Given, TimeScale>)
  static Epoch from_modified_julian_date(  // the scale first, (scale::tt, day, fraction)
      const Given&, const More&...) = delete;
  /// From a modified Julian day of UTC and the elapsed fraction of that day, in [0, 1). The fraction is of
  /// the day's own length: a day with a leap second has 86401 s. Throws BadInput if the fraction is outside,
  /// and as from_modified_julian_date does.
  static Epoch from_utc_mjd(int day, double part = 0.0);

  /// From a whole week since 1980 January 6 and the seconds of the week, in [0, 604800). Throws BadInput if
  /// the week is negative or above 1e6, or the seconds are outside.
  static Epoch from_gps_week(std::int64_t week, const Quantity<si::time>& second);
  /// From the whole seconds since 1980 January 6 and a fraction, in [0, 1). Throws BadInput if the seconds
  /// are negative or above 6e11, or the fraction is outside.
  static Epoch from_gps_seconds(std::int64_t seconds, double fraction = 0.0);

  /// The text of the instant, rounded to the given number of decimals, 0 to 9, but at the end of the year
  /// 9999 not up to a year that from() does not read. Throws BadInput in UTC before 1960, and in GPS before
  /// 1980. The type of the text has the scale, unless the scale is known at run time only.
  [[nodiscard]] std::string text(const TimeScale& scale, int decimals = 6) const;
  template <ScaleType Scale> [[nodiscard]] DateText<Scale> text(const Scale& scale, int decimals = 6) const {
    return DateText<Scale>{text(static_cast<const TimeScale&>(scale), decimals), scale};
  }
  /// The same with the day of the year, "2022-104T10:22:11.874999".
  [[nodiscard]] std::string day_of_year_text(const TimeScale& scale, int decimals = 6) const;
  template <ScaleType Scale>
  [[nodiscard]] DateText<Scale> day_of_year_text(const Scale& scale, int decimals = 6) const {
    return DateText<Scale>{day_of_year_text(static_cast<const TimeScale&>(scale), decimals), scale};
  }
  /// text(scale::utc, decimals), text(scale::tt, decimals)
  [[nodiscard]] DateText<scale::Utc> utc(int decimals = 6) const { return text(scale::utc, decimals); }
  [[nodiscard]] DateText<scale::Tt> tt(int decimals = 6) const { return text(scale::tt, decimals); }

  /// The Julian date in a scale: epoch.julian_date(scale::tdb) is a JulianDate<scale::Tdb>.
  template <ScaleType Scale> [[nodiscard]] JulianDate<Scale> julian_date(const Scale& scale) const {
    const auto date = date_in(scale);
    return detail::date_by(scale, date.day, date.fraction);
  }
  [[nodiscard]] const JulianDate<scale::Tai>& tai() const { return tai_; }
  [[nodiscard]] JulianDate<scale::Tt> tt_date() const { return julian_date(scale::tt); }

  /// Rounded to 1e-10 s, so that a week begins at its second 0. Throws BadInput before 1980 January 6.
  [[nodiscard]] GpsTime gps_time() const;
  /// Of the leap seconds at this instant; before 1972 of the line between two steps. The first instant after
  /// a step has the difference after it. Throws BadInput before 1960.
  [[nodiscard]] Quantity<si::time> tai_minus_utc() const;

  friend bool operator==(const Epoch& a, const Epoch& b) { return a.tai_ == b.tai_; }
  friend std::weak_ordering operator<=>(const Epoch& a, const Epoch& b) {
    if (a.tai_ < b.tai_) return std::weak_ordering::less;
    return b.tai_ < a.tai_ ? std::weak_ordering::greater : std::weak_ordering::equivalent;
  }

  // A text is rounded, and may not say its scale. Of deleted operators clang would list all those of std.
  template <detail::TextLike Text> friend bool operator==(const Epoch&, const Text&) {
    static_assert(detail::no_instant<Text>, "a text is no instant: compare the epochs");
    return false;
  }
  template <detail::TextLike Text> friend std::weak_ordering operator<=>(const Epoch&, const Text&) {
    static_assert(detail::no_instant<Text>, "a text is no instant: compare the epochs");
    return std::weak_ordering::equivalent;
  }
  template <detail::TextLike Text> friend Refused operator-(const Epoch&, const Text&) {
    static_assert(detail::no_instant<Text>, "a text is no instant: subtract the epochs");
    return {};
  }
  template <detail::TextLike Text> friend Refused operator-(const Text&, const Epoch&) {
    static_assert(detail::no_instant<Text>, "a text is no instant: subtract the epochs");
    return {};
  }
  template <std::same_as<Epoch> Other> friend Refused operator+(const Epoch&, const Other&) {
    static_assert(detail::no_instant<Other>, "epochs do not add: an epoch and a duration do");
    return {};
  }

  // Friends are no candidates where no epoch stands, and so not in the compiler's words on other operands.

  /// The SI seconds from the second epoch to the first.
  friend VECTRIX_EXPORT Quantity<si::time> operator-(const Epoch& end, const Epoch& start);
  /// Throws BadInput if the duration is not finite.
  friend VECTRIX_EXPORT Epoch operator+(const Epoch& epoch, const Quantity<si::time>& duration);
  friend VECTRIX_EXPORT Epoch operator-(const Epoch& epoch, const Quantity<si::time>& duration);

  /// In UTC, "2022-04-14T10:22:11.874999 UTC"; before 1960 in TT.
  friend VECTRIX_EXPORT std::ostream& operator<<(std::ostream& out, const Epoch& epoch);

 private:
  friend class detail::EpochReader;

  explicit Epoch(const JulianDate<scale::Tai>& tai) : tai_(tai) {}

  [[nodiscard]] JulianDate<TimeScale> date_in(const TimeScale& scale) const;

  JulianDate<scale::Tai> tai_;
};

}  // namespace vectrix
