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

/// Gives the process another table, with a leap second that was announced after the installed ERFA. An Epoch
/// is an instant of TAI, so those that exist do not change. Not for several threads: call it before the
/// others use UTC. Throws BadInput if the table does not begin with 1972 January, 10 s; the months do not
/// follow one another; a step is not one second; or it differs from ERFA's where both tell.
VECTRIX_EXPORT void use_leap_seconds(const std::vector<LeapSecond>& table);

/// Reads the file Leap_Second.dat of the IERS:
///     41317.0    1  1 1972       10          modified Julian day, day, month, year, TAI-UTC in s
/// Lines that begin with '#' are comments. Throws BadInput with file, line, column and what was found there.
VECTRIX_EXPORT std::vector<LeapSecond> read_leap_seconds(const std::filesystem::path& file);

}  // namespace vectrix
