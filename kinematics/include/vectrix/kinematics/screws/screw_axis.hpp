#pragma once

#include <vectrix/kinematics/attitude/quaternion.hpp>
#include <vectrix/kinematics/screws/screw.hpp>

namespace vectrix {

/// A screw motion in geometric form (Mozzi, Chasles): a turn about a line fixed in a, and an advance along
/// it.
template <Frame A, class S = double> struct ScrewAxis {
  Vector<A, si::dimensionless, S> direction;  // a unit vector
  Vector<A, si::length, S> place;             // a point of the line, from a's origin
  Quantity<si::angle, S> angle;
  Quantity<si::length, S> advance;
};
template <class A, class S, class... Rest>
ScrewAxis(const Vector<A, si::dimensionless, S>&, const Rest&...) -> ScrewAxis<A, S>;

/// Claims that this motion takes b from coincidence with a to b:
///     theta = angle n,  rho = place x theta + advance n
/// Throws BadInput when | |n| - 1 | exceeds unit_norm_tolerance, or the motion is not finite.
template <Frame B, Frame A, class S>
detail::OfTwo<B, A, Screw<A, B, S>> screw_along(Of<B>, RelativeTo<A>, const ScrewAxis<A, S>& axis) {
  const detail::Column<S>& n = axis.direction.coordinates();
  const S norm = detail::scaled_norm(n);
  const S error = detail::select(norm > S(1), S(norm - S(1)), S(S(1) - norm));
  if (!detail::all(error <= detail::number<S>(detail::door_tolerance<S>(unit_norm_tolerance)))) {
    throw BadInput(detail::parameters_name<Screw<A, B, S>>("screw_along") +
                   "the norm of its direction differs from 1 by " + detail::text(error) +
                   "; direction() projects");
  }
  const detail::Column<S> theta = axis.angle.value() * n;
  const detail::Column<S> rho = axis.place.coordinates().cross(theta) + axis.advance.value() * n;
  return {detail::trusted, detail::finite_motion<Screw<A, B, S>>(theta, "screw_along"),
          detail::finite_motion<Screw<A, B, S>>(rho, "screw_along")};
}
template <class OfFrame, class RelativeToFrame, class Given>
auto screw_along(  // of<B>, relative_to<A>: two frames; the axis of the motion in a
    const OfFrame&, const RelativeToFrame&, const Given&) -> Refused = delete;

/// The axis of xi_ab, with the point nearest to a's origin, and angle > 0:
///     n = theta/|theta|,  place = n x rho/|theta|,  advance = n . rho
/// Throws BadInput for a pure translation, which has no axis, and when the position of the axis overflows.
template <class A, class B, class S> ScrewAxis<A, S> screw_axis(const Screw<A, B, S>& xi_ab) {
  const S angle = xi_ab.rotation_vector().angle().value();
  const detail::Column<S> rho = xi_ab.in_reference().coordinates();
  const detail::Column<S> n = xi_ab.rotation_vector().coordinates() / angle;
  const detail::Column<S> place = n.cross(rho) / angle;
  if (!detail::all_finite(place)) {
    throw BadInput(detail::parameters_name<Screw<A, B, S>>("screw_axis") + "|theta| is " +
                   detail::text(angle) + "; a translation has no axis");
  }
  return {Vector<A, si::dimensionless, S>{detail::trusted, n},
          Vector<A, si::length, S>{detail::trusted, place}, Quantity<si::angle, S>::from_value(angle),
          Quantity<si::length, S>::from_value(n.dot(rho))};
}

template <class A, class S> std::ostream& print_framed(std::ostream& out, const ScrewAxis<A, S>& axis) {
  return out << axis.direction << " at " << axis.place << ", turn " << detail::printable(axis.angle.value())
             << " rad, advance " << detail::printable(axis.advance.value()) << " m";
}

}  // namespace vectrix
