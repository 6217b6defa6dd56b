#include <vectrix/kinematics/attitude/jacobian.hpp>

#include "subjects.hpp"

namespace vectrix::accuracy {
namespace {

const Bound jacobian_bound = roundings(
    24,
    "|theta|^2 5, c_2 and c_3 6, cross products 3 and 3, sums 2, of three columns, the norm being above 1");
const Bound inverse_bound = roundings(40, "the Jacobian's 24, and those of c_4 and the quotient e 8, twice");

struct Domain {
  std::string name;
  double from, to;
  bool even;
};

void forward_rows(Table& table) {
  const Domain domains[] = {
      {"tiny, 1e-300 to 1e-8 rad", 1e-300, 1e-8, false},
      {"small, 1e-8 to 1e-2 rad", 1e-8, 1e-2, false},
      {"1e-2 to 6.29 rad, across half a turn, the seam at 3 rad and a full turn", 1e-2, 6.29, true},
      {"long, 6 to 100 rad", 6.0, 100.0, false}};
  for (const Domain& domain : domains) {
    const auto draw_theta = [&](Draw& draw) -> Eigen::Vector3d {
      return domain.even ? draw.uniform(domain.from, domain.to) * draw.direction()
                         : draw.vector(domain.from, domain.to);
    };
    table.row("left_jacobian(theta)", domain.name, "|J|", jacobian_bound, [&](Draw& draw) {
      const Eigen::Vector3d theta = draw_theta(draw);
      const WideSquare exact = left_jacobian_series(widened(theta));
      return compare(left_jacobian(theta_of(theta)), exact, exact.norm(), "angle", theta.norm());
    });
    table.row("right_jacobian(theta)", domain.name, "|J|", jacobian_bound, [&](Draw& draw) {
      const Eigen::Vector3d theta = draw_theta(draw);
      const WideSquare exact = left_jacobian_series(-widened(theta));
      return compare(right_jacobian(theta_of(theta)), exact, exact.norm(), "angle", theta.norm());
    });
  }
}

// Rows for any theta, and for theta near a full turn: there a rounding of theta is divided by the distance of
// |theta| from the full turn.
template <bool left> void inverse_rows(Table& table) {
  const std::string name = left ? "inverse_left_jacobian(theta)" : "inverse_right_jacobian(theta)";
  const auto error = [](const Eigen::Vector3d& theta, bool near) {
    const WideColumn wide = left ? widened(theta) : WideColumn(-widened(theta));
    const WideSquare exact = inverse_of(left_jacobian_series(wide));
    const Wide distance = std::abs(2 * pi - wide.norm());
    const Wide condition = near ? 2 * pi / distance : 1;
    const auto x = theta_of(theta);
    return compare(left ? inverse_left_jacobian(x) : inverse_right_jacobian(x), exact,
                   exact.norm() * condition, near ? "rad from a full turn" : "angle",
                   near ? static_cast<double>(distance) : theta.norm());
  };
  table.row(name, "tiny, 1e-300 to 1e-8 rad", "|J^-1|", inverse_bound,
            [&](Draw& draw) { return error(draw.vector(1e-300, 1e-8), false); });
  table.row(name, "small, 1e-8 to 1e-2 rad", "|J^-1|", inverse_bound,
            [&](Draw& draw) { return error(draw.vector(1e-8, 1e-2), false); });
  table.row(name, "1e-2 to 4 rad, across half a turn and the seam at 3 rad", "|J^-1|", inverse_bound,
            [&](Draw& draw) { return error(draw.uniform(1e-2, 4.0) * draw.direction(), false); });
  table.row(name, "1e-12 to 2 rad from a full turn", "|J^-1| 2 pi / distance", inverse_bound,
            [&](Draw& draw) {
              const double distance = draw.logarithmic(1e-12, 2.0);
              const double side = draw.uniform(-1.0, 1.0) < 0.0 ? -1.0 : 1.0;
              return error((2 * std::numbers::pi + side * distance) * draw.direction(), true);
            });
}

}  // namespace

void jacobian_rows(Table& table) {
  table.section(
      "Jacobians of the rotation vector",
      "References: the power series of [theta]x, summed for a small part of theta and then doubled "
      "repeatedly; the inverse of the result. Near a full turn the inverse is ill-conditioned: the scale "
      "says how a rounding of theta grows.");
  forward_rows(table);
  inverse_rows<true>(table);
  inverse_rows<false>(table);
}

}  // namespace vectrix::accuracy
