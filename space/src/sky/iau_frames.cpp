#include <vectrix/space/sky/iau_frames.hpp>

#include <cmath>
#include <numbers>

#include "../time/near_j2000.hpp"
#include "iau_elements.hpp"

namespace vectrix::detail {
namespace {

constexpr double radians_per_degree = std::numbers::pi / 180.0;
constexpr double seconds_per_day = 86400.0;                        // s
constexpr double seconds_per_century = 36525.0 * seconds_per_day;  // s
constexpr double j2000 = 2451545.0;                                // TDB

}  // namespace

IauAngles iau_angles(Body body, const Epoch& epoch) {
  require_near_j2000({"iau_rotation"}, epoch);
  const IauElements e = iau_elements(body);
  const auto tdb = epoch.julian_date(scale::tdb);
  const double days = (tdb.day - j2000) + tdb.fraction, centuries = days / 36525.0;
  // alpha + 90 deg, 90 deg - delta, W: deg; the rates deg/s
  const double meridian = std::fmod(e.w1 * days, 360.0);
  IauAngles x{
      {90.0 + e.a0 + e.a1 * centuries, 90.0 - e.d0 - e.d1 * centuries, e.w0 + meridian + e.w2 * days * days},
      {e.a1 / seconds_per_century, -e.d1 / seconds_per_century, (e.w1 + 2.0 * e.w2 * days) / seconds_per_day},
      {0.0, 0.0, 2.0 * e.w2 / (seconds_per_day * seconds_per_day)}};
  for (const IauTerm& term : e.terms) {
    const double phase = (term.phase + term.rate * centuries) * radians_per_degree,
                 rate = term.rate / seconds_per_century * radians_per_degree;
    const double sine = std::sin(phase), cosine = std::cos(phase);
    x.angles += Eigen::Vector3d(term.a * sine, -term.d * cosine, term.w * sine);
    x.rates += rate * Eigen::Vector3d(term.a * cosine, term.d * sine, term.w * cosine);
    x.second_rates += rate * rate * Eigen::Vector3d(-term.a * sine, term.d * cosine, -term.w * sine);
  }
  return {radians_per_degree * x.angles, radians_per_degree * x.rates, radians_per_degree * x.second_rates};
}

}  // namespace vectrix::detail
