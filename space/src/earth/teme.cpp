#include <erfam.h>

#include <vectrix/frames/dcm_doors.hpp>
#include <vectrix/space/earth/intermediate_frames.hpp>
#include <vectrix/space/earth/teme.hpp>

#include "erfa_rotation.hpp"

namespace vectrix {
namespace {

// dGMST82/dUT1, rad/s: a turn a day, and the derivative of the polynomial of Aoki et al. (1982), which
// eraGmst82 evaluates.
double sidereal_rate(const JulianDate<scale::Ut1>& ut1) {
  const double T = ((ut1.day - ERFA_DJ00) + ut1.fraction) / ERFA_DJC;
  const double seconds_per_century = 8640184.812866 + T * (2.0 * 0.093104 - T * 3.0 * 6.2e-6);
  return ERFA_D2PI / ERFA_DAYSEC * (1.0 + seconds_per_century / (ERFA_DJC * ERFA_DAYSEC));
}

}  // namespace

MovingDcm<earth::Teme, earth::Itrf> teme_from_itrf(const Epoch& epoch,
                                                   const EarthOrientationParameters& parameters) {
  detail::require_observed(epoch, parameters);
  const auto ut1 = detail::ut1_date(epoch, parameters.ut1_minus_tai);
  const double rate = sidereal_rate(ut1) * (1.0 + parameters.ut1_gain.value());
  const auto R_tirf_from_teme =
      turned_z(to<earth::Tirf>, from<earth::Teme>, eraGmst82(ut1.day, ut1.fraction) * si::radian);
  return moving_dcm(inverse(R_tirf_from_teme),
                    angular_velocity(
                        of<earth::Tirf>, relative_to<earth::Teme>,
                        vector<si::angular_velocity>(in<earth::Tirf>, Eigen::Vector3d(0.0, 0.0, rate)))) *
         tirf_from_itrf(epoch, parameters);
}

}  // namespace vectrix
