#pragma once

#include <vectrix/dynamics/mass/join.hpp>
#include <vectrix/dynamics/mass/parallel_axes.hpp>

namespace vectrix {

/// m, r_oc^d and J_c^d of a rigid body b, of type MassProperties<B, O, In<D>>: its mass, the position of its
/// centre of mass c relative to the point o, and its inertia about c. `MassProperties<B>`: from the origin of
/// b, in the axes of b. Its laws:
///     1.  (m, R r_oc, R J_c R^T)                     R_e_from_d * body
///     2.  (m, r_oc - r_op, J_c)                      shift(body, r_op_d)
///     3.  m = m_1 + m_2,  m r_oc = m_1 r_o1 + m_2 r_o2,  J_o = J_1o + J_2o
///                                                    join(of<Whole>, body_1, body_2, ...)
/// Made by mass_properties(m, r_oc_d, J_c_d). There is no default constructor.
template <Frame B, Point O = B, class ExpressedIn = In<B>, class S = double> class MassProperties;

template <Frame B, Point O, Frame D, class S> class MassProperties<B, O, In<D>, S> {
 public:
  using Position = Displacement<O, CentreOfMassOf<B>, In<D>, S>;
  using InertiaAboutCentre = Inertia<B, CentreOfMassOf<B>, In<D>, S>;

  explicit MassProperties(detail::Trusted, const Quantity<si::mass, S>& mass, const Position& r_oc_d,
                          const InertiaAboutCentre& J_c_d)
      : mass_(mass), centre_(r_oc_d), inertia_(J_c_d) {}

  const Quantity<si::mass, S>& mass() const& { return mass_; }
  Quantity<si::mass, S> mass() && { return mass_; }
  /// r_oc^d, the position of the centre of mass.
  const Position& centre() const& { return centre_; }
  Position centre() && { return centre_; }
  /// About the centre of mass.
  const InertiaAboutCentre& inertia() const& { return inertia_; }
  InertiaAboutCentre inertia() && { return inertia_; }

  template <class Operand = MassProperties>
  auto operator-() const -> Refused = delete;  // a body has no negative

 private:
  Quantity<si::mass, S> mass_;
  Position centre_;
  InertiaAboutCentre inertia_;
};

template <class B, class O, class D, class S>
inline constexpr bool detail::is_framed<MassProperties<B, O, D, S>> = true;

/// The mass properties of b. Throws BadInput if the mass is not positive.
template <class B, class O, class D, class S>
MassProperties<B, O, In<D>, S> mass_properties(const Quantity<si::mass, S>& mass,
                                               const Displacement<O, CentreOfMassOf<B>, In<D>, S>& r_oc_d,
                                               const Inertia<B, CentreOfMassOf<B>, In<D>, S>& J_c_d) {
  detail::require_mass<B>("mass_properties", mass);
  return MassProperties<B, O, In<D>, S>{detail::trusted, mass, r_oc_d, J_c_d};
}
template <class MassGiven, class PositionGiven, class InertiaGiven>
  requires detail::any_framed<PositionGiven, InertiaGiven>
auto mass_properties(  // mass_properties(m, r_oc_d, J_c_d): both of the body's centre of mass, in one frame
    const MassGiven&, const PositionGiven&, const InertiaGiven&) -> Refused = delete;

// (m, R_d^e r_oc^d, R_d^e J_c^d (R_d^e)^T)
template <class E, class D, class B, class O, class S>
MassProperties<B, O, In<E>, S> product(const Dcm<E, D, S>& R_e_from_d,
                                       const MassProperties<B, O, In<D>, S>& body) {
  return MassProperties<B, O, In<E>, S>{detail::trusted, body.mass(), R_e_from_d * body.centre(),
                                        R_e_from_d * body.inertia()};
}

// (m, -r_op^d + r_oc^d, J_c^d)
template <class O, class P, class D, class B, class S>
MassProperties<B, P, In<D>, S> shifted(const MassProperties<B, O, In<D>, S>& body,
                                       const Displacement<O, P, In<D>, S>& r_op_d) {
  return MassProperties<B, P, In<D>, S>{detail::trusted, body.mass(), -r_op_d + body.centre(),
                                        body.inertia()};
}

// J_c = sum of J_k + m_k (|r_ck|^2 I - r_ck r_ck^T): taken about the new centre of mass, so that there is no
// subtraction
template <class Whole, class O, class D, class S, class... B>
  requires detail::all_different<Whole, B...> MassProperties<Whole, O, In<D>, S> joined(
      Of<Whole>, const MassProperties<B, O, In<D>, S>&... part) {
    using Result = MassProperties<Whole, O, In<D>, S>;
    const S mass = (part.mass().value() + ...);
    const detail::Column<S> centre = ((part.mass().value() / mass * part.centre().coordinates()) + ...);
    const auto about_centre = [&](const auto& body) -> detail::Square<S> {
      return body.inertia().matrix() +
             detail::inertia_of_point_mass<S>(body.mass().value(), body.centre().coordinates() - centre);
    };
    return Result{detail::trusted, Quantity<si::mass, S>::from_value(mass),
                  typename Result::Position{detail::trusted, centre},
                  typename Result::InertiaAboutCentre{detail::trusted, (about_centre(part) + ...)}};
  }

/// 12 kg; (1, 2, 3) m of CentreOfMassOf<Body> relative to Body in Body; [...] kg m^2 in Body
template <class B, class O, class D, class S>
std::ostream& print_framed(std::ostream& out, const MassProperties<B, O, In<D>, S>& body) {
  return out << body.mass().value() << " kg; " << body.centre() << "; " << body.inertia();
}

}  // namespace vectrix
