#include <erfa.h>
#include <erfam.h>

#include <vectrix/frames/dcm_doors.hpp>
#include <vectrix/space/earth/frames_of_date.hpp>
#include <vectrix/space/earth/intermediate_frames.hpp>

#include "../time/near_j2000.hpp"
#include "erfa_rotation.hpp"

namespace vectrix {
namespace {

// h^2/6 of the third derivative is 2e-17 rad/s where the nutations of 5 to 14 days add up; the matrices are
// rounded to 1e-16.
constexpr double h = 0.01, seconds = 2.0 * h * ERFA_DAYSEC;

using Series = void (*)(double day, double fraction, detail::Rows);
detail::RowMajor of_date(Series series, const JulianDate<scale::Tt>& tt, double later) {
  detail::Rows rows;
  series(tt.day, tt.fraction + later, rows);
  return detail::matrix_of(rows);
}

// R_g^d from a series and w_dg^g by dR_g^d/dt = R_g^d [w_dg^g]x. The quotient is skew to some 1e-8 of it, so
// that vee() would refuse it.
template <Frame Date>
MovingDcm<Date, earth::Gcrf> turning(const char* action, const Epoch& epoch, Series series) {
  using earth::Gcrf;
  detail::require_near_j2000({action}, epoch);
  const JulianDate tt = epoch.tt_date();
  const Eigen::Matrix3d R = of_date(series, tt, 0.0);
  const Eigen::Matrix3d W = R.transpose() * (of_date(series, tt, h) - of_date(series, tt, -h)) / seconds;
  const Eigen::Vector3d w = 0.5 * Eigen::Vector3d(W(2, 1) - W(1, 2), W(0, 2) - W(2, 0), W(1, 0) - W(0, 1));
  return {trust_dcm(to<Date>, from<Gcrf>, R),
          angular_velocity(of<Gcrf>, relative_to<Date>, vector<si::angular_velocity>(in<Gcrf>, w))};
}

}  // namespace

MovingDcm<earth::MeanOfDate, earth::Gcrf> mean_of_date_from_gcrf(const Epoch& epoch) {
  return turning<earth::MeanOfDate>("mean_of_date_from_gcrf", epoch, eraPmat06);
}

MovingDcm<earth::TrueOfDate, earth::Gcrf> true_of_date_from_gcrf(const Epoch& epoch) {
  return turning<earth::TrueOfDate>("true_of_date_from_gcrf", epoch, eraPnm06a);
}

MovingDcm<earth::Itrf, earth::TrueOfDate> itrf_from_true_of_date(
    const Epoch& epoch, const EarthOrientationParameters& parameters) {
  using earth::Tirf, earth::TrueOfDate;
  detail::require_near_j2000({"itrf_from_true_of_date"}, epoch);
  detail::require_observed(epoch, parameters);
  const JulianDate tt = epoch.tt_date();
  const JulianDate ut1 = detail::ut1_date(epoch, parameters.ut1_minus_tai);
  // GST is the angle of rotation less the equation of the origins, which the equinox has by TT.
  const auto of_origins = [&](double later) { return eraEo06a(tt.day, tt.fraction + later); };
  const double sidereal_time = eraAnp(eraEra00(ut1.day, ut1.fraction) - of_origins(0.0));
  const double rate = detail::earth_rotation_rate * (1.0 + parameters.ut1_gain.value()) -
                      (of_origins(h) - of_origins(-h)) / seconds;
  const MovingDcm tirf_from_true_of_date{
      turned_z(to<Tirf>, from<TrueOfDate>, sidereal_time * si::radian),
      angular_velocity(of<TrueOfDate>, relative_to<Tirf>,
                       vector<si::angular_velocity>(in<TrueOfDate>, Eigen::Vector3d(0.0, 0.0, -rate)))};
  return inverse(tirf_from_itrf(epoch, parameters)) * tirf_from_true_of_date;
}

}  // namespace vectrix
