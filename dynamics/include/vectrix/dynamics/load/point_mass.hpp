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

  void operator()(const Now<C>& now, Forces<C>& forces) const {
    const detail::Column3 r = -now.instant().template position<typename Shape::inertial>();
    const double distance = std::sqrt(multibody::dot(r, r));
    const double pull = detail::attraction(detail::gravity_at<H>("point_mass"), mu_.value(), distance);
    forces.field(Vector<H, si::acceleration>{detail::trusted, detail::eigen(r * -pull)});
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
  template <class B>
  void attract(const detail::CraftInstant<Shape>& at, const detail::Column3& r, Forces<C>& forces) const {
    using multibody::cross, multibody::dot;
    const BodyNumbers& body = bodies_[number_of<B>()];
    const detail::Column3 c = at.template to_hub<B>(body.centre_b);
    const detail::Column3 d = at.template position<B>() + c;
    const detail::Column3 r_c = r + d;
    const double distance = std::sqrt(dot(r_c, r_c));
    const double pull =
        detail::attraction(detail::gravity_at<H>("point_mass"), mu_.value(), distance);  // mu/|r_c|^3

    // r_c - r (1 + q)^(3/2), q = |r_c|^2/|r|^2 - 1
    const double q = dot(d, d + r * 2.0) / dot(r, r);
    const double cube = (1.0 + q) * std::sqrt(1.0 + q);
    const detail::Column3 difference = d - r * (q * (3.0 + q * (3.0 + q)) / (1.0 + cube));

    const detail::Column3 u = r_c * (1.0 / distance);
    const detail::Column3 Ju = at.template to_hub<B>(body.J_c_b * at.template from_hub<B>(u));
    const double trace = body.J_c_b.xx + body.J_c_b.yy + body.J_c_b.zz;
    const detail::Column3 of_size = (u * (trace - 5.0 * dot(u, Ju)) + Ju * 2.0) * (1.5 / distance);
    const detail::Column3 F = (difference * body.m + of_size) * -pull;
    const detail::Column3 M = cross(u, Ju) * (3.0 * pull);

    forces.force(of<B>, Displacement<B, CentreOfMassOf<B>, In<H>>{detail::trusted, detail::eigen(c)},
                 Vector<H, si::force>{detail::trusted, detail::eigen(F)});
    forces.torque(of<B>, Vector<H, si::torque>{detail::trusted, detail::eigen(M)});
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
template <class C, class Mu>
auto point_mass(  // point_mass(craft, mu): a craft whose hub is free_in<I>, so that it has a place; m^3/s^2
    const C&, const Mu&) -> Refused = delete;

}  // namespace vectrix
