#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vectrix/dynamics/craft/forces.hpp>
#include <vectrix/dynamics/force/gravity.hpp>
#include <vectrix/dynamics/load/finite.hpp>
#include <vectrix/dynamics/multibody/converted.hpp>

namespace vectrix {

/// A load: the attraction of a point mass at the origin of the inertial frame. The acceleration of the hub's
/// origin, -mu r/|r|^3, acts on all masses. Besides, on each body with the mass m and J about its centre of
/// mass, at r_c = r + d, u = r_c/|r_c|, acts what a rigid body has more, to the second order in its size:
///     F = -m mu (r_c/|r_c|^3 - r/|r|^3) - 3/2 mu/|r_c|^4 ((tr J - 5 u.J u) u + 2 J u)
///     M = 3 mu/|r_c|^3 u x J u
/// They are those of the potential -mu m/|r_c| - mu/2 (tr J - 3 u.J u)/|r_c|^3, so that energy and angular
/// momentum are kept. The difference is taken without cancellation (Battin 1999, section 8.4). What modes
/// move has the acceleration of the hub. Throws BadInput if mu/|r_c|^3 is not finite.
template <CraftType C> class PointMassAttraction {
  using Shape = typename C::shape;
  using H = typename Shape::hub;
  struct BodyNumbers {
    double m;
    detail::Column3 centre_b;
    multibody::Symmetric<double> J_c_b;
  };
  static constexpr std::size_t bodies = Shape::total.bodies + 1;

 public:
  PointMassAttraction(detail::Trusted, const C& craft, const Quantity<si::gravitational_parameter>& mu)
      : mu_(mu) {
    const PlainSpacecraft& plain = craft.core()->plain;
    bodies_[0] = {plain.mass, detail::numbers(plain.r_hc_h), detail::symmetric(plain.J_c_h)};
    for (std::size_t i = 1; i < bodies; ++i) {
      const PlainBody& body = plain.bodies[i - 1];
      bodies_[i] = {body.mass, detail::numbers(body.r_bc_b), detail::symmetric(body.J_c_b)};
    }
  }

  template <class S> void operator()(const Now<C, S>& now, Forces<C, S>& forces) const {
    using std::sqrt;
    const multibody::Column<S> r = -now.instant().template position<typename Shape::inertial>();
    const S distance = sqrt(multibody::dot(r, r));
    const S pull = detail::attraction<S>(detail::gravity_at<H>("point_mass"), mu_.value(), distance);
    forces.field(Vector<H, si::acceleration, S>{detail::trusted, detail::eigen(r * S(-pull))});
    each_part([&]<class Part>(std::type_identity<Part>) {
      using B = typename Part::frame;
      if constexpr (Shape::template has_body<B>) attract<B>(now.instant(), r, forces);
    });
  }

 private:
  template <class Function> static void each_part(const Function& function) {
    [&]<class... Part>(std::type_identity<std::tuple<Part...>>) {
      (function(std::type_identity<Part>{}), ...);
    }(std::type_identity<typename Shape::parts>{});
  }
  template <class B> static constexpr std::size_t number_of() {
    if constexpr (std::is_same_v<B, H>)
      return 0;
    else
      return 1 + Shape::template body_at<B>;
  }

  /// All in the hub's axes.
  template <class B, class S>
  void attract(const detail::CraftInstant<Shape, S>& at, const multibody::Column<S>& r,
               Forces<C, S>& forces) const {
    using multibody::cross, multibody::dot, multibody::converted;
    using std::sqrt;
    using Column = multibody::Column<S>;
    const BodyNumbers& body = bodies_[number_of<B>()];
    const multibody::Symmetric<S> J_c_b = converted<S>(body.J_c_b);
    const Column c = at.template to_hub<B>(converted<S>(body.centre_b));
    const Column d = at.template position<B>() + c;
    const Column r_c = r + d;
    const S distance = sqrt(dot(r_c, r_c));
    const S pull =
        detail::attraction<S>(detail::gravity_at<H>("point_mass"), mu_.value(), distance);  // mu/|r_c|^3

    // r_c - r (1 + q)^(3/2), q = |r_c|^2/|r|^2 - 1
    const S q = dot(d, d + r * S(2.0)) / dot(r, r);
    const S cube = (1.0 + q) * sqrt(S(1.0 + q));
    const Column difference = d - r * S(q * (3.0 + q * (3.0 + q)) / (1.0 + cube));

    const Column u = r_c * S(1.0 / distance);
    const Column Ju = at.template to_hub<B>(J_c_b * at.template from_hub<B>(u));
    const S trace = J_c_b.xx + J_c_b.yy + J_c_b.zz;
    const Column of_size = (u * S(trace - 5.0 * dot(u, Ju)) + Ju * S(2.0)) * S(1.5 / distance);
    const Column F = (difference * S(body.m) + of_size) * S(-pull);
    const Column M = cross(u, Ju) * S(3.0 * pull);

    forces.force(of<B>, Displacement<B, CentreOfMassOf<B>, In<H>, S>{detail::trusted, detail::eigen(c)},
                 Vector<H, si::force, S>{detail::trusted, detail::eigen(F)});
    forces.torque(of<B>, Vector<H, si::torque, S>{detail::trusted, detail::eigen(M)});
  }

  Quantity<si::gravitational_parameter> mu_;
  std::array<BodyNumbers, bodies> bodies_;
};

/// The attraction of a point mass at the origin of the inertial frame on all bodies.
template <CraftType C>
  requires C::shape::free PointMassAttraction<C> point_mass(const C& craft,
                                                            const Quantity<si::gravitational_parameter>& mu) {
    return {detail::trusted, craft, detail::positive("point_mass", "gravitational parameter", mu)};
  }
template <CraftType C, class... Given>
auto point_mass(  // point_mass(craft, mu): a craft whose hub is free_in<I>, so that it has a place; m^3/s^2
    const C&, const Given&...) -> Refused = delete;

}  // namespace vectrix
