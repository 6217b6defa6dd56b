#include <erfa.h>

#include <vectrix/frames/dcm_doors.hpp>
#include <vectrix/space/earth/intermediate_frames.hpp>
#include <vectrix/space/earth/teme.hpp>

#include "erfa_rotation.hpp"
#include "sidereal_time.hpp"

namespace vectrix {

MovingDcm<earth::Teme, earth::Itrf> teme_from_itrf(const Epoch& epoch,
                                                   const EarthOrientationParameters& parameters) {
  detail::require_observed(epoch, parameters);
  const auto ut1 = detail::ut1_date(epoch, parameters.ut1_minus_tai);
  const double rate = detail::sidereal_rate(ut1) * (1.0 + parameters.ut1_gain.value());
  const auto R_tirf_from_teme =
      turned_z(to<earth::Tirf>, from<earth::Teme>, eraGmst82(ut1.day, ut1.fraction) * si::radian);
  return moving_dcm(inverse(R_tirf_from_teme),
                    angular_velocity(
                        of<earth::Tirf>, relative_to<earth::Teme>,
                        vector<si::angular_velocity>(in<earth::Tirf>, Eigen::Vector3d(0.0, 0.0, rate)))) *
         tirf_from_itrf(epoch, parameters);
}

}  // namespace vectrix
