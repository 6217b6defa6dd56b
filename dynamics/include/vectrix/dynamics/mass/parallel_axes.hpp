#pragma once

#include <string>
#include <vectrix/dynamics/mass/inertia.hpp>
#include <vectrix/frames/export.hpp>
#include <vectrix/frames/shift.hpp>

namespace vectrix {
namespace detail {

[[noreturn]] VECTRIX_EXPORT void refuse_mass(const char* action, NameFunction body, const std::string& mass);
template <class B, class S> void require_mass(const char* action, const Quantity<si::mass, S>& mass) {
  if (!(mass.value() > S(0) && mass.value() - mass.value() == S(0)))
    refuse_mass(action, frame_name<B>, text(mass.value()));
}

/// m (|r|^2 I - r r^T): the inertia of a mass m at r.
template <class S> Square<S> inertia_of_point_mass(const S& mass, const Column<S>& r) {
  return mass * (r.squaredNorm() * Square<S>::Identity() - r * r.transpose());
}

}  // namespace detail

/// J_p = J_c + m (|r_cp|^2 I - r_cp r_cp^T): the parallel-axis theorem, from the centre of mass c of the body
/// b to any other point: shift(J_c, r_cp_c, m). Throws BadInput if the mass is not positive or the inertia
/// overflows.
template <class B, class P, class C, class S>
  requires(!std::same_as<P, CentreOfMassOf<B>>)
Inertia<B, P, In<C>, S> shifted(const Inertia<B, CentreOfMassOf<B>, In<C>, S>& J_c,
                                const Displacement<CentreOfMassOf<B>, P, In<C>, S>& r_cp_c,
                                const Quantity<si::mass, S>& mass) {
  detail::require_mass<B>("shift", mass);
  const detail::Square<S> tensor =
      J_c.matrix() + detail::inertia_of_point_mass(mass.value(), r_cp_c.coordinates());
  if (!detail::all_finite(tensor)) {
    throw BadInput("shift(" + frame_name<B>() + "): the inertia overflows at a distance of " +
                   detail::text(norm(r_cp_c).value()) + " m");
  }
  return Inertia<B, P, In<C>, S>{detail::trusted, tensor};
}

/// J_c = J_p - m (|r_pc|^2 I - r_pc r_pc^T): back to the centre of mass, where the inertia is smallest:
/// shift(J_p, r_pc_c, m). The result is off by the rounding of J_p, and knows it; its bare matrix does not,
/// and inertia_from_tensor() may refuse that of a plate or rod. Throws BadInput if the mass is not positive,
/// or if beyond this rounding no body has the result: J_p is too small for a mass m at that distance.
template <class B, class P, class C, class S>
  requires(!std::same_as<P, CentreOfMassOf<B>>)
Inertia<B, CentreOfMassOf<B>, In<C>, S> shifted(const Inertia<B, P, In<C>, S>& J_p,
                                                const Displacement<P, CentreOfMassOf<B>, In<C>, S>& r_pc_c,
                                                const Quantity<si::mass, S>& mass) {
  detail::require_mass<B>("shift", mass);
  // Each of the two tensors is a sum of products: a few roundings of the larger.
  const S rounding = S(16.0 * static_cast<double>(Eigen::NumTraits<S>::epsilon())) * J_p.matrix().trace();
  return detail::checked_inertia<Inertia<B, CentreOfMassOf<B>, In<C>, S>, S>(
      "shift", J_p.matrix() - detail::inertia_of_point_mass(mass.value(), r_pc_c.coordinates()), rounding);
}

}  // namespace vectrix
