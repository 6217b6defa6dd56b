#include "series.hpp"

#include <erfa.h>
#include <erfam.h>

#include <string>

#include <vectrix/frames/errors.hpp>

namespace vectrix::detail {
namespace {

using PositionAndVelocity = double[2][3];  // au, au/day

PlainMotion in_metres(const PositionAndVelocity& pv, double sign) {
  const double length = sign * ERFA_DAU;
  const double velocity = length / ERFA_DAYSEC;
  return {length * Eigen::Vector3d(pv[0][0], pv[0][1], pv[0][2]),
          velocity * Eigen::Vector3d(pv[1][0], pv[1][1], pv[1][2])};
}

}  // namespace

// Outside 1900 to 2099 eraEpv00 warns; require_series() has refused that.
PlainMotion sun_motion(const JulianDate<scale::Tt>& tt) {
  PositionAndVelocity heliocentric;
  PositionAndVelocity barycentric;
  eraEpv00(tt.day, tt.fraction, heliocentric, barycentric);
  return in_metres(heliocentric, -1.0);
}

PlainMotion earth_motion(const JulianDate<scale::Tt>& tt) {
  PositionAndVelocity heliocentric;
  PositionAndVelocity barycentric;
  eraEpv00(tt.day, tt.fraction, heliocentric, barycentric);
  return in_metres(barycentric, 1.0);
}

PlainMotion moon_motion(const JulianDate<scale::Tt>& tt) {
  PositionAndVelocity geocentric;
  eraMoon98(tt.day, tt.fraction, geocentric);
  return in_metres(geocentric, 1.0);
}

void require_series(const char* what, const Epoch& epoch) {
  constexpr double first = 2415020.5;  // 1900 January 1
  constexpr double after = 2488069.5;  // 2100 January 1
  if (!(epoch.tai().day >= first && epoch.tai().day < after)) {
    throw BadInput(std::string{what} + ": the epoch " + epoch.tt(0) +
                   " TT is outside the years of the series, 1900 to 2099");
  }
}

PlainMotion geocentric_motion(Of<sky::Sun>, const Epoch& epoch) {
  require_series("geocentric(of<Sun>)", epoch);
  return sun_motion(epoch.tt_date());
}

PlainMotion geocentric_motion(Of<sky::Moon>, const Epoch& epoch) {
  require_series("geocentric(of<Moon>)", epoch);
  return moon_motion(epoch.tt_date());
}

}  // namespace vectrix::detail
