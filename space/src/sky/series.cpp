#include "series.hpp"

#include <erfa.h>
#include <erfam.h>

#include <array>
#include <cstddef>
#include <string>

#include <vectrix/space/earth/eme2000.hpp>

namespace vectrix::detail {
namespace {

using PositionAndVelocity = double[2][3];  // au, au/day

PlainMotion in_metres(const PositionAndVelocity& pv, double sign) {
  const double length = sign * ERFA_DAU;
  const double velocity = length / ERFA_DAYSEC;
  return {length * Eigen::Vector3d(pv[0][0], pv[0][1], pv[0][2]),
          velocity * Eigen::Vector3d(pv[1][0], pv[1][1], pv[1][2])};
}

// Outside 1900 to 2099 eraEpv00 warns; require_series() has refused that.
PlainMotion sun_motion(const JulianDate<scale::Tt>& tt) {
  PositionAndVelocity heliocentric;
  PositionAndVelocity barycentric;
  eraEpv00(tt.day, tt.fraction, heliocentric, barycentric);
  return in_metres(heliocentric, -1.0);
}

PlainMotion moon_motion(const JulianDate<scale::Tt>& tt) {
  PositionAndVelocity geocentric;
  eraMoon98(tt.day, tt.fraction, geocentric);
  return in_metres(geocentric, 1.0);
}

// By the number of eraPlan94, which answers along the axes of EME2000. It warns far outside 1900 to 2099, and
// if Kepler's equation is not solved: not with the eccentricities of these years.
template <int number> PlainMotion planet_motion(const JulianDate<scale::Tt>& tt) {
  static const Eigen::Matrix3d R_gcrf_from_eme2000 = eme2000_from_gcrf().matrix().transpose();
  PositionAndVelocity heliocentric;
  eraPlan94(tt.day, tt.fraction, number, heliocentric);
  const PlainMotion planet = in_metres(heliocentric, 1.0);
  const PlainMotion sun = sun_motion(tt);
  return {R_gcrf_from_eme2000 * planet.position + sun.position,
          R_gcrf_from_eme2000 * planet.velocity + sun.velocity};
}

// In the order of Body, from the Sun.
constexpr std::array<BodySeries, 9> all_series = {{{"Sun", sun_motion},
                                                   {"Moon", moon_motion},
                                                   {"Mercury", planet_motion<1>},
                                                   {"Venus", planet_motion<2>},
                                                   {"Mars", planet_motion<4>},
                                                   {"Jupiter", planet_motion<5>},
                                                   {"Saturn", planet_motion<6>},
                                                   {"Uranus", planet_motion<7>},
                                                   {"Neptune", planet_motion<8>}}};

}  // namespace

BodySeries series_of(Body body) {
  return all_series.at(static_cast<std::size_t>(body));
}

PlainMotion earth_motion(const JulianDate<scale::Tt>& tt) {
  PositionAndVelocity heliocentric;
  PositionAndVelocity barycentric;
  eraEpv00(tt.day, tt.fraction, heliocentric, barycentric);
  return in_metres(barycentric, 1.0);
}

bool in_series(const Epoch& epoch) {
  constexpr double first = 2415020.5;  // 1900 January 1
  constexpr double after = 2488069.5;  // 2100 January 1
  return epoch.tai().day >= first && epoch.tai().day < after;
}

PlainMotion geocentric_motion(Body body, const Epoch& epoch) {
  const BodySeries series = series_of(body);
  require_series([&] { return std::string{"geocentric(of<"} + series.name + ">)"; }, epoch);
  return series.motion(epoch.tt_date());
}

}  // namespace vectrix::detail
