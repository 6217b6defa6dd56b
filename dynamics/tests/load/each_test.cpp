#include <gtest/gtest.h>

#include <sstream>
#include <vectrix/dynamics/load/each.hpp>
#include <vectrix/dynamics/load/lockable.hpp>
#include <vectrix/dynamics/load/pulse.hpp>
#include <vectrix/dynamics/load/springs.hpp>

#include "load/three_parts.hpp"

// One load for each of several joints.
namespace vectrix_test::each_test {
namespace {

using namespace vectrix;
using namespace vectrix_test::short_units;
using three_parts::Hub;
using three_parts::Inertial;

template <int i> struct Blade : moving_frame {};

template <int i> auto blade() {
  const Transform<Hub, Blade<i>> X_h_from_b{
      turned_z(to<Hub>, from<Blade<i>>, 0.9 * i * rad),
      displacement(of<Blade<i>>, relative_to<Hub>, vector(in<Hub>, 0.3 * i * m, 0.2 * m, 0.1 * i * m))};
  return body(three_parts::mass<Blade<i>>(1.0 + i, 0.5 * i), hinge(X_h_from_b, unit_x(in<Blade<i>>)));
}
auto make_fan() {
  return spacecraft(body(three_parts::mass<Hub>(6.0, 2.0), turning_in<Inertial>), blade<1>(), blade<2>(),
                    blade<3>());
}
struct Fan : decltype(make_fan()) {
  Fan() : decltype(make_fan())(make_fan()) {}
};
const Fan fan;
constexpr auto blades = of_numbered<Blade, 1, 3>;
static_assert(std::is_same_v<decltype(blades), const OfEach<Blade<1>, Blade<2>, Blade<3>>>);

constexpr auto k = 2.0 * N_m / rad;
const auto sprung = [](auto b) { return spring(fan, b, k, 0.1 * rad); };

auto start() {
  return state(fan, 0.0 * s,
               MovingDcm{aligned(to<Inertial>, from<Hub>),
                         angular_velocity(of<Hub>, relative_to<Inertial>,
                                          vector(in<Hub>, 0.2 * rad_s, -0.4 * rad_s, 0.3 * rad_s))},
               starts(of<Blade<1>>, 0.3 * rad, 0.0 * rad_s), starts(of<Blade<2>>, -0.2 * rad, 0.5 * rad_s),
               starts(of<Blade<3>>, 0.0 * rad, -0.7 * rad_s));
}

TEST(Each, IsTheListOfAll) {
  const auto listed = motion(fan, start(), sprung(of<Blade<1>>), sprung(of<Blade<2>>), sprung(of<Blade<3>>));
  EXPECT_EQ(motion(fan, start(), each(blades, sprung)).rates(), listed.rates());
  const auto two = motion(fan, start(), each(of_each<Blade<1>, Blade<3>>, sprung));
  EXPECT_EQ(two.rates(), motion(fan, start(), sprung(of<Blade<1>>), sprung(of<Blade<3>>)).rates());
  EXPECT_NE(two.rates(), listed.rates());
}

// Each has held values and changes of its own, also where a list is in a list.
TEST(Each, HoldsAValueForEach) {
  const auto push = [](auto b) { return pulse(fan, b, 0.2 * N_m, 0.5 * s, 0.9 * s); };
  const auto later = [](auto b) { return pulse(fan, b, -0.1 * N_m, 1.0 * s, 1.4 * s); };
  const auto latch = [](auto b) { return lockable(fan, b); };
  const auto latched = at_times({2.0 * s}, becomes(Locked<Blade<2>>{true}));
  const auto how = three_parts::until(3.0);
  const auto nested = each(of_each<Blade<1>, Blade<2>>, [&](auto) { return each(blades, later); });
  const auto lists =
      propagate(scenario(fan, each(blades, push), nested, each(blades, latch), latched), start(), how);
  const auto all = propagate(
      scenario(fan, push(of<Blade<1>>), push(of<Blade<2>>), push(of<Blade<3>>), later(of<Blade<1>>),
               later(of<Blade<2>>), later(of<Blade<3>>), later(of<Blade<1>>), later(of<Blade<2>>),
               later(of<Blade<3>>), latch(of<Blade<1>>), latch(of<Blade<2>>), latch(of<Blade<3>>), latched),
      start(), how);
  EXPECT_EQ(lists.at(3.0 * s).numbers(), all.at(3.0 * s).numbers());
  EXPECT_EQ(lists.at(3.0 * s).speed(of<Blade<2>>).value(), 0.0);
}

// The same types and numbers as of parts and starts that are written out.
TEST(Each, MakesACraftAndItsStart) {
  const auto listed = spacecraft(body(three_parts::mass<Hub>(6.0, 2.0), turning_in<Inertial>),
                                 each(blades, []<int i>(Of<Blade<i>>) { return blade<i>(); }));
  static_assert(std::is_same_v<decltype(listed), const decltype(make_fan())>);
  std::ostringstream one, other;
  one << plain(listed);
  other << plain(fan);
  EXPECT_EQ(one.str(), other.str());

  const MovingDcm hub{aligned(to<Inertial>, from<Hub>), at_rest(of<Hub>, relative_to<Inertial>, in<Hub>)};
  const std::array angles{0.3 * rad, -0.2 * rad, 0.0 * rad};
  const auto written =
      state(fan, 0.0 * s, hub, starts(of<Blade<1>>, angles[0], 0.5 * rad_s),
            starts(of<Blade<2>>, angles[1], 0.5 * rad_s), starts(of<Blade<3>>, angles[2], 0.5 * rad_s));
  EXPECT_EQ(state(fan, 0.0 * s, hub, starts(blades, angles, 0.5 * rad_s)).numbers(), written.numbers());
  const auto by_name =
      each(blades, [&]<int i>(Of<Blade<i>> b) { return starts(b, angles[i - 1], 0.5 * rad_s); });
  EXPECT_EQ(state(fan, 0.0 * s, hub, by_name).numbers(), written.numbers());
}

}  // namespace
}  // namespace vectrix_test::each_test
