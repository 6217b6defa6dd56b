#include "ephemeris_time.hpp"

#include <cmath>

#include <erfa.h>
#include <erfam.h>

#include <vectrix/frames/errors.hpp>

namespace vectrix::detail {
namespace {

double ephemeris_minus_terrestrial(double seconds) {
  const auto& c = ephemeris_time_constants;
  const double m = c.m0 + c.m1 * seconds;
  return c.k * std::sin(m + c.eb * std::sin(m));
}

}  // namespace

SecondsSince2000 terrestrial_time(const Epoch& epoch) {
  const auto date = epoch.tai();
  return {(date.day - ERFA_DJ00) * ERFA_DAYSEC,
          date.fraction * ERFA_DAYSEC + ephemeris_time_constants.delta_t_a};
}

SecondsSince2000 ephemeris_time(const Epoch& epoch) {
  SecondsSince2000 time = terrestrial_time(epoch);
  time.part += ephemeris_minus_terrestrial(time.whole + time.part);
  return time;
}

Epoch epoch_of_terrestrial_time(const SecondsSince2000& tt, const std::string& place) {
  constexpr double limit = 9000.0 * ERFA_DJY * ERFA_DAYSEC;
  const double seconds = tt.whole + tt.part;
  if (!(std::abs(seconds) <= limit))
    throw BadInput(place + ": the time " + text(seconds) + " s is more than 9000 years from 2000");
  // The days first, which are whole: the sum of all seconds would be rounded.
  static const Epoch j2000 = Epoch::from_julian_date(scale::tt, ERFA_DJ00);
  const double days = std::floor(tt.whole / ERFA_DAYSEC) * ERFA_DAYSEC;
  return (j2000 + days * si::second) + (tt.part + (tt.whole - days)) * si::second;
}

Epoch epoch_of_ephemeris_time(const SecondsSince2000& et, const std::string& place) {
  const double difference = ephemeris_minus_terrestrial(et.whole + et.part);
  return epoch_of_terrestrial_time({et.whole, et.part - difference}, place);
}

}  // namespace vectrix::detail
