#include <vectrix/kinematics/screws/screw.hpp>
#include <vectrix/kinematics/screws/screw_axis.hpp>
#include <vectrix/kinematics/screws/screw_rate.hpp>

#include "subjects.hpp"

namespace vectrix::accuracy {
namespace {

using Six = Eigen::Matrix<double, 6, 1>;
using WideSix = Eigen::Matrix<Wide, 6, 1>;

Screw<A, B> xi_of(const Eigen::Vector3d& theta, const Eigen::Vector3d& rho) {
  return screw(of<B>, relative_to<A>, vector<si::angle>(in<A>, theta), vector<si::length>(in<A>, rho));
}
WideMatrix<6> wide_ad(const Eigen::Vector3d& theta, const Eigen::Vector3d& rho) {
  WideMatrix<6> ad = WideMatrix<6>::Zero();
  ad.topLeftCorner<3, 3>() = ad.bottomRightCorner<3, 3>() = skew(widened(theta));
  ad.bottomLeftCorner<3, 3>() = skew(widened(rho));
  return ad;
}
WideMatrix<6> jacobian_series(const WideMatrix<6>& ad) {
  return WideMatrix<6>::Identity() + series<6>(ad).jacobian;
}

void exp_rows(Table& table, const Turns& kind) {
  table.row(
      "exp(xi), translation", kind.name, "|rho|",
      roundings(24, "those of the left Jacobian, applied to one vector"),
      [&](Draw& draw) {
        const Eigen::Vector3d theta = kind.draw(draw), rho = draw.vector(1e-3, 1e3);
        WideMatrix<4> generator = WideMatrix<4>::Zero();
        generator.topLeftCorner<3, 3>() = skew(widened(theta));
        generator.topRightCorner<3, 1>() = widened(rho);
        const WideColumn exact = series<4>(generator).exponential.topRightCorner<3, 1>();
        return compare(exp(xi_of(theta, rho)).translation.coordinates(), exact, widened(rho).norm(), "angle",
                       theta.norm());
      },
      kind.count);
}

void log_rows(Table& table, const Turns& kind) {
  table.row(
      "log(X), rho", kind.name, "|r|",
      roundings(65,
                "those of the inverse Jacobian 40; those of theta 25, from log(R), because theta turns "
                "rho"),
      [&](Draw& draw) {
        const Eigen::Matrix3d R = rounded_dcm(kind.draw(draw));
        const Eigen::Vector3d r = draw.vector(1e-3, 1e3);
        const Transform X{R_of<A, B>(R), displacement(of<B>, relative_to<A>, vector<si::length>(in<A>, r))};
        const WideColumn theta = rotation_vector_of(nearest_rotation(widened(R)));
        const Eigen::Vector3d found = log(X).in_reference().coordinates();
        const auto error = [&](const WideColumn& turn) {
          const WideColumn exact = inverse_of<3>(left_jacobian_series(turn)) * widened(r);
          return compare(found, exact, widened(r).norm(), "angle", static_cast<double>(turn.norm()));
        };
        const Found one = error(theta);
        const Wide angle = theta.norm();
        if (angle < 3.14L) return one;
        const Found other = error(theta - 2 * pi / angle * theta);
        return one.ulps < other.ulps ? one : other;
      },
      kind.count);
}

void six_by_six_rows(Table& table) {
  struct Domain {
    const char* name;
    double from, to;
  };
  for (const Domain& domain :
       {Domain{"tiny, 1e-300 to 1e-8 rad", 1e-300, 1e-8}, Domain{"1e-8 to 1e-2 rad", 1e-8, 1e-2},
        Domain{"1e-2 to 6 rad, across half a turn and the seam at 3 rad", 1e-2, 6.0},
        Domain{"long, 6 to 100 rad", 6.0, 100.0}}) {
    table.row("left_jacobian(xi)", domain.name,
              domain.to > 6.0 ? "|J| |theta|, for a rounding of the phase" : "|J|",
              roundings(60, "24 for J, twice; in Q cross products of cross products 9, and c_4, c_5 3"),
              [&](Draw& draw) {
                const Eigen::Vector3d theta = draw.vector(domain.from, domain.to),
                                      rho = draw.vector(1e-3, 1e3);
                const WideMatrix<6> exact = jacobian_series(wide_ad(theta, rho));
                return compare(left_jacobian(xi_of(theta, rho)), exact,
                               exact.norm() * (domain.to > 6.0 ? widened(theta).norm() : Wide(1)), "angle",
                               theta.norm());
              });
  }
  const Bound bound =
      roundings(200, "J^-1 Q J^-1: 40 twice, 60 and products 12, the inverses up to 1.6 each");
  table.row("inverse_left_jacobian(xi)", "1e-8 to 3.2 rad", "|J^-1|", bound, [](Draw& draw) {
    const Eigen::Vector3d theta = draw.vector(1e-8, 3.2), rho = draw.vector(1e-3, 1e3);
    const WideMatrix<6> exact = inverse_of<6>(jacobian_series(wide_ad(theta, rho)));
    return compare(inverse_left_jacobian(xi_of(theta, rho)), exact, exact.norm(), "angle", theta.norm());
  });
  table.row("inverse_right_jacobian(xi)", "1e-8 to 3.2 rad", "|J^-1|", bound, [](Draw& draw) {
    const Eigen::Vector3d theta = draw.vector(1e-8, 3.2), rho = draw.vector(1e-3, 1e3);
    const WideMatrix<6> exact = inverse_of<6>(jacobian_series(wide_ad(-theta, -rho)));
    return compare(inverse_right_jacobian(xi_of(theta, rho)), exact, exact.norm(), "angle", theta.norm());
  });
}

void rate_rows(Table& table) {
  table.row("twist_from(xi, xi_dot, in<A>)", "1e-8 to 6 rad", "|J| |xi_dot|",
            roundings(60, "those of the Jacobian, applied to one vector"), [](Draw& draw) {
              const Eigen::Vector3d theta = draw.vector(1e-8, 6.0), rho = draw.vector(1e-3, 1e3);
              Six rate;
              rate << draw.vector(0.1, 10.0), draw.vector(0.1, 10.0);
              const auto xidot = screw_rate(of<B>, relative_to<A>,
                                            vector<si::angular_velocity>(in<A>, rate.head<3>().eval()),
                                            vector<si::velocity>(in<A>, rate.tail<3>().eval()));
              const WideMatrix<6> J = jacobian_series(wide_ad(theta, rho));
              const WideSix exact = J * widened(rate);
              return compare(twist_from(xi_of(theta, rho), xidot, in<A>).coordinates(), exact,
                             J.norm() * widened(rate).norm(), "angle", theta.norm());
            });
  table.row("rate(xi, V_ab) of a twist in b", "1e-8 to 3.2 rad", "|J^-1| |V|",
            roundings(200, "those of the inverse Jacobian"), [](Draw& draw) {
              const Eigen::Vector3d theta = draw.vector(1e-8, 3.2), rho = draw.vector(1e-3, 1e3);
              Six V;
              V << draw.vector(0.1, 10.0), draw.vector(0.1, 10.0);
              const auto w = angular_velocity(of<B>, relative_to<A>,
                                              vector<si::angular_velocity>(in<B>, V.head<3>().eval()));
              const auto V_ab = twist(at<B>, w, vector<si::velocity>(in<B>, V.tail<3>().eval()));
              const WideMatrix<6> inverse = inverse_of<6>(jacobian_series(wide_ad(-theta, -rho)));
              const WideSix exact = inverse * widened(V);
              return compare(rate(xi_of(theta, rho), V_ab).coordinates(), exact,
                             inverse.norm() * widened(V).norm(), "angle", theta.norm());
            });
}

void axis_rows(Table& table) {
  table.row(
      "screw_along(axis)", "any", "|theta|, and |position| |theta| + |advance|",
      roundings(6, "products and sums 3, doubled"), [](Draw& draw) {
        const Eigen::Vector3d n = draw.direction(), place = draw.vector(1e-3, 1e3);
        const double angle = draw.uniform(-6.0, 6.0), advance = draw.uniform(-100.0, 100.0);
        const auto found =
            screw_along(of<B>, relative_to<A>,
                        ScrewAxis<A>{vector<si::dimensionless>(in<A>, n), vector<si::length>(in<A>, place),
                                     angle * si::radian, advance * si::metre});
        const WideColumn theta = static_cast<Wide>(angle) * widened(n);
        const WideColumn rho = widened(place).cross(theta) + static_cast<Wide>(advance) * widened(n);
        const Found one = compare(found.rotation_vector().coordinates(), theta, theta.norm(), "angle", angle);
        const Found other = compare(found.in_reference().coordinates(), rho,
                                    widened(place).norm() * theta.norm() + std::abs(advance), "angle", angle);
        return one.ulps > other.ulps ? one : other;
      });
  table.row("screw_axis(xi), position and advance", "1e-8 to 6 rad", "|rho| / |theta|, |rho|",
            roundings(16, "norm 5, two divisions, a product of vectors 4 on three components"),
            [](Draw& draw) {
              const Eigen::Vector3d theta = draw.vector(1e-8, 6.0), rho = draw.vector(1e-3, 1e3);
              const auto found = screw_axis(xi_of(theta, rho));
              const WideColumn t = widened(theta), r = widened(rho);
              const WideColumn place = t.cross(r) / t.squaredNorm();
              const Eigen::Matrix<Wide, 1, 1> advance(t.dot(r) / t.norm());
              const Eigen::Matrix<double, 1, 1> found_advance(found.advance.value());
              const Found one =
                  compare(found.place.coordinates(), place, r.norm() / t.norm(), "angle", theta.norm());
              const Found other = compare(found_advance, advance, r.norm(), "angle", theta.norm());
              return one.ulps > other.ulps ? one : other;
            });
}

}  // namespace

void screw_rows(Table& table) {
  table.section(
      "Screws: exponential, logarithm and Jacobians of rigid motions",
      "The lengths |rho| and |r| are from 1 mm to 1 km. References: the power series of the 4 by 4 matrix "
      "and of the 6 by 6 ad(xi), and their inverses by elimination with pivots. For the rotations see exp "
      "and log above.");
  for (const Turns& kind : turns()) {
    exp_rows(table, kind);
    log_rows(table, kind);
  }
  six_by_six_rows(table);
  rate_rows(table);
  axis_rows(table);
}

}  // namespace vectrix::accuracy
