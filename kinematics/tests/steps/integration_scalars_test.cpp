#include <gtest/gtest.h>

#include "testing/motions.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace integration_scalars_test {
namespace {

/// A rate and one step of each kind, of any scalar.
template <class S> AngularVelocity<Gcrf, Body, In<Body>, S> rate_of(const Quantity<si::time, S>& t) {
  using std::cos;
  using std::sin;
  const S c = cos(t.value()), s = sin(t.value());  // numbers, not Eigen's expressions
  return angular_velocity(of<Body>, relative_to<Gcrf>,
                          vector<si::angular_velocity>(in<Body>, Eigen::Matrix<S, 3, 1>(c, s, S(2))));
}
template <class S> Eigen::Matrix<S, 3, 3> several_steps(const S& dt) {
  const auto h = Quantity<si::time, S>::from_value(dt);
  const auto t = Quantity<si::time, S>::from_value(S(0.5));
  const auto rate = [](const auto& now, const Dcm<Gcrf, Body, S>&) { return rate_of<S>(now); };
  Dcm<Gcrf, Body, S> R = exponential_step(aligned<S>(to<Gcrf>, from<Body>), rate_of<S>(t), h);
  R = advance(R, magnus_increment<6>(rate_of<S>, t, h));
  R = commutator_free_step(rate, munthe_kaas_step<5>(rate, R, t, h), t, h);
  const auto alpha = [&](double part) {
    const S seconds = S(part) * dt;
    const Eigen::Matrix<S, 3, 1> angle = rate_of<S>(t).coordinates() * seconds;
    return angle_increment(of<Body>, relative_to<Gcrf>, vector<si::angle>(in<Body>, angle));
  };
  R = advance(R, coning_corrected(alpha(0.2), alpha(0.3), alpha(0.5)));
  return first_order_step(R, rate_of<S>(t), h).matrix();
}

TEST(Steps, TakeOtherScalars) {
  const double h = 0.3;
  const Eigen::Matrix3d of_double = several_steps<double>(h);
  EXPECT_LE(distance(several_steps<float>(0.3F).cast<double>(), of_double), 1e-5);
  EXPECT_LE(distance(several_steps<long double>(0.3L).cast<double>(), of_double), rounding);
  const Eigen::Matrix<Dual, 3, 3> of_dual = several_steps<Dual>(Dual(h, 1, 0));
  const Eigen::Matrix3d slope = (several_steps<double>(h + 1e-6) - several_steps<double>(h - 1e-6)) / 2e-6;
  EXPECT_LE(distance(of_dual.unaryExpr([](const Dual& x) { return x.value(); }), of_double), rounding);
  EXPECT_LE(distance(of_dual.unaryExpr([](const Dual& x) { return x.derivatives()(0); }), slope), 1e-8);
}

}  // namespace
}  // namespace integration_scalars_test
