#include "celestial_pole.hpp"

#include <erfa.h>
#include <erfam.h>

namespace vectrix::detail {
namespace {

Eigen::Array3d series(const JulianDate<scale::Tt>& tt, double later) {
  double x = 0.0;
  double y = 0.0;
  eraXy06(tt.day, tt.fraction + later, &x, &y);
  return {x, y, eraS06(tt.day, tt.fraction + later, x, y)};
}

}  // namespace

CelestialPole celestial_pole(const JulianDate<scale::Tt>& tt) {
  // h^2/6 of the third derivative of X and Y is 2e-17 rad/s where the nutations of 5 to 14 days add up. X is
  // rounded to 1e-18 rad.
  constexpr double h = 0.01, seconds = h * ERFA_DAYSEC;
  const Eigen::Array3d before = series(tt, -h), now = series(tt, 0.0), after = series(tt, h);
  const Eigen::Array3d rate = (after - before) / (2.0 * seconds);
  const Eigen::Array3d second = ((after - now) - (now - before)) / (seconds * seconds);
  const auto varying = [&](Eigen::Index i) { return Varying{now[i], rate[i], second[i]}; };
  return {varying(0), varying(1), varying(2)};
}

}  // namespace vectrix::detail
