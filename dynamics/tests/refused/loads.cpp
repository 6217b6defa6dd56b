// Ready loads on a craft
#include <vectrix/dynamics.hpp>

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Hub : moving_frame {};
struct Panel : moving_frame {};
struct Wheel : named_point {};

template <Frame B> auto unit_mass() {
  return mass_properties(1.0 * si::kilogram, coincident(of<CentreOfMassOf<B>>, relative_to<B>, in<B>),
                         trust_inertia(in<B>, Eigen::Matrix3d::Identity()));
}
template <HubMotion motion> auto make_craft(MovesIn<Gcrf, motion> moves) {
  return spacecraft(
      body(unit_mass<Hub>(), moves),
      body(unit_mass<Panel>(),
           hinge(Transform{aligned(to<Hub>, from<Panel>), coincident(of<Panel>, relative_to<Hub>, in<Hub>)},
                 unit_x(in<Panel>))),
      rotor(of<Wheel>, unit_x(in<Hub>), 0.1 * si::kilogram_square_metre));
}
struct Sat : decltype(make_craft(free_in<Gcrf>)) {
  Sat() : decltype(make_craft(free_in<Gcrf>))(make_craft(free_in<Gcrf>)) {}
};
struct Turning : decltype(make_craft(turning_in<Gcrf>)) {
  Turning() : decltype(make_craft(turning_in<Gcrf>))(make_craft(turning_in<Gcrf>)) {}
};
constexpr auto N_m = si::newton_metre;
constexpr auto rad = si::radian;
constexpr auto s = si::second;

namespace gravity_without_a_place {
// mistake: the attraction of the Earth on a craft that does not know where it is
// expect: free_in<I>
auto gravity(const Sat& sat, const Turning& turning, const Quantity<si::gravitational_parameter>& mu) {
#ifdef REPAIRED
  return static_cast<void>(turning), point_mass(sat, mu);
#else
  return static_cast<void>(sat), point_mass(turning, mu);
#endif
}
}  // namespace gravity_without_a_place

namespace gravity_of_a_mass {
// mistake: a mass where its gravitational parameter is due
// expect: m\^3/s\^2
auto gravity(const Sat& sat) {
#ifdef REPAIRED
  return point_mass(sat, Quantity<si::gravitational_parameter>::from_value(3.986004418e14));
#else
  return point_mass(sat, 5.97e24 * si::kilogram);
#endif
}
}  // namespace gravity_of_a_mass

namespace a_spring_on_the_hub {
// mistake: a spring on the hub, which hangs on nothing
// expect: b on a hinge
auto panel_spring(const Sat& sat) {
#ifdef REPAIRED
  return spring(sat, of<Panel>, 2.0 * N_m / rad, 0.0 * rad);
#else
  return spring(sat, of<Hub>, 2.0 * N_m / rad, 0.0 * rad);
#endif
}
}  // namespace a_spring_on_the_hub
