#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <random>
#include <vectrix/kinematics/named/graph.hpp>

#include "testing/motions.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace sampled_edge_test {
namespace {

/// Slerp evaluates sine and cosine of the same angles in another way: one or two roundings each.
constexpr double slerp_rounding = 32 * epsilon;

class SampledEdge : public testing::Test {
 protected:
  NamedGraph graph;
  NamedFrame gcrf = graph.add_frame("gcrf", FrameMotion::inertial);
  NamedFrame body = graph.add_frame("body", FrameMotion::moving);

  NamedSample sample(double t, const Eigen::Quaterniond& q = Eigen::Quaterniond::Identity()) const {
    return {t * si::second, quaternion_scalar_first(To(gcrf), From(body), q.w(), q.x(), q.y(), q.z())};
  }
  std::vector<NamedSample> samples(const std::vector<double>& times) const {
    std::vector<NamedSample> list;
    for (const double t : times)
      list.push_back(sample(t, Eigen::Quaterniond(Eigen::AngleAxisd(0.1 * t, Eigen::Vector3d::UnitZ()))));
    return list;
  }
  NamedDcm rotation(double t) const { return graph.at(t * si::second).rotation(To(gcrf), From(body)); }
  Eigen::Vector3d rate(double t) const {
    return graph.at(t * si::second).angular_velocity(Of(body), RelativeTo(gcrf), In(body)).coordinates();
  }
  template <class Action> static void expect(const char* text, const Action& action) {
    EXPECT_EQ(message<BadInput>(action), text);
  }
};
/// For property tests, which rapidcheck calls outside a fixture.
struct Attitudes : SampledEdge {
  using SampledEdge::body;
  using SampledEdge::gcrf;
  using SampledEdge::graph;
  using SampledEdge::rate;
  using SampledEdge::rotation;
  using SampledEdge::sample;
  void TestBody() override {}
};

Quaternion<Gcrf, Body> typed(const Eigen::Quaterniond& q) {
  return quaternion_scalar_first(to<Gcrf>, from<Body>, q.w(), q.x(), q.y(), q.z());
}

// In each segment it is the Slerp of the two samples, for equal and unequal steps, turns of any size and
// either sign.
RC_GTEST_PROP(SampledEdges, IsTheSlerpOfNeighbours, ()) {
  Attitudes a;
  const bool equal_steps = *rc::gen::arbitrary<bool>();
  std::vector<double> times{-3.0};
  std::vector<Eigen::Quaterniond> attitudes{*attitude()};
  std::vector<NamedSample> list{a.sample(times[0], attitudes[0])};
  const int count = *rc::gen::inRange(1, 20);
  for (int i = 0; i < count; ++i) {
    times.push_back(times.back() + (equal_steps ? 0.25 : 0.01 + std::abs(*coordinate())));
    attitudes.push_back(*attitude());
    list.push_back(a.sample(times.back(), attitudes.back()));
  }
  a.graph.add_edge(sampled_edge(list, 2.0 * si::second));
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const Slerp slew(times[i] * si::second, typed(attitudes[i]), times[i + 1] * si::second,
                     typed(attitudes[i + 1]));
    for (const double s : {0.0, 1e-9, 0.1, 0.5, 0.999}) {
      const double t = times[i] + s * (times[i + 1] - times[i]);
      const auto expected = slew(t * si::second);
      RC_ASSERT(distance(a.rotation(t).matrix(), expected.rotation.matrix()) <= slerp_rounding);
      RC_ASSERT(distance(a.rate(t), expected.angular_velocity.coordinates()) <=
                slerp_rounding * expected.angular_velocity.coordinates().norm());
    }
  }
  RC_ASSERT(distance(a.rotation(times.back()).matrix(), attitudes.back().toRotationMatrix()) <=
            slerp_rounding);
}

RC_GTEST_PROP(SampledEdges, TheSignOfAQuaternionDoesNotMatter, ()) {
  Attitudes a, b;
  const auto q0 = *attitude(), q1 = *attitude();
  a.graph.add_edge(sampled_edge({a.sample(0, q0), a.sample(1, q1)}, 1.0 * si::second));
  b.graph.add_edge(
      sampled_edge({b.sample(0, q0), b.sample(1, Eigen::Quaterniond(-q1.coeffs()))}, 1.0 * si::second));
  RC_ASSERT(distance(a.rotation(0.3).matrix(), b.rotation(0.3).matrix()) <= slerp_rounding);
  RC_ASSERT(distance(a.rate(0.3), b.rate(0.3)) <= slerp_rounding * 4);
}

// At a sample the rate is that of the segment that begins there; at the last sample, of the segment that ends
// there.
TEST_F(SampledEdge, TheRateJumpsAtASample) {
  auto list = samples({0, 1, 3});
  list.back() = sample(3.0, Eigen::Quaterniond(Eigen::AngleAxisd(0.9, Eigen::Vector3d::UnitZ())));
  graph.add_edge(sampled_edge(list, 2.0 * si::second));
  EXPECT_NEAR(rate(0.0).z(), 0.1, rounding);
  EXPECT_NEAR(rate(std::nextafter(1.0, 0.0)).z(), 0.1, rounding);
  EXPECT_NEAR(rate(1.0).z(), 0.4, rounding);
  EXPECT_NEAR(rate(3.0).z(), 0.4, rounding);
  expect(
      R"(angular_acceleration(of "body", relative to "gcrf", in "body"): the edge "gcrf" - "body" has no acceleration)",
      [&] { graph.at(1.0 * si::second).angular_acceleration(Of(body), RelativeTo(gcrf), In(body)); });
}

TEST_F(SampledEdge, OutsideTheSamplesIsRefused) {
  graph.add_edge(sampled_edge(samples({10, 11, 12}), 1.0 * si::second));
  expect(R"(the edge "gcrf" - "body": the time 9.5 s is outside the samples, [10 s, 12 s])",
         [&] { rotation(9.5); });
  expect(R"(the edge "gcrf" - "body": the time 12.5 s is outside the samples, [10 s, 12 s])",
         [&] { rate(12.5); });
  EXPECT_EQ(message<BadInput>([&] { rotation(10), rotation(12); }), "");
}

TEST_F(SampledEdge, InAGapIsRefused) {
  graph.add_edge(sampled_edge(samples({0, 1, 2, 7, 8}), 2.0 * si::second));
  const char* const text =
      R"(the edge "gcrf" - "body": the time 3 s is in a gap of 5 s after the sample at 2 s; the longest allowed is 2 s)";
  expect(text, [&] { rotation(3); });
  expect(text, [&] { rate(3); });
  for (const double t : {0.0, 1.5, 2.0, 7.0, 7.5, 8.0})
    EXPECT_LE(distance(rotation(t).matrix(),
                       Eigen::AngleAxisd(0.1 * t, Eigen::Vector3d::UnitZ()).toRotationMatrix()),
              rounding);
}

TEST_F(SampledEdge, BadSamplesAreRefused) {
  const auto make = [&](const std::vector<double>& times, double gap = 1.0) {
    return message<BadInput>([&] { sampled_edge(samples(times), gap * si::second); });
  };
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::string edge = R"(the edge "gcrf" - "body": )";
  EXPECT_EQ(make({}), "sampled_edge: the number of samples is 0, at least 2 are needed");
  EXPECT_EQ(make({1}), edge + "the number of samples is 1, at least 2 are needed");
  EXPECT_EQ(make({0, 1, 1, 2}), edge + "samples 1 and 2 have one time, 1 s");
  EXPECT_EQ(make({0, 2, 1}), edge + "the time of sample 2, 1 s, is before that of sample 1, 2 s");
  EXPECT_EQ(make({0, 5e-324}), edge + "samples 0 and 1 are 5e-324 s apart");
  EXPECT_EQ(make({-1.5e308, 1.5e308}), edge + "samples 0 and 1 are inf s apart");
  EXPECT_EQ(make({-1.5e308, 0, 1.5e308}), edge + "the samples span inf s");
  EXPECT_EQ(make({0, 1}, 0), edge + "the longest gap is 0 s");
  EXPECT_EQ(make({0, 1}, infinity), edge + "the longest gap is inf s");
  const auto at = [&](double t) {
    return message<BadInput>([&] { sampled_edge({sample(0), sample(t)}, 1.0 * si::second); });
  };
  EXPECT_EQ(at(nan), edge + "the time of sample 1 is nan s");
  EXPECT_EQ(at(infinity), edge + "the time of sample 1 is inf s");
  auto list = samples({0, 1});
  list.push_back({2.0 * si::second, quaternion_scalar_last(To(body), From(gcrf), 0.0, 0.0, 0.0, 1.0)});
  EXPECT_EQ(message<BadInput>([&] { sampled_edge(list, 1.0 * si::second); }),
            edge + R"(sample 2 is to "body" from "gcrf", the first to "gcrf" from "body")");
}

}  // namespace
}  // namespace sampled_edge_test
