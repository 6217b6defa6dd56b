// Craft of jointed bodies
#include <vectrix/dynamics.hpp>
#include <vectrix/dynamics/craft/named_state.hpp>

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Itrf : moving_frame {};
struct Hub : moving_frame {};
struct Panel : moving_frame {};
struct Boom : moving_frame {};
struct Box : moving_frame {};
struct Wheel : named_point {};
struct Bending : named_point {};

auto make_sat() {
  const auto J_s = 0.1 * si::kilogram_square_metre;
  const auto mass = [](auto b) {
    using B = decltype(b);
    return mass_properties(1.0 * si::kilogram, coincident(of<CentreOfMassOf<B>>, relative_to<B>, in<B>),
                           trust_inertia(in<B>, Eigen::Matrix3d::Identity()));
  };
  const auto place = [](auto b) {
    using B = decltype(b);
    return Transform{aligned(to<Hub>, from<B>), coincident(of<B>, relative_to<Hub>, in<Hub>)};
  };
  return spacecraft(body(mass(Hub{}), free_in<Gcrf>),
                    body(mass(Panel{}), hinge(place(Panel{}), unit_x(in<Panel>))),
                    body(mass(Box{}), fixed_joint(place(Box{}))), rotor(of<Wheel>, unit_z(in<Hub>), J_s));
}
struct Sat : decltype(make_sat()) {
  Sat() : decltype(make_sat())(make_sat()) {}
};

const auto rad_s = si::radian / si::second;

namespace body_on_a_joint_of_another {
// mistake: the mass properties of one body with the joint of another
// expect: Mass = (vectrix::)?MassProperties<Boom
// expect: Given = .(vectrix::)?BodyJoint<.*Panel
auto part(const MassProperties<Boom>& boom, const MassProperties<Panel>& panel,
          const Transform<Hub, Panel>& X) {
#ifdef REPAIRED
  return static_cast<void>(boom), body(panel, fixed_joint(X));
#else
  return static_cast<void>(panel), body(boom, fixed_joint(X));
#endif
}
}  // namespace body_on_a_joint_of_another

namespace body_on_a_later_body {
// mistake: a panel on a boom that comes after it
// expect: HangsOnLaterPart<Panel, Boom>
auto craft(const MassProperties<Hub>& hub, const MassProperties<Boom>& boom,
           const MassProperties<Panel>& panel, const Transform<Hub, Boom>& X_h_from_b,
           const Transform<Boom, Panel>& X_b_from_p) {
#ifdef REPAIRED
  return spacecraft(body(hub, free_in<Gcrf>), body(boom, fixed_joint(X_h_from_b)),
                    body(panel, fixed_joint(X_b_from_p)));
#else
  return spacecraft(body(hub, free_in<Gcrf>), body(panel, fixed_joint(X_b_from_p)),
                    body(boom, fixed_joint(X_h_from_b)));
#endif
}
}  // namespace body_on_a_later_body

namespace body_on_itself {
// mistake: a body that hangs on itself
// expect: Transform<Panel, Panel>|B = Panel
auto joint(const Transform<Panel, Panel>& X_p_from_p, const Transform<Hub, Panel>& X_h_from_p) {
#ifdef REPAIRED
  return static_cast<void>(X_p_from_p), ball(X_h_from_p);
#else
  return static_cast<void>(X_h_from_p), ball(X_p_from_p);
#endif
}
}  // namespace body_on_itself

namespace body_on_nothing {
// mistake: a panel on a boom that the craft has not
// expect: HangsOnNothing<Panel, Boom>
auto craft(const MassProperties<Hub>& hub, const MassProperties<Panel>& panel,
           const Transform<Hub, Panel>& X_h_from_p, const Transform<Boom, Panel>& X_b_from_p) {
#ifdef REPAIRED
  return static_cast<void>(X_b_from_p),
         spacecraft(body(hub, free_in<Gcrf>), body(panel, fixed_joint(X_h_from_p)));
#else
  return static_cast<void>(X_h_from_p),
         spacecraft(body(hub, free_in<Gcrf>), body(panel, fixed_joint(X_b_from_p)));
#endif
}
}  // namespace body_on_nothing

namespace body_twice {
// mistake: one body on two joints
// expect: NamedTwice<Panel>
auto craft(const MassProperties<Hub>& hub, const MassProperties<Panel>& panel,
           const Transform<Hub, Panel>& X_h_from_p) {
#ifdef REPAIRED
  return spacecraft(body(hub, free_in<Gcrf>), body(panel, fixed_joint(X_h_from_p)));
#else
  return spacecraft(body(hub, free_in<Gcrf>), body(panel, fixed_joint(X_h_from_p)),
                    body(panel, ball(X_h_from_p)));
#endif
}
}  // namespace body_twice

namespace effort_in_newtons {
// mistake: a force as the effort of a hinge
// expect: B = Panel
// expect: si::force
auto at(const Sat& sat, const CraftState<Sat>& now) {
  return motion(sat, now, [](const Now<Sat>&, Forces<Sat>& forces) {
#ifdef REPAIRED
    forces.effort(of<Panel>, 0.1 * si::newton_metre);
#else
    forces.effort(of<Panel>, 0.1 * si::newton);
#endif
  });
}
}  // namespace effort_in_newtons

namespace force_on_a_rotor {
// mistake: a force on a wheel, which has no place: its body has it
// expect: B = Wheel
auto at(const Sat& sat, const CraftState<Sat>& now, const Vector<Hub, si::force>& F_h) {
  return motion(sat, now, [=](const Now<Sat>&, Forces<Sat>& forces) {
#ifdef REPAIRED
    forces.force(of<Hub>, F_h);
#else
    forces.force(of<Wheel>, F_h);
#endif
  });
}
}  // namespace force_on_a_rotor

namespace hinge_axis_in_parent {
// mistake: the axis of a hinge in the frame of the parent
// expect: hinge
// expect: C = Hub
// expect: B = Panel
auto joint(const Transform<Hub, Panel>& X_h_from_p) {
#ifdef REPAIRED
  return hinge(X_h_from_p, unit_x(in<Panel>));
#else
  return hinge(X_h_from_p, unit_x(in<Hub>));
#endif
}
}  // namespace hinge_axis_in_parent

namespace hub_relative_to_the_earth {
// mistake: the motion of the hub relative to the rotating Earth
// expect: HubMovesWith<.*MovingTransform<Itrf, Hub.*MovingTransform<Gcrf, Hub
auto start(const Sat& sat, const MovingTransform<Itrf, Hub>& X_e_from_hub,
           const MovingTransform<Gcrf, Itrf>& X_i_from_e) {
#ifdef REPAIRED
  return state(sat, 0.0 * si::second, X_i_from_e * X_e_from_hub,
               starts(of<Panel>, 0.1 * si::radian, 0.0 * rad_s), spins(of<Wheel>, 0.0 * rad_s));
#else
  return static_cast<void>(X_i_from_e),
         state(sat, 0.0 * si::second, X_e_from_hub, starts(of<Panel>, 0.1 * si::radian, 0.0 * rad_s),
               spins(of<Wheel>, 0.0 * rad_s));
#endif
}
}  // namespace hub_relative_to_the_earth

namespace mode_of_another_body {
// mistake: participations in the axes of another body
// expect: B = Panel
// expect: FlexibleMode<Boom>
auto part(const FlexibleMode<Boom>& of_boom, const FlexibleMode<Panel>& of_panel) {
#ifdef REPAIRED
  return static_cast<void>(of_boom), modes(of<Bending>, on<Panel>, of_panel);
#else
  return static_cast<void>(of_panel), modes(of<Bending>, on<Panel>, of_boom);
#endif
}
}  // namespace mode_of_another_body

namespace motor_in_newtons {
// mistake: the torque of a wheel in newtons
// expect: W = Wheel
// expect: si::force
auto at(const Sat& sat, const CraftState<Sat>& now) {
  return motion(sat, now, [](const Now<Sat>&, Forces<Sat>& forces) {
#ifdef REPAIRED
    forces.motor(of<Wheel>, 0.1 * si::newton_metre);
#else
    forces.motor(of<Wheel>, 0.1 * si::newton);
#endif
  });
}
}  // namespace motor_in_newtons

namespace question_for_a_frame_elsewhere {
// mistake: a rotation to a frame that the craft does not have; a frame graph joins them
// expect: B = Itrf
// expect: A = Hub
auto at(const Sat& sat, const CraftState<Sat>& now, const Dcm<Gcrf, Itrf>& R_i_from_e) {
  return motion(sat, now, [=](const Now<Sat>& at_t, Forces<Sat>&) {
#ifdef REPAIRED
    static_cast<void>(inverse(R_i_from_e) * at_t.rotation(to<Gcrf>, from<Hub>));
#else
    static_cast<void>(R_i_from_e), at_t.rotation(to<Itrf>, from<Hub>);
#endif
  });
}
}  // namespace question_for_a_frame_elsewhere

namespace spring_on_a_fixed_body {
// mistake: a spring on a body that is fixed
// expect: Given = .Sat, (vectrix::)?Of<Box>
auto at(const Sat& sat, const CraftState<Sat>& now) {
  const auto k = 3.0 * si::newton_metre / si::radian;
#ifdef REPAIRED
  return motion(sat, now, spring(sat, of<Panel>, k, 0.0 * si::radian));
#else
  return motion(sat, now, spring(sat, of<Box>, k, 0.0 * si::radian));
#endif
}
}  // namespace spring_on_a_fixed_body

namespace torque_in_a_frame_elsewhere {
// mistake: a torque in a frame that the craft does not have
// expect: B = Hub
// expect: Itrf
auto at(const Sat& sat, const CraftState<Sat>& now, const Vector<Itrf, si::torque>& M_e,
        const Dcm<Gcrf, Itrf>& R_i_from_e) {
  return motion(sat, now, [=](const Now<Sat>&, Forces<Sat>& forces) {
#ifdef REPAIRED
    forces.torque(of<Hub>, R_i_from_e * M_e);
#else
    static_cast<void>(R_i_from_e);
    forces.torque(of<Hub>, M_e);
#endif
  });
}
}  // namespace torque_in_a_frame_elsewhere

namespace an_edge_that_the_craft_has {
// mistake: a place for the panel in the graph of the craft, which has the panel on its hinge
// expect: Fault = (.*)TwoPathsOver<
auto graph(const Sat& sat, const Transform<Gcrf, Itrf>& X_i_from_e, const Transform<Hub, Panel>& X_h_from_p) {
#ifdef REPAIRED
  return static_cast<void>(X_h_from_p), frame_graph_of(sat, rigid_edge(X_i_from_e));
#else
  return static_cast<void>(X_i_from_e), frame_graph_of(sat, rigid_edge(X_h_from_p));
#endif
}
}  // namespace an_edge_that_the_craft_has

namespace hub_without_its_frame {
// mistake: the hub, without the frame in which it moves
// expect: the hub body\(mass, free_in<I>\)
auto craft(const MassProperties<Hub>& mass) {
#ifdef REPAIRED
  return spacecraft(body(mass, free_in<Gcrf>));
#else
  return spacecraft(body(mass));
#endif
}
}  // namespace hub_without_its_frame
