#include <vectrix/kinematics/attitude/exp.hpp>

#include "subjects.hpp"

namespace vectrix::accuracy {
namespace {

const Bound exp_bound =
    roundings(12, "|theta|^2 5, its root, half, sine or cosine 2, quotient, product, the given half");
const Bound dcm_bound = roundings(24, "the quaternion's 12, counted twice");
const Bound log_bound =
    roundings(17, "|v|^2 5, root, arc tangent 5, its quotient by |v| 2, products 2, rest 2");
const Bound log_dcm_bound =
    roundings(25, "log's 17; before it those of q, counted twice in the angle: sums of entries 3, scaling 1");

void exp_rows(Table& table) {
  for (const Turns& kind : turns()) {
    table.row(
        "exp_quaternion(theta)", kind.name, "1", exp_bound,
        [&](Draw& draw) {
          const Eigen::Vector3d theta = kind.draw(draw);
          const Eigen::Vector4d q = exp_quaternion(theta_of(theta)).eigen().coeffs();
          return compare_up_to_sign(q, quaternion_of(exponential(widened(theta))), "angle", theta.norm());
        },
        kind.count);
    table.row(
        "exp(theta)", kind.name, "1", dcm_bound,
        [&](Draw& draw) {
          const Eigen::Vector3d theta = kind.draw(draw);
          return compare(exp(theta_of(theta)).matrix(), exponential(widened(theta)), 1, "angle",
                         theta.norm());
        },
        kind.count);
  }
  table.row("exp(theta), the vector part of R - I", "tiny, 1e-300 to 1e-8 rad", "|theta|", dcm_bound,
            [](Draw& draw) {
              const Eigen::Vector3d theta = draw.vector(1e-300, 1e-8);
              const Eigen::Matrix3d R = exp(theta_of(theta)).matrix();
              const WideSquare exact = series<3>(skew(widened(theta))).exponential;
              const Eigen::Vector3d off(R(2, 1), R(0, 2), R(1, 0));
              const WideColumn exact_off(exact(2, 1), exact(0, 2), exact(1, 0));
              return compare(off, exact_off, widened(theta).norm(), "angle", theta.norm());
            });
  table.row("exp(theta)", "long, 3.14 to 1e3 rad", "|theta|", dcm_bound, [](Draw& draw) {
    const Eigen::Vector3d theta = draw.vector(3.14, 1e3);
    return compare(exp(theta_of(theta)).matrix(), exponential(widened(theta)), widened(theta).norm(), "angle",
                   theta.norm());
  });
}

void log_rows(Table& table) {
  for (const Turns& kind : turns()) {
    table.row(
        "log(q)", kind.name, "|theta|", log_bound,
        [&](Draw& draw) {
          const Eigen::Vector4d q = rounded_quaternion(kind.draw(draw));
          return compare_turns(log(q_of<A, B>(q)).coordinates(), rotation_vector_of(wide_quaternion(q)));
        },
        kind.count);
    table.row(
        "log(R)", kind.name, "|theta|", log_dcm_bound,
        [&](Draw& draw) {
          const Eigen::Matrix3d R = rounded_dcm(kind.draw(draw));
          return compare_turns(log(R_of<A, B>(R)).coordinates(),
                               rotation_vector_of(nearest_rotation(widened(R))));
        },
        kind.count);
  }
}

}  // namespace

void rotation_rows(Table& table) {
  table.section("Exponential and logarithm of rotations",
                "References: the power series of the matrix exponential; the arc tangent of the nearest "
                "rotation's quaternion. At half a turn +n and -n are both right.");
  exp_rows(table);
  log_rows(table);
}

}  // namespace vectrix::accuracy
