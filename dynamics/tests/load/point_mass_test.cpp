#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <memory>
#include <vectrix/dynamics/craft/propagate.hpp>
#include <vectrix/dynamics/load/point_mass.hpp>
#include <vectrix/dynamics/rigid/euler.hpp>

#include "craft/random_spacecraft.hpp"

// The attraction of a point mass on the bodies of a craft, against sums over points with four times the
// digits, and what its potential keeps.
namespace vectrix_test::spacecraft_test::point_mass_test {
namespace {

using namespace vectrix;
using Quad = boost::multiprecision::cpp_bin_float_quad;
using QuadColumn = Eigen::Matrix<Quad, 3, 1>;

constexpr double mu_of_earth = 3.986004418e14;

Quantity<si::gravitational_parameter> parameter(double mu) {
  return Quantity<si::gravitational_parameter>::from_value(mu);
}
QuadColumn quad(const Eigen::Vector3d& v) {
  return v.cast<Quad>();
}
QuadColumn attraction(double mu, const QuadColumn& r) {
  const Quad square = r.dot(r);
  return r * Quad(-mu / (square * sqrt(square)));
}

struct Acting {
  Eigen::Vector3d force, torque;  // about the origin of the body
};
/// What a load puts on the link with a number, 0 for the hub, in the hub's axes; nothing may turn.
template <CraftType C> class Probed {
 public:
  template <class Load>
  Probed(const C& craft, const CraftState<C>& state, const Load& load)
      : core_(craft.core()), state_(state), work_(core_->tree.work()) {
    core_->tree.place(state_.data(), work_);
    const auto clear = [](auto& I) { I.n = I.f = multibody::zero_column<double>(); };
    clear(work_.hub);
    for (auto& link : work_.links) clear(link.I);
    const Now<C> seen = now();
    Forces<C> forces{vectrix::detail::trusted, seen, work_};
    load(seen, forces);
  }
  Now<C> now() const { return {vectrix::detail::trusted, *core_, 0.0, state_.data(), work_}; }
  Acting on(std::size_t link) const {
    const auto& I = link == 0 ? work_.hub : work_.links[link - 1].I;
    return {-eigen(I.f), -eigen(I.n)};
  }

 private:
  std::shared_ptr<const vectrix::detail::CraftCore> core_;
  CraftState<C> state_;
  multibody::Work<double> work_;
};

/// A body as six points with its mass, centre and inertia, at ends of its principal axes. It differs from a
/// rigid body with this inertia in the fourth order of its size.
struct SixPoints {
  double m;
  std::vector<Eigen::Vector3d> from_centre_b;
};
SixPoints six_points(double m, const Eigen::Matrix3d& J_c_b) {
  const Eigen::Matrix3d squares =
      0.5 * J_c_b.trace() * Eigen::Matrix3d::Identity() - J_c_b;  // sum of m x x^T
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(squares);
  SixPoints points{m / 6.0, {}};
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d arm =
        std::sqrt(3.0 * principal.eigenvalues()[i] / m) * principal.eigenvectors().col(i);
    points.from_centre_b.push_back(arm);
    points.from_centre_b.push_back(-arm);
  }
  return points;
}
/// The sum over the points of a body at the hub's origin r, each less the field there.
Acting summed(double mu, double m, const Eigen::Vector3d& c_b, const Eigen::Matrix3d& J_c_b,
              const Eigen::Matrix3d& R_h_from_b, const Eigen::Vector3d& origin_h, const QuadColumn& r_h) {
  QuadColumn force = QuadColumn::Zero(), torque = QuadColumn::Zero();
  const SixPoints points = six_points(m, J_c_b);
  for (const Eigen::Vector3d& p : points.from_centre_b) {
    const QuadColumn arm = R_h_from_b.cast<Quad>() * (quad(c_b) + quad(p));
    const QuadColumn F = (attraction(mu, r_h + quad(origin_h) + arm) - attraction(mu, r_h)) * Quad(points.m);
    force += F;
    torque += arm.cross(F);
  }
  return {force.cast<double>(), torque.cast<double>()};
}

constexpr double rounding_of_attraction = 1e-14;  // some 30 roundings

/// Compares with the sum over six points of the body. `arms`, m: the greatest of the lengths whose sum is the
/// place of the centre of mass, relative to the hub.
template <class B, CraftType C>
void expect_summed(const C& craft, const CraftState<C>& state, double mu, double arms) {
  using Shape = typename C::shape;
  const Probed<C> probed(craft, state, point_mass(craft, parameter(mu)));
  const PlainSpacecraft parts = plain(craft);
  const QuadColumn r_i = quad(state.hub_motion().translation.coordinates());
  // Of the numbers of the state, whose quaternion is not exactly of norm 1.
  const Eigen::Matrix<Quad, 4, 1> q = Eigen::Map<const Eigen::Vector4d>(state.data()).template cast<Quad>();
  const QuadColumn v = -q.template tail<3>();
  const QuadColumn r_h = r_i + (v.cross(r_i) * q[0] + v.cross(v.cross(r_i))) * (Quad(2) / q.squaredNorm());
  Acting wanted{};
  double distance = 0.0, of_gradient = 0.0;
  if constexpr (std::is_same_v<B, Hub>) {
    wanted = summed(mu, parts.mass, parts.r_hc_h, parts.J_c_h, Eigen::Matrix3d::Identity(),
                    Eigen::Vector3d::Zero(), r_h);
    distance = parts.r_hc_h.norm();
    of_gradient = parts.J_c_h.norm();
  } else {
    const PlainBody& b = parts.bodies[Shape::template body_at<B>];
    const Eigen::Matrix3d R_h_from_b = probed.now().rotation(to<Hub>, from<B>).matrix();
    const Eigen::Vector3d r_hb_h = probed.now().position(of<B>, relative_to<Hub>, in<Hub>).coordinates();
    wanted = summed(mu, b.mass, b.r_bc_b, b.J_c_b, R_h_from_b, r_hb_h, r_h);
    distance = (r_hb_h + R_h_from_b * b.r_bc_b).norm();
    of_gradient = b.J_c_b.norm();
  }
  const Acting found = probed.on(Shape::template link_of<B>());
  const double within = rounding_of_attraction * std::max(1.0, distance > 0.0 ? arms / distance : 1.0);
  EXPECT_LE((found.force - wanted.force).norm(), within * wanted.force.norm()) << frame_name<B>();
  of_gradient *= 3.0 * mu / std::pow(r_i.cast<double>().norm(), 3);
  EXPECT_LE((found.torque - wanted.torque).norm(), within * (of_gradient + arms * wanted.force.norm()))
      << frame_name<B>();
}

template <Frame B> MovingTransform<Gcrf, B> resting(RandomCraft& random, double distance) {
  const Eigen::Vector3d r = distance * random.triple().normalized();
  return {moving_dcm(dcm(to<Gcrf>, from<B>, random.rotation()), at_rest(of<B>, relative_to<Gcrf>, in<B>)),
          displacement(of<B>, relative_to<Gcrf>, vector<si::length>(in<Gcrf>, r)),
          at_rest(of<B>, relative_to<Gcrf>, observed_from<Gcrf>, in<Gcrf>)};
}

// Hub, hinge, gimbal, slider, ball, fixed and free joint, 6900 km from the Earth.
TEST(PointMass, EachBodyHasTheSumOverItsPoints) {
  for (unsigned long seed = 1; seed <= 10; ++seed) {
    RandomCraft random(seed);
    const Every craft(random);
    const auto still = state(craft, 0.0 * s, resting<Hub>(random, 6.9e6),
                             starts(of<Boom>, 0.3 * rad, 0.0 * rad_s), spins(of<WheelOfHub>, 0.0 * rad_s),
                             starts(of<Antenna>, 0.4 * rad, 0.0 * rad_s, -2.0 * rad, 0.0 * rad_s),
                             starts(of<Mass>, 0.7 * si::metre, 0.0 * m_s),
                             starts(moving<Boom, Gyro>(random).turning), starts(moving<Box, Probe>(random)),
                             deflects(of<Blanket>, std::array{0.0, 0.0}, std::array{0.0, 0.0}),
                             deflects(of<Tank>, 0.0, 0.0), spins(of<WheelOfBoom>, 0.0 * rad_s));
    constexpr double arms = 10.0;
    expect_summed<Hub>(craft, still, mu_of_earth, arms);
    expect_summed<Boom>(craft, still, mu_of_earth, arms);
    expect_summed<Antenna>(craft, still, mu_of_earth, arms);
    expect_summed<Mass>(craft, still, mu_of_earth, arms);
    expect_summed<Gyro>(craft, still, mu_of_earth, arms);
    expect_summed<Box>(craft, still, mu_of_earth, arms);
    expect_summed<Probe>(craft, still, mu_of_earth, arms);
  }
}

template <Frame B> MassProperties<B> ball_of(double kg, double J) {
  return mass_properties(kg * si::kilogram, coincident(of<CentreOfMassOf<B>>, relative_to<B>, in<B>),
                         inertia_from_principal_moments(in<B>, J * kg_m2, J * kg_m2, 0.8 * J * kg_m2));
}
auto make_slider() {
  return spacecraft(
      body(ball_of<Hub>(400.0, 70.0), free_in<Gcrf>),
      body(ball_of<Mass>(1.0, 1e-9),
           slider(Transform{aligned(to<Hub>, from<Mass>), coincident(of<Mass>, relative_to<Hub>, in<Hub>)},
                  unit_x(in<Mass>))));
}
struct WithSlider : decltype(make_slider()) {
  WithSlider() : decltype(make_slider())(make_slider()) {}
};

// No digits are lost near the hub: across, along and aslant to the vertical.
TEST(PointMass, ABodyIsNearTheHubOrFarFromIt) {
  const WithSlider craft;
  RandomCraft random(20261129);
  for (const double length : {1e-7, 1e-4, 1.0, 100.0, 1e4}) {
    for (const Eigen::Vector3d& vertical : {Eigen::Vector3d(1, 0, 0), Eigen::Vector3d(0, 1, 0),
                                            Eigen::Vector3d(0.6, 0, 0.8), Eigen::Vector3d(1e-9, 1, 0)}) {
      auto hub = resting<Hub>(random, 6.9e6);
      hub.translation = displacement(of<Hub>, relative_to<Gcrf>,
                                     hub.turning.rotation * vector<si::length>(in<Hub>, 6.9e6 * vertical));
      const auto start = state(craft, 0.0 * s, hub, starts(of<Mass>, length * si::metre, 0.0 * m_s));
      expect_summed<Mass>(craft, start, mu_of_earth, length);
    }
  }
}

// Of one body: the law of gravity.hpp, at the centre of mass.
TEST(PointMass, OneBodyHasTheTorqueOfTheGradient) {
  RandomCraft random(3);
  for (int trial = 0; trial < 20; ++trial) {
    const auto properties = mass<Hub>(random, 10.0);
    const auto craft = spacecraft(body(properties, free_in<Gcrf>));
    auto X_i_from_h = moving<Gcrf, Hub>(random, 100.0);
    const auto start = state(craft, 0.0 * s, X_i_from_h);
    const auto mu = parameter(random.between(10.0, 1000.0));
    const auto r_ic_h =
        inverse(X_i_from_h.turning.rotation) * X_i_from_h.translation.vector() + properties.centre().vector();
    const auto wanted = euler(properties.inertia(), X_i_from_h.turning.angular_velocity,
                              gravity_gradient_torque(mu, properties.inertia(), r_ic_h));
    const auto found = motion(craft, start, point_mass(craft, mu)).angular_acceleration(of<Hub>, in<Hub>);
    expect_same(found.coordinates(), wanted.coordinates());
  }
}

auto make_hinged() {
  RandomCraft random(20261130);
  return spacecraft(body(mass<Hub>(random, 10.0), free_in<Gcrf>),
                    body(mass<Boom>(random, 3.0), hinge(place<Hub, Boom>(random), axis<Boom>(random))),
                    body(mass<Box>(random, 3.0), hinge(place<Boom, Box>(random), axis<Box>(random))),
                    rotor(of<WheelOfBoom>, axis<Boom>(random), 0.01 * kg_m2));
}
struct Hinged : decltype(make_hinged()) {
  Hinged() : decltype(make_hinged())(make_hinged()) {}
};
/// -mu m/|r_c| - mu/2 (tr J - 3 u.J u)/|r_c|^3
template <class B>
double potential(const Now<Hinged>& now, double mu, double m, const Eigen::Vector3d& c_b,
                 const Eigen::Matrix3d& J_c_b) {
  const Eigen::Vector3d r_b = now.position(of<B>, relative_to<Gcrf>, in<B>).coordinates() + c_b,
                        u = r_b.normalized();
  const double r = r_b.norm();
  return -mu * m / r - 0.5 * mu * (J_c_b.trace() - 3.0 * u.dot(J_c_b * u)) / (r * r * r);
}
double total_energy(const Hinged& craft, const CraftState<Hinged>& state, double mu) {
  const auto moving = motion(craft, state);
  const auto now = moving.now();
  const PlainSpacecraft parts = plain(craft);
  const PlainBody &boom = parts.bodies[0], &box = parts.bodies[1];
  return now.energy().value() + potential<Hub>(now, mu, parts.mass, parts.r_hc_h, parts.J_c_h) +
         potential<Boom>(now, mu, boom.mass, boom.r_bc_b, boom.J_c_b) +
         potential<Box>(now, mu, box.mass, box.r_bc_b, box.J_c_b);
}

// So near that all terms count: without the force of the second order the angular momentum changes in its
// fourth digit.
TEST(PointMass, EnergyAndAngularMomentumAreKept) {
  const Hinged craft;
  RandomCraft random(8);
  constexpr double mu = 80.0, r = 20.0;
  const MovingTransform<Gcrf, Hub> X_i_from_h{
      moving_dcm(dcm(to<Gcrf>, from<Hub>, random.rotation()),
                 angular_velocity(of<Hub>, relative_to<Gcrf>,
                                  vector(in<Hub>, 0.1 * rad_s, -0.2 * rad_s, 0.3 * rad_s))),
      displacement(of<Hub>, relative_to<Gcrf>,
                   vector(in<Gcrf>, r * si::metre, 0.0 * si::metre, 1.0 * si::metre)),
      velocity(of<Hub>, relative_to<Gcrf>, observed_from<Gcrf>,
               vector(in<Gcrf>, 0.0 * m_s, std::sqrt(mu / r) * m_s, 0.3 * m_s))};
  const auto start = state(craft, 0.0 * s, X_i_from_h, starts(of<Boom>, 0.4 * rad, 0.1 * rad_s),
                           starts(of<Box>, -1.0 * rad, 0.2 * rad_s), spins(of<WheelOfBoom>, 30.0 * rad_s));
  const auto end =
      propagate(scenario(craft, point_mass(craft, parameter(mu))), start,
                {.end = 100.0 * s,
                 .relative_tolerance = 1e-13,
                 .absolute_tolerances = {1e-13 * rad, 1e-13 * rad_s, 1e-13 * si::metre, 1e-13 * m_s, 1e-13}})
          .at(100.0 * s);
  constexpr double kept = 1e-10;  // relative: some 500 steps with an error of 1e-13 each
  const double energy = total_energy(craft, start, mu);
  EXPECT_NEAR(total_energy(craft, end, mu), energy, kept * std::abs(energy));
  const auto before = motion(craft, start).angular_momentum(), after = motion(craft, end).angular_momentum();
  EXPECT_LE((after - before).coordinates().norm(), kept * before.coordinates().norm());
  EXPECT_GT(std::abs(end.coordinate(of<Boom>).value() - 0.4), 0.1);
}

TEST(PointMass, RefusesBadInput) {
  const WithSlider craft;
  EXPECT_EQ(
      message<BadInput>([&] { point_mass(craft, parameter(std::numeric_limits<double>::quiet_NaN())); }),
      "point_mass: the gravitational parameter is nan m^3/s^2");
  EXPECT_EQ(message<BadInput>([&] { point_mass(craft, parameter(-1.0)); }),
            "point_mass: the gravitational parameter is -1 m^3/s^2; it must be positive");
  RandomCraft random(5);
  const auto start =
      state(craft, 0.0 * s, resting<Hub>(random, 0.0), starts(of<Mass>, 1.0 * si::metre, 0.0 * m_s));
  EXPECT_EQ(message<BadInput>([&] { motion(craft, start, point_mass(craft, parameter(1.0))); }),
            "point_mass(r in " + frame_name<Hub>() +
                "): mu is 1 m^3/s^2 and |r| 0 m; mu must be positive, mu/|r|^3 finite");
}

}  // namespace
}  // namespace vectrix_test::spacecraft_test::point_mass_test
