// A user's program with Simbody: a body that turns freely, in both engines, and in one process with SUNDIALS.
#include <iostream>
#include <vectrix/simbody.hpp>

struct Site : vectrix::inertial_frame {};
struct Top : vectrix::moving_frame {};

int main() {
  using namespace vectrix;
  const auto kg_m2 = si::kilogram_square_metre;
  const auto rad_s = si::radian / si::second;
  const auto top = spacecraft(
      body(mass_properties(1.0 * si::kilogram, coincident(of<CentreOfMassOf<Top>>, relative_to<Top>, in<Top>),
                           inertia_from_principal_moments(in<Top>, 1.0 * kg_m2, 2.0 * kg_m2, 2.5 * kg_m2)),
           turning_in<Site>));
  const auto spinning =
      angular_velocity(of<Top>, relative_to<Site>, vector(in<Top>, 0.1 * rad_s, 1.0 * rad_s, 0.0 * rad_s));
  const auto start = state(top, 0.0 * si::second, MovingDcm{aligned(to<Site>, from<Top>), spinning});
  const CraftTolerances fine{1e-12 * si::radian, 1e-12 * rad_s, 1e-12 * si::metre,
                             1e-12 * (si::metre / si::second), 1e-12};
  const auto ours = propagate(scenario(top), start,
                              {.end = 5.0 * si::second,
                               .relative_tolerance = 1e-12,
                               .absolute_tolerances = fine,
                               .method = ode::Method::cvode_adams});
  const auto theirs =
      propagate_with_simbody(scenario(top), start, {.end = 5.0 * si::second, .accuracy = 1e-10});
  const auto found = compare(top, ours, theirs);
  std::cout << found;
  return found.attitude(of<Top>).size < 1e-7 * si::radian ? 0 : 1;
}
