#include <gtest/gtest.h>

#include <vectrix/dynamics/load/pulse.hpp>
#include <vectrix/dynamics/load/thruster.hpp>

#include "load/three_parts.hpp"
#include "methods.hpp"
#include "testing/trials.hpp"

// Changes that are closer to each other than the rounding of time, 1.2e-7 s in seconds since 2000.
namespace vectrix_test::three_parts::ticks_test {
namespace {

constexpr double epochs[] = {0.0, 8e8};
constexpr double spans[] = {1e-7, 2.5e-7, 5e-7, 7e-7, 9e-7, 1.3e-6, 5e-6};  // s
constexpr double rounding_of_time = 1.2e-7;                                 // s
constexpr double rounding = 1e-13;  // of numbers near 1, in a run of some ten steps

/// Under the sanitizers one: a change of the craft is the same code for all of them.
const auto some_methods = tried(methods);

struct Count {
  int value;
};
const auto one_more = [](const Now<Sat>&, const Count& count) { return Count{count.value + 1}; };

CraftPropagation with(ode::Method method, double end) {
  auto how = until(end);
  if (method == ode::Method::cvode_bdf) how.relative_tolerance = 1e-9;
  how.method = method;
  return how;
}

TEST(Ticks, AShortBurstEnds) {
  const Sat sat;
  constexpr double F = 1.8;
  for (const double epoch : epochs) {
    for (const double span : spans) {
      for (const double from : {0.0, 0.3}) {
        const double on = epoch + from, off = on + span;
        if (!(off > on)) continue;
        const auto fired = scenario(sat, thruster(sat, of<Hub>, F * N * unit_y(in<Inertial>),
                                                  {0.0 * s, 0.0 * s}, {{on * s, off * s}}));
        for (const ode::Method method : some_methods) {
          const auto flight = propagate(fired, start_of(sat, {.time = epoch}), with(method, epoch + 1.0));
          EXPECT_FALSE(flight.held<Firing<Hub>>(flight.end()).is_on()) << epoch << ' ' << span;
          const double velocity = flight.at(flight.end()).hub_motion().velocity.y().value();
          // Times closer than four roundings are one; then the burst may vanish.
          EXPECT_NEAR((m_hub + m_panel + m_mass) * velocity, F * (off - on),
                      epoch > 0.0 ? F * 7 * rounding_of_time : rounding);
        }
      }
    }
  }
}

// The counter sees each tick before it, also of the same instant.
TEST(Ticks, EachTickOfAListFollowsTheOneBefore) {
  const Sat sat;
  for (const double epoch : epochs) {
    for (const double span : spans) {
      std::vector<Quantity<si::time>> times;
      for (int k = 0; k < 10; ++k) {
        const auto next = (epoch + 0.5 + k * span) * s;
        if (times.empty() || next > times.back()) times.push_back(next);
      }
      const auto counting = scenario(sat, held(Count{0}), at_times(times, one_more));
      for (const ode::Method method : some_methods) {
        const auto flight = propagate(counting, start_of(sat, {.time = epoch}), with(method, epoch + 1.0));
        EXPECT_EQ(flight.held<Count>(flight.end()).value, times.size()) << epoch << ' ' << span;
      }
    }
  }
}

// What one list gives does not reach the others at the same instant.
TEST(Ticks, OtherListsSeeWhatWasBefore) {
  struct Seen {
    int value;
  };
  const Sat sat;
  for (const double epoch : epochs) {
    const auto at = (epoch + 0.5) * s;
    const auto looking =
        scenario(sat, held(Count{0}), held(Seen{-1}), at_times({at, at + 5e-7 * s}, one_more),
                 at_times({at}, [](const Now<Sat>&, const Count& count) { return Seen{count.value}; }));
    const auto flight = propagate(looking, start_of(sat, {.time = epoch}), until(epoch + 1.0));
    EXPECT_EQ(flight.held<Seen>(flight.end()).value, 0);
    EXPECT_EQ(flight.held<Count>(flight.end()).value, 2);
  }
}

// The shortest period that is allowed at this time, with a latency below the rounding.
TEST(Ticks, AFastClockTicksEachTime) {
  const Sat sat;
  constexpr double period = 5e-6;
  for (const double epoch : epochs) {
    for (const double latency : {0.0, 1e-7, 1e-6, 7e-6}) {
      int ticks = 0;
      const auto counting =
          scenario(sat, held(Count{0}),
                   every(
                       period * s, [&](const Now<Sat>&) { return Count{++ticks}; }, latency * s));
      for (const ode::Method method : some_methods) {
        ticks = 0;
        const auto flight =
            propagate(counting, start_of(sat, {.time = epoch}), with(method, epoch + 100.75 * period));
        EXPECT_EQ(ticks, 101) << epoch << ' ' << latency;
        EXPECT_EQ(flight.held<Count>(flight.end()).value, latency > period ? 100 : 101)
            << epoch << ' ' << latency;
      }
    }
  }
}

TEST(Ticks, TrainsOfPulsesAddUp) {
  const Sat sat;
  constexpr double force = 0.9;
  for (const double epoch : epochs) {
    for (const double span : spans) {
      const double on = epoch + 0.25;
      if (!(on + span > on)) continue;
      const auto push = [&](double from) {
        return pulse(sat, of<Hub>, force * N * unit_y(in<Inertial>), from * s, (from + span) * s);
      };
      const auto pushed = scenario(sat, push(on), push(on + span), push(on + 2.0 * span), push(on + 0.5));
      for (const ode::Method method : some_methods) {
        const auto flight = propagate(pushed, start_of(sat, {.time = epoch}), with(method, epoch + 1.0));
        const double velocity = flight.at(flight.end()).hub_motion().velocity.y().value();
        EXPECT_NEAR((m_hub + m_panel + m_mass) * velocity, 4.0 * force * span,
                    epoch > 0.0 ? force * 4 * 7 * rounding_of_time : rounding)
            << epoch << ' ' << span;
      }
    }
  }
}

}  // namespace
}  // namespace vectrix_test::three_parts::ticks_test
