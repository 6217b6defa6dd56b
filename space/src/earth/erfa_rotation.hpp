#pragma once

#include <erfa.h>
#include <erfam.h>
#include <Eigen/Core>
#include <cmath>

#include <vectrix/space/earth/earth_orientation.hpp>

#include "../time/date.hpp"

namespace vectrix::detail {

using Rows = double[3][3];  // as ERFA has a matrix
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

inline RowMajor matrix_of(const Rows& rows) {
  return Eigen::Map<const RowMajor>(&rows[0][0]);
}

/// Throws BadInput if UT1-TAI is none; see ut1_fault.
inline JulianDate<scale::Ut1> ut1_date(const Epoch& epoch, const Quantity<si::time>& ut1_minus_tai,
                                       Ut1Kept kept = Ut1Kept::no) {
  const auto& tai = epoch.tai();
  const double difference = ut1_minus_tai.value();
  if (const auto fault = ut1_fault({tai.day, tai.fraction}, difference, kept); !fault.empty())
    throw BadInput("Earth orientation at " + epoch.utc() + " UTC: " + fault);
  const Date ut1 = normalised(tai.day, tai.fraction + difference / ERFA_DAYSEC);
  return {ut1.day, ut1.fraction, scale::Ut1::minus_tai(ut1_minus_tai)};
}

/// A hundred times what has been observed of x, y, dX and dY: in other units they would be more.
constexpr double largest_pole_offset = 60.0;  // arcsec
/// And far more than of their derivatives, 0.02 arcsec a day and 5e-8 with the tides.
constexpr double largest_pole_rate = 60.0 * ERFA_DAS2R / ERFA_DAYSEC;  // rad/s
constexpr double largest_ut1_gain = 1e-6;

/// Throws BadInput if a parameter is not finite, or beyond these.
inline void require_observed(const Epoch& epoch, const EarthOrientationParameters& p) {
  const auto fail = [&](const char* name, double value, const char* unit) {
    throw BadInput("Earth orientation at " + shown(epoch) + ": " + name + " is " + text(value) + unit);
  };
  const auto angle = [&](const char* name, const Quantity<si::angle>& value) {
    if (!(std::abs(value.value()) <= largest_pole_offset * ERFA_DAS2R))
      fail(name, value.value(), " rad; it must be within 60 arcsec");
  };
  const auto rate = [&](const char* name, const Quantity<si::angular_velocity>& value) {
    if (!(std::abs(value.value()) <= largest_pole_rate))
      fail(name, value.value(), " rad/s; it must be within 60 arcsec a day");
  };
  angle("pole_x", p.pole_x);
  angle("pole_y", p.pole_y);
  angle("dX", p.dX);
  angle("dY", p.dY);
  rate("pole_x_rate", p.pole_x_rate);
  rate("pole_y_rate", p.pole_y_rate);
  rate("dX_rate", p.dX_rate);
  rate("dY_rate", p.dY_rate);
  if (!std::isfinite(p.ut1_minus_tai.value())) fail("UT1-TAI", p.ut1_minus_tai.value(), " s");
  if (!(std::abs(p.ut1_gain.value()) <= largest_ut1_gain))
    fail("d(UT1-TAI)/dTAI", p.ut1_gain.value(), "; it must be within 1e-6");
}

/// cirf_from_tirf of a UT1-TAI that may be kept.
MovingDcm<earth::Cirf, earth::Tirf> cirf_from_tirf(const Epoch& epoch,
                                                   const EarthOrientationParameters& parameters,
                                                   Ut1Kept kept);

/// dERA/dUT1, rad/s (IERS Conventions 2010, equation 5.15).
constexpr double earth_rotation_rate = ERFA_D2PI * 1.00273781191135448 / ERFA_DAYSEC;

}  // namespace vectrix::detail
