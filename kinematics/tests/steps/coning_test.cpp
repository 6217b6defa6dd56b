#include <gtest/gtest.h>

#include <numbers>

#include "testing/attitudes.hpp"
#include "testing/coning_motion.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace coning_test {
namespace {

using Coning = ConingMotion<Gcrf, Body>;
const Coning motion{1e-3, 50.0};  // 1 mrad, about 8 turns per second

TEST(Coning, TheMotionIsThatOfItsRate) {
  const Coning wide{0.7, 3.0};
  const double t = 0.4, h = 1e-5;
  const auto R = [&](double at) { return dcm(wide.attitude(at)).matrix(); };
  EXPECT_LE(distance(R(t) * hat(wide.rate(t).coordinates()), (R(t + h) - R(t - h)) / (2 * h)), 1e-9);
  // The integral by Simpson's rule.
  const Eigen::Vector3d simpson =
      0.1 / 6 *
      (wide.rate(0.4).coordinates() + 4 * wide.rate(0.45).coordinates() + wide.rate(0.5).coordinates());
  EXPECT_LE(distance(wide.count(0.4, 0.1).coordinates(), simpson), 1e-5);
}

/// The error of an algorithm's increment along the axis of the cone, over sin^2(cone). In closed form, with k
/// = speed h for one count: p counts lack (pk - sin pk) / 2, and a product alpha_i x alpha_j of the counts i
/// and j gives 4 sin^2(k/2) sin((j - i) k).
template <class Algorithm> double drift(double h, int counts, Algorithm algorithm) {
  const double t = 0.123;
  const double s = std::sin(motion.cone);
  return (algorithm(t) - motion.increment(t, counts * h)).x() / (s * s);
}
double lacking(double k, int counts) {
  return (counts * k - std::sin(counts * k)) / 2;
}
double product(double k, int apart) {
  return 4 * std::sin(k / 2) * std::sin(k / 2) * std::sin(apart * k);
}

// The closed forms omit the square of the cone, 1e-6 of the lacking part, and rounding: 1e-16 / s^2.
double room(double k, int counts) {
  return 2e-6 * lacking(k, counts) + 2e-9;
}

TEST(Coning, DriftsAsTheClosedFormSays) {
  for (const double k : {0.05, 0.1, 0.2, 0.4, 0.8}) {
    const double h = k / motion.speed;
    const auto count = [&](double t, int i) { return motion.count(t + i * h, h); };
    const double uncorrected = drift(h, 1, [&](double t) { return count(t, 0).coordinates(); });
    EXPECT_NEAR(uncorrected, -lacking(k, 1), room(k, 1)) << k;
    const double one = drift(
        h, 1, [&](double t) { return coning_corrected_after(count(t, -1), count(t, 0)).coordinates(); });
    EXPECT_NEAR(one, product(k, 1) / 12 - lacking(k, 1), room(k, 1)) << k;
    const double two =
        drift(h, 2, [&](double t) { return coning_corrected(count(t, 0), count(t, 1)).coordinates(); });
    EXPECT_NEAR(two, product(k, 1) * 2 / 3 - lacking(k, 2), room(k, 2)) << k;
    const double three = drift(h, 3, [&](double t) {
      return coning_corrected(count(t, 0), count(t, 1), count(t, 2)).coordinates();
    });
    EXPECT_NEAR(three, product(k, 2) * 9 / 20 + 2 * product(k, 1) * 27 / 40 - lacking(k, 3), room(k, 3)) << k;
    if (k < 0.4) continue;
    // Error per count: about k^3/12 uncorrected, k^5/60 for `one` and `two`, smaller again by k^2 for
    // `three`.
    EXPECT_LT(std::abs(one), 0.3 * k * k * std::abs(uncorrected)) << k;
    EXPECT_NEAR(two / 2, one, 0.1 * std::abs(one)) << k;
    EXPECT_LT(std::abs(three / 3), 0.25 * k * k * std::abs(two / 2)) << k;
  }
}

// The attitude itself, compared with the closed form over one second, with a wide cone. The remaining error
// of the last algorithm is of third order in the counts; products of two counts cannot remove it.
TEST(Coning, CorrectedCountsKeepTheAttitude) {
  const Coning wide{0.1, 20.0};
  const double h = 1.0 / 240;
  const auto run = [&](int counts, auto increment) {
    Quaternion<Gcrf, Body> q = wide.attitude(0.0);
    for (int i = 0; i < 240; i += counts) q = advance(q, increment(i * h));
    return log(inverse(before(q)) * wide.attitude(1.0)).angle().value();
  };
  const double plain = run(1, [&](double t) {
    return rotation_vector(of<Body>, relative_to<Before<Gcrf, Body>>, wide.count(t, h).vector());
  });
  const double after =
      run(1, [&](double t) { return coning_corrected_after(wide.count(t - h, h), wide.count(t, h)); });
  const double two =
      run(2, [&](double t) { return coning_corrected(wide.count(t, h), wide.count(t + h, h)); });
  const double three = run(3, [&](double t) {
    return coning_corrected(wide.count(t, h), wide.count(t + h, h), wide.count(t + 2 * h, h));
  });
  EXPECT_GT(plain, 1e-4);
  EXPECT_LT(after, 1e-2 * plain);
  EXPECT_LT(two, 1e-2 * plain);
  EXPECT_LT(three, 0.3 * two);
}

// Counts over intervals of 0.8 h and 1.2 h in turn. The error of a run falls with h^3, with the coefficient
// of equal intervals with h^2.
TEST(Coning, KeepsItsOrderForUnequalIntervals) {
  const Coning wide{0.1, 20.0};
  const auto error = [&](int steps) {
    const double h = 1.0 / steps;
    GyroAttitude<Gcrf, Body> attitude(
        wide.attitude(0.0),
        gyro_errors(zero<si::angular_velocity>(in<Body>), zero<si::dimensionless>(in<Body>),
                    Eigen::Matrix<double, 3, 2>(Eigen::Matrix<double, 3, 2>::Zero())));
    double t = 0.0;
    for (int i = 0; i < steps; ++i) {
      const double dt = i % 2 == 0 ? 0.8 * h : 1.2 * h;
      attitude.add(measured(wide.count(t, dt)), dt * si::second);
      t += dt;
    }
    return log(inverse(before(attitude.attitude())) * wide.attitude(1.0)).angle().value();
  };
  const double coarse = error(400), fine = error(800);
  EXPECT_GT(coarse / fine, 6.5);  // 8 but for higher orders; 4 with the wrong coefficient
}

// 2 Hz, half angle 0.02 rad, intervals of 5 and 15 ms for 60 s. With the coefficient of equal intervals 4e-4
// rad.
TEST(Coning, ShortAndLongIntervalsDoNotDrift) {
  const Coning motion_2_hz{0.02, 4 * std::numbers::pi};
  Quaternion<Gcrf, Body> q = motion_2_hz.attitude(0.0);
  double t = 0.0, dt_before = 0.005;
  auto before_count = motion_2_hz.count(-dt_before, dt_before);
  for (int i = 0; i < 6000; ++i) {
    const double dt = i % 2 == 0 ? 0.015 : 0.005;
    const auto count = motion_2_hz.count(t, dt);
    q = advance(q, coning_corrected_after(before_count, dt_before * si::second, count, dt * si::second));
    before_count = count;
    dt_before = dt;
    t += dt;
  }
  // k^5/60 sin^2(cone) in each count of equal ones, here for 6000 of the longer ones.
  const double k = 0.015 * motion_2_hz.speed, s = std::sin(motion_2_hz.cone);
  EXPECT_LT(log(inverse(before(q)) * motion_2_hz.attitude(60.0)).angle().value(),
            6000 * std::pow(k, 5) / 60 * s * s);
}

// Steps of two counts, a quarter and three quarters of the step: an interval loses 1/12 of h^4 w x w'' and
// the like, so that a run has order 3. With 2/3 for c it has order 2.
TEST(Coning, KeepsItsOrderForUnequalParts) {
  const Coning wide{0.1, 20.0};
  const auto error = [&](int steps) {
    const double h = 1.0 / steps, first = 0.25 * h, second = 0.75 * h;
    Quaternion<Gcrf, Body> q = wide.attitude(0.0);
    for (int i = 0; i < steps; ++i)
      q = advance(q, coning_corrected(wide.count(i * h, first), first * si::second,
                                      wide.count(i * h + first, second), second * si::second));
    return log(inverse(before(q)) * wide.attitude(1.0)).angle().value();
  };
  EXPECT_GT(error(200) / error(400), 6.5);  // 8 but for higher orders
}

TEST(Coning, RefusesThreeUnequalParts) {
  const auto a = motion.count(0.0, 0.01), b = motion.count(0.01, 0.01), c = motion.count(0.02, 0.01);
  const auto s = si::second;
  EXPECT_LE(distance(coning_corrected(a, 0.01 * s, b, 0.01 * s, c, 0.01 * s).coordinates(),
                     coning_corrected(a, b, c).coordinates()),
            0.0);
  EXPECT_NE(message<BadInput>([&] {
              (void)coning_corrected(a, 0.01 * s, b, 0.0101 * s, c, 0.01 * s);
            }).find("one takes 0.0101 s, the first 0.01 s"),
            std::string::npos);
  EXPECT_NE(message<BadInput>([&] { (void)coning_corrected(a, 0.01 * s, b, 0.01 * s, c, 0.02 * s); }), "");
}

TEST(Coning, RefusesDurationsWhoseRatioOverflows) {
  const auto a = motion.count(0.0, 0.01), b = motion.count(0.01, 0.01);
  const auto said = [&](const char* action, const auto& corrected, double h1, double h2) {
    const std::string text =
        message<BadInput>([&] { (void)corrected(a, h1 * si::second, b, h2 * si::second); });
    return text.empty() ? ""
                        : std::string{contains(text, std::string{action} + "(of ") ? "" : "no action "} +
                              text.substr(text.find("): ") + 3);
  };
  const auto after = [](const auto&... x) { return coning_corrected_after(x...); };
  const auto two = [](const auto&... x) { return coning_corrected(x...); };
  const std::string overflows =
      "counts over " + detail::text(1e-320) + " s and over 0.01 s; the ratio of their durations overflows";
  EXPECT_EQ(said("coning_corrected_after", after, 1e-320, 0.01), overflows);
  EXPECT_EQ(said("coning_corrected", two, 1e-320, 0.01), overflows);
  EXPECT_NE(said("coning_corrected", two, 0.01, 1e-320), "");
  // The formulas overflow only with the ratio itself, and a short interval after a long one has no
  // correction.
  for (const double ratio : {1e200, 1e-200, 1e-320}) {
    const auto theta = coning_corrected_after(a, 1.0 * si::second, b, ratio * si::second);
    EXPECT_TRUE(theta.coordinates().allFinite()) << ratio;
  }
  EXPECT_EQ(coning_corrected_after(a, 1.0 * si::second, b, 1e-320 * si::second).coordinates(),
            b.coordinates());
  EXPECT_TRUE(coning_corrected(a, 1.0 * si::second, b, 1e200 * si::second).coordinates().allFinite());
}

TEST(Coning, EqualIntervalsNeedNoDuration) {
  const double h = 0.01;
  const auto first = motion.count(0.0, h), second = motion.count(h, h);
  EXPECT_LE(distance(coning_corrected_after(first, h * si::second, second, h * si::second).coordinates(),
                     coning_corrected_after(first, second).coordinates()),
            rounding * second.coordinates().norm());
  EXPECT_LE(distance(coning_corrected(first, h * si::second, second, h * si::second).coordinates(),
                     coning_corrected(first, second).coordinates()),
            rounding * second.coordinates().norm());
  for (const double bad : {0.0, -0.01, std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_NE(message<BadInput>(
                  [&] { (void)coning_corrected_after(first, bad * si::second, second, h * si::second); }),
              "");
    EXPECT_NE(message<BadInput>(
                  [&] { (void)coning_corrected_after(first, h * si::second, second, bad * si::second); }),
              "");
    EXPECT_NE(
        message<BadInput>([&] { (void)coning_corrected(first, bad * si::second, second, h * si::second); }),
        "");
  }
}

TEST(Coning, AdjoiningCountsAdd) {
  const auto whole = motion.count(0.2, 0.03);
  const auto parts = motion.count(0.2, 0.01) + motion.count(0.21, 0.02);
  EXPECT_LE(distance(whole.coordinates(), parts.coordinates()), rounding);
}

GyroErrors<Body> errors() {
  Eigen::Matrix<double, 3, 2> lean;
  lean << 1e-3, -2e-3, 3e-3, 4e-3, -5e-3, 6e-3;
  return gyro_errors(vector<si::angular_velocity>(in<Body>, Eigen::Vector3d(1e-3, -2e-3, 3e-3)),
                     vector<si::dimensionless>(in<Body>, Eigen::Vector3d(1e-2, 2e-2, -3e-2)), lean);
}

TEST(Gyro, MeasuresByItsModel) {
  const auto w = angular_velocity(of<Body>, relative_to<Gcrf>,
                                  vector<si::angular_velocity>(in<Body>, Eigen::Vector3d(0.1, 0.2, 0.3)));
  const Eigen::Vector3d expected(1.01 * 0.1 + 1e-3 * 0.2 - 2e-3 * 0.3 + 1e-3,
                                 3e-3 * 0.1 + 1.02 * 0.2 + 4e-3 * 0.3 - 2e-3,
                                 -5e-3 * 0.1 + 6e-3 * 0.2 + 0.97 * 0.3 + 3e-3);
  EXPECT_LE(distance(errors().applied(w).coordinates(), expected), rounding);
  EXPECT_LE(distance(errors().corrected(errors().applied(w)).coordinates(), w.coordinates()), rounding);
  const auto alpha = motion.count(0.1, 0.5);
  const auto dt = 0.5 * si::second;
  EXPECT_LE(distance(errors().corrected(errors().applied(alpha, dt), dt).coordinates(), alpha.coordinates()),
            rounding);
}

TEST(Gyro, CarriesTheAttitudeAlong) {
  const Coning wide{0.1, 20.0};
  const double h = 1.0 / 500;
  const auto dt = h * si::second;
  GyroAttitude<Gcrf, Body> known(wide.attitude(0.0), errors());
  Quaternion<Gcrf, Body> unknown = wide.attitude(0.0);
  for (int i = 0; i < 2000; ++i) {
    const auto count = errors().applied(wide.count(i * h, h), dt);
    known.add(count, dt);
    unknown = advance(unknown, rotation_vector(of<Body>, relative_to<Before<Gcrf, Body>>,
                                               vector<si::angle>(in<Body>, count.coordinates())));
  }
  const auto off = [&](const Quaternion<Gcrf, Body>& q) {
    return log(inverse(before(q)) * wide.attitude(4.0)).angle().value();
  };
  EXPECT_LT(off(known.attitude()), 1e-7);
  EXPECT_GT(off(unknown), 1e-2);
}

TEST(Gyro, RefusesBadInput) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto none = zero<si::angular_velocity>(in<Body>);
  const auto make = [&](double scale, double lean) {
    return message<BadInput>([&] {
      gyro_errors(none, vector<si::dimensionless>(in<Body>, Eigen::Vector3d(0, scale, 0)),
                  Eigen::Matrix<double, 3, 2>(Eigen::Matrix<double, 3, 2>::Constant(lean)));
    });
  };
  EXPECT_EQ(make(0.0, 0.0), "");
  EXPECT_TRUE(contains(make(-1.0, 0.0), "the determinant of the sensitivity is 0")) << make(-1.0, 0.0);
  EXPECT_TRUE(contains(make(0.0, nan), "of the sensitivity entry (1, 2) is nan")) << make(0.0, nan);
  GyroAttitude<Gcrf, Body> attitude(motion.attitude(0.0), errors());
  const auto count = measured(motion.count(0.0, 0.1));
  EXPECT_EQ(
      message<BadInput>([&] { attitude.add(count, nan * si::second); }),
      "GyroAttitude::add(of " + frame_name<Body>() + " relative to " + frame_name<Gcrf>() + "): dt is nan s");
  attitude.add(count, 1e-320 * si::second);
  const auto until_then = attitude.attitude().eigen().coeffs().eval();
  EXPECT_THROW(attitude.add(count, 0.1 * si::second), BadInput);
  EXPECT_EQ(attitude.attitude().eigen().coeffs(), until_then);
}

}  // namespace
}  // namespace coning_test
