// The conventions of Simbody on which the reference depends. Each is tested by a case whose answer is known
// by hand; then the same conventions are tested through the adapter.

#include <Simbody.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "simbody_reference.hpp"

namespace {

using namespace vectrix::validation;
using SimTK::Mat33;
using SimTK::Rotation;
using SimTK::State;
using SimTK::Vec3;

constexpr double rounding = 1e-14;        // a few products of numbers of order 1 to 10
constexpr double tight_accuracy = 1e-12;  // of Simbody's local error in the runs below

// A rotation with rational entries, not symmetric, all entries of a row or column different. Columns: body
// axes in ground.
const Mat33 known_rotation = Mat33(6, 2, 3, -3, 6, 2, -2, -3, 6) / 7.0;
const Matrix3 known_R_i_from_b{6. / 7, 2. / 7, 3. / 7, -3. / 7, 6. / 7, 2. / 7, -2. / 7, -3. / 7, 6. / 7};
const Matrix3 known_inertia{5.0, -0.7, 0.4, -0.7, 7.0, 0.9, 0.4, 0.9, 8.0};

Vector3 times(const Matrix3& M, const Vector3& v) {
  return {M[0] * v[0] + M[1] * v[1] + M[2] * v[2], M[3] * v[0] + M[4] * v[1] + M[5] * v[2],
          M[6] * v[0] + M[7] * v[1] + M[8] * v[2]};
}
Matrix3 transposed(const Matrix3& M) {
  return {M[0], M[3], M[6], M[1], M[4], M[7], M[2], M[5], M[8]};
}
Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double norm(const Vector3& v) {
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

template <class A, class B>
void expect_near(const A& actual, const B& expected, int count, double tolerance, const char* what) {
  for (int i = 0; i < count; ++i) {
    const auto k = static_cast<typename A::size_type>(i);
    EXPECT_NEAR(actual[k], expected[k], tolerance) << what << "[" << i << "]";
  }
}
void expect_near(const Vector3& actual, const Vector3& expected, double tolerance, const char* what) {
  expect_near(actual, expected, 3, tolerance, what);
}
void expect_near(const Vec3& actual, const Vec3& expected, double tolerance, const char* what) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], tolerance) << what << "[" << i << "]";
}

/// One rigid body on a Free mobilizer, turned to the known rotation.
class SimbodyConvention : public ::testing::Test {
 protected:
  SimbodyConvention()
      : matter(system),
        free(matter.Ground(), SimTK::Body::Rigid(SimTK::MassProperties(
                                  2.0, Vec3(0), SimTK::Inertia(Vec3(5, 7, 8), Vec3(-0.7, 0.4, 0.9))))) {
    matter.setShowDefaultGeometry(false);
    state = system.realizeTopology();
    system.realizeModel(state);
    free.setQToFitRotation(state, Rotation(known_rotation, true));
  }

  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter;
  SimTK::MobilizedBody::Free free;
  State state;
};

TEST_F(SimbodyConvention, BodyRotationTakesBodyCoordinatesToGround) {
  system.realize(state, SimTK::Stage::Position);
  const Vec3 p_b(0.3, -1.1, 2.0);
  const Vec3 p_ground = free.findStationLocationInGround(state, p_b);
  expect_near(p_ground, known_rotation * p_b, rounding, "station in ground");
  expect_near(free.getBodyRotation(state) * p_b, p_ground, rounding, "R_G_from_B p_B");
}

TEST_F(SimbodyConvention, BodyAngularVelocityIsExpressedInGround) {
  const Vec3 w_ground(0.2, -0.5, 0.9);
  free.setUToFitAngularVelocity(state, w_ground);
  system.realize(state, SimTK::Stage::Velocity);
  const Vec3 p_b(0.3, -1.1, 2.0);
  // v = w x p, all in ground: Simbody computes the velocity of a station, the test computes the product.
  expect_near(SimTK::cross(free.getBodyAngularVelocity(state), known_rotation * p_b),
              free.findStationVelocityInGround(state, p_b), rounding, "w x p");
}

TEST_F(SimbodyConvention, SpeedsOfFreeAreInTheParentFrameAngularFirst) {
  for (int i = 0; i < 6; ++i) free.setOneU(state, i, 0.1 + 0.3 * i);
  system.realize(state, SimTK::Stage::Velocity);
  expect_near(free.getBodyAngularVelocity(state), Vec3(0.1, 0.4, 0.7), rounding, "u[0..2]");
  expect_near(free.getBodyOriginVelocity(state), Vec3(1.0, 1.3, 1.6), rounding, "u[3..5]");
}

TEST_F(SimbodyConvention, AngularMomentumIsTensorTimesAngularVelocity) {
  const Vec3 w_b(0.2, -0.5, 0.9);
  free.setUToFitAngularVelocity(state, known_rotation * w_b);
  system.realize(state, SimTK::Stage::Velocity);
  const Vec3 h_b = ~known_rotation * system.getMatterSubsystem().calcSystemCentralMomentum(state)[0];
  const Vector3 expected = times(known_inertia, {w_b[0], w_b[1], w_b[2]});
  expect_near(h_b, Vec3(expected[0], expected[1], expected[2]), 10 * rounding, "J w");
}

TEST(SimbodyInertia, OffDiagonalArgumentsAreTensorEntriesInTheOrderXyXzYz) {
  const SimTK::Inertia J(5, 7, 8, -0.7, 0.4, 0.9);
  EXPECT_EQ(J.toMat33()[0][1], -0.7);
  EXPECT_EQ(J.toMat33()[0][2], 0.4);
  EXPECT_EQ(J.toMat33()[1][2], 0.9);
  // A point mass has the tensor entry -m x y; its product of inertia would be +m x y.
  EXPECT_DOUBLE_EQ(SimTK::Inertia(Vec3(2, 3, 5), 0.5).toMat33()[0][1], -0.5 * 2 * 3);
}

TEST(SimbodyRotation, ConstructionFromAMatrixRepairsItSilently) {
  Mat33 stretched = known_rotation;
  stretched[0][1] += 1e-3;
  const Rotation repaired(stretched);
  const Mat33 unit(1, 0, 0, 0, 1, 0, 0, 0, 1);
  EXPECT_GT((stretched * ~stretched - unit).norm(), 1e-3);
  EXPECT_LT((repaired * ~repaired - unit).norm(), rounding);
  EXPECT_GT((repaired.asMat33() - stretched).norm(), 1e-4);
  EXPECT_EQ((Rotation(stretched, true).asMat33() - stretched).norm(), 0.0);  // the unchecked constructor
}

// Yaw and roll of a quarter turn, no pitch. With body-fixed axes, x of the body ends along y; with ground
// axes it ends along z. The columns of R_AB, and so of R_a_from_b, are the axes of the body.
TEST(SimbodyRotation, BodySequencesAreIntrinsicAndSpaceSequencesExtrinsic) {
  const double quarter = SimTK::Pi / 2;
  const Rotation body(SimTK::BodyRotationSequence, quarter, SimTK::ZAxis, 0.0, SimTK::YAxis, quarter,
                      SimTK::XAxis);
  EXPECT_LT((body.asMat33() - Mat33(0, 0, 1, 1, 0, 0, 0, 1, 0)).norm(), rounding);
  const Rotation space(SimTK::SpaceRotationSequence, quarter, SimTK::ZAxis, 0.0, SimTK::YAxis, quarter,
                       SimTK::XAxis);
  EXPECT_LT((space.asMat33() - Mat33(0, -1, 0, 0, 0, -1, 1, 0, 0)).norm(), rounding);
}

SimbodyBody resting_body() {
  SimbodyBody body{};
  body.mass_kg = 3.0;
  body.inertia_tensor_b = known_inertia;
  body.R_i_from_b = known_R_i_from_b;
  return body;
}

SimbodyRun propagate(const SimbodyBody& body, const std::vector<double>& times_s,
                     SimbodyIntegrator integrator = SimbodyIntegrator::runge_kutta_merson,
                     double accuracy = tight_accuracy) {
  return simbody_propagate(body, accuracy, times_s, integrator);
}

constexpr double low_orbit_mu = 3.986004415e14;
const SimbodyOrbit low_orbit{low_orbit_mu, {-4292653.0, 955168.0, 5139356.0}, {109.6, -7527.7, 1484.5}};

TEST(SimbodyAdapter, FirstSampleIsTheStateGiven) {
  SimbodyBody body = resting_body();
  body.w_ib_b = {0.2, -0.5, 0.9};
  body.orbit = low_orbit;
  const auto run = propagate(body, {12.5});
  ASSERT_EQ(run.samples.size(), 1u);
  EXPECT_EQ(run.samples[0].t_s, 12.5);
  expect_near(run.samples[0].R_i_from_b, known_R_i_from_b, 9, rounding, "R_i_from_b");
  expect_near(run.samples[0].w_ib_b, body.w_ib_b, rounding, "w_ib_b");
  EXPECT_EQ(run.samples[0].r_i_m, low_orbit.r_i_m);
  EXPECT_EQ(run.samples[0].v_i_m_s, low_orbit.v_i_m_s);
}

TEST(SimbodyAdapter, RotationGrowsByTheBodyRate) {
  // Rdot_b^i = R_b^i [w_ib^b]x: a central difference in time, with error dt^2 |w|^3 / 6, about 2e-9.
  constexpr double dt = 1e-4, difference_tolerance = 1e-8;
  SimbodyBody body = resting_body();
  body.w_ib_b = {0.2, -0.5, 0.9};
  const auto run = propagate(body, {0.0, 1.0 - dt, 1.0, 1.0 + dt});
  const auto& middle = run.samples[2];
  const Vector3 p_b{0.3, -1.1, 2.0};
  const Vector3 before = times(run.samples[1].R_i_from_b, p_b), after = times(run.samples[3].R_i_from_b, p_b);
  const Vector3 rate = times(middle.R_i_from_b, cross(middle.w_ib_b, p_b));
  for (std::size_t k = 0; k < 3; ++k)
    EXPECT_NEAR((after[k] - before[k]) / (2 * dt), rate[k], difference_tolerance) << k;
}

// The exact torque-free motion of a tri-axial body after 400 s (Jacobi's elliptic solution, 20 digits).
struct TorqueFree {
  static constexpr double start_s = 5.0, stop_s = 405.0;  // the start time is not 0
  static constexpr std::array<double, 4> initial_q{0.89956426664365806392, 0.43678842724808730437, 0, 0};
  static constexpr std::array<double, 4> final_q{0.45122360833967579056, -0.096361821125386329099,
                                                 0.829980293402275267, -0.31343957514997204998};
  SimbodyBody body{
      1.0,  {0.375, 0, 0, 0, 0.5, 0, 0, 0, 0.625}, R_i_from_b(initial_q), {0.05, 0, 0.04}, std::nullopt, {},
      false};
  Vector3 w_ib_b{-0.033902585735236990424, -0.045010243508532121694, 0.028100377074357148205};

  /// Hamilton quaternion of body to inertial, scalar first: v^i = q v^b q*.
  static Matrix3 R_i_from_b(const std::array<double, 4>& q) {
    const auto& [w, x, y, z] = q;
    return {1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
            2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
            2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y)};
  }

  Vector3 error(SimbodyIntegrator integrator, double accuracy) const {
    const auto w = propagate(body, {start_s, stop_s}, integrator, accuracy).samples.back().w_ib_b;
    return {w[0] - w_ib_b[0], w[1] - w_ib_b[1], w[2] - w_ib_b[2]};
  }
};

TEST(SimbodyAdapter, TorqueFreeMotionIsExact) {
  constexpr double rate_reached = 1e-11, rotation_reached = 1e-9;  // three times the measured errors
  const TorqueFree exact;
  const auto last = propagate(exact.body, {exact.start_s, exact.stop_s}).samples.back();
  expect_near(last.w_ib_b, exact.w_ib_b, rate_reached, "w_ib_b");
  expect_near(last.R_i_from_b, exact.R_i_from_b(exact.final_q), 9, rotation_reached, "R_i_from_b");
}

TEST(SimbodyAdapter, ErrorFallsWithAccuracyForEveryIntegrator) {
  const TorqueFree exact;
  for (const auto kind : {SimbodyIntegrator::runge_kutta_merson, SimbodyIntegrator::runge_kutta_feldberg}) {
    const double loose = norm(exact.error(kind, 1e-6)), middle = norm(exact.error(kind, 1e-9)),
                 tight = norm(exact.error(kind, 1e-12));
    EXPECT_LT(middle, loose / 50) << static_cast<int>(kind);
    EXPECT_LT(tight, middle / 50) << static_cast<int>(kind);
  }
}

TEST(SimbodyAdapter, AngularMomentumStaysInInertialAxes) {
  constexpr double reached = 1e-9;  // of |h| = 8.6 N m s
  SimbodyBody body = resting_body();
  body.w_ib_b = {0.2, -0.5, 0.9};
  const auto run = propagate(body, {0.0, 7.0, 30.0});
  const Vector3 h_i = times(known_R_i_from_b, times(known_inertia, body.w_ib_b));
  for (const auto& s : run.samples)
    expect_near(times(s.R_i_from_b, times(known_inertia, s.w_ib_b)), h_i, reached, "R J w");
}

TEST(SimbodyAdapter, PulseTorqueIsInBodyAxesAndStopsOnTime) {
  // A ball: J w = tau t about an axis fixed in the body. With a torque fixed in ground axes the vector would
  // differ.
  constexpr double reached = 1e-12;
  SimbodyBody body = resting_body();
  body.inertia_tensor_b = {4, 0, 0, 0, 4, 0, 0, 0, 4};
  const double start = 1.0 / 3, stop = 1.7, second_start = 1.1, second_stop = 2.9;
  const Vector3 first{0.4, -0.8, 1.3}, second{-0.3, 0.2, 0.1};
  body.pulses = {{start, stop, first}, {second_start, second_stop, second}};
  const auto run = propagate(body, {0.2, 0.3, 1.0, 2.0, 5.0});
  const auto rate = [&](double t) {
    Vector3 w{};
    for (std::size_t k = 0; k < 3; ++k)
      w[k] = (first[k] * std::max(0.0, std::min(t, stop) - start) +
              second[k] * std::max(0.0, std::min(t, second_stop) - second_start)) /
             4;
    return w;
  };
  for (const auto& s : run.samples) expect_near(s.w_ib_b, rate(s.t_s), reached, "w_ib_b");
  EXPECT_EQ(run.samples[1].w_ib_b, (Vector3{0, 0, 0}));
}

TEST(SimbodyAdapter, EverySampleIsTheEndOfAStep) {
  // At this accuracy the motion needs only about twelve steps; if samples were interpolated, they would add
  // none.
  SimbodyBody body = resting_body();
  body.w_ib_b = {0.2, -0.5, 0.9};
  body.pulses = {{0.0, 1.985, {0.01, -0.02, 0.03}}};  // steps before a jump of the torque count too
  std::vector<double> times_s(201);
  for (std::size_t k = 0; k < times_s.size(); ++k) times_s[k] = 0.01 * static_cast<double>(k);
  const auto run = propagate(body, times_s, SimbodyIntegrator::runge_kutta_merson, 1e-4);
  EXPECT_EQ(run.samples.size(), times_s.size());
  EXPECT_GE(run.steps, 200);
  EXPECT_LT(propagate(body, {0.0, 2.0}, SimbodyIntegrator::runge_kutta_merson, 1e-4).steps, 50);
}

TEST(SimbodyAdapter, InertiaArgumentIsTensorEntries) {
  // From rest J w = tau t, except for the effect of w x J w, (tau t)^2 t / (3 J): 2e-8 of tau t after 1e-3 s.
  constexpr double short_time = 1e-3, gyroscopic = 1e-7;
  SimbodyBody body = resting_body();
  body.pulses = {{0.0, 1.0, {0.4, -0.8, 1.3}}};
  const auto w = propagate(body, {0.0, short_time}).samples.back().w_ib_b;
  const Vector3 h_b = times(known_inertia, w);
  expect_near(h_b, {0.4 * short_time, -0.8 * short_time, 1.3 * short_time}, short_time * gyroscopic, "J w");
}

TEST(SimbodyAdapter, GravityGradientTorqueIsThreeMuOverR5TimesRCrossJr) {
  // From rest w = J^-1 tau t. After 0.1 s the body has turned 1e-8 rad and the orbit 1e-4 rad.
  constexpr double short_time = 0.1, orbit_turn = 3e-4;
  SimbodyBody body = resting_body();
  body.orbit = low_orbit;
  body.gravity_gradient = true;
  const Vector3 r_b = times(transposed(known_R_i_from_b), low_orbit.r_i_m);
  const Vector3 r_x_Jr = cross(r_b, times(known_inertia, r_b));
  const double factor = 3 * low_orbit_mu / std::pow(norm(r_b), 5);
  const auto w = propagate(body, {0.0, short_time}).samples.back().w_ib_b;
  const Vector3 tau_b = times(known_inertia, {w[0] / short_time, w[1] / short_time, w[2] / short_time});
  const Vector3 expected{factor * r_x_Jr[0], factor * r_x_Jr[1], factor * r_x_Jr[2]};
  ASSERT_GT(norm(expected), 1e-7);
  expect_near(tau_b, expected, orbit_turn * norm(expected), "tau_b");
}

TEST(SimbodyAdapter, GravityGradientRightsALongBodyAlongTheVertical) {
  // Circular orbit in the x-y plane; the long axis (least inertia) is 0.1 rad off the vertical. Pitch
  // oscillates about the vertical at sqrt(3 (Jx - Jr) / Jz) n: after half a period it is -0.1 rad.
  constexpr double amplitude_effect = 1e-3;  // rad: the oscillation of 0.1 rad is not exactly harmonic
  const double radius = 7e6, n = std::sqrt(low_orbit_mu / std::pow(radius, 3)), tilt = 0.1;
  const double least = 2.0, across = 9.0, normal = 10.0;
  SimbodyBody body{};
  body.mass_kg = 100.0;
  body.inertia_tensor_b = {least, 0, 0, 0, across, 0, 0, 0, normal};
  body.R_i_from_b = {std::cos(tilt), -std::sin(tilt), 0, std::sin(tilt), std::cos(tilt), 0, 0, 0, 1};
  body.w_ib_b = {0, 0, n};
  body.orbit = SimbodyOrbit{low_orbit_mu, {radius, 0, 0}, {0, radius * n, 0}};
  body.gravity_gradient = true;
  const double half_swing = M_PI / (n * std::sqrt(3 * (across - least) / normal));
  const auto last = propagate(body, {0.0, half_swing}).samples.back();
  const double heading = std::atan2(last.R_i_from_b[3], last.R_i_from_b[0]);
  const double vertical = std::atan2(last.r_i_m[1], last.r_i_m[0]);
  EXPECT_NEAR(std::remainder(heading - vertical, 2 * M_PI), -tilt, amplitude_effect);
}

TEST(SimbodyAdapter, OrbitClosesAfterOnePeriod) {
  constexpr double reached_m = 1e-3, reached_m_s = 1e-6;  // 1e-10 of the orbit
  SimbodyBody body = resting_body();
  body.orbit = low_orbit;
  const double r = norm(low_orbit.r_i_m), v = norm(low_orbit.v_i_m_s);
  const double semi_major_axis = 1.0 / (2.0 / r - v * v / low_orbit_mu);
  const double period = 2 * M_PI * std::sqrt(std::pow(semi_major_axis, 3) / low_orbit_mu);
  const auto run = propagate(body, {0.0, period / 4, period});
  expect_near(run.samples.back().r_i_m, low_orbit.r_i_m, reached_m, "r_i");
  expect_near(run.samples.back().v_i_m_s, low_orbit.v_i_m_s, reached_m_s, "v_i");
  EXPECT_GT(run.rhs_evaluations, run.steps);
  EXPECT_GT(run.steps, 10);
}

TEST(SimbodyAdapter, BadDataIsRefusedByName) {
  const auto refused = [](const char* word, const std::function<void(SimbodyBody&)>& spoil,
                          double accuracy = 1e-6, const std::vector<double>& times_s = {0.0, 1.0}) {
    SimbodyBody body = resting_body();
    spoil(body);
    try {
      propagate(body, times_s, SimbodyIntegrator::runge_kutta_merson, accuracy);
      ADD_FAILURE() << "accepted: " << word;
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
    }
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto nothing = [](SimbodyBody&) {};
  EXPECT_NO_THROW(propagate(resting_body(), {0.0, 1.0}));
  refused("mass_kg", [](auto& b) { b.mass_kg = -1; });
  refused("w_ib_b[1] is not finite", [&](auto& b) { b.w_ib_b[1] = nan; });
  refused("not orthogonal", [](auto& b) { b.R_i_from_b[1] += 1e-9; });
  refused("determinant", [](auto& b) {
    for (auto& entry : b.R_i_from_b) entry = -entry;
  });
  refused("symmetric", [](auto& b) { b.inertia_tensor_b[1] = -b.inertia_tensor_b[3]; });
  refused("positive definite", [](auto& b) { b.inertia_tensor_b = {1, 2, 0, 2, 1, 0, 0, 0, 2}; });
  refused("triangle", [](auto& b) { b.inertia_tensor_b = {1, 0, 0, 0, 2, 0, 0, 0, 3.1}; });
  refused("trace", [](auto& b) { b.inertia_tensor_b = {-1, 0, 0, 0, -1, 0, 0, 0, -1}; });
  refused("gravity_gradient", [](auto& b) { b.gravity_gradient = true; });
  refused("mu_m3_s2", [](auto& b) { b.orbit = SimbodyOrbit{0, {1, 0, 0}, {0, 0, 0}}; });
  refused("centre", [](auto& b) { b.orbit = SimbodyOrbit{1, {0, 0, 0}, {0, 0, 0}}; });
  refused("pulse", [](auto& b) { b.pulses = {{2, 1, {0, 0, 0}}}; });
  refused("torque_b_nm", [&](auto& b) { b.pulses = {{0, 1, {0, nan, 0}}}; });
  refused("accuracy", nothing, 0.0);
  refused("accuracy", nothing, nan);
  refused("times_s is empty", nothing, 1e-6, {});
  refused("does not increase", nothing, 1e-6, {0.0, 1.0, 1.0});
  refused("times_s[1]", nothing, 1e-6, {0.0, nan});
}

TEST(SimbodyAdapter, PlanarInertiaIsAccepted) {  // equality in the triangle inequality: 1 + 2 = 3
  SimbodyBody body = resting_body();
  body.inertia_tensor_b = {1, 0, 0, 0, 2, 0, 0, 0, 3};
  EXPECT_NO_THROW(propagate(body, {0.0, 1.0}));
}

}  // namespace
