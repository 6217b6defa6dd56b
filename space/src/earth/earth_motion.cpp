#include <erfa.h>
#include <erfam.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include <vectrix/space/earth/earth_motion.hpp>

#include "../fused.hpp"
#include "celestial_pole.hpp"
#include "erfa_rotation.hpp"
#include "ocean_tides.hpp"
#include "sidereal_time.hpp"

namespace vectrix {
namespace {

constexpr int quintic_degree = 5, curve_count = 6, cell_size = (quintic_degree + 1) * curve_count;
using Numbers = Eigen::Array<double, curve_count, 1>;                // X, Y, angle, x, y, angle from TEME
using Cell = Eigen::Array<double, curve_count, quintic_degree + 1>;  // their coefficients
using Node = Eigen::Array<double, curve_count, 3>;  // their values and derivatives at an end, unit: cell

// The quintic with the values, slopes and second derivatives of both ends; the value at the end is `moved`
// more than at the start.
Cell quintic(const Node& start, const Node& end, const Numbers& moved) {
  const Numbers slope = start.col(1), bend = start.col(2);
  const Numbers value_left = moved - slope - 0.5 * bend, slope_left = end.col(1) - slope - bend,
                bend_left = end.col(2) - bend;
  Cell cell;
  cell << start.col(0), slope, 0.5 * bend, 10.0 * value_left - 4.0 * slope_left + 0.5 * bend_left,
      -15.0 * value_left + 7.0 * slope_left - bend_left,
      6.0 * value_left - 3.0 * slope_left + 0.5 * bend_left;
  return cell;
}

struct Motion {
  Numbers value, slope, half_bend;
};
Eigen::Map<const Numbers> coefficients(const double* cell, int power) {
  return Eigen::Map<const Numbers>(cell + power * curve_count);
}
[[gnu::always_inline]] inline Motion motion(const double* cell, double time) {
  Motion p{coefficients(cell, quintic_degree), Numbers::Zero(), Numbers::Zero()};
  for (int power = quintic_degree - 1; power >= 0; --power) {
    p.half_bend = p.half_bend * time + p.slope;
    p.slope = p.slope * time + p.value;
    p.value = p.value * time + coefficients(cell, power);
  }
  return p;
}
// The values alone, as a sum of pairs: no sum waits for all before it.
[[gnu::always_inline]] inline Numbers values(const double* cell, double time) {
  const Numbers low = coefficients(cell, 0) + time * coefficients(cell, 1);
  const Numbers middle = coefficients(cell, 2) + time * coefficients(cell, 3);
  const Numbers high = coefficients(cell, 4) + time * coefficients(cell, 5);
  const double square = time * time;
  const Numbers upper = middle + square * high;
  return low + square * upper;
}

// UT1-TAI may be that of EarthOrientation::unobserved over a long span.
constexpr auto may_be_kept = detail::Ut1Kept::for_years;

// At midnight, in days; and the locators, which the angle has in it.
struct Midnight {
  Node node;
  double ut1_minus_tai, sidereal_rate;            // s; rad/s
  double terrestrial_locator, celestial_locator;  // s' and s, rad
};
Midnight midnight(const Epoch& epoch, const Eigen::Matrix<double, 5, 3>& observed) {
  const JulianDate tt = epoch.tt_date();
  const JulianDate ut1 = detail::ut1_date(epoch, observed(2, 0) * si::second, may_be_kept);
  const auto [X, Y, s] = detail::celestial_pole(tt);
  const double turned = eraSp00(tt.day, tt.fraction);  // changes by 1e-19 rad/s
  const double rate = detail::earth_rotation_rate, sidereal = detail::sidereal_rate(ut1);
  Node node;
  node.row(0) << X.value + observed(3, 0), X.rate + observed(3, 1), X.second + observed(3, 2);
  node.row(1) << Y.value + observed(4, 0), Y.rate + observed(4, 1), Y.second + observed(4, 2);
  node.row(2) << eraEra00(ut1.day, ut1.fraction) + (turned - s.value), rate * (1.0 + observed(2, 1)) - s.rate,
      rate * observed(2, 2) - s.second;
  node.row(3) = observed.row(0);
  node.row(4) = observed.row(1);
  node.row(5) << eraGmst82(ut1.day, ut1.fraction) + turned, sidereal * (1.0 + observed(2, 1)),
      sidereal * observed(2, 2);
  node.col(1) *= ERFA_DAYSEC;
  node.col(2) *= ERFA_DAYSEC * ERFA_DAYSEC;
  return {node, observed(2, 0), sidereal, turned, s.value};
}

Cell day_between(const Midnight& start, const Midnight& end) {
  Numbers moved = end.node.col(0) - start.node.col(0);
  const double day_of_ut1 = ERFA_DAYSEC + (end.ut1_minus_tai - start.ut1_minus_tai);
  const double turned = end.terrestrial_locator - start.terrestrial_locator;
  moved[2] =
      detail::earth_rotation_rate * day_of_ut1 + (turned - (end.celestial_locator - start.celestial_locator));
  // The rate is linear in UT1, but for 1e-25 rad.
  moved[5] = 0.5 * (start.sidereal_rate + end.sidereal_rate) * day_of_ut1 + turned;
  return quintic(start.node, end.node, moved);
}

// The motion of a day and the tides at a time of it, in parts of the day.
Node with_tides(const Cell& day, double time, double part, const Eigen::Matrix3d& tides) {
  const Motion m = motion(day.data(), time);
  Node node;
  node << m.value, part * m.slope, (2.0 * part * part) * m.half_bend;
  Eigen::Array33d added = tides.array();
  added.row(2) *= detail::earth_rotation_rate;
  const double seconds = part * ERFA_DAYSEC;
  added.col(1) *= seconds;
  added.col(2) *= seconds * seconds;
  node.row(2) += added.row(2);
  node.row(5) += added.row(2);  // the sidereal rate differs by 1e-7 of it
  node.row(3) += added.row(0);
  node.row(4) += added.row(1);
  return node;
}

// x and y are below 5e-4 rad, as the columns of the file have room for: to rounding.
double small_sine(double angle) {
  return angle - angle * angle * angle * (1.0 / 6.0);
}
double small_cosine(double angle) {
  const double square = angle * angle;
  return 1.0 - square * (0.5 - square * (1.0 / 24.0));
}

detail::Varying varying(const Motion& m, double per_second, Eigen::Index i) {
  return {m.value[i], per_second * m.slope[i], 2.0 * per_second * per_second * m.half_bend[i]};
}

// R_c^i = R1(-y) R2(-x) R3(angle), where c has the axes of the celestial intermediate pole, and turns by
// `angle` into Tirf.
struct IntoItrf {
  double c, s, cx, sx, cy, sy;

  [[gnu::always_inline]] IntoItrf(double angle, double x, double y)
      : c(std::cos(angle)),
        s(std::sin(angle)),
        cx(small_cosine(x)),
        sx(small_sine(x)),
        cy(small_cosine(y)),
        sy(small_sine(y)) {}

  [[nodiscard, gnu::always_inline]] Eigen::Vector3d tirf_from_c(const Eigen::Vector3d& v) const {
    return {c * v[0] + s * v[1], c * v[1] - s * v[0], v[2]};
  }
  [[nodiscard, gnu::always_inline]] Eigen::Vector3d itrf_from_tirf(const Eigen::Vector3d& v) const {
    const double z = cx * v[2] - sx * v[0];
    return {cx * v[0] + sx * v[2], cy * v[1] - sy * z, sy * v[1] + cy * z};
  }
  // R_i^g = (R_c^i R_g^c)^T. The first two columns of R_g^c share registers.
  [[nodiscard, gnu::always_inline]] Eigen::Matrix3d g_from_itrf(const Eigen::Matrix3d& R_c_from_g) const {
    using Two = double __attribute__((vector_size(16)));
    const auto itrf_from_c = [&]<class S>(S v0, S v1, S v2) __attribute__((always_inline)) {
      const S x = c * v0 + s * v1, y = c * v1 - s * v0, z = cx * v2 - sx * x;
      return std::array<S, 3>{cx * x + sx * v2, cy * y - sy * z, sy * y + cy * z};
    };
    const auto& m = R_c_from_g;
    const auto two = itrf_from_c(Two{m(0, 0), m(0, 1)}, Two{m(1, 0), m(1, 1)}, Two{m(2, 0), m(2, 1)});
    const auto third = itrf_from_c(m(0, 2), m(1, 2), m(2, 2));
    Eigen::Matrix3d R_g_from_itrf;
    R_g_from_itrf << two[0][0], two[1][0], two[2][0], two[0][1], two[1][1], two[2][1], third[0], third[1],
        third[2];
    return R_g_from_itrf;
  }
};

// Of Itrf relative to an inertial frame g, with `pole` of c: with R_t^i = R1(-y) R2(-x) from Tirf to Itrf and
// n = R3(angle) w_gc^c + (0, 0, d angle/dt), the rate of Tirf in its axes,
//     w_gi^i = R_t^i n + p,    p = (-dy/dt, -dx/dt cos y, -dx/dt sin y)
//     alpha_gi^i = R_t^i dn/dt - p x (R_t^i n) + dp/dt
struct Turn {
  Eigen::Matrix3d R_g_from_itrf;
  Eigen::Vector3d w, alpha;
};
[[gnu::always_inline]] inline Turn turn(const detail::PoleTurn& pole, const detail::Varying& angle,
                                        const detail::Varying& x, const detail::Varying& y) {
  const IntoItrf into(angle.value, x.value, y.value);
  const double cy = into.cy, sy = into.sy;
  const Eigen::Vector3d across = into.tirf_from_c(pole.w_gc_c), change = into.tirf_from_c(pole.alpha_gc_c);
  const Eigen::Vector3d n(across[0], across[1], across[2] + angle.rate);
  const Eigen::Vector3d nd(change[0] + angle.rate * across[1], change[1] - angle.rate * across[0],
                           change[2] + angle.second);
  const Eigen::Vector3d turning = into.itrf_from_tirf(n);
  const Eigen::Vector3d p(-y.rate, -x.rate * cy, -x.rate * sy);
  const Eigen::Vector3d pd(-y.second, -x.second * cy + x.rate * y.rate * sy,
                           -x.second * sy - x.rate * y.rate * cy);
  return {into.g_from_itrf(pole.R_c_from_g), turning + p, into.itrf_from_tirf(nd) - p.cross(turning) + pd};
}

template <class A> AcceleratingDcm<A, earth::Itrf> accelerating(const Turn& turn) {
  using earth::Itrf;
  return {Dcm<A, Itrf>{detail::trusted, turn.R_g_from_itrf},
          AngularVelocity<A, Itrf, In<Itrf>>{detail::trusted, turn.w},
          AngularAcceleration<A, Itrf, In<Itrf>>{detail::trusted, turn.alpha}};
}

}  // namespace

EarthMotion::EarthMotion(const EarthOrientation& orientation, const TimeSpan& span)
    : EarthMotion(orientation, span, false) {}
EarthMotion::EarthMotion(const EarthOrientation& orientation, const TimeSpan& span, SubdailyTides)
    : EarthMotion(orientation, span, true) {}

EarthMotion::EarthMotion(const EarthOrientation& orientation, const TimeSpan& span, bool with_tides)
    : span_(span), first_day_(span.start().tai().day), cells_of_a_day_(with_tides ? 16 : 1) {
  for (const Epoch& end : {span.start(), span.end()}) {
    orientation.require(end);
    detail::ut1_date(end, orientation.curves(end)(2, 0) * si::second, may_be_kept);  // throws
  }
  const auto days = static_cast<std::size_t>(span.end().tai().day - first_day_) + 1;
  std::vector<double> cells(days * static_cast<std::size_t>(cells_of_a_day_ * cell_size));
  const auto at = [&](std::size_t day, double fraction) {
    return Epoch::from_julian_date(scale::tai, first_day_ + static_cast<double>(day), fraction);
  };
  const auto midnight_of = [&](std::size_t day) {
    return midnight(at(day, 0.0), orientation.curves(at(day, 0.0)));
  };
  auto next = cells.begin();
  const auto add = [&](const Cell& cell) { next = std::copy(cell.data(), cell.data() + cell_size, next); };
  Midnight start = midnight_of(0);
  for (std::size_t day = 0; day < days; ++day) {
    const Midnight end = midnight_of(day + 1);
    const Cell whole = day_between(start, end);
    if (with_tides) {
      const double part = 1.0 / cells_of_a_day_;
      const auto node = [&](int i) {
        const Epoch epoch = at(day, i * part);
        const auto ut1_minus_tai = orientation.curves(epoch)(2, 0) * si::second;
        return vectrix::with_tides(whole, i * part, part, detail::ocean_tides(epoch, ut1_minus_tai));
      };
      Node before = node(0);
      for (int i = 1; i <= cells_of_a_day_; ++i) {
        const Node after = node(i);
        add(quintic(before, after, after.col(0) - before.col(0)));
        before = after;
      }
    } else {
      add(whole);
    }
    start = end;
  }
  cells_ = std::make_shared<const std::vector<double>>(std::move(cells));
}

inline EarthMotion::Place EarthMotion::place(const Epoch& epoch) const {
  if (!span_.contains(epoch)) [[unlikely]] {
    detail::refuse_outside("EarthMotion", epoch, "the span,", span_);
  }
  const auto& tai = epoch.tai();
  const double of_day = tai.fraction * cells_of_a_day_;
  const int in_day = static_cast<int>(of_day);
  const auto index =
      static_cast<std::size_t>(tai.day - first_day_) * static_cast<std::size_t>(cells_of_a_day_) +
      static_cast<std::size_t>(in_day);
  return {cells_->data() + index * cell_size, of_day - in_day};
}

AcceleratingDcm<earth::Gcrf, earth::Itrf> EarthMotion::at(const Epoch& epoch) const {
  const auto in = place(epoch);
  return accelerating<earth::Gcrf>(detail::fused([&]() __attribute__((always_inline)) {
    const Motion m = motion(in.cell, in.time);
    const auto of = [&](Eigen::Index i) __attribute__((always_inline)) {
      return varying(m, cells_of_a_day_ / ERFA_DAYSEC, i);
    };
    return turn(detail::pole_turn(of(0), of(1)), of(2), of(3), of(4));
  }));
}

AcceleratingDcm<earth::Teme, earth::Itrf> teme_from_itrf(const Epoch& epoch, const EarthMotion& earth) {
  const auto in = earth.place(epoch);
  return accelerating<earth::Teme>(detail::fused([&]() __attribute__((always_inline)) {
    const Motion m = motion(in.cell, in.time);
    const auto of = [&](Eigen::Index i) __attribute__((always_inline)) {
      return varying(m, earth.cells_of_a_day_ / ERFA_DAYSEC, i);
    };
    const detail::PoleTurn along_z{Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero(),
                                   Eigen::Vector3d::Zero()};
    return turn(along_z, of(5), of(3), of(4));
  }));
}

Dcm<earth::Gcrf, earth::Itrf> EarthMotion::rotation(const Epoch& epoch) const {
  const auto in = place(epoch);
  return {detail::trusted, detail::fused([&]() __attribute__((always_inline)) {
            const Numbers v = values(in.cell, in.time);
            return IntoItrf(v[2], v[3], v[4]).g_from_itrf(detail::pole_matrix(detail::pole_at(v[0], v[1])));
          })};
}

}  // namespace vectrix
