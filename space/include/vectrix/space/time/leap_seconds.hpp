#pragma once

#include <filesystem>
#include <vector>

#include <vectrix/frames/export.hpp>

namespace vectrix {

/// From the first of the month on TAI-UTC has this many seconds.
struct LeapSecond {
  int year, month;
  int tai_minus_utc;

  friend bool operator==(const LeapSecond&, const LeapSecond&) = default;
};

/// The table of the process, from 1972 January, 10 s, on: that of the installed ERFA, or the one that was
/// given.
VECTRIX_EXPORT std::vector<LeapSecond> leap_seconds();

/// Gives the process another table: that of the installed ERFA, and after it leap seconds that were announced
/// later. An Epoch is an instant of TAI, so those that exist do not change. Not for several threads: call it
/// before the others use UTC. Throws BadInput if the table does not begin with all rows of the installed
/// ERFA's; a row has no month from 1 to 12, a year after 9999, or is not later than the one before; or a step
/// is not one second.
VECTRIX_EXPORT void use_leap_seconds(const std::vector<LeapSecond>& table);

/// Reads the file Leap_Second.dat of the IERS:
///     41317.0    1  1 1972       10          modified Julian day, day, month, year, TAI-UTC in s
/// Lines that begin with '#' are comments. Throws BadInput with file, line, column and what was found there;
/// also if the file cannot be read, has no rows, or stops within its last line. use_leap_seconds() checks the
/// order.
VECTRIX_EXPORT std::vector<LeapSecond> read_leap_seconds(const std::filesystem::path& file);

}  // namespace vectrix
