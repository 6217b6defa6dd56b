#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vectrix/frames/graph/edge.hpp>
#include <vectrix/frames/graph/frame_graph.hpp>

#include "testing/motions.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace slerp_test {
namespace {

constexpr auto t0 = 10.0 * si::second;
constexpr auto t1 = 14.0 * si::second;

Quaternion<Gcrf, Body> unit(const Eigen::Quaterniond& q) {
  return quaternion_scalar_first(to<Gcrf>, from<Body>, q.w(), q.x(), q.y(), q.z());
}
Slerp<Gcrf, Body> any_slerp() {
  return {t0, unit(*attitude()), t1, unit(*attitude())};
}

RC_GTEST_PROP(Slerp, TheEndsAreTheGivenAttitudes, ()) {
  const auto q0 = unit(*attitude());
  const auto q1 = unit(*attitude());
  const Slerp slew(t0, q0, t1, q1);
  RC_ASSERT(distance(slew(t0).rotation.matrix(), dcm(q0).matrix()) <= rounding);
  RC_ASSERT(distance(slew(t1).rotation.matrix(), dcm(q1).matrix()) <= rounding);
}

RC_GTEST_PROP(Slerp, TheRateIsConstantAndGoesTheShortestWay, ()) {
  const auto slew = any_slerp();
  const Eigen::Vector3d w = slew(t0).angular_velocity.coordinates();
  RC_ASSERT(slew(12.5 * si::second).angular_velocity.coordinates() == w);
  RC_ASSERT(w.norm() * 4.0 <= std::numbers::pi * (1 + rounding));
  const auto turned = log(inverse(slew(t0).rotation) * slew(t1).rotation);
  RC_ASSERT(std::abs(turned.angle().value() - 4.0 * w.norm()) <= rounding * 4);
}

RC_GTEST_PROP(Slerp, TheSignOfAQuaternionDoesNotMatter, ()) {
  const auto q0 = *attitude();
  const auto q1 = *attitude();
  const auto t = 11.0 * si::second;
  const Slerp plus(t0, unit(q0), t1, unit(q1));
  const Slerp minus(t0, unit(q0), t1, unit(Eigen::Quaterniond(-q1.coeffs())));
  RC_ASSERT(distance(plus(t).rotation.matrix(), minus(t).rotation.matrix()) <= rounding);
}

// The derivative of the matrix is R [w]x. Both from one slerp: at half a turn, two slerps could go opposite
// ways.
RC_GTEST_PROP(Slerp, ItsRateIsTheDerivativeOfItsRotation, ()) {
  const auto q0 = *attitude();
  const auto q1 = *attitude();
  const auto dual = [](const Eigen::Quaterniond& q) {
    const auto c = [](double x) { return Dual(x, Eigen::Matrix<double, 1, 1>(0.0)); };
    return quaternion_scalar_first(to<Gcrf>, from<Body>, c(q.w()), c(q.x()), c(q.y()), c(q.z()));
  };
  const auto time = [](const Dual& seconds) { return Quantity<si::time, Dual>::from_value(seconds); };
  const Slerp<Gcrf, Body, Quantity<si::time, Dual>> differentiable(
      time(Dual(10.0, Eigen::Matrix<double, 1, 1>(0.0))), dual(q0),
      time(Dual(14.0, Eigen::Matrix<double, 1, 1>(0.0))), dual(q1));
  const auto here = differentiable(time(Dual(11.5, 1, 0)));
  const Eigen::Matrix3d R = here.rotation.matrix().unaryExpr([](const Dual& x) { return x.value(); });
  const Eigen::Matrix3d Rdot =
      here.rotation.matrix().unaryExpr([](const Dual& x) { return x.derivatives()(0); });
  const Eigen::Vector3d w =
      here.angular_velocity.coordinates().unaryExpr([](const Dual& x) { return x.value(); });
  RC_ASSERT(distance(R * hat(w), Rdot) <= rounding);
}

TEST(Slerp, IsAnEdge) {
  const Slerp slew(t0, unit(Eigen::Quaterniond::Identity()), t1,
                   unit(Eigen::Quaterniond(Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitY()))));
  const auto graph = frame_graph(edge(slew));
  const auto w = graph.at(12.0 * si::second).angular_velocity(of<Body>, relative_to<Gcrf>, in<Body>);
  EXPECT_LE(distance(w.coordinates(), Eigen::Vector3d(0, 0.25, 0)), rounding);
  EXPECT_LE(distance(graph.at(12.0 * si::second).rotation(to<Gcrf>, from<Body>).matrix(),
                     Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY()).toRotationMatrix()),
            rounding);
}

TEST(Slerp, BadTimesAreBadInput) {
  const auto q = unit(Eigen::Quaterniond::Identity());
  const auto make = [&](double from, double until) {
    return message<BadInput>([&] { Slerp(from * si::second, q, until * si::second, q); });
  };
  EXPECT_TRUE(contains(make(2, 1), "the times 2 s and 1 s do not increase")) << make(2, 1);
  EXPECT_TRUE(contains(make(2, 2), "do not increase"));
  EXPECT_TRUE(contains(make(std::numeric_limits<double>::quiet_NaN(), 1), "nan s and 1 s do not increase"));
  EXPECT_TRUE(contains(make(0, std::numeric_limits<double>::infinity()), "0 s and inf s do not increase"));
  const auto other = unit(Eigen::Quaterniond(Eigen::AngleAxisd(1.0, Eigen::Vector3d::UnitY())));
  const auto near = message<BadInput>([&] { Slerp(0.0 * si::second, q, 1e-320 * si::second, other); });
  EXPECT_TRUE(contains(near, "are " + detail::text(1e-320) + " s apart; the rate overflows")) << near;
  const Slerp slew(t0, q, t1, q);
  const auto ask = [&](double t) { return message<BadInput>([&] { slew(t * si::second); }); };
  EXPECT_TRUE(contains(ask(9.5), "Slerp of ") && contains(ask(9.5), "the time 9.5 s is outside [10 s, 14 s]"))
      << ask(9.5);
  EXPECT_TRUE(contains(ask(14.5), "time 14.5 s is outside"));
  EXPECT_TRUE(contains(ask(std::numeric_limits<double>::quiet_NaN()), "time nan s is outside"));
  EXPECT_EQ(ask(10) + ask(14), "");
}

}  // namespace
}  // namespace slerp_test
