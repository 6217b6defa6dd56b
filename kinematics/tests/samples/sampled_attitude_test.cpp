#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vectrix/kinematics/named/graph.hpp>
#include <vectrix/kinematics/samples/sampled_attitude.hpp>

#include "testing/attitudes.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace sampled_attitude_test {
namespace {

using Eigen::Quaterniond;
using Samples = std::vector<AttitudeSample<Gcrf, Body>>;

/// The named edge evaluates sine and cosine of the same angles in another way: one or two roundings each.
constexpr double slerp_rounding = 32 * epsilon;

Quantity<si::time> seconds(double t) {
  return t * si::second;
}
AttitudeSample<Gcrf, Body> sample(double t, const Quaterniond& q = Quaterniond::Identity()) {
  return {seconds(t), quaternion_scalar_first(to<Gcrf>, from<Body>, q.w(), q.x(), q.y(), q.z())};
}
Samples about_z(const std::vector<double>& times) {
  Samples list;
  for (const double t : times)
    list.push_back(sample(t, Quaterniond(Eigen::AngleAxisd(0.1 * t, Eigen::Vector3d::UnitZ()))));
  return list;
}

// An attitude file gives the same attitudes with typed and with named frames.
RC_GTEST_PROP(SampledAttitude, IsTheEdgeOfTheNamedGraph, ()) {
  NamedGraph named;
  const auto gcrf = named.add_frame("gcrf", FrameMotion::inertial);
  const auto body = named.add_frame("body", FrameMotion::moving);
  Samples list;
  std::vector<NamedSample> names;
  double t = -3.0;
  for (int i = 0; i < 5; ++i) {
    const Quaterniond q = *attitude();
    list.push_back(sample(t, q));
    names.push_back({seconds(t), quaternion_scalar_first(To(gcrf), From(body), q.w(), q.x(), q.y(), q.z())});
    t += 0.01 + std::abs(*coordinate());
  }
  named.add_edge(sampled_edge(names, seconds(2.0)));
  const auto typed = frame_graph(sampled_edge(list, seconds(2.0)));
  for (int i = 0; i < 20; ++i) {
    const double s = (1 + *coordinate()) / 2;
    const auto now = seconds(-3.0 + s * (list.back().time.value() + 3.0));
    const auto w = typed.at(now).angular_velocity(of<Body>, relative_to<Gcrf>, in<Body>).coordinates();
    const auto expected = named.at(now).angular_velocity(Of(body), RelativeTo(gcrf), In(body)).coordinates();
    RC_ASSERT(distance(w, expected) <= slerp_rounding * expected.norm());
    RC_ASSERT(distance(typed.at(now).rotation(to<Gcrf>, from<Body>).matrix(),
                       named.at(now).rotation(To(gcrf), From(body)).matrix()) <= slerp_rounding);
  }
}

RC_GTEST_PROP(SampledAttitude, TheSignOfAQuaternionDoesNotMatter, ()) {
  const auto q0 = *attitude(), q1 = *attitude();
  const SampledAttitude plain(Samples{sample(0, q0), sample(1, q1)}, seconds(1.0));
  const SampledAttitude flipped(Samples{sample(0, q0), sample(1, Quaterniond(-q1.coeffs()))}, seconds(1.0));
  RC_ASSERT(distance(plain(seconds(0.3)).rotation.matrix(), flipped(seconds(0.3)).rotation.matrix()) <=
            slerp_rounding);
}

TEST(SampledAttitude, OutsideAndInAGapIsRefused) {
  const SampledAttitude attitude(about_z({0, 1, 2, 7, 8}), seconds(2.0));
  const auto said = [&](double t) { return message<BadInput>([&] { attitude(seconds(t)); }); };
  const std::string place = detail::samples_place<Gcrf, Body>("SampledAttitude") + ": ";
  EXPECT_EQ(said(-0.5), place + "the time -0.5 s is outside the samples, [0 s, 8 s]");
  EXPECT_EQ(said(8.5), place + "the time 8.5 s is outside the samples, [0 s, 8 s]");
  EXPECT_EQ(said(std::nan("")), place + "the time nan s is outside the samples, [0 s, 8 s]");
  EXPECT_EQ(said(3),
            place + "the time 3 s is in a gap of 5 s after the sample at 2 s; the longest allowed is 2 s");
  for (const double t : {0.0, 1.5, 2.0, 7.0, 7.5, 8.0}) {
    EXPECT_LE(distance(attitude(seconds(t)).rotation.matrix(),
                       Eigen::AngleAxisd(0.1 * t, Eigen::Vector3d::UnitZ()).toRotationMatrix()),
              rounding);
  }
  // A step as long as the longest gap is none: found at once, by bisection, and from its end.
  const SampledAttitude longest(about_z({0, 0.5, 2.5, 7, 9}), seconds(2.0));
  for (const double t : {0.75, 2.0, 2.5, 8.5}) EXPECT_NO_THROW(longest(seconds(t))) << t;
  // Between two gaps a sample has no neighbour.
  const SampledAttitude lonely(about_z({0, 5, 10}), seconds(2.0));
  EXPECT_TRUE(contains(message<BadInput>([&] { lonely(seconds(5)); }), "time 5 s is in a gap of 5 s"));
}

TEST(SampledAttitude, BadSamplesAreRefused) {
  const auto said = [](const std::vector<double>& times, double gap = 1.0) {
    return message<BadInput>([&] { sampled_edge(about_z(times), seconds(gap)); });
  };
  const std::string place = detail::samples_place<Gcrf, Body>("SampledAttitude") + ": ";
  EXPECT_EQ(said({}), place + "the number of samples is 0, at least 2 are needed");
  EXPECT_EQ(said({0, 1, 1, 2}), place + "samples 1 and 2 have one time, 1 s");
  EXPECT_EQ(said({0, 2, 1}), place + "the time of sample 2, 1 s, is before that of sample 1, 2 s");
  EXPECT_EQ(said({0, 1}, 0.0), place + "the longest gap is 0 s");
  EXPECT_EQ(said({0, 1}, std::nan("")), place + "the longest gap is nan s");
  EXPECT_EQ(message<BadInput>([&] {
              sampled_edge(Samples{sample(0), sample(HUGE_VAL)}, seconds(1));
            }),
            place + "the time of sample 1 is inf s");
}

}  // namespace
}  // namespace sampled_attitude_test
