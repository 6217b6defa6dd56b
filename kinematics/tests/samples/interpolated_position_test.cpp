#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <vectrix/frames/graph/frame_graph.hpp>
#include <vectrix/kinematics/samples/interpolated_position.hpp>

#include "testing/attitudes.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace interpolated_position_test {
namespace {

using Eigen::Vector3d;
using Samples = std::vector<PositionSample<Itrf, Body>>;
using State = AcceleratingTransform<Itrf, Body>;

// A path and its first two derivatives.
struct Path {
  Vector3d r, v, a;
};
// Not even, not symmetric.
const std::vector<double> uneven{-5.2, -4.0, -3.1, -1.9, -1.2, 0.0, 0.9, 2.1, 2.8, 4.0, 5.3, 6.0};

Path smooth(double t) {
  return {{std::cos(t), std::sin(1.3 * t), std::exp(0.3 * t)},
          {-std::sin(t), 1.3 * std::cos(1.3 * t), 0.3 * std::exp(0.3 * t)},
          {-std::cos(t), -1.69 * std::sin(1.3 * t), 0.09 * std::exp(0.3 * t)}};
}
// (1 - t/6)^n in each coordinate, with factors.
Path power(int n, double t) {
  const Vector3d c(1.0, -2.0, 0.5);
  const double x = 1.0 - t / 6.0;
  return {c * std::pow(x, n), c * -n / 6.0 * std::pow(x, n - 1), c * n * (n - 1) / 36.0 * std::pow(x, n - 2)};
}
template <class Of> Samples sampled(const std::vector<double>& times, const Of& path) {
  Samples samples;
  for (const double t : times) {
    const Path at = path(t);
    samples.push_back({t * si::second, point_motion(of<Body>, relative_to<Itrf>, observed_from<Itrf>,
                                                    vector<si::length>(in<Itrf>, at.r),
                                                    vector<si::velocity>(in<Itrf>, at.v))});
  }
  return samples;
}
const auto longest_gap = 100.0 * si::second;

struct Errors {
  double r, v, a;
};
Errors errors(const State& found, const Path& exact) {
  return {(found.translation.coordinates() - exact.r).norm(), (found.velocity.coordinates() - exact.v).norm(),
          (found.acceleration.coordinates() - exact.a).norm()};
}

template <class Method> void expect_exact(const Method& method) {
  const auto path = [&](double t) { return power(method.degree, t); };
  const InterpolatedPosition position(sampled(uneven, path), method, longest_gap);
  // (1 - t/6)^15 reaches 1.87^15, and the interpolation at the ends amplifies the rounding of the samples by
  // less than 2^15.
  const double tolerance = 1e-16 * std::pow(1.87 * 2, method.degree) + 1e-13;
  for (const double t : {-5.2, -5.0, -3.1, -0.7, 0.0, 0.3, 2.4, 5.9, 6.0}) {
    const Errors off = errors(position(t * si::second), path(t));
    EXPECT_LE(off.r, tolerance) << method.degree << ' ' << t;
    EXPECT_LE(off.v, 10 * tolerance) << method.degree << ' ' << t;
    EXPECT_LE(off.a, 100 * tolerance) << method.degree << ' ' << t;
  }
}
TEST(InterpolatedPosition, ReproducesPolynomialsOfItsDegree) {
  for (int degree = 2; degree <= 11; ++degree) expect_exact(Lagrange{degree});
  for (int degree = 3; degree <= 15; degree += 2) expect_exact(Hermite{degree});
}

// The error falls by 2 to the order if the step is halved. All derivatives of this path are the path.
Path exponential(double t) {
  const Vector3d r = std::exp(t) * Vector3d(1.0, -2.0, 0.5);
  return {r, r, r};
}
template <class Method> void expect_orders(const Method& method, double around) {
  const auto off = [&](double h) {
    std::vector<double> times;
    for (const double t : uneven) times.push_back(0.4 + h * (t - around));
    return errors(InterpolatedPosition(sampled(times, exponential), method, longest_gap)(0.4 * si::second),
                  exponential(0.4));
  };
  const double h = method.degree < 6 ? 0.1 : 0.2;  // above rounding
  const Errors coarse = off(h), fine = off(h / 2);
  const double next_order =
      2.6 * h;  // exp(3.6 h/2) as a power of 2: the middle of the samples is up to 3.6 h away
  EXPECT_NEAR(std::log2(coarse.r / fine.r), method.degree + 1, next_order) << method.degree << ' ' << around;
  EXPECT_NEAR(std::log2(coarse.v / fine.v), method.degree, next_order) << method.degree << ' ' << around;
  EXPECT_NEAR(std::log2(coarse.a / fine.a), method.degree - 1, next_order) << method.degree << ' ' << around;
}
TEST(InterpolatedPosition, HasItsOrders) {
  for (const double around : {0.3, -5.0, 5.7}) {
    for (const int degree : {2, 3, 4, 5, 6, 7}) expect_orders(Lagrange{degree}, around);
    for (const int degree : {3, 5, 7}) expect_orders(Hermite{degree}, around);
  }
}

// In the middle of its samples, and of the first or last ones at the ends: the others may be anything.
template <class Method>
void expect_window(const Method& method, double t, std::size_t first, std::size_t end) {
  auto samples = sampled(uneven, [](double x) { return power(2, x); });
  const auto far = sampled({0.0},
                           [](double) {
                             return Path{{1e9, 1e9, 1e9}, {1e9, 1e9, 1e9}, {}};
                           })
                       .front()
                       .motion;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const bool used = i >= first && i < end;
    auto changed = samples;
    changed[i].motion = far;
    const State found = InterpolatedPosition(changed, method, longest_gap)(t * si::second);
    EXPECT_EQ(errors(found, power(2, t)).r < 1.0, !used) << t << ' ' << i;
  }
}
TEST(InterpolatedPosition, TakesTheSamplesAround) {
  expect_window(Lagrange{5}, 0.5, 3, 9);
  expect_window(Lagrange{5}, -4.5, 0, 6);
  expect_window(Lagrange{5}, -3.0, 0, 6);
  expect_window(Lagrange{5}, 5.5, 6, 12);
  expect_window(Hermite{5}, 0.5, 5, 8);
  expect_window(Hermite{7}, 0.5, 4, 8);
  expect_window(Hermite{7}, -5.0, 0, 4);
  expect_window(Hermite{7}, 5.5, 8, 12);
}

// The velocities of the samples are used by Hermite's interpolation alone.
TEST(InterpolatedPosition, LagrangeTakesPositionsAlone) {
  auto samples = sampled(uneven, smooth);
  const InterpolatedPosition before(samples, Lagrange{7}, longest_gap);
  for (auto& sample : samples)
    sample.motion.velocity =
        at_rest<Body, Itrf, Itrf, Itrf>(of<Body>, relative_to<Itrf>, observed_from<Itrf>, in<Itrf>);
  const InterpolatedPosition after(samples, Lagrange{7}, longest_gap);
  const auto t = 0.4 * si::second;
  EXPECT_EQ(after(t).translation.coordinates(), before(t).translation.coordinates());
  EXPECT_LT(errors(after(t), smooth(0.4)).v, 1e-2);
}

// No polynomial leads over a gap: here from one path to another.
TEST(InterpolatedPosition, DoesNotLeadOverAGap) {
  const auto path = [](double t) { return power(t < 10 ? 3 : 2, t); };
  const auto samples = sampled({0, 1, 2, 3, 20, 21, 22, 23}, path);
  const InterpolatedPosition lagrange(samples, Lagrange{3}, 2.0 * si::second);
  const InterpolatedPosition hermite(samples, Hermite{7}, 2.0 * si::second);
  for (const double t : {0.5, 2.7, 3.0, 20.0, 20.4, 23.0}) {
    EXPECT_LE(errors(lagrange(t * si::second), path(t)).r, 1e-13) << t;
    EXPECT_LE(errors(hermite(t * si::second), path(t)).r, 1e-13) << t;
  }
  const auto said = [&](double t) { return message<BadInput>([&] { lagrange(t * si::second); }); };
  const std::string place = detail::samples_place<Itrf, Body>("InterpolatedPosition") + ": ";
  EXPECT_EQ(said(7),
            place + "the time 7 s is in a gap of 17 s after the sample at 3 s; the longest allowed is 2 s");
  EXPECT_EQ(said(23.5), place + "the time 23.5 s is outside the samples, [0 s, 23 s]");
  EXPECT_NE(said(-1e-9), "");
  EXPECT_NE(said(std::numeric_limits<double>::quiet_NaN()), "");
}

TEST(InterpolatedPosition, IsAnEdgeWithAcceleration) {
  const auto graph = frame_graph(sampled_edge(sampled(uneven, smooth), Hermite{9}, longest_gap));
  const auto now = graph.at(0.4 * si::second);
  const Path exact = smooth(0.4);
  EXPECT_LT((now.position(of<Body>, relative_to<Itrf>, in<Itrf>).coordinates() - exact.r).norm(), 1e-4);
  EXPECT_LT((now.velocity(of<Body>, relative_to<Itrf>, observed_from<Itrf>, in<Itrf>).coordinates() - exact.v)
                .norm(),
            1e-3);
  EXPECT_LT(
      (now.acceleration(of<Body>, relative_to<Itrf>, observed_from<Itrf>, in<Itrf>).coordinates() - exact.a)
          .norm(),
      1e-2);
  EXPECT_EQ(now.angular_acceleration(of<Body>, relative_to<Itrf>, in<Body>).coordinates(), Vector3d::Zero());
}

TEST(InterpolatedPosition, WrongSamplesAreRefused) {
  const std::string place = detail::samples_place<Itrf, Body>("InterpolatedPosition") + ": ";
  const auto straight = [](double t) { return power(1, t); };
  const auto said = [&](const std::vector<double>& times, const auto& method, double gap = 100.0) {
    return message<BadInput>(
        [&] { InterpolatedPosition(sampled(times, straight), method, gap * si::second); });
  };
  EXPECT_EQ(said({0, 1, 2}, Lagrange{3}),
            place + "samples 0 to 2 are 3; Lagrange interpolation of degree 3 needs 4");
  EXPECT_EQ(said({0, 1, 2}, Hermite{7}),
            place + "samples 0 to 2 are 3; Hermite interpolation of degree 7 needs 4");
  EXPECT_EQ(said({0, 1, 2, 3, 9, 10, 11}, Lagrange{3}, 2.0),
            place + "samples 4 to 6, between gaps, are 3; Lagrange interpolation of degree 3 needs 4");
  EXPECT_EQ(said({0, 1, 2, 3}, Lagrange{3}) + said({0, 1, 2, 3}, Hermite{7}), "");
  EXPECT_EQ(said({0, 1, 1, 3}, Lagrange{3}), place + "samples 1 and 2 have one time, 1 s");
  EXPECT_NE(said({0, 2, 1, 3}, Lagrange{3}), "");
  EXPECT_NE(said({}, Lagrange{3}), "");
  const double short_step = 0x1p-360;  // its cube is below all numbers
  EXPECT_EQ(said({0, short_step, 2 * short_step, 3 * short_step}, Lagrange{3}),
            place + "samples 0 and 1 are " + detail::text(short_step) +
                " s apart; Lagrange interpolation of degree 3 divides by a power of it that no number holds");
  EXPECT_NE(said({0, 0x1p360, 0x1p361, 0x1.8p361}, Lagrange{3}, 0x1p400), "");
  // Nothing is divided by a gap: here its 15th power overflows.
  std::vector<double> around_a_gap;
  for (const double start : {0.0, 0x1p80})
    for (int i = 0; i < 16; ++i) around_a_gap.push_back(start + i * 0x1p40);
  EXPECT_EQ(said(around_a_gap, Lagrange{15}, 0x1p41), "");
  // A step as long as the longest gap is none.
  EXPECT_EQ(said({0, 1, 2, 3, 9, 10, 11, 12}, Lagrange{3}, 1.0), "");
  EXPECT_NE(said({0, 0x1p360, 0x1p361, 0x1.8p361}, Lagrange{3}, 0x1p360), "");
  EXPECT_EQ(said(uneven, Lagrange{1}), place + "the degree of Lagrange interpolation is 1; it is 2 to 15");
  EXPECT_NE(said(uneven, Lagrange{16}), "");
  EXPECT_NE(said(uneven, Lagrange{-1}), "");
  EXPECT_EQ(said(uneven, Hermite{4}), place + "the degree of Hermite interpolation is 4; it is odd, 3 to 15");
  EXPECT_NE(said(uneven, Hermite{1}), "");
  EXPECT_NE(said(uneven, Hermite{17}), "");
  EXPECT_NE(said(uneven, Hermite{-3}), "");
}

}  // namespace
}  // namespace interpolated_position_test
