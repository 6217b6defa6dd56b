#include <vectrix/kinematics/samples/slerp.hpp>

#include "subjects.hpp"

namespace vectrix::accuracy {
namespace {

const Bound product_bound = roundings(
    8,
    "four products and three sums to a component, on the components of a unit quaternion, which count as 2");

void conversion_rows(Table& table) {
  for (const Turns& kind : turns()) {
    table.row(
        "quaternion(R)", kind.name, "1",
        roundings(
            10, "sums of entries 3, scaling 2; the rounding of R itself, seen from the nearest rotation, 5"),
        [&](Draw& draw) {
          const Eigen::Matrix3d R = rounded_dcm(kind.draw(draw));
          const WideQuaternion exact = quaternion_of(nearest_rotation(widened(R)));
          const Eigen::Vector4d q = quaternion(R_of<A, B>(R)).eigen().coeffs();
          return compare_up_to_sign(q, exact, "q_w", static_cast<double>(std::abs(exact.w())));
        },
        kind.count);
    table.row(
        "dcm(q)", kind.name, "1",
        roundings(16,
                  "products and sums 3 to an entry, nine entries together 9; the length of q counted 4 "
                  "times"),
        [&](Draw& draw) {
          const Eigen::Vector4d q = rounded_quaternion(kind.draw(draw));
          return compare(dcm(q_of<A, B>(q)).matrix(), rotation_of(wide_quaternion(q)), 1, "q_w",
                         std::abs(q(3)));
        },
        kind.count);
  }
}

void product_rows(Table& table) {
  table.row("q_c_from_b * q_b_from_a", "any", "1", product_bound, [](Draw& draw) {
    const auto f = []<class Q>(const Q& q, const Q& p) -> Q {
      return (q_of<C, B>(q) * q_of<B, A>(p)).eigen().coeffs();
    };
    const Eigen::Vector4d q = draw.quaternion(), p = draw.quaternion();
    return rounding(f, 1, "", 0, q, p);
  });
  table.row("q_b_from_a * r_a", "any; |r| from 1e-150 to 1e150", "|r|",
            roundings(16, "two cross products 3 each, doubled, and two sums 2, each of three components"),
            [](Draw& draw) {
              const Eigen::Vector4d q = draw.quaternion();
              const Eigen::Vector3d r = draw.vector(1e-150, 1e150);
              const auto f = []<class S>(const FourOf<S>& q_, const ColumnOf<S>& r_) -> ColumnOf<S> {
                return (q_of<B, A>(q_) * vector<si::length>(in<A>, r_)).coordinates();
              };
              return compare(f(q, r), f(widened(q), widened(r)), widened(r).norm(), "|r|", r.norm());
            });
  table.row("nearest_quaternion_scalar_last", "any; |q| from 1e-150 to 1e150", "1",
            roundings(10, "scaling 1, the norm 4, the division 1, of four components"), [](Draw& draw) {
              const Eigen::Vector4d q = draw.logarithmic(1e-150, 1e150) * draw.quaternion();
              const auto found = nearest_quaternion_scalar_last(to<B>, from<A>, q(0), q(1), q(2), q(3));
              const Eigen::Matrix<Wide, 4, 1> exact = widened(q) / widened(q).norm();
              return compare(found.quaternion.eigen().coeffs(), exact, 1, "|q|", q.norm());
            });
}

// q(s) by Shoemake's formula, (sin((1 - s) w) q0 + sin(s w) q1) / sin w; the library uses another formula.
Found slerp_error(Draw& draw, double angle) {
  const Eigen::Vector4d q0 = draw.quaternion();
  const WideQuaternion turn = wide_quaternion(rounded_quaternion(angle * draw.direction()));
  const Eigen::Vector4d q1 = (wide_quaternion(q0) * turn).coeffs().cast<double>();
  const double s = draw.uniform(0.0, 1.0);
  const Slerp<A, B> motion(0.0 * si::second, q_of<A, B>(q0), 1.0 * si::second, q_of<A, B>(q1));

  const WideQuaternion from = wide_quaternion(q0).normalized(), until = wide_quaternion(q1).normalized();
  const Wide w = std::acos(std::min(Wide(1), from.dot(until)));
  const Wide half_sine = (until.coeffs() - from.coeffs()).norm() / 2;  // sin(w/2), to full accuracy
  const Wide full = angle < 1 ? 2 * std::asin(half_sine) : w;
  const Eigen::Matrix<Wide, 4, 1> q =
      (std::sin((1 - s) * full) * from.coeffs() + std::sin(s * full) * until.coeffs()) / std::sin(full);
  return compare(motion(s * si::second).rotation.matrix(), rotation_of(WideQuaternion(q)), 1, "angle", angle);
}

void slerp_rows(Table& table) {
  const Bound bound =
      roundings(63, "product and log of the quaternions 25, scaled 1, exp 12, product 9, dcm 16");
  table.row("Slerp, the rotation", "samples 1e-8 to 1 rad apart", "1", bound,
            [](Draw& draw) { return slerp_error(draw, draw.logarithmic(1e-8, 1.0)); });
  table.row("Slerp, the rotation", "samples 1 to 3.14 rad apart", "1", bound,
            [](Draw& draw) { return slerp_error(draw, draw.uniform(1.0, 3.14)); });
}

}  // namespace

void quaternion_rows(Table& table) {
  table.section(
      "Quaternions",
      "References: the quaternion of the rotation nearest to R; the rotation of q/|q|, whatever the "
      "rounding of the given q; the same products in wider arithmetic; Shoemake's formula with sines.");
  conversion_rows(table);
  product_rows(table);
  slerp_rows(table);
}

}  // namespace vectrix::accuracy
