#include <erfa.h>
#include <erfam.h>

#include <algorithm>
#include <cstddef>
#include <utility>

#include <vectrix/frames/dcm_doors.hpp>
#include <vectrix/space/earth/earth_orientation.hpp>

#include "erfa_rotation.hpp"
#include "finals2000a.hpp"

namespace vectrix {
namespace {

struct Tirs : moving_frame {};  // Itrf before polar motion

using detail::Rows, detail::matrix_of, detail::ut1_date, detail::set_polar_motion;

// dERA/dUT1, rad/s (IERS Conventions 2010, equation 5.15).
constexpr double earth_rotation_rate = ERFA_D2PI * 1.00273781191135448 / ERFA_DAYSEC;

}  // namespace

MovingDcm<earth::Gcrf, earth::Itrf> earth_rotation(const Epoch& epoch,
                                                   const EarthOrientationParameters& parameters) {
  const JulianDate tt = epoch.tt_date();
  const JulianDate ut1 = ut1_date(epoch, parameters);
  double x = 0.0;
  double y = 0.0;
  eraXy06(tt.day, tt.fraction, &x, &y);
  const double s = eraS06(tt.day, tt.fraction, x, y);
  Rows cirs_from_gcrf;
  eraC2ixys(x + parameters.dX.value(), y + parameters.dY.value(), s, cirs_from_gcrf);
  Rows polar_motion;
  set_polar_motion(tt, parameters, polar_motion);
  Rows itrf_from_gcrf;
  eraC2tcio(cirs_from_gcrf, eraEra00(ut1.day, ut1.fraction), polar_motion, itrf_from_gcrf);

  // The celestial intermediate pole is the z axis of the frame before polar motion.
  const Eigen::Vector3d pole = matrix_of(polar_motion).col(2);
  const double rate = earth_rotation_rate * (1.0 + parameters.ut1_gain.value());
  return moving_dcm(
      inverse(trust_dcm(to<earth::Itrf>, from<earth::Gcrf>, matrix_of(itrf_from_gcrf))),
      angular_velocity(of<earth::Itrf>, relative_to<earth::Gcrf>,
                       vector<si::angular_velocity>(in<earth::Itrf>, Eigen::Vector3d(rate * pole))));
}

Dcm<earth::TrueOfDate, earth::Gcrf> true_of_date_from_gcrf(const Epoch& epoch) {
  const JulianDate tt = epoch.tt_date();
  Rows rows;
  eraPnm06a(tt.day, tt.fraction, rows);
  return trust_dcm(to<earth::TrueOfDate>, from<earth::Gcrf>, Eigen::Matrix3d(matrix_of(rows)));
}

Dcm<earth::Itrf, earth::TrueOfDate> itrf_from_true_of_date(const Epoch& epoch,
                                                           const EarthOrientationParameters& parameters) {
  const JulianDate tt = epoch.tt_date();
  const JulianDate ut1 = ut1_date(epoch, parameters);
  Rows true_of_date;
  eraPnm06a(tt.day, tt.fraction, true_of_date);
  const double sidereal_time = eraGst06(ut1.day, ut1.fraction, tt.day, tt.fraction, true_of_date);
  Rows polar_motion;
  set_polar_motion(tt, parameters, polar_motion);
  return trust_dcm(to<earth::Itrf>, from<Tirs>, Eigen::Matrix3d(matrix_of(polar_motion))) *
         turned_z(to<Tirs>, from<earth::TrueOfDate>, sidereal_time * si::radian);
}

EarthOrientation::EarthOrientation(std::vector<Epoch> epochs, std::vector<EarthOrientationParameters> rows)
    : epochs_(std::move(epochs)), rows_(std::move(rows)) {}

EarthOrientation EarthOrientation::read(const std::filesystem::path& finals2000A) {
  auto [epochs, rows] = detail::read_finals2000A(finals2000A);
  return {std::move(epochs), std::move(rows)};
}

EarthOrientationParameters EarthOrientation::parameters(const Epoch& epoch) const {
  if (epoch < first() || epoch > last()) {
    throw BadInput("EarthOrientation: the epoch " + detail::shown(epoch) +
                   " is outside the data, which span " + detail::shown(first()) + " to " +
                   detail::shown(last()));
  }
  const auto after = std::upper_bound(epochs_.begin(), epochs_.end() - 1, epoch) - epochs_.begin();
  const auto right = static_cast<std::size_t>(after);
  const std::size_t left = right - 1;
  const auto day = epochs_[right] - epochs_[left];
  const double part = (epoch - epochs_[left]) / day;
  const auto between = [&](auto member) {
    return rows_[left].*member + part * (rows_[right].*member - rows_[left].*member);
  };
  using P = EarthOrientationParameters;
  return {between(&P::pole_x),
          between(&P::pole_y),
          between(&P::ut1_minus_tai),
          (rows_[right].ut1_minus_tai - rows_[left].ut1_minus_tai) / day,
          between(&P::dX),
          between(&P::dY)};
}

MovingDcm<earth::Gcrf, earth::Itrf> EarthOrientation::at(const Epoch& epoch) const {
  return earth_rotation(epoch, parameters(epoch));
}

}  // namespace vectrix
