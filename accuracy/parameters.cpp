#include <vectrix/kinematics/attitude/axis_angle.hpp>
#include <vectrix/kinematics/attitude/exp.hpp>
#include <vectrix/kinematics/attitude/gibbs_vector.hpp>
#include <vectrix/kinematics/attitude/modified_rodrigues.hpp>

#include "subjects.hpp"

namespace vectrix::accuracy {
namespace {

AxisAngle<A, B> axis_angle_from(const Eigen::Vector3d& axis, double angle) {
  return axis_angle(of<B>, relative_to<A>, vector<si::dimensionless>(in<A>, axis), angle * si::radian);
}
GibbsVector<A, B> gibbs_from(const Eigen::Vector3d& g) {
  return gibbs_vector(of<B>, relative_to<A>, vector<si::dimensionless>(in<A>, g));
}
ModifiedRodrigues<A, B> rodrigues_from(const Eigen::Vector3d& sigma) {
  return modified_rodrigues(of<B>, relative_to<A>, vector<si::dimensionless>(in<A>, sigma));
}

// The relative error of the angle, together with the error of the axis. A zero turn may have any axis.
Found axis_angle_error(const AxisAngle<A, B>& x, const WideColumn& theta) {
  const Wide angle = theta.norm();
  if (angle == 0) return {std::abs(static_cast<Wide>(x.angle().value())) * ulps_in_one, "angle", 0};
  const Eigen::Matrix<Wide, 4, 1> numbers = widened(x.coordinates());
  Eigen::Matrix<Wide, 4, 1> found = numbers, exact;
  found(0) /= angle;
  exact << 1, theta / angle;
  const Found one = compare(found, exact, 1, "angle", static_cast<double>(angle));
  if (angle < 3.14L) return one;
  exact << 2 * pi / angle - 1, -theta / angle;
  const Found other = compare(found, exact, 1, "angle", static_cast<double>(angle));
  return one.ulps < other.ulps ? one : other;
}

void axis_angle_rows(Table& table) {
  for (const Turns& kind : turns()) {
    table.row(
        "axis_angle(q), angle relative to itself, and axis", kind.name, "1",
        roundings(16, "scaling 1, norm 4, product 1, arc tangent 5; division 1 of three components"),
        [&](Draw& draw) {
          const Eigen::Vector4d q = rounded_quaternion(kind.draw(draw));
          return axis_angle_error(axis_angle(q_of<A, B>(q)), rotation_vector_of(wide_quaternion(q)));
        },
        kind.count);
  }
  table.row("quaternion(angle and axis)", "any axis; |angle| from 1e-300 to 1e6 rad", "1",
            roundings(6, "sine and cosine 2 each, product, of three components"), [](Draw& draw) {
              const double angle = draw.logarithmic(1e-300, 1e6);
              const Eigen::Vector3d axis = draw.direction();
              const Eigen::Vector4d q = quaternion(axis_angle_from(axis, angle)).eigen().coeffs();
              const Wide half = static_cast<Wide>(angle) / 2;
              Eigen::Matrix<Wide, 4, 1> exact;
              exact << std::sin(half) * widened(axis), std::cos(half);
              return compare(q, exact, 1, "angle", angle);
            });
  table.row(
      "dcm(angle and axis)", "any axis; 0 to 6.28 rad", "1",
      roundings(30, "the quaternion's 6 and the length of the given axis 2, counted 2 to 4 times; dcm(q) 12"),
      [](Draw& draw) {
        const double angle = draw.uniform(0.0, 6.28);
        const Eigen::Vector3d axis = draw.direction();
        const WideColumn theta = static_cast<Wide>(angle) * widened(axis).normalized();
        return compare(dcm(axis_angle_from(axis, angle)).matrix(), exponential(theta), 1, "angle", angle);
      });
}

void gibbs_rows(Table& table) {
  const auto from_quaternion = [](const Eigen::Vector4d& q) {
    const WideColumn exact = widened(q).head<3>() / static_cast<Wide>(q(3));
    return compare(gibbs_vector(q_of<A, B>(q)).coordinates(), exact, exact.norm(), "|g|",
                   static_cast<double>(exact.norm()));
  };
  for (std::size_t i = 0; i < 4; ++i) {  // omitted at half a turn
    const Turns& kind = turns()[i];
    table.row("gibbs_vector(q)", kind.name, "|g|", roundings(2, "a division, of three components"),
              [&](Draw& draw) { return from_quaternion(rounded_quaternion(kind.draw(draw))); });
    table.row("gibbs_vector(R), backward", kind.name, "1",
              roundings(20, "quaternion(R) 10, counted twice in the angle"), [&](Draw& draw) {
                const Eigen::Matrix3d R = rounded_dcm(kind.draw(draw));
                const WideColumn g = widened(gibbs_vector(R_of<A, B>(R)).coordinates());
                const WideQuaternion found(1, g.x(), g.y(), g.z());
                return Found{turn_between(nearest_rotation(widened(R)), rotation_of(found)) * ulps_in_one,
                             "|g|", static_cast<double>(g.norm())};
              });
  }
  table.row("quaternion(g)", "|g| from 1e-300 to 1e12", "1",
            roundings(12, "|g|^2 3, sum, root 1, the division 1, of four components"), [](Draw& draw) {
              const Eigen::Vector3d g = draw.vector(1e-300, 1e12);
              Eigen::Matrix<Wide, 4, 1> exact;
              exact << widened(g), 1;
              exact.normalize();
              return compare(quaternion(gibbs_from(g)).eigen().coeffs(), exact, 1, "|g|", g.norm());
            });
}

void rodrigues_rows(Table& table) {
  for (const Turns& kind : turns()) {
    table.row(
        "modified_rodrigues(q)", kind.name, "|sigma|",
        roundings(6, "sum and division, of three components; the length of q 2"),
        [&](Draw& draw) {
          const Eigen::Vector4d q = rounded_quaternion(kind.draw(draw));
          const WideQuaternion unit = wide_quaternion(q).normalized();
          const bool longer = unit.w() < 0;
          const WideColumn exact = (longer ? -1 : 1) * unit.vec() / (1 + std::abs(unit.w()));
          const Eigen::Vector3d found = modified_rodrigues(q_of<A, B>(q)).coordinates();
          const Wide scale = exact.norm() > 0 ? exact.norm() : 1;
          const Found one = compare(found, exact, scale, "|sigma|", found.norm());
          if (std::abs(unit.w()) > 1e-15L) return one;
          const Found other = compare(found, WideColumn(-exact), scale, "|sigma|", found.norm());
          return one.ulps < other.ulps ? one : other;
        },
        kind.count);
  }
  table.row("quaternion(sigma)", "|sigma| from 1e-300 to 1e12", "1",
            roundings(14, "|sigma|^2 3, counted twice, sum, quotient, products 2, of four components"),
            [](Draw& draw) {
              const Eigen::Vector3d sigma = draw.vector(1e-300, 1e12);
              const Wide square = widened(sigma).squaredNorm();
              Eigen::Matrix<Wide, 4, 1> exact;
              exact << 2 * widened(sigma), 1 - square;
              exact /= 1 + square;
              return compare(quaternion(rodrigues_from(sigma)).eigen().coeffs(), exact, 1, "|sigma|",
                             sigma.norm());
            });
  const Bound shadow_bound = roundings(14, "norm 4, counted twice, two divisions, of three components");
  table.row("sigma.shadow()", "|sigma| from 1e-12 to 1e12", "|shadow|", shadow_bound, [](Draw& draw) {
    const Eigen::Vector3d sigma = draw.vector(1e-12, 1e12);
    const WideColumn exact = -widened(sigma) / widened(sigma).squaredNorm();
    return compare(rodrigues_from(sigma).shadow().coordinates(), exact, exact.norm(), "|sigma|",
                   sigma.norm());
  });
  table.row("switch_to_shadow(sigma)", "|sigma| from 1e-3 to 1e3; within 1e-15 of 1, either of the two sets",
            "|result|", shadow_bound, [](Draw& draw) {
              const Eigen::Vector3d sigma = draw.vector(1e-3, 1e3);
              const Wide square = widened(sigma).squaredNorm();
              const Eigen::Vector3d found = switch_to_shadow(rodrigues_from(sigma)).parameters.coordinates();
              const WideColumn own = widened(sigma), shadow = -own / square;
              const WideColumn& exact = square > 1 ? shadow : own;
              const Found one = compare(found, exact, exact.norm(), "|sigma|", sigma.norm());
              if (std::abs(square - 1) > 1e-15L) return one;
              const WideColumn& twin = square > 1 ? own : shadow;
              const Found other = compare(found, twin, twin.norm(), "|sigma|", sigma.norm());
              return one.ulps < other.ulps ? one : other;
            });
}

}  // namespace

void parameter_rows(Table& table) {
  table.section("Angle and axis, Gibbs vector, modified Rodrigues parameters",
                "References: the definitions, and for the DCM the power series. For q: the result of q/|q|.");
  axis_angle_rows(table);
  gibbs_rows(table);
  rodrigues_rows(table);
}

}  // namespace vectrix::accuracy
