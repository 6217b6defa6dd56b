#include <erfa.h>

#include <Eigen/Geometry>
#include <cmath>

#include <vectrix/frames/dcm_doors.hpp>
#include <vectrix/space/earth/intermediate_frames.hpp>

#include "../time/near_j2000.hpp"
#include "celestial_pole.hpp"
#include "erfa_rotation.hpp"

namespace vectrix {
namespace {

// R_b^a and w_ab^b from ERFA's matrix, which is R_a^b.
template <Frame A, Frame B> MovingDcm<A, B> moving(const detail::Rows& R_b_from_a, const Eigen::Vector3d& w) {
  return {inverse(trust_dcm(to<B>, from<A>, detail::matrix_of(R_b_from_a))),
          angular_velocity(of<B>, relative_to<A>, vector<si::angular_velocity>(in<B>, w))};
}

}  // namespace

MovingDcm<earth::Gcrf, earth::Cirf> gcrf_from_cirf(const Epoch& epoch,
                                                   const EarthOrientationParameters& parameters) {
  detail::require_near_j2000({"gcrf_from_cirf"}, epoch);
  detail::require_observed(epoch, parameters);
  auto [X, Y, s] = detail::celestial_pole(epoch.tt_date());
  X.value += parameters.dX.value();
  X.rate += parameters.dX_rate.value();
  Y.value += parameters.dY.value();
  Y.rate += parameters.dY_rate.value();
  detail::Rows cirf_from_gcrf;
  eraC2ixys(X.value, Y.value, s.value, cirf_from_gcrf);
  // By the shortest arc, then R3(-s).
  const Eigen::Vector3d w =
      Eigen::AngleAxisd(s.value, Eigen::Vector3d::UnitZ()) * detail::pole_turn(X, Y).w_gc_c;
  return moving<earth::Gcrf, earth::Cirf>(cirf_from_gcrf, {w.x(), w.y(), w.z() - s.rate});
}

MovingDcm<earth::Cirf, earth::Tirf> detail::cirf_from_tirf(const Epoch& epoch,
                                                           const EarthOrientationParameters& parameters,
                                                           Ut1Kept kept) {
  detail::require_observed(epoch, parameters);
  const auto ut1 = detail::ut1_date(epoch, parameters.ut1_minus_tai, kept);
  detail::Rows tirf_from_cirf;
  eraIr(tirf_from_cirf);
  eraRz(eraEra00(ut1.day, ut1.fraction), tirf_from_cirf);
  return moving<earth::Cirf, earth::Tirf>(
      tirf_from_cirf, {0.0, 0.0, detail::earth_rotation_rate * (1.0 + parameters.ut1_gain.value())});
}

MovingDcm<earth::Cirf, earth::Tirf> cirf_from_tirf(const Epoch& epoch,
                                                   const EarthOrientationParameters& parameters) {
  return detail::cirf_from_tirf(epoch, parameters, detail::Ut1Kept::no);
}

MovingDcm<earth::Tirf, earth::Itrf> tirf_from_itrf(const Epoch& epoch,
                                                   const EarthOrientationParameters& parameters) {
  detail::require_observed(epoch, parameters);
  const JulianDate tt = epoch.tt_date();
  const double y = parameters.pole_y.value();
  const double x_rate = parameters.pole_x_rate.value(), y_rate = parameters.pole_y_rate.value();
  detail::Rows itrf_from_tirf;
  eraPom00(parameters.pole_x.value(), y, eraSp00(tt.day, tt.fraction), itrf_from_tirf);
  return moving<earth::Tirf, earth::Itrf>(itrf_from_tirf,
                                          {-y_rate, -x_rate * std::cos(y), -x_rate * std::sin(y)});
}

}  // namespace vectrix
