#pragma once

#include <vectrix/dynamics/multibody/kinds.hpp>
#include <vectrix/dynamics/multibody/tree.hpp>

namespace vectrix::multibody {

template <class S> Column<S> Tree<S>::position(int body, const Work<S>& k) const {
  Column<S> r = zero_column<S>();
  for (; body != 0; body = numbers_.links[static_cast<std::size_t>(body) - 1].parent)
    r += k.links[static_cast<std::size_t>(body) - 1].r;
  return r;
}

// v_b = v_p + w_p x r + v_pb|p
template <class S> Column<S> Tree<S>::velocity_beyond_hub(int body, const S* y, const Work<S>& k) const {
  Column<S> v = zero_column<S>();
  while (body != 0) {
    const std::size_t i = static_cast<std::size_t>(body) - 1;
    const Link<S>& link = numbers_.links[i];
    const Moving<S>& b = k.links[i];
    v += cross(angular_velocity(link.parent, k), b.r) + with_kind(link.joint.kind, [&](auto kind) {
           return kind.velocity(rotation(link.parent, k), y + layout_.speed_at[i], b);
         });
    body = link.parent;
  }
  return v;
}

/// In the hub's axes, about the hub's origin.
template <class S>
Conserved<S> Tree<S>::sum_over_bodies(const S* y, const Column<S>& hub_velocity, const Work<S>& k) const {
  Conserved<S> sum{zero_column<S>(), zero_column<S>(), S(0.0)};
  const S half(0.5);
  const auto velocity_of = [&](int body) { return hub_velocity + velocity_beyond_hub(body, y, k); };
  const auto add = [&](int body, const Column<S>& p, const Column<S>& h, const S& energy) {
    sum.momentum += p;
    sum.angular_momentum += h + cross(position(body, k), p);
    sum.energy += energy;
  };
  for (int body = 0; body <= static_cast<int>(numbers_.links.size()); ++body) {
    const Mass<S>& mass = body == 0 ? numbers_.hub : numbers_.links[static_cast<std::size_t>(body) - 1].mass;
    const Square<S>& R = rotation(body, k);
    const Column<S>& w = angular_velocity(body, k);
    const Column<S> v = velocity_of(body), mc = R * mass.mc;
    const Column<S> Jw = R * (mass.J * transposed_times(R, w)), around = cross(w, mc);
    add(body, v * mass.m + around, Jw + cross(mc, v),
        S(half * (mass.m * dot(v, v) + dot(w, Jw)) + dot(v, around)));
  }
  const S* speed = y + layout_.rotors_begin();
  for (std::size_t i = 0; i < numbers_.rotors.size(); ++i) {
    const Rotor<S>& rotor = numbers_.rotors[i];
    const Column<S> axis = rotation(rotor.body, k) * rotor.axis;
    const S momentum(rotor.inertia * speed[i]);
    add(rotor.body, zero_column<S>(), axis * momentum,
        S(momentum * (half * speed[i] + dot(axis, angular_velocity(rotor.body, k)))));
  }
  const S* eta = y + layout_.modes_begin();
  const S* rate = eta + layout_.modes;
  for (std::size_t i = 0; i < numbers_.modes.size(); ++i) {
    const Mode<S>& mode = numbers_.modes[i];
    const Square<S>& R = rotation(mode.body, k);
    const Column<S>& w = angular_velocity(mode.body, k);
    const Column<S> v = velocity_of(mode.body), moment = R * mode.translation * eta[i];
    const Column<S> turning = R * mode.rotation * rate[i];
    const Column<S> moving = R * mode.translation * rate[i] + cross(w, moment);
    const S stretch(mode.frequency * eta[i]);
    add(mode.body, moving, turning + cross(moment, v),
        S(half * (rate[i] * rate[i] + stretch * stretch) + dot(v, moving) + dot(w, turning)));
  }
  return sum;
}

// Of a turning hub: so that the momentum is zero.
template <class S> Column<S> Tree<S>::hub_velocity(const S* y, const Work<S>& k) const {
  if (numbers_.hub_motion == HubMotion::free)
    return transposed_times(k.R_i_from_h, Column<S>{y[10], y[11], y[12]});
  S mass(numbers_.hub.m);
  for (const Link<S>& link : numbers_.links) mass += link.mass.m;
  return sum_over_bodies(y, zero_column<S>(), k).momentum * S(S(-1.0) / mass);
}

template <class S> Column<S> Tree<S>::velocity(int body, const S* y, const Work<S>& k) const {
  return hub_velocity(y, k) + velocity_beyond_hub(body, y, k);
}

template <class S>
Conserved<S> Tree<S>::conserved(const S* y, const Column<S>& about, const Work<S>& k) const {
  const Conserved<S> in_hub_axes = sum_over_bodies(y, hub_velocity(y, k), k);
  const Column<S> p_i = k.R_i_from_h * in_hub_axes.momentum;
  Column<S> h_i = k.R_i_from_h * in_hub_axes.angular_momentum;
  if (numbers_.hub_motion == HubMotion::free) h_i += cross(Column<S>{y[7], y[8], y[9]} - about, p_i);
  return {p_i, h_i, in_hub_axes.energy};
}

template <class S> Accelerations<S> Tree<S>::accelerations(int body, const Work<S>& k) const {
  const Accelerations<S> beyond = less_field(body, k);
  return {beyond.alpha, beyond.a + transposed_times(k.R_i_from_h, k.field)};
}

// What the joint leaves of the articulated inertia, times the parent's accelerations at the joint.
template <class S> Transmitted<S> Tree<S>::reaction(int body, const Work<S>& k) const {
  const std::size_t i = static_cast<std::size_t>(body) - 1;
  const Moving<S>& b = k.links.at(i);
  Accelerations<S> p = k.hub_acceleration;
  if (const int parent = numbers_.links[i].parent; parent != 0) {
    const Moving<S>& moving = k.links[static_cast<std::size_t>(parent) - 1];
    p = {moving.alpha, moving.a};
  }
  const Column<S> a = p.a + cross(p.alpha, b.r);
  return {transposed_times(b.I.H, p.alpha) + b.I.M * a + b.I.f, b.I.A * p.alpha + b.I.H * a + b.I.n};
}

template <class S> S Tree<S>::holding_effort(int body, const Work<S>& k) const {
  const std::size_t i = static_cast<std::size_t>(body) - 1;
  const Transmitted<S> given = reaction(body, k);
  const S along = numbers_.links[i].joint.kind == Kind::hinge ? Hinge::effort(given, k.links[i])
                                                              : Slider::effort(given, k.links[i]);
  return along - k.efforts[layout_.speed_at[i] - layout_.speeds_begin()];
}

// tau = J_s (O' + n.alpha)
template <class S> S Tree<S>::holding_torque(std::size_t rotor, const Work<S>& k) const {
  if (k.held_rotors[rotor] == Hold::none) return S(0.0);
  const Rotor<S>& wheel = numbers_.rotors[rotor];
  const Column<S> alpha = less_field(wheel.body, k).alpha;
  return S(wheel.inertia * (k.given_spins[rotor] + dot(k.axes[rotor], alpha)) - k.motors[rotor]);
}

}  // namespace vectrix::multibody
