#include <vectrix/kinematics/steps/coning.hpp>
#include <vectrix/kinematics/steps/exponential_step.hpp>
#include <vectrix/kinematics/steps/magnus.hpp>

#include "subjects.hpp"

namespace vectrix::accuracy {
namespace {

template <class S> auto rate_of(const ColumnOf<S>& w) {
  return angular_velocity(of<B>, relative_to<A>, vector<si::angular_velocity>(in<B>, w));
}
template <class S> auto seconds(const S& t) {
  return Quantity<si::time, S>::from_value(t);
}

// The rate is a polynomial of time, so that both arithmetics integrate the same function.
template <int order, class S>
ColumnOf<S> magnus(const ColumnOf<S>& w0, const ColumnOf<S>& w1, const ColumnOf<S>& w2,
                   const FourOf<S>& when) {
  const auto rate = [&](const Quantity<si::time, S>& t) {
    return rate_of<S>(w0 + t.value() * (w1 + t.value() * w2));
  };
  return magnus_increment<order>(rate, seconds(when(0)), seconds(when(1))).coordinates();
}

template <int order> void magnus_row(Table& table, const Bound& bound) {
  table.row("magnus_increment<" + std::to_string(order) + ">",
            "polynomial rates to 2 rad/s, steps 1e-6 to 1 s", "(|w0| + |w1| + |w2|) dt", bound,
            [](Draw& draw) {
              const Eigen::Vector3d w0 = draw.cube(1.0), w1 = draw.cube(1.0), w2 = draw.cube(1.0);
              const Eigen::Vector4d when(draw.uniform(-1.0, 0.0), draw.logarithmic(1e-6, 1.0), 0, 0);
              const auto f = []<class S>(const ColumnOf<S>& a, const ColumnOf<S>& b, const ColumnOf<S>& c,
                                         const FourOf<S>& t) { return magnus<order, S>(a, b, c, t); };
              const Wide scale = widened(w0).norm() + widened(w1).norm() + widened(w2).norm();
              return compare(f(w0, w1, w2, when), f(widened(w0), widened(w1), widened(w2), widened(when)),
                             scale * when(1), "dt", when(1));
            });
}

template <class S> auto count_of(const ColumnOf<S>& alpha) {
  return angle_increment(of<B>, relative_to<A>, vector<si::angle>(in<B>, alpha));
}
void coning_rows(Table& table) {
  const auto row = [&](const char* name, const Bound& bound, const auto& f) {
    table.row(name, "counts of 1e-9 to 1 rad", "sum of |alpha|", bound, [&](Draw& draw) {
      const Eigen::Vector3d a = draw.vector(1e-9, 1.0), b = draw.vector(1e-9, 1.0),
                            c = draw.vector(1e-9, 1.0);
      const Wide scale = widened(a).norm() + widened(b).norm() + widened(c).norm();
      return compare(f(a, b, c), f(widened(a), widened(b), widened(c)), scale, "|alpha_1|", a.norm());
    });
  };
  row("coning_corrected(alpha_1, alpha_2)", roundings(10, "cross product 4, coefficient 2, sums 2, factor 2"),
      []<class S>(const ColumnOf<S>& a, const ColumnOf<S>& b, const ColumnOf<S>&) -> ColumnOf<S> {
        return coning_corrected(count_of<S>(a), count_of<S>(b)).coordinates();
      });
  row("coning_corrected(alpha_1, alpha_2, alpha_3)",
      roundings(20, "two cross products 4, their coefficients 2 each, sums 4, a difference"),
      []<class S>(const ColumnOf<S>& a, const ColumnOf<S>& b, const ColumnOf<S>& c) -> ColumnOf<S> {
        return coning_corrected(count_of<S>(a), count_of<S>(b), count_of<S>(c)).coordinates();
      });
  row("coning_corrected_after(alpha_1, alpha_2)", roundings(8, "cross product 4, division 1, sum 1"),
      []<class S>(const ColumnOf<S>& a, const ColumnOf<S>& b, const ColumnOf<S>&) -> ColumnOf<S> {
        return coning_corrected_after(count_of<S>(a), count_of<S>(b)).coordinates();
      });
}

void attitude_rows(Table& table) {
  const Bound bound = roundings(44, "w dt 1, as an angle of up to 4 rad; exp 24; the product 11");
  const auto exact_step = [](const Eigen::Matrix3d& R, const Eigen::Vector3d& w, double dt) -> WideSquare {
    return widened(R) * exponential(static_cast<Wide>(dt) * widened(w));
  };
  table.row("exponential_step(R, w, dt)", "|w| dt to 3.9 rad", "1", bound, [&](Draw& draw) {
    const Eigen::Matrix3d R = any_dcm(draw);
    const Eigen::Vector3d w = draw.vector(1e-6, 3.9);
    const double dt = draw.uniform(0.0, 1.0);
    const Eigen::Matrix3d found = exponential_step(R_of<A, B>(R), rate_of<double>(w), seconds(dt)).matrix();
    return compare(found, exact_step(R, w, dt), 1, "|w|", w.norm());
  });
  table.row("exponential_step(q, w, dt)", "|w| dt to 3.9 rad", "1",
            roundings(24, "w dt 1, half an angle of up to 4 rad; exp 12; the product 8"), [&](Draw& draw) {
              const Eigen::Vector4d q = draw.quaternion();
              const Eigen::Vector3d w = draw.vector(1e-6, 3.9);
              const double dt = draw.uniform(0.0, 1.0);
              const Eigen::Vector4d found =
                  exponential_step(q_of<A, B>(q), rate_of<double>(w), seconds(dt)).eigen().coeffs();
              const WideQuaternion turn = quaternion_of(exponential(static_cast<Wide>(dt) * widened(w)));
              return compare_up_to_sign(found, wide_quaternion(q) * turn, "|w|", w.norm());
            });
  table.row("first_order_step(R, w, dt), against its own law", "|w| dt to 3.9 rad", "1 + |w| dt",
            roundings(14, "w dt 1, the product 11, the sum 2"), [](Draw& draw) {
              const Eigen::Matrix3d R = any_dcm(draw);
              const Eigen::Vector3d w = draw.vector(1e-6, 3.9);
              const double dt = draw.uniform(0.0, 1.0);
              const Eigen::Matrix3d found =
                  first_order_step(R_of<A, B>(R), rate_of<double>(w), seconds(dt)).matrix();
              const WideColumn theta = static_cast<Wide>(dt) * widened(w);
              const WideSquare exact = widened(R) + widened(R) * skew(theta);
              return compare(found, exact, 1 + theta.norm(), "|w|", w.norm());
            });
}

}  // namespace

void step_rows(Table& table) {
  table.section(
      "Increments and steps",
      "Rounding alone: the truncation error of the rules is a question of their order, not of rounding. "
      "Reference for the exponential step: the power series.");
  magnus_row<2>(table, roundings(20, "the time 2, the polynomial 4, counted in full; three components"));
  magnus_row<4>(table,
                roundings(40, "the polynomial 6 at two times; cross product 4, coefficients 4, sums 2"));
  magnus_row<6>(
      table,
      roundings(120,
                "the polynomial 6 at three times, differences multiplied by up to 13; cross products 4 x 4"));
  coning_rows(table);
  attitude_rows(table);
}

}  // namespace vectrix::accuracy
