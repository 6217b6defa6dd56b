#pragma once

#include <concepts>
#include <type_traits>
#include <vectrix/dynamics/craft/forces.hpp>

namespace vectrix {

/// The magnetic dipole moment of the coils on a body or mount, in its axes, A m^2: a value to be held, which
/// a controller changes.
template <Frame B> struct Dipole { Vector<B, si::magnetic_dipole_moment> m_b; };

namespace detail {

template <class Value> struct FluxFrame { using type = void; };
template <class D, class S> struct FluxFrame<Vector<D, si::magnetic_flux_density, S>> { using type = D; };

/// Whether F gives the magnetic flux density at an instant in a frame of the craft.
template <class C, class F, class S = double> constexpr bool gives_field() {
  if constexpr (std::invocable<const F&, const Now<C, S>&>)
    return C::shape::template has_frame<
        typename FluxFrame<std::remove_cvref_t<std::invoke_result_t<const F&, const Now<C, S>&>>>::type>;
  else
    return false;
}

}  // namespace detail

/// A load: the torque m x B on a body or mount. Made by magnetorquer().
template <CraftType C, class B, class F> struct MagnetorquerLoad {
  F field;

  template <class S>
    requires(detail::gives_field<C, F, S>())
  void operator()(const Now<C, S>& now, Forces<C, S>& forces, const Dipole<B>& dipole) const {
    const auto B_d = field(now);
    using D = typename detail::FluxFrame<std::remove_cvref_t<decltype(B_d)>>::type;
    const Vector<B, si::magnetic_dipole_moment, S> m_b{detail::trusted,
                                                       dipole.m_b.coordinates().template cast<S>()};
    if constexpr (std::is_same_v<B, D>)
      forces.torque(of<B>, cross(m_b, B_d));
    else
      forces.torque(of<B>, cross(m_b, now.rotation(to<B>, from<D>) * B_d));
  }
};

/// The torque m x B of coils on a body or mount b. The scenario holds their Dipole<B>; the field is a
/// function of const Now<C>& that gives the magnetic flux density B, in a frame of the craft, for example of
/// the place by a MagneticField.
template <CraftType C, class B, class F>
  requires(C::shape::template has_place<B>&& detail::gives_field<C, F>())
MagnetorquerLoad<C, B, F> magnetorquer(const C&, Of<B>, const F& field) {
  return {field};
}
template <class... Given>
  requires(detail::about_frames<Given...>)
auto magnetorquer(  // craft, of<B>, f: on a body or mount of C; f(const Now<C>&) gives tesla in a frame of C
    const Given&...) -> Refused = delete;

}  // namespace vectrix
