#pragma once

#include <string>
#include <utility>
#include <vectrix/dynamics/multibody/kinds.hpp>
#include <vectrix/dynamics/multibody/tree.hpp>
#include <vectrix/frames/errors.hpp>

namespace vectrix::multibody {

template <class S>
int add_gimbal(TreeNumbers<S>& tree, int parent, const Square<S>& R_p_from_b, const Column<S>& axis_1,
               const Column<S>& axis_2, const Column<S>& r_pb_p, const Mass<S>& mass) {
  const Mass<S> none{S(0.0), zero_column<S>(), diagonal(S(0.0))};
  tree.links.push_back({parent, hinge(R_p_from_b, axis_1, r_pb_p), none});
  const int ring = static_cast<int>(tree.links.size());
  tree.links.push_back({ring, hinge(identity<S>(), axis_2, zero_column<S>()), mass});
  return ring;
}

template <class S> TreeLayout layout_of(const TreeNumbers<S>& tree) {
  TreeLayout layout{
      tree.hub_motion == HubMotion::free ? 13U : 7U, 0, 0, tree.rotors.size(), tree.modes.size(), {}, {}};
  for (const Link<S>& link : tree.links) {
    layout.position_at.push_back(layout.hub + layout.positions);
    layout.speed_at.push_back(layout.speeds);
    with_kind(link.joint.kind, [&](auto kind) {
      layout.positions += std::size_t{kind.positions};
      layout.speeds += std::size_t{kind.speeds};
    });
  }
  for (std::size_t& at : layout.speed_at) at += layout.speeds_begin();
  return layout;
}

template <class S> Tree<S>::Tree(TreeNumbers<S> numbers) : numbers_(std::move(numbers)) {
  const auto require = [&](const char* what, int body, std::size_t below) {
    if (body < 0 || static_cast<std::size_t>(body) >= below)
      throw BadInput(std::string{"Tree: "} + what + " is on body " + std::to_string(body) + " of " +
                     std::to_string(below) + " that are before it");
  };
  for (std::size_t i = 0; i < numbers_.links.size(); ++i) require("a link", numbers_.links[i].parent, i + 1);
  for (const Rotor<S>& rotor : numbers_.rotors) require("a rotor", rotor.body, numbers_.links.size() + 1);
  for (const Mode<S>& mode : numbers_.modes) require("a mode", mode.body, numbers_.links.size() + 1);
  layout_ = layout_of(numbers_);

  less_rotors_.push_back(numbers_.hub);
  for (const Link<S>& link : numbers_.links) less_rotors_.push_back(link.mass);
  for (const Rotor<S>& rotor : numbers_.rotors)
    less_rotors_[static_cast<std::size_t>(rotor.body)].J.subtract_outer(rotor.axis * rotor.inertia,
                                                                        rotor.axis);

  rigid_ = numbers_.links.empty() && numbers_.modes.empty();
  const Mass<S>& hub = less_rotors_.front();
  const S inverse_mass(S(1.0) / hub.m);
  centre_ = hub.mc * inverse_mass;
  Symmetric<S> J = hub.J;  // J_c = J - (mc.c 1 - mc c^T)
  J.subtract_outer(-hub.mc, centre_);
  const S d = dot(hub.mc, centre_);
  J.xx -= d, J.yy -= d, J.zz -= d;
  inverse_inertia_ = inverse(J);
}

template <class S> Work<S> Tree<S>::work() const {
  Work<S> k;
  k.efforts.assign(layout_.speeds, S(0.0));
  k.motors.assign(layout_.rotors, S(0.0));
  k.modal.assign(layout_.modes, S(0.0));
  k.held.assign(numbers_.links.size(), Hold::none);
  k.given.assign(layout_.speeds, S(0.0));
  k.held_rotors.assign(layout_.rotors, Hold::none);
  k.given_spins.assign(layout_.rotors, S(0.0));
  k.field = zero_column<S>();
  k.unit = identity<S>();
  k.links.resize(numbers_.links.size());
  k.axes.resize(numbers_.rotors.size());
  k.modes.resize(numbers_.modes.size());
  return k;
}

template <class S> void Tree<S>::place_hub(const S* y, Work<S>& k) const {
  const Mass<S>& hub = less_rotors_.front();
  k.R_i_from_h = matrix_of_quaternion(y);
  k.w = {y[4], y[5], y[6]};
  if (!rigid_) give_hub_inertia(k);
  k.hub.n = cross(k.w, hub.J * k.w);
  k.hub.f = cross(k.w, cross(k.w, hub.mc));
}

template <class S> void Tree<S>::give_hub_inertia(Work<S>& k) const {
  const Mass<S>& hub = less_rotors_.front();
  k.hub.A = hub.J;
  k.hub.H = hat(hub.mc);
  k.hub.M = diagonal(hub.m);
}

template <class S> void Tree<S>::place_link(std::size_t i, const S* y, Work<S>& k) const {
  const Link<S>& link = numbers_.links[i];
  Moving<S>& b = k.links[i];
  const S* q = y + layout_.position_at[i];
  const S* u = y + layout_.speed_at[i];
  with_kind(link.joint.kind, [&](auto kind) {
    if (link.parent == 0) {
      kind.place(link.joint, q, u, OnHub<S>{k.w}, b);
    } else {
      kind.place(link.joint, q, u, k.links[static_cast<std::size_t>(link.parent) - 1], b);
    }
    load_rigid(less_rotors_[i + 1], b);
  });
}

template <class S> void Tree<S>::place(const S* y, Work<S>& k) const {
  for (S& effort : k.efforts) effort = S(0.0);
  for (S& motor : k.motors) motor = S(0.0);
  for (S& force : k.modal) force = S(0.0);
  for (Hold& hold : k.held) hold = Hold::none;
  for (S& acceleration : k.given) acceleration = S(0.0);
  for (Hold& hold : k.held_rotors) hold = Hold::none;
  for (S& acceleration : k.given_spins) acceleration = S(0.0);
  k.field = zero_column<S>();
  place_hub(y, k);
  for (std::size_t i = 0; i < k.links.size(); ++i) place_link(i, y, k);
}

template <class S> const Square<S>& Tree<S>::rotation(int body, const Work<S>& k) const {
  return body == 0 ? k.unit : k.links[static_cast<std::size_t>(body) - 1].R;
}
template <class S> const Column<S>& Tree<S>::angular_velocity(int body, const Work<S>& k) const {
  return body == 0 ? k.w : k.links[static_cast<std::size_t>(body) - 1].w;
}
template <class S> Accelerations<S> Tree<S>::less_field(int body, const Work<S>& k) const {
  if (body == 0) return k.hub_acceleration;
  const Moving<S>& b = k.links[static_cast<std::size_t>(body) - 1];
  return {b.alpha0 + b.alpha, b.a0 + b.a};
}
template <class S> Articulated<S>& Tree<S>::inertia(int body, Work<S>& k) const {
  return body == 0 ? k.hub : k.links[static_cast<std::size_t>(body) - 1].I;
}

template <class S>
void Tree<S>::add_wrench(int body, const Column<S>& force, const Column<S>& torque, Work<S>& k) const {
  Articulated<S>& I = inertia(body, k);
  I.n -= torque;
  I.f -= force;
}

template <class S> void Tree<S>::add_internals(const S* y, Work<S>& k) const {
  const S* speed = y + layout_.rotors_begin();
  for (std::size_t i = 0; i < numbers_.rotors.size(); ++i) {
    const Rotor<S>& rotor = numbers_.rotors[i];
    k.axes[i] = rotor.body == 0 ? rotor.axis : rotation(rotor.body, k) * rotor.axis;
    Articulated<S>& I = inertia(rotor.body, k);
    const bool held = k.held_rotors[i] != Hold::none;
    if (held) {
      const Column<S> J_n = k.axes[i] * rotor.inertia;
      I.A.subtract_outer(-J_n, k.axes[i]);
      if (rotor.body != 0)
        I.n += J_n * dot(k.axes[i], k.links[static_cast<std::size_t>(rotor.body) - 1].alpha0);
    }
    add_rotor(rotor, k.axes[i], speed[i], held ? S(rotor.inertia * k.given_spins[i]) : k.motors[i],
              angular_velocity(rotor.body, k), I);
  }
  const S* eta = y + layout_.modes_begin();
  const S* rate = eta + layout_.modes;
  for (std::size_t i = 0; i < numbers_.modes.size(); ++i) {
    const Mode<S>& mode = numbers_.modes[i];
    const Square<S>& R = rotation(mode.body, k);
    const S& W = mode.frequency;
    k.modes[i] = {R * mode.rotation, R * mode.translation,
                  S(k.modal[i] - W * (S(2.0) * mode.damping_ratio * rate[i] + W * eta[i]))};
    Column<S> alpha = zero_column<S>(), a = alpha;
    if (mode.body != 0) {
      alpha = k.links[static_cast<std::size_t>(mode.body) - 1].alpha0;
      a = k.links[static_cast<std::size_t>(mode.body) - 1].a0;
    }
    add_mode(k.modes[i], eta[i], rate[i], angular_velocity(mode.body, k), alpha, a, inertia(mode.body, k));
  }
}

template <class S> void Tree<S>::inward(std::size_t i, Work<S>& k) const {
  const Link<S>& link = numbers_.links[i];
  Moving<S>& b = k.links[i];
  const std::size_t speed = layout_.speed_at[i] - layout_.speeds_begin();
  with_kind(link.joint.kind, [&](auto kind) {
    if (k.held[i] == Hold::none) [[likely]]
      kind.eliminate(rotation(link.parent, k), k.efforts.data() + speed, b);
    else
      add_acceleration(b.I, kind.relative(rotation(link.parent, k), k.given.data() + speed, b));
  });
  add_shifted(inertia(link.parent, k), b.I, b.r);
}

template <class S> Accelerations<S> Tree<S>::solve_hub(bool rigid, const Work<S>& k) const {
  if (!rigid) return solve_free(k.hub, zero_column<S>(), zero_column<S>());
  // J_c alpha = -(n - c x f),  m a = -f - alpha x mc
  const Column<S> alpha = inverse_inertia_ * (cross(centre_, k.hub.f) - k.hub.n);
  return {alpha, cross(centre_, alpha) - k.hub.f * S(S(1.0) / numbers_.hub.m)};
}

template <class S> void Tree<S>::outward(std::size_t i, S* ydot, Work<S>& k) const {
  const Link<S>& link = numbers_.links[i];
  Moving<S>& b = k.links[i];
  S* udot = ydot + layout_.speed_at[i];
  if (link.parent == 0) {
    b.alpha = k.hub_acceleration.alpha;
    b.a = k.hub_acceleration.a + cross(b.alpha, b.r);
  } else {
    const Moving<S>& p = k.links[static_cast<std::size_t>(link.parent) - 1];
    b.alpha = p.alpha;
    b.a = p.a + cross(b.alpha, b.r);
  }
  with_kind(link.joint.kind, [&](auto kind) {
    if (k.held[i] == Hold::none) {
      kind.advance(rotation(link.parent, k), b, udot);
    } else {
      const S* given = k.given.data() + (layout_.speed_at[i] - layout_.speeds_begin());
      for (int n = 0; n < kind.speeds; ++n) udot[n] = given[n];
      const Accelerations<S> added = kind.relative(rotation(link.parent, k), given, b);
      b.alpha += added.alpha;
      b.a += added.a;
    }
  });
}

template <class S> void Tree<S>::solve(const S* y, S* ydot, Work<S>& k) const {
  bool rigid = rigid_;
  for (const Hold hold : k.held_rotors) rigid = rigid && hold == Hold::none;
  if (rigid_ && !rigid) give_hub_inertia(k);
  add_internals(y, k);
  for (std::size_t i = k.links.size(); i-- > 0;) inward(i, k);
  k.hub_acceleration = solve_hub(rigid, k);
  for (std::size_t i = 0; i < k.links.size(); ++i) outward(i, ydot, k);

  for (std::size_t i = 0; i < k.links.size(); ++i) {
    with_kind(numbers_.links[i].joint.kind, [&](auto kind) {
      kind.rates(y + layout_.position_at[i], y + layout_.speed_at[i], ydot + layout_.position_at[i]);
    });
  }
  quaternion_rate(y, y + 4, ydot);
  const Column<S>& alpha = k.hub_acceleration.alpha;
  ydot[4] = alpha.x, ydot[5] = alpha.y, ydot[6] = alpha.z;
  if (numbers_.hub_motion == HubMotion::free) {
    const Column<S> a_i = k.R_i_from_h * k.hub_acceleration.a + k.field;
    ydot[7] = y[10], ydot[8] = y[11], ydot[9] = y[12];
    ydot[10] = a_i.x, ydot[11] = a_i.y, ydot[12] = a_i.z;
  }
  S* speed_dot = ydot + layout_.rotors_begin();
  for (std::size_t i = 0; i < numbers_.rotors.size(); ++i) {
    const Rotor<S>& rotor = numbers_.rotors[i];
    speed_dot[i] = k.held_rotors[i] != Hold::none
                       ? k.given_spins[i]
                       : S(k.motors[i] / rotor.inertia - dot(k.axes[i], less_field(rotor.body, k).alpha));
  }
  const S* rate = y + layout_.modes_begin() + layout_.modes;
  S* eta_dot = ydot + layout_.modes_begin();
  for (std::size_t i = 0; i < numbers_.modes.size(); ++i) {
    const Accelerations<S> of_body = less_field(numbers_.modes[i].body, k);
    eta_dot[i] = rate[i];
    eta_dot[layout_.modes + i] =
        k.modes[i].force - dot(k.modes[i].r, of_body.alpha) - dot(k.modes[i].t, of_body.a);
  }
}

}  // namespace vectrix::multibody
