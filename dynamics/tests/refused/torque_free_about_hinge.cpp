// mistake: the torque-free motion with the inertia about a hinge
// expect: InertiaAbout = Hinge
// expect: StateOf = Panel
// expect: about its centre of mass
#include <vectrix/dynamics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Panel : vectrix::moving_frame {};
struct Hinge : vectrix::named_point {};

using namespace vectrix;

auto tumble(const Inertia<Panel, Hinge, In<Panel>>& J_hinge_panel, const State<Gcrf, Panel>& start,
            [[maybe_unused]] const Quantity<si::mass>& mass,
            [[maybe_unused]] const Displacement<Hinge, CentreOfMassOf<Panel>, In<Panel>>& r_hc_panel) {
#ifdef REPAIRED
  return torque_free(shift(J_hinge_panel, r_hc_panel, mass), start);
#else
  return torque_free(J_hinge_panel, start);
#endif
}
