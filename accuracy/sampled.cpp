#include <vectrix/kinematics/samples/rotation_spline.hpp>
#include <vectrix/kinematics/steps/group_runge_kutta.hpp>

#include "subjects.hpp"

namespace vectrix::accuracy {
namespace {

// One step of R' = R [w0 + t w1 + R^T w2]x; the columns of W are w0, w1 and w2.
template <int method, class S>
SquareOf<S> stepped(const SquareOf<S>& R, const SquareOf<S>& W, const FourOf<S>& when) {
  const auto rate = [&](const Quantity<si::time, S>& t, const Dcm<A, B, S>& R_a_from_b) {
    const ColumnOf<S> w = W.col(0) + t.value() * W.col(1) + R_a_from_b.matrix().transpose() * W.col(2);
    return angular_velocity(of<B>, relative_to<A>, vector<si::angular_velocity>(in<B>, w));
  };
  const auto t = Quantity<si::time, S>::from_value(when(0)), dt = Quantity<si::time, S>::from_value(when(1));
  if constexpr (method == 0) {
    return commutator_free_step(rate, R_of<A, B>(R), t, dt).matrix();
  } else {
    return munthe_kaas_step<method>(rate, R_of<A, B>(R), t, dt).matrix();
  }
}
template <int method> void step_row(Table& table, const char* name, const Bound& bound) {
  table.row(name, "rates to 1 rad/s, steps 1e-6 to 0.5 s", "1", bound, [](Draw& draw) {
    const Eigen::Matrix3d R = any_dcm(draw);
    Eigen::Matrix3d W;
    W << draw.cube(0.3), draw.cube(0.3), draw.cube(0.3);
    const Eigen::Vector4d when(draw.uniform(-1.0, 0.0), draw.logarithmic(1e-6, 0.5), 0, 0);
    return compare(stepped<method, double>(R, W, when),
                   stepped<method, Wide>(widened(R), widened(W), widened(when)), 1, "dt", when(1));
  });
}

// The motion at a time: R, w, alpha in five columns.
template <class S> using Fifteen = Eigen::Matrix<S, 3, 5>;
template <class S> Fifteen<S> splined(const std::vector<Eigen::Vector4d>& q, double t) {
  std::vector<AttitudeSample<A, B, Quantity<si::time, S>>> samples;
  for (std::size_t i = 0; i < q.size(); ++i) {
    const auto when = Quantity<si::time, S>::from_value(S(static_cast<double>(i)));
    samples.push_back({when, q_of<A, B>(FourOf<S>(q[i].cast<S>()))});
  }
  const RotationSpline<A, B, Quantity<si::time, S>> spline(samples, Quantity<si::time, S>::from_value(S(2)),
                                                           natural_ends);
  const auto motion = spline(Quantity<si::time, S>::from_value(S(t)));
  Fifteen<S> numbers;
  numbers << rotation_of(motion).matrix(), motion.angular_velocity.coordinates(),
      motion.angular_acceleration.coordinates();
  return numbers;
}
template <int first, int count>
void spline_row(Table& table, const char* name, const char* scale_name, double scale, const Bound& bound) {
  table.row(name, "6 samples a second apart, to 1 rad from one to the next", scale_name, bound,
            [=](Draw& draw) {
              std::vector<Eigen::Vector4d> q = {draw.quaternion()};
              for (int i = 0; i < 5; ++i) {
                const WideQuaternion turn =
                    wide_quaternion(rounded_quaternion(draw.uniform(0.0, 1.0) * draw.direction()));
                q.push_back((wide_quaternion(q.back()) * turn).coeffs().cast<double>());
              }
              const double t = draw.uniform(0.0, 5.0);
              const Fifteen<double> found = splined<double>(q, t);
              const Fifteen<Wide> exact = splined<Wide>(q, t);
              return compare(found.middleCols<count>(first).eval(), exact.middleCols<count>(first).eval(),
                             static_cast<Wide>(scale), "t", t);
            });
}

}  // namespace

void sampled_rows(Table& table) {
  table.section("Steps with a rate that depends on the attitude, and the spline through samples",
                "Rounding alone: the same rules in `long double`.");
  step_row<4>(
      table, "munthe_kaas_step<4>",
      roundings(95,
                "exp 24 and the product 11 of the step, and half of that in each of three stages; the "
                "rates 5 each"));
  step_row<5>(
      table, "munthe_kaas_step<5>",
      roundings(330,
                "exp 24 and the product 11 of the step; in each of six stages the same, with weights of up "
                "to 8 in all, for at most half a radian"));
  step_row<0>(table, "commutator_free_step",
              roundings(120, "two exp 24 and two products 11; half of that in each of three stages"));
  const Bound bound = {64 + 60,
                       "the iteration for the rates at the samples stops when they change by less than 64 "
                       "ulp; slerp's 60 roundings twice"};
  spline_row<0, 3>(table, "RotationSpline, rotation", "1", 1.0, bound);
  spline_row<3, 1>(table, "RotationSpline, rate", "1 rad/s", 1.0, bound);
  spline_row<4, 1>(table, "RotationSpline, acceleration", "6 rad/s^2: 6 turns of a radian, over h^2", 6.0,
                   bound);
}

}  // namespace vectrix::accuracy
