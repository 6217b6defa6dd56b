/// Right-hand sides of trees of bodies, compared with Simbody in the same run. Prints a section of
/// docs/evidence/performance.md. Fails if the two engines disagree, or a call allocates memory.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>
#include <vectrix/dynamics.hpp>
#include <vectrix/dynamics/craft/named_spacecraft.hpp>
#include <vectrix/dynamics/multibody/hinge.hpp>
#include <vectrix/frames/scalar/larger.hpp>
#include <vectrix/simbody.hpp>

#include "testing/allocations.hpp"
#include "typed_kernels.hpp"

namespace bench {
namespace {

using namespace vectrix;
using Clock = std::chrono::steady_clock;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Numbers = std::vector<double>;

constexpr double same = 1e-10;  // relative to the largest rate: rounding of both engines, on 200 bodies
constexpr double stiffness = 3.0, damping = 0.05;

/// A chain of bodies on hinges, or all on the hub, with springs and dampers; rotors in the hub.
struct Craft {
  const char* name;
  int hinged;
  bool chain;
  int rotors;
};

Numbers random_numbers(std::mt19937_64& random, std::size_t count) {
  std::normal_distribution<double> normal;
  Numbers list(count);
  for (double& number : list) number = normal(random);
  return list;
}

PlainSpacecraft plain(const Craft& craft) {
  std::mt19937_64 random(7);
  const auto triple = [&] {
    const Numbers n = random_numbers(random, 3);
    return Vector3d(n[0], n[1], n[2]);
  };
  const auto rotation = [&] {
    const Numbers n = random_numbers(random, 4);
    return Eigen::Quaterniond(n[0], n[1], n[2], n[3]).normalized().toRotationMatrix();
  };
  PlainSpacecraft made{
      "inertial", "hub", HubMotion::free, 300.0, 0.1 * triple(), 100.0 * Matrix3d::Identity(), {}, {}, {}};
  for (int i = 0; i < craft.hinged; ++i) {
    made.bodies.push_back({"body " + std::to_string(i),
                           craft.chain && i > 0 ? made.bodies.back().name : "hub",
                           JointKind::hinge,
                           {triple().normalized()},
                           rotation(),
                           triple(),
                           3.0,
                           0.3 * triple(),
                           Vector3d(0.5, 0.6, 0.8).asDiagonal()});
  }
  for (int i = 0; i < craft.rotors; ++i)
    made.rotors.push_back({"rotor " + std::to_string(i), "hub", triple().normalized(), 0.1});
  return made;
}

multibody::Tree<double> tree(const PlainSpacecraft& craft) {
  using multibody::Column, multibody::Square;
  const auto column = [](const Vector3d& v) { return Column<double>{v.x(), v.y(), v.z()}; };
  const auto mass = [&](double m, const Vector3d& c, const Matrix3d& J_c) {
    const Matrix3d J = J_c + m * (c.squaredNorm() * Matrix3d::Identity() - c * c.transpose());
    return multibody::Mass<double>{m, column(m * c), {J(0, 0), J(1, 1), J(2, 2), J(0, 1), J(0, 2), J(1, 2)}};
  };
  multibody::TreeNumbers<double> numbers{
      craft.motion, mass(craft.mass, craft.r_hc_h, craft.J_c_h), {}, {}, {}};
  for (const PlainBody& b : craft.bodies) {
    const bool chained = b.parent != craft.hub;
    const Matrix3d& R = b.R_p_from_b;
    numbers.links.push_back(
        {chained ? static_cast<int>(numbers.links.size()) : 0,
         multibody::hinge(Square<double>{column(R.col(0)), column(R.col(1)), column(R.col(2))},
                          column(b.axes_b[0]), column(b.r_pb_p)),
         mass(b.mass, b.r_bc_b, b.J_c_b)});
  }
  for (const PlainRotor& rotor : craft.rotors)
    numbers.rotors.push_back({0, column(rotor.axis_b), rotor.inertia});
  return multibody::Tree<double>(numbers);
}

/// Without loads.
detail::SimbodyEngine simbody(const PlainSpacecraft& craft) {
  detail::SimbodyLoads none{};
  none.forces.resize(craft.bodies.size() + 1);
  none.torques.resize(craft.bodies.size() + 1);
  none.efforts.resize(craft.bodies.size());
  none.given.resize(craft.bodies.size());
  none.locked_links.resize(craft.bodies.size());
  none.driven_links.resize(craft.bodies.size());
  none.motors.resize(craft.rotors.size());
  none.locked_rotors.resize(craft.rotors.size());
  none.driven_rotors.resize(craft.rotors.size());
  none.given_spins.resize(craft.rotors.size());
  return {detail::simbody_craft(craft), SimbodyPair::merson, 1e-3, 1.0,
          [none](double, const double*, detail::SimbodyLoads& loads) { loads = none; }};
}

struct Row {
  std::function<void()> call;
  int calls;  // in a burst
  Numbers ns = {};

  /// The low percentile: on a machine that others use too, the middle measures the others.
  double time() {
    std::sort(ns.begin(), ns.end());
    return ns[ns.size() / 20];
  }
};

/// Short bursts, interleaved, so that a slow machine slows all.
void measure(std::vector<Row*> rows, int rounds) {
  std::mt19937_64 random(11);
  for (int round = 0; round < rounds; ++round) {
    std::shuffle(rows.begin(), rows.end(), random);
    for (Row* row : rows) {
      const auto begin = Clock::now();
      for (int i = 0; i < row->calls; ++i) row->call();
      row->ns.push_back(std::chrono::duration<double, std::nano>(Clock::now() - begin).count() / row->calls);
    }
  }
}

/// Measures one craft: the engine with its springs, the named craft with springs by name, Simbody without.
bool measure(const Craft& craft) {
  const PlainSpacecraft parts = plain(craft);
  const auto engine = tree(parts);
  const NamedSpacecraft named(parts);
  detail::SimbodyEngine theirs = simbody(parts);
  std::mt19937_64 random(3);
  Numbers y = random_numbers(random, named.state_size());
  std::fill(y.begin() + 7, y.begin() + 13, 0.0);
  Numbers ydot(y.size());
  auto work = engine.work();
  engine.place(y.data(), work);
  engine.solve(y.data(), ydot.data(), work);
  Numbers rates(y.size());
  theirs.rates(0.0, y.data(), rates.data());
  double largest = 1.0, difference = 0.0;
  for (std::size_t i = 4; i < rates.size(); ++i) {
    if (i >= 7 && i < 10) continue;
    largest = std::max(largest, std::abs(rates[i]));
    difference = vectrix::detail::larger(difference, std::abs(rates[i] - ydot[i]));
  }
  if (!(difference <= same * largest)) {
    std::fprintf(stderr, "trees: %s differs from Simbody by %g\n", craft.name, difference / largest);
    return false;
  }

  const auto& layout = engine.layout();
  const auto springs = [&](const NamedNow& now, NamedForces& forces) {
    for (const PlainBody& body : parts.bodies) {
      forces.effort(body.name, (-stiffness * now.angle(body.name).value() -
                                damping * now.angle_rate(body.name).value()) *
                                   si::newton_metre);
    }
  };
  const CraftTolerances tolerances{1e-9 * si::radian, 1e-9 * (si::radian / si::second), 1e-9 * si::metre,
                                   1e-9 * (si::metre / si::second), 1e-9};
  const auto problem =
      named.problem(named.state(y), 0.0 * si::second, 1.0 * si::second, 1e-9, tolerances, springs);
  // Each call needs the result of the last, as in an integrator.
  const int calls = 10 + 20000 / (20 + 10 * craft.hinged);
  Row by_engine{[&] {
                  engine.place(y.data(), work);
                  for (std::size_t i = 0; i < layout.speeds; ++i)
                    work.efforts[i] = -stiffness * y[13 + i] - damping * y[layout.speeds_begin() + i];
                  engine.solve(y.data(), ydot.data(), work);
                  y[4] += 1e-12 * ydot[4];
                },
                calls};
  Row by_name{[&] {
                problem.rhs(0.0, 0.0, y, ydot);
                y[4] += 1e-12 * ydot[4];
              },
              calls};
  Row by_simbody{[&] {
                   theirs.rates(0.0, y.data(), rates.data());
                   y[4] += 1e-12;
                 },
                 std::max(3, calls / 40)};
  const std::size_t before = vectrix_test::allocations();
  by_engine.call();
  by_name.call();
  if (vectrix_test::allocations() != before) {
    std::fprintf(stderr, "trees: %s allocates memory in a call\n", craft.name);
    return false;
  }
  measure({&by_engine, &by_name, &by_simbody}, 200);
  const double ns = by_engine.time();
  std::printf("| %s | %.0f | %.0f | %.0f | %.0f | %.1f |\n", craft.name, ns, ns / (craft.hinged + 1),
              by_name.time(), by_simbody.time(), by_simbody.time() / ns);
  return true;
}

/// A hub alone, whose attitude is the state, and the typed laws of one body.
void measure_hub() {
  const multibody::Tree<double> hub(
      {HubMotion::turning, {1.0, {0.0, 0.0, 0.0}, {1.0, 2.0, 3.0, 0.0, 0.0, 0.0}}, {}, {}, {}});
  auto work = hub.work();
  std::array<double, 7> y{1.0, 0.0, 0.0, 0.0, 0.7, 0.6, 0.6}, z = y, ydot{}, zdot{};
  const auto kg_m2 = si::kilogram_square_metre;
  const auto J_b = inertia_from_principal_moments(in<B>, 1.0 * kg_m2, 2.0 * kg_m2, 3.0 * kg_m2);
  Row by_engine{[&] {
                  hub.place(y.data(), work);
                  hub.solve(y.data(), ydot.data(), work);
                  y[4] += 1e-12 * ydot[4];
                },
                2000};
  Row by_laws{[&] {
                typed::body_rate(AttitudeState::quaternion, J_b, z, zdot);
                z[4] += 1e-12 * zdot[4];
              },
              2000};
  measure({&by_engine, &by_laws}, 200);
  std::printf(
      "\nA hub alone that only turns takes %.0f ns. The laws of one body, `rate()` and `euler()`, "
      "take %.0f ns.\n\n",
      by_engine.time(), by_laws.time());
}

}  // namespace
}  // namespace bench

int main() {
  std::printf(
      "## Trees of bodies\n\n"
      "One right-hand side, ns, g++, x86-64; each call needs the result of the last. Fifth percentiles of "
      "short "
      "interleaved bursts, because a middle value would measure the other programs on the machine. "
      "`multibody::Tree` has a spring and a damper on each joint. So has `NamedSpacecraft`, whose load finds "
      "each "
      "joint by its name. Simbody has none, and realizes its accelerations.\n\n"
      "| craft | `multibody::Tree` | a body | `NamedSpacecraft` | Simbody | times `Tree` |\n"
      "| --- | --- | --- | --- | --- | --- |\n");
  bool agree = true;
  for (const bench::Craft& craft : {bench::Craft{"hub and 2 hinged panels", 2, false, 0},
                                    {"hub and 4 balanced rotors", 0, false, 4},
                                    {"hub and chain of 5", 5, true, 0},
                                    {"hub and chain of 7", 7, true, 0},
                                    {"hub and chain of 31", 31, true, 0},
                                    {"hub and chain of 127", 127, true, 0},
                                    {"hub and chain of 199", 199, true, 0}})
    agree = bench::measure(craft) && agree;
  bench::measure_hub();
  return agree ? 0 : 1;
}
