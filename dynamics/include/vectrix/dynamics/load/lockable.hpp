#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <string>
#include <tuple>
#include <vectrix/dynamics/craft/craft_scenario.hpp>
#include <vectrix/dynamics/load/joint_units.hpp>

namespace vectrix {

/// The held value of a joint or rotor that can be locked.
template <class On> struct Locked {
  bool locked = false;
  bool operator==(const Locked&) const = default;
};

namespace detail {

/// The joint of a body that moves, or a rotor.
template <class C, class On> constexpr bool can_stand() {
  using Shape = typename C::shape;
  if constexpr (Shape::template has_rotor<On>)
    return true;
  else if constexpr (Shape::template is<On, PartRole::body>)
    return Shape::template Part<On>::counts.speeds > 0;
  else
    return false;
}

/// With its unit; of a free joint the last three speeds are m/s.
template <class C, class On> std::string largest_speed(const double* y) {
  const auto speeds = speeds_of<C, On>(y);
  const auto most = std::max_element(speeds.begin(), speeds.end(),
                                     [](double u, double v) { return std::abs(u) < std::abs(v); });
  bool slides = most - speeds.begin() >= 3;
  if constexpr (!C::shape::template has_rotor<On>)
    slides = slides || C::shape::template Part<On>::joint == JointKind::slider;
  return text(*most) + (slides ? " m/s" : " rad/s");
}

}  // namespace detail

/// A joint or a rotor that can be locked. Made by lockable().
template <CraftType C, class On> struct LockableJoint {
  using State = Locked<On>;
  State initial;

  template <std::size_t> auto parts() const {
    const auto load = []<class S>(const Now<C, S>&, Forces<C, S>& forces, const State& state) {
      if (state.locked) forces.lock(of<On>);
    };
    const auto at_first = [](const Now<C>& now, const State& state) {
      if (state.locked && detail::is_moving<C, On>(now.data()))
        throw BadInput("lockable: " + frame_name<On>() + " is locked and moves at the start, " +
                       detail::largest_speed<C, On>(now.data()));
      return state;
    };
    return std::tuple{held(initial), load, at_start(at_first), detail::Stands<On, State>{}};
  }
};

/// A latch or brake of a joint or rotor b. While the held value Locked<B> is true, it is at rest relative to
/// what it hangs on, exactly, whatever acts; changes lock and release it:
///     when("b is deployed", angle_to_go, ode::Direction::falling, becomes(Locked<B>{true}))
/// If it moves when it is locked, an impulse stops it: no place changes, all speeds may. Momentum and angular
/// momentum are kept; the energy lost is the kinetic energy of the changes of the speeds (Carnot's theorem).
/// Other joints, rotors and modes give way in the impulse, also those held by friction, but not what
/// forces.lock() locks. A run whose start is locked and moves fails and says so.
template <CraftType C, class B>
  requires(detail::can_stand<C, B>())
LockableJoint<C, B> lockable(const C&, Of<B>, const Locked<B>& at_start = {}) {
  return {at_start};
}
template <class... Given>
  requires(detail::about_frames<Given...>)
auto lockable(  // craft, of<B>: a body of C on a joint that moves, or a rotor; at the start a Locked<B>
    const Given&...) -> Refused = delete;

}  // namespace vectrix
