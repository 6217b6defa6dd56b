#include <gtest/gtest.h>

#include <vectrix/kinematics.hpp>
#include <vectrix/space/time/epoch.hpp>

#include "testing/attitudes.hpp"

// Samples, splines and estimates can be ordered by any instant: here by epochs, compared with seconds.
using namespace vectrix;
using namespace vectrix_test;

namespace samples_by_epoch_test {
namespace {

const Epoch start = Epoch::from_utc("2016-12-31T23:59:58");  // the year ends in 2 s and a leap second

// An epoch is stored to 1e-11 s. In this time nothing here turns by more than this.
constexpr double kept = 1e-11;

Quantity<si::time> seconds(double t) {
  return t * si::second;
}
Quaternion<Gcrf, Body> tumbling(double t) {
  const Eigen::Quaterniond q = Eigen::AngleAxisd(0.3 * t, Eigen::Vector3d::UnitX()) *
                               Eigen::AngleAxisd(0.2 * t * t, Eigen::Vector3d::UnitY());
  return quaternion_scalar_first(to<Gcrf>, from<Body>, q.w(), q.x(), q.y(), q.z());
}

struct Samples {
  std::vector<AttitudeSample<Gcrf, Body>> by_seconds;
  std::vector<AttitudeSample<Gcrf, Body, Epoch>> by_epoch;
};
Samples samples() {
  Samples list;
  for (const double t : {0.0, 0.5, 1.0, 2.0, 2.5, 3.0, 4.0}) {
    list.by_seconds.push_back({seconds(t), tumbling(t)});
    list.by_epoch.push_back({start + seconds(t), tumbling(t)});
  }
  return list;
}

void agree(const MovingDcm<Gcrf, Body>& found, const MovingDcm<Gcrf, Body>& expected) {
  EXPECT_LT(distance(found.rotation.matrix(), expected.rotation.matrix()), kept);
  EXPECT_LT(distance(found.angular_velocity.coordinates(), expected.angular_velocity.coordinates()), kept);
}

TEST(SamplesByEpoch, AreThoseBySeconds) {
  const auto list = samples();
  const auto gap = seconds(2.0);
  const SampledAttitude sampled(list.by_seconds, gap);
  const SampledAttitude sampled_by_epoch(list.by_epoch, gap);
  const RotationSpline spline(list.by_seconds, gap, natural_ends);
  const RotationSpline spline_by_epoch(list.by_epoch, gap, natural_ends);
  const Slerp slerp(seconds(0.0), tumbling(0), seconds(4.0), tumbling(1));
  const Slerp slerp_by_epoch(start, tumbling(0), start + seconds(4.0), tumbling(1));
  for (const double t : {0.25, 1.5, 2.75, 3.875}) {
    agree(sampled_by_epoch(start + seconds(t)), sampled(seconds(t)));
    agree(without_acceleration(spline_by_epoch(start + seconds(t))),
          without_acceleration(spline(seconds(t))));
    agree(slerp_by_epoch(start + seconds(t)), slerp(seconds(t)));
  }
  const auto sigma = 1e-4 * si::radian;
  const auto found = estimate_motion(list.by_epoch, start + seconds(2.0), seconds(1.75), sigma);
  agree(without_acceleration(found.motion),
        without_acceleration(estimate_motion(list.by_seconds, seconds(2.0), seconds(1.75), sigma).motion));
}

TEST(SamplesByEpoch, AreEdgesOfOneGraph) {
  const auto list = samples();
  std::vector<PositionSample<Gcrf, Itrf, Epoch>> positions;
  for (const double t : {0.0, 4.0}) {
    positions.push_back(
        {start + seconds(t), point_motion(of<Itrf>, relative_to<Gcrf>, observed_from<Gcrf>,
                                          vector<si::length>(in<Gcrf>, Eigen::Vector3d(2.0 * t, 0.0, 1.0)),
                                          vector<si::velocity>(in<Gcrf>, Eigen::Vector3d(2.0, 0.0, 0.0)))});
  }
  const auto graph =
      frame_graph(sampled_edge(list.by_epoch, seconds(2.0)), sampled_edge(positions, seconds(4.0)));
  const auto now = graph.at(start + seconds(1.5));
  const auto r_body = now.position(of<Itrf>, relative_to<Gcrf>, in<Body>);
  const auto expected = SampledAttitude(list.by_seconds, seconds(2.0))(seconds(1.5));
  EXPECT_LT(
      distance(r_body.coordinates(), expected.rotation.matrix().transpose() * Eigen::Vector3d(3.0, 0.0, 1.0)),
      2 * kept);
}

TEST(SamplesByEpoch, AreRefusedByTheirNamesInUtc) {
  const auto list = samples();
  const SampledAttitude sampled(list.by_epoch, seconds(0.75));
  const std::string place = detail::samples_place<Gcrf, Body>("SampledAttitude") + ": ";
  EXPECT_EQ(message<BadInput>([&] { sampled(start + seconds(4.5)); }),
            place +
                "the time 2017-01-01T00:00:01.500000 UTC is outside the samples, "
                "[2016-12-31T23:59:58.000000 UTC, 2017-01-01T00:00:01.000000 UTC]");
  EXPECT_TRUE(contains(message<BadInput>([&] { sampled(start + seconds(1.25)); }),
                       "the time 2016-12-31T23:59:59.250000 UTC is in a gap of"));
  auto falling = list.by_epoch;
  std::swap(falling[0], falling[1]);
  EXPECT_EQ(message<BadInput>([&] { SampledAttitude(falling, seconds(2.0)); }),
            place +
                "the time of sample 1, 2016-12-31T23:59:58.000000 UTC, is before that of sample 0, "
                "2016-12-31T23:59:58.500000 UTC");
}

}  // namespace
}  // namespace samples_by_epoch_test
