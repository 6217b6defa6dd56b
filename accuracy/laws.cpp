#include <vectrix/kinematics/points/acceleration.hpp>
#include <vectrix/kinematics/rates/dcm_rate.hpp>
#include <vectrix/kinematics/screws/constant_twist.hpp>
#include <vectrix/kinematics/screws/twist_rate.hpp>

#include "subjects.hpp"

namespace vectrix::accuracy {
namespace {

template <class S> using Six = Eigen::Matrix<S, 6, 1>;

template <class To, class From, class S> auto w_of(const ColumnOf<S>& w) {
  return angular_velocity(of<To>, relative_to<From>, vector<si::angular_velocity>(in<A>, w));
}
template <class To, class From, class S> auto alpha_of(const ColumnOf<S>& alpha) {
  return angular_acceleration(of<To>, relative_to<From>, vector<si::angular_acceleration>(in<A>, alpha));
}
template <class S> auto place_of(const ColumnOf<S>& r) {
  return displacement(of<D>, relative_to<C>, vector<si::length>(in<A>, r));
}
template <class Observer, class S> auto velocity_of(const ColumnOf<S>& v) {
  return velocity(of<D>, relative_to<C>, observed_from<Observer>, vector<si::velocity>(in<A>, v));
}
template <class Of, class RelativeTo, class Place, class S> auto twist_of_numbers(const Six<S>& V) {
  const auto w = angular_velocity(of<Of>, relative_to<RelativeTo>,
                                  vector<si::angular_velocity>(in<A>, ColumnOf<S>(V.template head<3>())));
  return twist(at<Place>, w, vector<si::velocity>(in<A>, ColumnOf<S>(V.template tail<3>())));
}

// Rates, positions and their derivatives of very different magnitudes.
struct Motion {
  Eigen::Vector3d r, v, a, w, alpha;
  explicit Motion(Draw& draw)
      : r(draw.vector(1e-3, 1e3)),
        v(draw.vector(1e-3, 1e3)),
        a(draw.vector(1e-3, 1e3)),
        w(draw.vector(1e-3, 1e1)),
        alpha(draw.vector(1e-3, 1e1)) {}
};

template <class F, class Scale>
void motion_row(Table& table, const char* name, const char* scale_name, const Bound& bound, const F& f,
                const Scale& scale) {
  table.row(name, "lengths 1e-3 to 1e3, rates 1e-3 to 10", scale_name, bound, [&](Draw& draw) {
    const Motion m(draw);
    return compare(f(m.r, m.v, m.a, m.w, m.alpha),
                   f(widened(m.r), widened(m.v), widened(m.a), widened(m.w), widened(m.alpha)),
                   static_cast<Wide>(scale(m.r.norm(), m.v.norm(), m.a.norm(), m.w.norm(), m.alpha.norm())),
                   "|w|", m.w.norm());
  });
}

void point_rows(Table& table) {
  motion_row(
      table, "transport of a velocity", "|v| + |w| |r|",
      roundings(6, "cross product 4, sum, to three components 1"),
      []<class S>(const ColumnOf<S>& r, const ColumnOf<S>& v, const ColumnOf<S>&, const ColumnOf<S>& w,
                  const ColumnOf<S>&) -> ColumnOf<S> {
        return transport(observed_from<A>, velocity_of<B>(v), place_of(r), w_of<B, A>(w)).coordinates();
      },
      [](double r, double v, double, double w, double) { return v + w * r; });
  motion_row(
      table, "transport of an acceleration", "|a| + |alpha| |r| + 2 |w| |v| + |w|^2 |r|",
      roundings(14, "cross products 4, one of another; sums 4, to three components 2"),
      []<class S>(const ColumnOf<S>& r, const ColumnOf<S>& v, const ColumnOf<S>& a, const ColumnOf<S>& w,
                  const ColumnOf<S>& alpha) -> ColumnOf<S> {
        const auto a_b =
            acceleration(of<D>, relative_to<C>, observed_from<B>, vector<si::acceleration>(in<A>, a));
        return transport(observed_from<A>, a_b, velocity_of<B>(v), place_of(r), alpha_of<B, A>(alpha),
                         w_of<B, A>(w))
            .coordinates();
      },
      [](double r, double v, double a, double w, double alpha) {
        return a + alpha * r + 2 * w * v + w * w * r;
      });
  motion_row(
      table, "centrifugal_acceleration", "|w|^2 |r|",
      roundings(9, "two cross products 4, to three components 1"),
      []<class S>(const ColumnOf<S>& r, const ColumnOf<S>&, const ColumnOf<S>&, const ColumnOf<S>& w,
                  const ColumnOf<S>&) -> ColumnOf<S> {
        return centrifugal_acceleration(w_of<B, A>(w), place_of(r)).coordinates();
      },
      [](double r, double, double, double w, double) { return w * w * r; });
  motion_row(
      table, "chain of angular accelerations", "|alpha| + |a| + |w| |v|",
      roundings(7, "cross product 4, two sums, to three components 1"),
      []<class S>(const ColumnOf<S>&, const ColumnOf<S>& v, const ColumnOf<S>& a, const ColumnOf<S>& w,
                  const ColumnOf<S>& alpha) -> ColumnOf<S> {
        return chain(alpha_of<B, A>(alpha), alpha_of<C, B>(a), w_of<B, A>(w), w_of<C, B>(v)).coordinates();
      },
      [](double, double v, double a, double w, double alpha) { return alpha + a + w * v; });
}

void twist_rows(Table& table) {
  motion_row(
      table, "shift of a twist", "|w| + |v| + |w| |r|",
      roundings(6, "cross product 4, sum, to three components 1"),
      []<class S>(const ColumnOf<S>& r, const ColumnOf<S>& v, const ColumnOf<S>&, const ColumnOf<S>& w,
                  const ColumnOf<S>&) -> Six<S> {
        Six<S> V;
        V << w, v;
        return shift(twist_of_numbers<B, A, C>(V), place_of(r)).coordinates();
      },
      [](double r, double v, double, double w, double) { return w + v + w * r; });
  motion_row(
      table, "chain of twist rates", "|alpha| + |a| + |w|^2 + |w| |v|, doubled",
      roundings(12, "two cross products 4, three sums, to three components 1"),
      []<class S>(const ColumnOf<S>& r, const ColumnOf<S>& v, const ColumnOf<S>& a, const ColumnOf<S>& w,
                  const ColumnOf<S>& alpha) -> Six<S> {
        Six<S> V, W;
        V << w, v;
        W << w, r;
        const auto ab = twist_of_numbers<B, A, D>(V);
        const auto bc = twist_of_numbers<C, B, D>(W);
        const auto change = vector<si::acceleration>(in<A>, a);
        return chain(twist_rate(ab, alpha_of<B, A>(alpha), change),
                     twist_rate(bc, alpha_of<C, B>(alpha), change), ab, bc)
            .coordinates();
      },
      [](double r, double v, double a, double w, double alpha) {
        return 2 * (alpha + a + w * w + w * (v + r));
      });
  motion_row(
      table, "particle_acceleration of a twist and its rate", "|a| + |w| |v|",
      roundings(6, "cross product 4, sum, to three components 1"),
      []<class S>(const ColumnOf<S>&, const ColumnOf<S>& v, const ColumnOf<S>& a, const ColumnOf<S>& w,
                  const ColumnOf<S>& alpha) -> ColumnOf<S> {
        Six<S> V;
        V << w, v;
        const auto ab = twist_of_numbers<B, A, D>(V);
        const auto rate = twist_rate(ab, alpha_of<B, A>(alpha), vector<si::acceleration>(in<A>, a));
        return particle_acceleration(ab, rate).coordinates() +
               rate.velocity_rate().coordinates();  // converts both ways: a again, and vdot
      },
      [](double, double v, double a, double w, double) { return 2 * (a + w * v); });
  table.row("X_c_from_b * V_ab, and adjoint(X) V", "|r| 1e-3 to 1e3, rates 1e-3 to 10", "|w| + |v| + |r| |w|",
            roundings(24,
                      "two products with a matrix 6, one counted again in a cross product 4; sum 1, to six "
                      "components"),
            [](Draw& draw) {
              const Eigen::Matrix3d R = any_dcm(draw);
              const Eigen::Vector3d r = draw.vector(1e-3, 1e3);
              Six<double> V;
              V << draw.vector(1e-3, 1e1), draw.vector(1e-3, 1e1);
              const auto X =
                  Transform{R_of<C, A>(R), displacement(of<A>, relative_to<C>, vector<si::length>(in<C>, r))};
              const Six<double> typed = (X * twist_of_numbers<B, D, A>(V)).coordinates();
              const Six<double> bare = adjoint(X) * V;
              Six<Wide> exact;
              exact.head<3>() = widened(R) * widened(V).head<3>();
              exact.tail<3>() = widened(R) * widened(V).tail<3>() + widened(r).cross(exact.head<3>());
              const Wide scale = static_cast<Wide>(V.head<3>().norm() * (1 + r.norm()) + V.tail<3>().norm());
              const Found one = compare(typed, exact, scale, "|r|", r.norm());
              const Found other = compare(bare, exact, scale, "|r|", r.norm());
              return one.ulps > other.ulps ? one : other;
            });
  table.row(
      "moved(X, V_ab, t), translation", "|theta| to 6 rad, |r|, |v| t 1e-3 to 1e3", "|r| + |v| t",
      roundings(44, "the screw 2, exp 24, the product with R 8; as a turn of up to 6 rad the screw again 6"),
      [](Draw& draw) {
        const Eigen::Matrix3d R = any_dcm(draw);
        const Eigen::Vector3d r = draw.vector(1e-3, 1e3), w = draw.vector(1e-6, 3.0),
                              v = draw.vector(1e-3, 1e3);
        const double t = draw.uniform(0.0, 2.0);
        const auto X =
            Transform{R_of<A, B>(R), displacement(of<B>, relative_to<A>, vector<si::length>(in<A>, r))};
        const auto V =
            twist(at<B>, angular_velocity(of<B>, relative_to<A>, vector<si::angular_velocity>(in<B>, w)),
                  vector<si::velocity>(in<B>, v));
        const WideColumn theta = static_cast<Wide>(t) * widened(w);
        const WideColumn rho = static_cast<Wide>(t) * widened(v);
        const WideColumn exact = widened(r) + widened(R) * (left_jacobian_series(theta) * rho);
        return compare(moved(X, V, t * si::second).translation.coordinates(), exact,
                       widened(r).norm() + rho.norm(), "angle", w.norm() * t);
      });
}

void rate_rows(Table& table) {
  const Bound bound = roundings(6, "two products and a difference, to nine entries with two shares of w");
  table.row("rate(R, w_ab_b)", "any; |w| 1e-3 to 10", "|w|", bound, [](Draw& draw) {
    const Eigen::Matrix3d R = any_dcm(draw);
    const Eigen::Vector3d w = draw.vector(1e-3, 1e1);
    const auto w_ab_b = angular_velocity(of<B>, relative_to<A>, vector<si::angular_velocity>(in<B>, w));
    return compare(rate(R_of<A, B>(R), w_ab_b).matrix(), WideSquare(widened(R) * skew(widened(w))),
                   widened(w).norm(), "|w|", w.norm());
  });
  table.row("rate(R, w_ab_a)", "any; |w| 1e-3 to 10", "|w|", bound, [](Draw& draw) {
    const Eigen::Matrix3d R = any_dcm(draw);
    const Eigen::Vector3d w = draw.vector(1e-3, 1e1);
    return compare(rate(R_of<A, B>(R), w_of<B, A>(w)).matrix(), WideSquare(skew(widened(w)) * widened(R)),
                   widened(w).norm(), "|w|", w.norm());
  });
  table.row(
      "rate(q, w_ab_b)", "any; |w| 1e-3 to 10", "|w| / 2", roundings(8, "a product of quaternions"),
      [](Draw& draw) {
        const Eigen::Vector4d q = draw.quaternion();
        const Eigen::Vector3d w = draw.vector(1e-3, 1e1);
        const auto w_ab_b = angular_velocity(of<B>, relative_to<A>, vector<si::angular_velocity>(in<B>, w));
        const WideColumn half = widened(w) / 2;
        const WideQuaternion exact = wide_quaternion(q) * WideQuaternion(0, half.x(), half.y(), half.z());
        return compare(rate(q_of<A, B>(q), w_ab_b).eigen().coeffs(), exact.coeffs(), half.norm(), "|w|",
                       w.norm());
      });
  table.row("angular_velocity_from(R, Rdot, in<B>)", "any; |w| 1e-3 to 10", "|w|",
            roundings(14, "a product of matrices 11, half a difference 2; R is 1 away from the rotations"),
            [](Draw& draw) {
              const Eigen::Matrix3d R = any_dcm(draw);
              const Eigen::Vector3d w = draw.vector(1e-3, 1e1);
              const Eigen::Matrix3d Rdot = (widened(R) * skew(widened(w))).cast<double>();
              const auto Rdot_a_from_b = dcm_rate(R_of<A, B>(R), Rdot);
              const WideSquare exact = widened(R).transpose() * widened(Rdot);
              const WideColumn vee((exact(2, 1) - exact(1, 2)) / 2, (exact(0, 2) - exact(2, 0)) / 2,
                                   (exact(1, 0) - exact(0, 1)) / 2);
              return compare(angular_velocity_from(R_of<A, B>(R), Rdot_a_from_b, in<B>).coordinates(), vee,
                             vee.norm(), "|w|", w.norm());
            });
}

}  // namespace

void law_rows(Table& table) {
  table.section("Rates, accelerations and twists",
                "Rounding alone, except for `moved`: the power series. The scale is the sum of the sizes "
                "of the terms, because they may cancel.");
  point_rows(table);
  twist_rows(table);
  rate_rows(table);
}

}  // namespace vectrix::accuracy
