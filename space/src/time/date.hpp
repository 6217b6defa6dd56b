#pragma once

#include <string>
#include <string_view>

#include <vectrix/space/time/epoch.hpp>

namespace vectrix::detail {

/// A Julian date of which the context says the scale. In UTC it is ERFA's quasi-Julian date, in which every
/// day has the length 1.
using Date = JulianDate<TimeScale>;

/// Splits the sum of the parts into a day that ends in .5 and a fraction in [0, 1).
Date normalised(double day, double fraction);

/// TAI of a date in the scale. `what` names the date in a BadInput.
Date tai_of(const TimeScale& scale, const Date& date, const std::string& what);
/// The date in the scale of an instant of TAI.
Date date_of(const TimeScale& scale, const Date& tai);
bool before_utc(const Date& tai);
/// TAI - UTC, s, at a date of UTC.
double tai_minus_utc(const Date& utc);
/// The length of the day of UTC, s, that the date is in.
double length_of_utc_day(const Date& utc);

/// The epoch for messages and streams: in UTC, before UTC in TT.
std::string shown(const Epoch& epoch);

/// The date in the scale of a calendar text. Throws BadInput with text, scale and reason.
Date read_calendar(const TimeScale& scale, std::string_view text);
enum class DayStyle { month_and_day, day_of_year };
/// The text of a date on a day of this length, s.
std::string calendar_text(const Date& date, double day_length, DayStyle style, int decimals);

}  // namespace vectrix::detail
