#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "load/three_parts.hpp"
#include "methods.hpp"

// Every kind of change with every method, at time zero and late.
namespace vectrix_test::three_parts::methods_test {
namespace {

struct Command {
  double torque;
};
enum class Mode { up, down };
struct Samples {
  int count;
};

constexpr double tolerance = 1e-11;
constexpr double period = 0.25, latency = 0.1, kick = 1.375, last = 4.0;
constexpr double J = J_rest;

/// J w' = K (w_set - w(k T)), T after a latency, w_set = 1/2 rad/s, and 1/10 from the kick on.
struct Loop {
  static constexpr double K = 2.0;
  double setpoint = 0.5, w = 0.05, command = 0.0, seen = 0.0, t = 0.0;
  void go_to(double end) {
    w += command * (end - t) / J;
    t = end;
  }
  double rate_at(double end) {
    for (int k = 0; k * period <= end; ++k) {
      const double tick = k * period;
      if (k > 0 && kick > tick - period && kick <= tick) setpoint = 0.1;
      go_to(tick);
      seen = K * (setpoint - w);
      if (tick + latency > end) break;
      go_to(tick + latency);
      command = seen;
    }
    go_to(end);
    return w;
  }
};

double rate_of(const auto& state) {
  return state.turning().angular_velocity.z().value();
}
double hub_rate(const Now<Sat>& now) {
  return now.angular_velocity(of<Hub>, relative_to<Inertial>, in<Hub>).z().value();
}

auto place_of(const Now<Sat>& now) {
  return now.position(of<Hub>, relative_to<Inertial>, in<Inertial>).y();
}

TEST(Methods, ChangesHappenAlikeWithEach) {
  struct Setpoint {
    double value;
  };
  const Sat sat;
  for (const double epoch : {0.0, 8e8}) {
    const auto loop = scenario(
        sat, held(Command{0.0}), held(Setpoint{0.5}), held(Samples{0}), held(Mode::down),
        [](const Now<Sat>&, Forces<Sat>& forces, const Command& command) {
          forces.torque(of<Hub>, command.torque * N_m * unit_z(in<Hub>));
        },
        // To and fro, through the common centre of mass, beyond 5 cm on both sides.
        [](const Now<Sat>&, Forces<Sat>& forces, const Mode& mode) {
          forces.lock(of<Mass>);
          forces.force(of<Hub>, (mode == Mode::up ? 20.0 : -20.0) * N * unit_y(in<Inertial>));
        },
        at_start([](const Now<Sat>&) { return Mode::up; }),
        at_times({(epoch + kick) * s}, becomes(Setpoint{0.1})),
        every(
            period * s,
            [](const Now<Sat>& now, const Setpoint& set) {
              return Command{Loop::K * (set.value - hub_rate(now))};
            },
            latency * s),
        every(period * s, [](const Now<Sat>&, const Samples& samples) { return Samples{samples.count + 1}; }),
        when(
            "far", [](const Now<Sat>& now) { return place_of(now).value() - 0.05; }, ode::Direction::rising,
            becomes(Mode::down)),
        when(
            "near", [](const Now<Sat>& now) { return place_of(now).value() + 0.05; }, ode::Direction::falling,
            becomes(Mode::up)),
        when(
            "half", [](const Now<Sat>& now) { return hub_rate(now) - 0.25; }, ode::Direction::any));
    // Some 40 changes at rounded times, of accelerations up to 4.5 m/s^2, each until the end.
    const double of_time = epoch > 0.0 ? 1.2e-7 * 40 * 4.5 * last : 0.0;
    std::vector<std::string> names;
    for (const ode::Method method : methods) {
      auto how = until(epoch + last, tolerance);
      how.method = method;
      const auto flight = propagate(loop, start_of(sat, {.time = epoch, .hub_rate = 0.05}), how);
      // Each step, also one of the some fifty segments, errs by the tolerance.
      const double within =
          2.0 * tolerance * static_cast<double>(flight.solution().statistics().steps) * last + of_time;
      EXPECT_EQ(flight.held<Samples>(flight.end()).count, 16) << static_cast<int>(method);
      for (const double t : {0.05, 0.35, 1.0, 1.3, 1.45, 1.6, 2.9, 4.0})
        EXPECT_NEAR(rate_of(flight.at((epoch + t) * s)), Loop().rate_at(t), within)
            << epoch << ' ' << t << ' ' << static_cast<int>(method);
      std::vector<std::string> found;
      for (const auto& event : flight.events()) {
        found.push_back(event.name);
        const double y = event.state.hub_motion().translation.y().value();
        if (event.name == "far") {
          EXPECT_NEAR(y, 0.05, within);
        }
        if (event.name == "near") {
          EXPECT_NEAR(y, -0.05, within);
        }
        if (event.name == "half") {
          EXPECT_NEAR(rate_of(event.state), 0.25, within);
        }
      }
      if (names.empty()) names = found;
      EXPECT_EQ(found, names) << epoch << ' ' << static_cast<int>(method);
      EXPECT_GT(std::ranges::count(found, "far"), 1);
      EXPECT_GT(std::ranges::count(found, "half"), 0);
    }
  }
}

}  // namespace
}  // namespace vectrix_test::three_parts::methods_test
