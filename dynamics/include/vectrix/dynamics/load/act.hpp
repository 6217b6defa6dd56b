#pragma once

#include <vectrix/dynamics/craft/forces.hpp>

namespace vectrix::detail {

/// How what is given acts on a body or mount, on a joint with one axis, or on a rotor: its type says it.
enum class ActsAs { nothing, torque, force, wrench, effort, motor };

template <class C, class On, class Given, class S = double> constexpr ActsAs acts_as() {
  if constexpr (requires(Forces<C, S> & forces, const Given& given) { forces.torque(of<On>, given); })
    return ActsAs::torque;
  else if constexpr (requires(Forces<C, S> & forces, const Given& given) { forces.force(of<On>, given); })
    return ActsAs::force;
  else if constexpr (requires(Forces<C, S> & forces, const Given& given) { forces.wrench(of<On>, given); })
    return ActsAs::wrench;
  else if constexpr (requires(Forces<C, S> & forces, const Given& given) { forces.effort(of<On>, given); })
    return ActsAs::effort;
  else if constexpr (requires(Forces<C, S> & forces, const Given& given) { forces.motor(of<On>, given); })
    return ActsAs::motor;
  else
    return ActsAs::nothing;
}
template <class C, class On, class Given>
inline constexpr bool acts_on = acts_as<C, On, Given>() != ActsAs::nothing;

template <class On, class C, class S, class Given> void act(Forces<C, S>& forces, const Given& given) {
  constexpr ActsAs as = acts_as<C, On, Given, S>();
  if constexpr (as == ActsAs::torque)
    forces.torque(of<On>, given);
  else if constexpr (as == ActsAs::force)
    forces.force(of<On>, given);
  else if constexpr (as == ActsAs::wrench)
    forces.wrench(of<On>, given);
  else if constexpr (as == ActsAs::effort)
    forces.effort(of<On>, given);
  else
    forces.motor(of<On>, given);
}

}  // namespace vectrix::detail
