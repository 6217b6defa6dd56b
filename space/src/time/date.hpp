#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <vectrix/space/time/epoch.hpp>

namespace vectrix::detail {

/// A Julian date of which the context says the scale. In UTC it is ERFA's quasi-Julian date, in which every
/// day has the length 1.
using Date = JulianDate<TimeScale>;

struct Calendar {
  int year = 0, month = 0, day = 0;
};
/// Throws BadInput for a Julian day that ERFA has no date for.
Calendar calendar_of(double julian_day);

/// Splits the sum of the parts into a day that ends in .5 and a fraction in [0, 1).
Date normalised(double day, double fraction);

/// TAI of a date in the scale. `what` names the date in a BadInput.
Date tai_of(const TimeScale& scale, const Date& date, const std::string& what);
/// Whether TAI of every time of a day in the scale, which is not UTC, is known to exist.
bool has_whole_day(const TimeScale& scale, double day);
/// The date in the scale of an instant of TAI.
Date date_of(const TimeScale& scale, const Date& tai);
bool before_utc(const Date& tai);
/// Leap seconds keep UT1-UTC within so much, s. From 1973 to 2026 it reached 0.81.
constexpr double largest_ut1_minus_utc = 0.9;
/// For how long UT1-TAI is kept. 0 for a UT1-UTC that is not known may cross one leap second, or some.
enum class Ut1Kept { no, over_a_leap_second, for_years };
/// What is wrong with UT1-TAI, s; empty if nothing: where all leap seconds are known UT1-UTC may have 0.9 s,
/// kept over a leap second 1.1 s. In the future of the table some may be missing: there, and if it is kept
/// for years, it may have 5 s.
std::string ut1_fault(const Date& tai, double ut1_minus_tai, Ut1Kept kept = Ut1Kept::no);
/// Throws BadInput, which begins with `what`, before 1960.
void require_known_utc(const Date& utc, const std::string& what);
/// A day of UTC, from midnight on: TAI - UTC at its beginning, how much it grows in 86400 s (before 1972),
/// and the step at its end, a leap second; in s.
struct UtcDay {
  double day;
  double tai_minus_utc, drift, step;

  /// The length of ERFA's quasi-Julian day, s. A step before 1972 is one of TAI: of UTC it is up to 3 ns
  /// less.
  [[nodiscard]] double quasi_length() const;
  /// How long the day is, in seconds of UTC: TAI of its end is TAI of the next midnight.
  [[nodiscard]] double length() const;
};
UtcDay utc_day(double day);
/// TAI of a fraction of the quasi-Julian day, from its begin to its end.
Date tai_of(const UtcDay& utc, double fraction);

/// An instant of UTC. The fraction of the quasi-Julian day passes 1 by up to 4e-14 at a negative step.
struct UtcTime {
  UtcDay day;
  double fraction;

  /// Of UTC, since midnight.
  [[nodiscard]] double second() const;
  [[nodiscard]] double tai_minus_utc() const;
};
/// Throws BadInput before 1960. A midnight as tai_of() gives it is of the day that it begins.
UtcTime utc_time(const Date& tai);

/// UTC, TAI, TT, TDB or GPS by its name. Null for any other.
const TimeScale* scale_named(std::string_view name);

/// The epoch for messages and streams: in UTC, before UTC in TT.
std::string shown(const Epoch& epoch);

/// Reads calendar texts of one scale, as Epoch::from does. The day is kept: texts of one day cost one
/// conversion of the calendar.
class EpochReader {
 public:
  explicit EpochReader(const TimeScale& scale);

  /// Throws BadInput with text, scale and reason.
  Epoch read(std::string_view text);

  /// The epoch at the begin of a text and where it ends, if it is of the day that is kept, and has no name of
  /// a scale. Nothing for any other text, also for one that read() refuses.
  struct Scanned {
    Epoch epoch;
    const char* end;
  };
  [[nodiscard]] std::optional<Scanned> scan(const char* at, const char* end) const;

 private:
  struct TimeOfDay;

  void begin_day(std::string_view text, std::string_view day);
  [[nodiscard]] const char* fault(const TimeOfDay& time) const;
  [[nodiscard]] Epoch epoch_at(const TimeOfDay& time, std::string_view text) const;
  [[noreturn]] void refuse(std::string_view text, const std::string& reason) const;
  [[nodiscard]] std::string what(std::string_view text) const;

  TimeScale scale_;
  std::string end_;        // that may follow, " UTC"
  std::string on_{};       // the text of the day that is kept
  UtcDay day_{};           // in other scales without drift and step
  bool is_known_ = false;  // there is a day, and TAI of all its times
};

enum class DayStyle { month_and_day, day_of_year };
/// The text of a second of a day of this length, s.
std::string calendar_text(double day, double second, double day_length, DayStyle style, int decimals);

}  // namespace vectrix::detail
