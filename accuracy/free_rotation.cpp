#include <array>
#include <vectrix/dynamics/rigid/torque_free.hpp>

#include "subjects.hpp"

namespace vectrix::accuracy {
namespace {

using WideFour = Eigen::Matrix<Wide, 4, 1>;

/// w and q of a torque-free body in its principal axes.
struct Turning {
  WideColumn w;
  WideQuaternion q;
};

/// One step of h by the Taylor series of Euler's equations and of q' = q (0, w)/2. Each coefficient is a sum
/// of products of earlier ones.
Turning taylor_step(const WideColumn& J, const Turning& start, Wide h) {
  constexpr std::size_t order = 30;
  std::array<WideColumn, order + 1> w;
  std::array<WideFour, order + 1> q;  // scalar last
  w[0] = start.w;
  q[0] = start.q.coeffs();
  for (std::size_t k = 0; k < order; ++k) {
    WideColumn sum = WideColumn::Zero();
    WideFour turn = WideFour::Zero();
    for (std::size_t i = 0; i <= k; ++i) {
      const WideColumn& other = w[k - i];
      const WideColumn H = J.cwiseProduct(w[i]);
      sum += H.cross(other);
      turn += (WideQuaternion(q[i]) * WideQuaternion(0, other.x(), other.y(), other.z())).coeffs();
    }
    w[k + 1] = sum.cwiseQuotient(J) / Wide(k + 1);
    q[k + 1] = turn / Wide(2 * (k + 1));
  }
  WideColumn w_end = w[order];
  WideFour q_end = q[order];
  for (std::size_t k = order; k-- > 0;) {
    w_end = w[k] + h * w_end;
    q_end = q[k] + h * q_end;
  }
  return {w_end, WideQuaternion(q_end)};
}

/// The two errors of the closed form at one time: attitude in ulp per radian turned, rate in ulp of the rate.
struct Errors {
  Wide attitude, rate;
};

/// The largest moment exceeds the smallest, 1, by `spread` or less, down to 2^-halvings of it; the second is
/// anywhere between.
Errors errors(Draw& draw, double spread, double halvings) {
  const double third = 1.0 + spread * std::exp2(-draw.uniform(0.0, halvings));
  const Eigen::Vector3d J(1.0, draw.uniform(1.0, third), third);
  const Eigen::Vector3d w = draw.uniform(0.1, 2.0) * draw.direction();
  const Eigen::Vector4d q = draw.quaternion();
  const double t = draw.uniform(0.1, 20.0);
  const auto kg_m2 = si::kilogram_square_metre;
  const State<A, B> initial{
      .time = 0.0 * si::second,
      .q_i_from_b = q_of<A, B>(q),
      .w_ib_b = angular_velocity(of<B>, relative_to<A>, vector<si::angular_velocity>(in<B>, w))};
  const auto motion =
      torque_free(inertia_from_principal_moments(in<B>, J(0) * kg_m2, J(1) * kg_m2, J(2) * kg_m2), initial);
  const State<A, B> found = motion.at(t * si::second);

  const int steps = 1 + static_cast<int>(8 * t * w.norm());
  Turning exact{widened(w), wide_quaternion(q).normalized()};
  for (int i = 0; i < steps; ++i) exact = taylor_step(widened(J), exact, static_cast<Wide>(t) / steps);
  const Wide turned = std::max(Wide(1), static_cast<Wide>(t) * widened(w).norm());
  return {compare_up_to_sign(found.q_i_from_b.eigen().coeffs(), exact.q, "", 0).ulps / turned,
          compare(found.w_ib_b.coordinates(), exact.w, exact.w.norm() * turned, "", 0).ulps};
}

}  // namespace

void free_rotation_rows(Table& table) {
  table.section(
      "Motion without torque",
      "Reference: Taylor series of order 30 of Euler's equations and of the quaternion, with steps of an "
      "eighth of a radian. The closed form uses elliptic integrals, and their errors are included.");
  const Bound bound{
      100,
      "about 20 operations for the constants of the motion, and some for each radian turned: the "
      "error grows with the angle"};
  struct Bodies {
    double spread, halvings;
    const char* domain;
  };
  for (const Bodies& bodies : {Bodies{0.6, 0.0, "moments 1 to 1.6"}, Bodies{0.95, 0.0, "moments 1 to 1.95"},
                               Bodies{0.95, 52.0, "largest moment 1 + 2^-52 to 1.95 of the smallest"}}) {
    const std::string domain = std::string{bodies.domain} + "; rates to 2 rad/s, times to 20 s";
    table.row(
        "torque_free(...), attitude", domain, "radians turned, at least 1", bound,
        [&](Draw& draw) {
          return Found{errors(draw, bodies.spread, bodies.halvings).attitude, "", 0};
        },
        300);
    table.row(
        "torque_free(...), rate", domain, "|w| times radians turned", bound,
        [&](Draw& draw) {
          return Found{errors(draw, bodies.spread, bodies.halvings).rate, "", 0};
        },
        300);
  }
}

}  // namespace vectrix::accuracy
