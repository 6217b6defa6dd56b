#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>

#include <vectrix/dynamics/analysis/controllability.hpp>
#include <vectrix/dynamics/analysis/equilibrium.hpp>
#include <vectrix/dynamics/analysis/natural_modes.hpp>
#include <vectrix/dynamics/load/point_mass.hpp>
#include <vectrix/dynamics/load/springs.hpp>

#include "short_units.hpp"
#include "testing/attitudes.hpp"

// Equilibria in closed form, and where there is none; the modes about them; what wheels can move.
namespace vectrix::equilibrium_test {
namespace {

using namespace vectrix_test::short_units;
using Eigen::Matrix3d, Eigen::Vector3d;

struct Star : inertial_frame {};
struct Hub : moving_frame {};
struct Near : moving_frame {};
struct Far : moving_frame {};
template <int I> struct Wheel : named_point {};

template <Frame B> auto ball_mass(double kg) {
  return mass_properties(kg * si::kilogram, coincident(of<CentreOfMassOf<B>>, relative_to<B>, in<B>),
                         inertia_from_principal_moments(in<B>, 2.0 * kg_m2, 2.5 * kg_m2, 3.0 * kg_m2));
}
template <Frame P, Frame B> auto at(double x, double y, double z) {
  return Transform{aligned(to<P>, from<B>),
                   displacement(of<B>, relative_to<P>, vector(in<P>, x * m, y * m, z * m))};
}
const EquilibriumTolerances fine{1e-12 * (rad_s / s), 1e-12 * (m_s / s), 1e-12};
constexpr auto N_per_m = N / m;

// Three equal masses along x, with a spring between neighbours.
auto make_chain() {
  return spacecraft(body(ball_mass<Hub>(4.0), free_in<Star>),
                    body(ball_mass<Near>(4.0), slider(at<Hub, Near>(0, 0, 0), unit_x(in<Near>))),
                    body(ball_mass<Far>(4.0), slider(at<Near, Far>(0, 0, 0), unit_x(in<Far>))));
}
using Chain = decltype(make_chain());
template <class S> using OnChain = Now<Chain, S>;

CraftState<Chain> chain_state(const Chain& chain, double near, double far) {
  const MovingTransform<Star, Hub> rest{
      moving_dcm(turned_z(to<Star>, from<Hub>, 0.7 * rad), at_rest(of<Hub>, relative_to<Star>, in<Hub>)),
      displacement(of<Hub>, relative_to<Star>, vector(in<Star>, 5.0 * m, -2.0 * m, 1.0 * m)),
      at_rest(of<Hub>, relative_to<Star>, observed_from<Star>, in<Star>)};
  return state(chain, 0.0 * s, rest, starts(of<Near>, near * m, 0.0 * m_s),
               starts(of<Far>, far * m, 0.0 * m_s));
}

// Springs of 12 N/m between three masses of 4 kg: w^2 = k/m and 3 k/m; three turns and three ways are free,
// each twice zero. A damper of c on one spring: both modes are damped.
TEST(NaturalModes, OfAChainOfSprings) {
  const Chain chain = make_chain();
  const auto springs = scenario(chain, spring(chain, of<Near>, 12.0 * N_per_m, 0.5 * m),
                                spring(chain, of<Far>, 12.0 * N_per_m, 0.3 * m));
  const auto rest = equilibrium(springs, chain_state(chain, 0.6, 0.1), fine);
  EXPECT_NEAR(rest.coordinate(of<Near>).value(), 0.5, 1e-13);
  EXPECT_NEAR(rest.coordinate(of<Far>).value(), 0.3, 1e-13);
  const auto system = linearise(springs, rest);
  const NaturalModes modes = natural_modes(system);
  EXPECT_EQ(modes.zeros, 12U);
  ASSERT_EQ(modes.list.size(), 2U);
  EXPECT_NEAR(modes.list[0].frequency.value(), std::sqrt(3.0), 1e-13);
  EXPECT_NEAR(modes.list[1].frequency.value(), 3.0, 1e-13);
  for (const NaturalMode& mode : modes.list) {
    EXPECT_NEAR(mode.damping_ratio, 0.0, 1e-13);
    // A shape is an eigenvector of the whole system.
    EXPECT_LE((system.A * mode.shape - mode.eigenvalue * mode.shape).norm(), 1e-12);
    EXPECT_NEAR(mode.participation.sum(), 1.0, 1e-14);
  }
  // In the first the middle mass is at rest, its neighbours move apart: the hub by -a, Near by a on the hub,
  // Far by a on Near. Near is the middle one.
  const auto near = system.coordinate(of<Near>), far = system.coordinate(of<Far>);
  const auto& first = modes.list[0].shape;
  EXPECT_LE(std::abs(first[near] - first[far]), 1e-12 * std::abs(first[near]));
  const auto& second = modes.list[1].shape;
  EXPECT_LE(std::abs(second[near] + second[far]), 1e-12 * std::abs(second[near]));
}

// One spring and damper, the other joint at rest by a stiff spring: c/(2 sqrt(k mu)), mu = 4 * 8/12 kg.
TEST(NaturalModes, ADamperDampsAsOfTheReducedMass) {
  const auto pair = spacecraft(body(ball_mass<Hub>(4.0), turning_in<Star>),
                               body(ball_mass<Near>(8.0), slider(at<Hub, Near>(0, 0, 0), unit_x(in<Near>))));
  using Pair = std::remove_cvref_t<decltype(pair)>;
  const auto start = state(
      pair, 0.0 * s, moving_dcm(aligned(to<Star>, from<Hub>), at_rest(of<Hub>, relative_to<Star>, in<Hub>)),
      starts(of<Near>, 0.0 * m, 0.0 * m_s));
  const auto damped = [&](double c) {
    return natural_modes(linearise(scenario(pair, spring(pair, of<Near>, 24.0 * N_per_m, 0.0 * m),
                                            damper(pair, of<Near>, c * (N / m_s))),
                                   start));
  };
  const double mu = 32.0 / 12.0;
  const auto light = damped(1.6);
  ASSERT_EQ(light.list.size(), 1U);
  EXPECT_EQ(light.zeros, 6U);
  EXPECT_NEAR(light.list[0].frequency.value(), std::sqrt(24.0 / mu), 1e-13);
  EXPECT_NEAR(light.list[0].damping_ratio, 1.6 / (2.0 * std::sqrt(24.0 * mu)), 1e-13);
  EXPECT_TRUE(light.list[0].oscillates());
  const auto heavy = damped(40.0);  // s^2 + 15 s + 9
  ASSERT_EQ(heavy.list.size(), 2U);
  EXPECT_NEAR(heavy.list[0].frequency.value(), 7.5 - std::sqrt(7.5 * 7.5 - 9.0), 1e-12);
  EXPECT_NEAR(heavy.list[1].damping_ratio, 1.0, 1e-13);
  static_assert(CraftType<Pair>);
}

// A system of my own, without names: an oscillator and an input that moves it.
TEST(NaturalModes, OfASystemWithoutNames) {
  LinearSystem system;
  system.A = (Eigen::MatrixXd(2, 2) << 0.0, 1.0, -4.0, 0.0).finished();
  system.B = Eigen::MatrixXd::Zero(2, 1);
  std::ostringstream out;
  out << natural_modes(system) << controllability(system);
  EXPECT_EQ(out.str(),
            "0 zero eigenvalues\n2 rad/s, damping ratio 0: 50 % x1, 50 % x2\n"
            "0 of 2 states are controllable\nno input moves 1 (x1)\nno input moves 1 (x2)\n");
  system.state_names = {"angle [rad]"};
  EXPECT_EQ(vectrix_test::message<BadInput>([&] { natural_modes(system); }),
            "natural_modes: A has 2 rows, and 1 states have names");
  EXPECT_THROW(controllability(system), BadInput);
}

// On a hub that spins about z a mass m at the distance q has k (q - q0) = mu w^2 q.
TEST(Equilibrium, ASpinPullsASpring) {
  const auto pair = spacecraft(body(ball_mass<Hub>(4.0), turning_in<Star>),
                               body(ball_mass<Near>(8.0), slider(at<Hub, Near>(0, 0, 0), unit_x(in<Near>))));
  const double w = 1.5, k = 24.0, mu = 32.0 / 12.0;
  const auto guess =
      state(pair, 0.0 * s,
            moving_dcm(turned_x(to<Star>, from<Hub>, 0.3 * rad),
                       angular_velocity(of<Hub>, relative_to<Star>, w * rad_s * unit_z(in<Hub>))),
            starts(of<Near>, 0.4 * m, 0.9 * m_s));
  const auto pulled = scenario(pair, spring(pair, of<Near>, k * N_per_m, 0.4 * m));
  const auto steady = equilibrium(pulled, guess, fine);
  EXPECT_NEAR(steady.coordinate(of<Near>).value(), k * 0.4 / (k - mu * w * w), 1e-12);
  EXPECT_EQ(steady.speed(of<Near>).value(), 0.0);
  // A joint that is locked stays where it is, also where moving it would help to bring the spin to an axis.
  const auto tilted =
      state(pair, 0.0 * s,
            moving_dcm(turned_x(to<Star>, from<Hub>, 0.3 * rad),
                       angular_velocity(of<Hub>, relative_to<Star>,
                                        vector(in<Hub>, 0.02 * rad_s, 0.1 * rad_s, w * rad_s))),
            starts(of<Near>, 0.4 * m, 0.0 * m_s));
  const auto locked = scenario(pair, spring(pair, of<Near>, k * N_per_m, 0.4 * m),
                               [](const auto&, auto& forces) { forces.lock(of<Near>); });
  const auto upright = equilibrium(locked, tilted, fine);
  EXPECT_EQ(upright.coordinate(of<Near>).value(), 0.4);
  const Vector3d w_b = upright.turning().angular_velocity.coordinates();
  EXPECT_NEAR(w_b.z(), std::sqrt(0.02 * 0.02 + 0.1 * 0.1 + w * w), 1e-12);
}

template <class Call> NoEquilibrium refusal(const Call& call) {
  try {
    call();
  } catch (const NoEquilibrium& error) {
    return error;
  }
  ADD_FAILURE() << "no refusal";
  return {"", "", 0.0, 0};
}

TEST(Equilibrium, IsRefusedWhereThereIsNone) {
  const Chain chain = make_chain();
  const auto guess = chain_state(chain, 0.5, 0.3);
  const auto push = [](const auto&, auto& forces) { forces.torque(of<Hub>, 0.2 * N_m * unit_y(in<Hub>)); };
  const auto held = spring(chain, of<Far>, 12.0 * N_per_m, 0.3 * m);
  const auto also = spring(chain, of<Near>, 12.0 * N_per_m, 0.5 * m);
  const auto pushed = refusal([&] { equilibrium(scenario(chain, push, held, also), guess, fine); });
  EXPECT_EQ(pushed.component(), "attitude error y of " + frame_name<Hub>() + " [rad]") << pushed.what();
  EXPECT_GT(std::abs(pushed.residual()), 1e-3);
  EXPECT_NE(std::string(pushed.what()).find("none found near the guess"), std::string::npos) << pushed.what();
  // A pull that grows faster than its spring: k q - f (1 + q^2) < 0 for all q.
  const auto pull = []<class S>(const OnChain<S>& now, Forces<Chain, S>& forces) {
    const S q = now.coordinate(of<Near>).value();
    forces.effort(of<Near>, Quantity<si::force, S>::from_value(S(1.0 + q * q)));
  };
  const auto none = refusal([&] {
    equilibrium(scenario(chain, spring(chain, of<Near>, 1.5 * N_per_m, 0.0 * m), held, pull), guess, fine);
  });
  EXPECT_NE(none.component().find("of " + frame_name<Near>()), std::string::npos) << none.what();
  // With a stiffer spring, 2.5 q = 1 + q^2.
  const auto there =
      equilibrium(scenario(chain, spring(chain, of<Near>, 2.5 * N_per_m, 0.0 * m), held, pull), guess, fine);
  EXPECT_NEAR(there.coordinate(of<Near>).value(), 0.5, 1e-12);
  // A point mass pulls what is at rest.
  const auto mu = Quantity<si::gravitational_parameter>::from_value(50.0);
  refusal([&] {
    equilibrium(scenario(chain, point_mass(chain, mu), spring(chain, of<Near>, 2.5 * N_per_m, 0.0 * m), held),
                guess, fine);
  });
  EXPECT_EQ(vectrix_test::message<BadInput>([&] {
              equilibrium(scenario(chain), guess, {0.0 * (rad_s / s), 1.0 * (m_s / s), 1.0});
            }),
            "equilibrium: the tolerance of what turns is 0; it must be positive, and has no default: "
            "it is left out, or 0");
  EXPECT_THROW(equilibrium(scenario(chain, [](const auto&, auto&) { throw std::domain_error("no star"); }),
                           guess, fine),
               std::domain_error);
  // What is no number is bad input, not a search that failed.
  const auto effort = [](double newtons) {
    return [newtons](const auto&, auto& forces) { forces.effort(of<Far>, newtons * N); };
  };
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    const std::string text = vectrix_test::message<BadInput>(
        [&] { equilibrium(scenario(chain, effort(bad), held), guess, fine); });
    EXPECT_NE(text.find("equilibrium of the craft of "), std::string::npos) << text;
    EXPECT_NE(text.find(": load 1 of 2: the effort on the joint of " + frame_name<Far>() + " is "),
              std::string::npos)
        << text;
  }
  // Of the guess itself, and of the guess at rest.
  const auto over_speed = []<class S>(const OnChain<S>& now, Forces<Chain, S>& forces) {
    const S u = now.speed(of<Far>).value();
    forces.effort(of<Far>, Quantity<si::force, S>::from_value(S(1.0 / u)));
  };
  auto numbers = guess.numbers();
  numbers[Chain::shape::speed_at<Far>] = 1.0;
  const auto moving = state_from_numbers(chain, guess.time(), numbers);
  const std::string text =
      vectrix_test::message<BadInput>([&] { equilibrium(scenario(chain, over_speed, held), moving, fine); });
  EXPECT_NE(text.find("at the guess the second derivative of "), std::string::npos) << text;
}

// In a circular orbit the principal axes of a body lie along the vertical, the velocity and the normal of the
// orbit. About that attitude, Hughes, Spacecraft Attitude Dynamics, chapter 9: with k1 = (Jy - Jz)/Jx,
// k3 = (Jy - Jx)/Jz, x along the velocity, y against the normal, z down,
//     pitch w^2 = 3 n^2 (Jx - Jz)/Jy,   roll and yaw s^4 + (1 + 3 k1 + k1 k3) n^2 s^2 + 4 k1 k3 n^4 = 0
TEST(Equilibrium, AGravityGradientTrimAndItsLibrations) {
  const double Jx = 110.0, Jy = 120.0, Jz = 30.0;
  const Matrix3d R = (Eigen::AngleAxisd(0.1, Vector3d::UnitZ()) *
                      Eigen::AngleAxisd(-0.15, Vector3d::UnitY()) * Eigen::AngleAxisd(0.2, Vector3d::UnitX()))
                         .toRotationMatrix();
  const Matrix3d J = R * Vector3d(Jx, Jy, Jz).asDiagonal() * R.transpose();
  const auto sat = spacecraft(body(
      mass_properties(300.0 * si::kilogram, coincident(of<CentreOfMassOf<Hub>>, relative_to<Hub>, in<Hub>),
                      inertia_from_tensor(in<Hub>, J)),
      free_in<Star>));
  const double r = 7e6, mu = 3.986004418e14, n = std::sqrt(mu / (r * r * r));
  const auto in_orbit = scenario(sat, point_mass(sat, Quantity<si::gravitational_parameter>::from_value(mu)));
  // z down is -x of the star, y against the normal is -z, x along the velocity is y.
  Matrix3d R_i_from_l;
  R_i_from_l << 0, 0, -1, 1, 0, 0, 0, -1, 0;
  const auto at_angle = [&](double phase) {
    const Matrix3d turn = Eigen::AngleAxisd(phase, Vector3d::UnitZ()).toRotationMatrix();
    const Matrix3d R_i_from_h = turn * R_i_from_l;
    return state(
        sat, 0.0 * s,
        MovingTransform<Star, Hub>{
            moving_dcm(dcm(to<Star>, from<Hub>, R_i_from_h),
                       angular_velocity(of<Hub>, relative_to<Star>,
                                        vector<si::angular_velocity>(in<Hub>, Vector3d(0.0, -n, 0.0)))),
            displacement(of<Hub>, relative_to<Star>, vector<si::length>(in<Star>, turn * Vector3d(r, 0, 0))),
            velocity(of<Hub>, relative_to<Star>, observed_from<Star>,
                     vector<si::velocity>(in<Star>, turn * Vector3d(0, n * r, 0)))});
  };
  // Of a stiffness 3 n^2 60/120 1e-14 rad/s^2 is 6e-9 rad; 1e-14 m/s^2 is some roundings of 8 m/s^2.
  const EquilibriumTolerances tight{1e-14 * (rad_s / s), 1e-14 * (m_s / s), 1.0};
  const auto trim = equilibrium(in_orbit, at_angle(0.0), tight);
  const Matrix3d R_l_from_h = R_i_from_l.transpose() * trim.turning().rotation.matrix();
  EXPECT_LE((R_l_from_h * J * R_l_from_h.transpose() - Matrix3d(Vector3d(Jx, Jy, Jz).asDiagonal())).norm(),
            1e-5);
  EXPECT_LE((R_l_from_h - R.transpose()).norm(), 1e-7);

  const auto system = linearise(in_orbit, trim);
  const auto later = linearise(in_orbit, equilibrium(in_orbit, at_angle(1.1), tight));
  EXPECT_LE((later.A - system.A).cwiseAbs().maxCoeff(), 1e-8 * n);  // as the trims differ

  const NaturalModes modes = natural_modes(system);
  const double k1 = (Jy - Jz) / Jx, k3 = (Jy - Jx) / Jz;
  const double b = 1.0 + 3.0 * k1 + k1 * k3, root = std::sqrt(b * b - 16.0 * k1 * k3);
  const std::array librations{std::sqrt(3.0 * (Jx - Jz) / Jy), std::sqrt(0.5 * (b - root)),
                              std::sqrt(0.5 * (b + root))};
  const auto theta = system.attitude_error(of<Hub>), rate = system.rate(of<Hub>);
  std::vector<double> found;
  for (const NaturalMode& mode : modes.list)
    if (mode.participation(theta).sum() + mode.participation(rate).sum() > 0.5)
      found.push_back(mode.frequency.value() / n);
  ASSERT_EQ(found.size(), librations.size()) << modes;
  for (const double wanted : librations) {
    const auto near = [&](double w) { return std::abs(w - wanted) < 1e-7; };
    EXPECT_EQ(std::count_if(found.begin(), found.end(), near), 1) << wanted << '\n' << modes;
  }
  // Those of the orbit: along it twice zero, in and across its plane n.
  EXPECT_EQ(modes.list.size(), 5U) << modes;
  EXPECT_EQ(modes.zeros, 2U) << modes;
}

// Wheels change the attitude, but never the angular momentum of the whole craft.
TEST(Controllability, OfWheels) {
  const auto with_wheels = spacecraft(
      body(ball_mass<Hub>(4.0), turning_in<Star>), rotor(of<Wheel<1>>, unit_x(in<Hub>), 0.1 * kg_m2),
      rotor(of<Wheel<2>>, unit_y(in<Hub>), 0.1 * kg_m2), rotor(of<Wheel<3>>, unit_z(in<Hub>), 0.2 * kg_m2));
  const auto at_speeds = [&](double w1, double w2) {
    return state(
        with_wheels, 0.0 * s,
        moving_dcm(turned_x(to<Star>, from<Hub>, 0.3 * rad), at_rest(of<Hub>, relative_to<Star>, in<Hub>)),
        spins(of<Wheel<1>>, w1 * rad_s), spins(of<Wheel<2>>, w2 * rad_s), spins(of<Wheel<3>>, 0.0 * rad_s));
  };
  const auto one = motor_input(of<Wheel<1>>);
  const auto two = motor_input(of<Wheel<2>>);
  const auto three = motor_input(of<Wheel<3>>);
  const auto all =
      controllability(linearise(scenario(with_wheels), at_speeds(0, 0), inputs(one, two, three)));
  EXPECT_EQ(all.controllable, 6U);
  EXPECT_EQ(all.size, 9U);
  EXPECT_EQ(all.unmoved_eigenvalues, std::vector<std::complex<double>>(3, 0.0));
  // J w + J_s Omega about each axis; 2 to 0.1, 2.5 to 0.1, 3 to 0.2.
  const std::array<double, 3> least{0.1 / 2.0, 0.1 / 2.5, 0.2 / 3.0};
  for (Eigen::Index k = 0; k < 3; ++k) {
    Eigen::Index largest = 0;
    all.unmoved.row(k).cwiseAbs().maxCoeff(&largest);
    ASSERT_TRUE(largest >= 3 && largest < 6) << all;
    EXPECT_NEAR(all.unmoved(k, largest + 3), least[static_cast<std::size_t>(largest - 3)], 1e-12) << all;
  }
  // With two wheels at rest the third axis is lost, too: its attitude, and the speed of the third wheel.
  const auto without = linearise(scenario(with_wheels), at_speeds(0, 0), inputs(one, two));
  EXPECT_EQ(controllability(without).controllable, 4U);
  // A momentum bias couples it: then only the momentum is lost, and that of the third wheel about its axis.
  const auto biased = controllability(linearise(scenario(with_wheels), at_speeds(0, 50), inputs(one, two)));
  EXPECT_EQ(biased.controllable, 5U) << biased;
  EXPECT_EQ(vectrix_test::message<BadInput>([&] { controllability(without, 2.0); }),
            "controllability: the tolerance is 2; it must be in (0, 1)");
  const auto with_torque = linearise(scenario(with_wheels), at_speeds(0, 0),
                                     inputs(torque_input(of<Hub>, in<Star>), one, two, three));
  EXPECT_EQ(controllability(with_torque).controllable, 9U);
}

}  // namespace
}  // namespace vectrix::equilibrium_test
