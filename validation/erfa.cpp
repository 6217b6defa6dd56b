#include <erfa.h>

#include <cmath>
#include <vectrix/frames/scalar/larger.hpp>
#include <vectrix/space.hpp>

#include "comparison.hpp"

namespace vectrix::validation {
namespace {

using Rows3 = double[3][3];
using Eigen::Matrix3d, Eigen::Vector3d;

constexpr double microarcsecond = 4.84813681109536e-12;  // rad
constexpr const char* reason_of_rotation =
    "0.1 of quintics in X and Y through ERFA's values a day apart; rounding";
constexpr const char* reason_of_rate =
    "difference of ERFA's matrices over two minutes, in which the angle is rounded to 3e-14 rad";
constexpr const char* reason_of_matrix =
    "X and Y of the matrix of precession and nutation differ by 2.3 from their own series";

// ERFA's numbers of one instant. The pole stands in ITRF, without observed offsets.
struct Erfa {
  JulianDate<scale::Tt> tt;
  JulianDate<scale::Ut1> ut1;

  Erfa(const Epoch& epoch, const EarthOrientationParameters& p)
      : tt(epoch.tt_date()), ut1(epoch.julian_date(scale::Ut1::minus_tai(p.ut1_minus_tai))) {}

  static Matrix3d gcrf_from_itrf(const Rows3& itrf_from_gcrf) {
    return Eigen::Map<const Matrix3d>(&itrf_from_gcrf[0][0]);  // column by column: the transpose
  }
  [[nodiscard]] Matrix3d by_the_series_of_the_pole() const {
    double x = 0.0;
    double y = 0.0;
    eraXy06(tt.day, tt.fraction, &x, &y);
    Rows3 cirf, polar_motion, all;
    eraC2ixys(x, y, eraS06(tt.day, tt.fraction, x, y), cirf);
    eraPom00(0.0, 0.0, eraSp00(tt.day, tt.fraction), polar_motion);
    eraC2tcio(cirf, eraEra00(ut1.day, ut1.fraction), polar_motion, all);
    return gcrf_from_itrf(all);
  }
  [[nodiscard]] Matrix3d by_the_matrix_of_nutation() const {
    Rows3 all;
    eraC2t06a(tt.day, tt.fraction, ut1.day, ut1.fraction, 0.0, 0.0, all);
    return gcrf_from_itrf(all);
  }
};

double apart(const Matrix3d& a, const Matrix3d& b) {
  return (a - b).norm() / std::sqrt(2.0) / microarcsecond;
}

}  // namespace

Rows erfa_rows(const std::string&) {
  double rotation = 0.0, rate = 0.0, by_matrix = 0.0;
  const auto start = Epoch::from_utc("1973-01-02T00:00:00");
  constexpr int years = 54;
  constexpr double year = 365.25 * 86400.0, h = 60.0;  // s
  for (int i = 0; i < 2 * years; ++i) {
    // Half a year and some days apart, so that the phase of the Moon changes.
    const auto span = from_until(start + (0.4987 * year * i) * si::second, 86400.0 * si::second);
    const auto orientation = EarthOrientation::unobserved(span, -0.3 * si::second);
    const EarthMotion earth(orientation, span);
    const auto observed = orientation.parameters(span.start());
    for (const double part : {0.21, 0.49, 0.83}) {
      const Epoch t = span.start() + part * (span.end() - span.start());
      const auto erfa = [&](double later) { return Erfa(t + later * si::second, observed); };
      const auto found = earth.at(t);
      rotation =
          detail::larger(rotation, apart(found.rotation.matrix(), erfa(0.0).by_the_series_of_the_pole()));
      by_matrix =
          detail::larger(by_matrix, apart(found.rotation.matrix(), erfa(0.0).by_the_matrix_of_nutation()));
      const Eigen::AngleAxisd turn(erfa(-h).by_the_series_of_the_pole().transpose() *
                                   erfa(h).by_the_series_of_the_pole());
      const Vector3d w = turn.angle() / (2.0 * h) * turn.axis();
      rate = detail::larger(rate, (found.angular_velocity.coordinates() - w).norm());
    }
  }
  const std::string years_text = "the Earth over days of 1973 to 2026";
  return {{"Earth", years_text, "GCRF to ITRF, ERFA's eraXy06 and eraS06", 1.0, "microarcsec",
           reason_of_rotation, rotation},
          {"Earth", years_text, "GCRF to ITRF, ERFA's eraC2t06a", 5.0, "microarcsec", reason_of_matrix,
           by_matrix},
          {"Earth", years_text, "angular velocity", 1e-15, "rad/s", reason_of_rate, rate}};
}

}  // namespace vectrix::validation
