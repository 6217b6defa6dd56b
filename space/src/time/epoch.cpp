#include <erfam.h>

#include <cmath>
#include <ostream>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/time/epoch.hpp>

#include "date.hpp"

namespace vectrix {
namespace {

using detail::Date;
using detail::DayStyle;

constexpr double modified_julian_zero = 2400000.5;
constexpr double gps_zero = 2444244.5;  // 1980 January 6, 0 h
constexpr std::int64_t seconds_of_week = 604800;
constexpr double days_of_week = 7.0;
constexpr double one_instant = 1e-9;  // s: the clock has 1e-11, and a day before 1972 some roundings more

// A modified Julian date taken for a Julian date is before the year 0. A Julian date since then, taken for a
// modified one, is of the year 6570 or later.
constexpr double year_0 = 1721059.5, year_10000 = 5373484.5;  // Julian days of January 1
constexpr double least_julian_date = 1721059.0;

void require_julian(const Date& date, const std::string& what) {
  if (!(date.day >= year_0 && date.day < year_10000))
    throw BadInput(what + ": Julian dates are of the years 0 to 9999, " + detail::text(year_0) +
                   " or more; " + "for a modified one, from_modified_julian_date");
}
void require_modified(const Date& date, const std::string& what) {
  if (!(date.day >= year_0 && date.modified_day() < least_julian_date))
    throw BadInput(what + ": modified Julian dates are of the years 0 to 6570, less than " +
                   detail::text(least_julian_date) + "; for a Julian date, from_julian_date");
}

JulianDate<scale::Tai> as_tai(const Date& date) {
  return {date.day, date.fraction};
}
Date as_date(const JulianDate<scale::Tai>& tai) {
  return {tai.day, tai.fraction};
}

std::string text_of(const JulianDate<scale::Tai>& tai, const TimeScale& scale, DayStyle style, int decimals) {
  if (scale.kind() == TimeScale::Kind::utc) {
    const auto utc = detail::utc_time(as_date(tai));
    return detail::calendar_text(utc.day.day, utc.second(), utc.day.length(), style, decimals);
  }
  const Date date = detail::date_of(scale, as_date(tai));
  return detail::calendar_text(date.day, date.fraction * ERFA_DAYSEC, ERFA_DAYSEC, style, decimals);
}

std::string difference(const TimeScale& ut1) {
  return std::string{ut1.kind() == TimeScale::Kind::ut1_by_tai ? "UT1-TAI " : "UT1-UTC "} +
         detail::text(ut1.ut1_offset().value()) + " s";
}

}  // namespace

Epoch Epoch::from(const TimeScale& scale, AnyDateText text) {
  const auto& written_in = text.written_in();
  if (!written_in) return detail::EpochReader(scale).read(text);
  const auto refuse = [&](const std::string& in, const std::string& reason) {
    throw BadInput("epoch '" + std::string{text} + "' in " + in + ": it was written " + reason);
  };
  if (std::string_view{written_in->name()} != scale.name())
    refuse(scale.name(), std::string{"in "} + written_in->name());
  const Epoch read = detail::EpochReader(scale).read(text);
  // UT1-TAI and UT1-UTC may be two words for one difference.
  const auto apart = read - detail::EpochReader(*written_in).read(text);
  if (std::abs(apart.value()) > one_instant)
    refuse("UT1 with " + difference(scale), "with " + difference(*written_in));
  return read;
}

Epoch Epoch::from(std::string_view text) {
  if (text.ends_with('Z')) return from(scale::utc, text);
  const auto blank = text.rfind(' ');
  const TimeScale* scale =
      blank == std::string_view::npos ? nullptr : detail::scale_named(text.substr(blank + 1));
  if (!scale)
    throw BadInput("epoch '" + std::string{text} +
                   "': it does not end with its scale, UTC, TAI, TT, TDB or GPS; UT1 needs UT1-TAI");
  return from(*scale, text);
}

Epoch Epoch::from_julian_date(const TimeScale& scale, double day, double fraction) {
  const std::string what = "Julian date " + detail::text(day) + " + " + detail::text(fraction) + " in " +
                           std::string{scale.name()};
  if (!std::isfinite(day) || !std::isfinite(fraction)) throw BadInput(what + ": it is not finite");
  const Date date = detail::normalised(day, fraction);
  require_julian(date, what);
  return Epoch{as_tai(detail::tai_of(scale, date, what))};
}

Epoch Epoch::from_modified_julian_date(const TimeScale& scale, double day, double fraction) {
  const std::string what = "modified Julian date " + detail::text(day) + " + " + detail::text(fraction) +
                           " in " + std::string{scale.name()};
  if (!std::isfinite(day) || !std::isfinite(fraction)) throw BadInput(what + ": it is not finite");
  const double whole = std::floor(day), of_fraction = std::floor(fraction);
  const Date date = detail::normalised(modified_julian_zero + (whole + of_fraction),
                                       (day - whole) + (fraction - of_fraction));
  require_modified(date, what);
  return Epoch{as_tai(detail::tai_of(scale, date, what))};
}

Epoch Epoch::from_utc_mjd(int day, double part) {
  const std::string what = "Epoch::from_utc_mjd(" + detail::text(day) + ", " + detail::text(part) + ")";
  if (!(part >= 0.0 && part < 1.0)) throw BadInput(what + ": the part of the day is outside [0, 1)");
  const Date utc{modified_julian_zero + day, part};
  require_modified(utc, what);
  return Epoch{as_tai(detail::tai_of(scale::utc, utc, what))};
}

Epoch Epoch::from_gps_week(std::int64_t week, const Quantity<si::time>& second) {
  const std::string what = "GPS week " + detail::text(week) + ", second " + detail::text(second.value());
  constexpr std::int64_t most = 1'000'000;
  if (week < 0 || week > most) throw BadInput(what + ": the week is outside [0, 1000000]");
  if (!(second.value() >= 0.0 && second.value() < static_cast<double>(seconds_of_week))) {
    throw BadInput(what + ": the second is outside [0, 604800)");
  }
  const double day = std::floor(second.value() / ERFA_DAYSEC);
  const Date gps{gps_zero + days_of_week * static_cast<double>(week) + day,
                 std::fma(-day, ERFA_DAYSEC, second.value()) / ERFA_DAYSEC};
  return Epoch{as_tai(detail::tai_of(scale::gps, gps, what))};
}

Epoch Epoch::from_gps_seconds(std::int64_t seconds, double fraction) {
  const std::string what = "GPS second " + detail::text(seconds) + " + " + detail::text(fraction);
  constexpr std::int64_t most = 600'000'000'000;
  if (seconds < 0 || seconds > most) throw BadInput(what + ": the second is outside [0, 6e11]");
  if (!(fraction >= 0.0 && fraction < 1.0)) throw BadInput(what + ": the fraction is outside [0, 1)");
  constexpr std::int64_t of_day = 86400;
  const Date gps{gps_zero + static_cast<double>(seconds / of_day),
                 (static_cast<double>(seconds % of_day) + fraction) / ERFA_DAYSEC};
  return Epoch{as_tai(detail::tai_of(scale::gps, gps, what))};
}

std::string Epoch::text(const TimeScale& scale, int decimals) const {
  return text_of(tai_, scale, DayStyle::month_and_day, decimals);
}

std::string Epoch::day_of_year_text(const TimeScale& scale, int decimals) const {
  return text_of(tai_, scale, DayStyle::day_of_year, decimals);
}

JulianDate<TimeScale> Epoch::date_in(const TimeScale& scale) const {
  return detail::date_of(scale, as_date(tai_));
}

GpsTime Epoch::gps_time() const {
  constexpr double per_second = 1e10;
  const Date gps = date_in(scale::gps);
  const auto ticks = std::llround(gps.fraction * ERFA_DAYSEC * per_second);
  const auto days = static_cast<std::int64_t>(gps.day - gps_zero);
  constexpr std::int64_t ticks_of_day = 864'000'000'000'000;
  const std::int64_t day = days + (ticks == ticks_of_day ? 1 : 0);
  const auto week = day / 7;
  const double of_day = static_cast<double>(ticks % ticks_of_day) / per_second;
  return {week, (static_cast<double>(day % 7) * ERFA_DAYSEC + of_day) * si::second};
}

Quantity<si::time> Epoch::tai_minus_utc() const {
  return detail::utc_time(as_date(tai_)).tai_minus_utc() * si::second;
}

Quantity<si::time> operator-(const Epoch& end, const Epoch& start) {
  return ((end.tai().day - start.tai().day) * ERFA_DAYSEC +
          (end.tai().fraction - start.tai().fraction) * ERFA_DAYSEC) *
         si::second;
}

Epoch operator+(const Epoch& epoch, const Quantity<si::time>& duration) {
  const double seconds = duration.value();
  if (!std::isfinite(seconds)) {
    throw BadInput("epoch + duration: the duration is " + detail::text(seconds) + " s");
  }
  const double days = std::floor(seconds / ERFA_DAYSEC);
  const double rest = std::fma(-days, ERFA_DAYSEC, seconds) / ERFA_DAYSEC;
  return Epoch{as_tai(detail::normalised(epoch.tai_.day + days, epoch.tai_.fraction + rest))};
}

Epoch operator-(const Epoch& epoch, const Quantity<si::time>& duration) {
  return epoch + (-duration);
}

std::string detail::shown(const Epoch& epoch) {
  return before_utc(as_date(epoch.tai())) ? epoch.tt() + " TT" : epoch.utc() + " UTC";
}

std::ostream& operator<<(std::ostream& out, const Epoch& epoch) {
  return out << detail::shown(epoch);
}

}  // namespace vectrix
