#pragma once

#include <concepts>
#include <vectrix/dynamics/craft/craft_numbers.hpp>
#include <vectrix/dynamics/craft/instant.hpp>
#include <vectrix/kinematics/points/velocity.hpp>
#include <vectrix/kinematics/rates/angular_velocity.hpp>

namespace vectrix {

/// A craft at one instant: a view of its state, with the place and the velocity of every body and mount. A
/// load sees it. Frames are those of the bodies and mounts, and the inertial one; each answer is one product.
template <CraftType C, class S = double> class Now : public detail::CraftNumbers<Now<C, S>, C, S> {
  using Shape = typename C::shape;
  using I = typename Shape::inertial;

  template <class F> static constexpr bool turns = Shape::template has_frame<F>;
  /// The position of a hub that is only turning is not known.
  template <class F>
  static constexpr bool placed = Shape::template has_place<F> || (Shape::free && std::is_same_v<F, I>);

 public:
  Now(detail::Trusted, const detail::CraftCoreIn<S>& core, double t, const S* y,
      const multibody::Work<S>& work)
      : at_(core, y, work), t_(t) {}

  Quantity<si::time> time() const { return Quantity<si::time>::from_value(t_); }

  /// R_a^b
  template <class B, class A>
    requires(turns<B>&& turns<A> && !std::is_same_v<A, B>)
  Dcm<B, A, S> rotation(To<B>, From<A>)
  const { return Dcm<B, A, S>{detail::trusted, detail::eigen(at_.template rotation_between<B, A>())}; }
  template <class B, class A>
  auto rotation(  // to<B>, from<A>: two frames of the craft C, its bodies, mounts and inertial frame
      To<B>, From<A>) const -> Refused = delete;

  /// w_ab^c
  template <class B, class A, class D>
    requires(turns<B>&& turns<A>&& turns<D> && !std::is_same_v<A, B>)
  AngularVelocity<A, B, In<D>, S> angular_velocity(Of<B>, RelativeTo<A>, In<D>)
  const {
    return AngularVelocity<A, B, In<D>, S>{detail::trusted,
                                           in<D>(at_.template turning<B>() - at_.template turning<A>())};
  }
  template <class B, class A, class D>
  auto angular_velocity(  // frames of the craft C, its bodies, mounts and inertial frame
      Of<B>, RelativeTo<A>, In<D>) const -> Refused = delete;

  /// r_ab^c of the origins.
  template <class B, class A, class D>
    requires(placed<B>&& placed<A>&& turns<D> && !std::is_same_v<A, B>)
  Displacement<A, B, In<D>, S> position(Of<B>, RelativeTo<A>, In<D>)
  const {
    return Displacement<A, B, In<D>, S>{detail::trusted,
                                        in<D>(at_.template position<B>() - at_.template position<A>())};
  }
  template <class B, class A, class D>
  auto position(  // frames of the craft C; relative to the inertial one if the hub is free_in<I>
      Of<B>, RelativeTo<A>, In<D>) const -> Refused = delete;

  /// v_ab|o^c of the origins: v_b - v_a - w_io x r_ab.
  template <class B, class A, class O, class D>
    requires(placed<B>&& placed<A>&& turns<O>&& turns<D> && !std::is_same_v<A, B>)
  Velocity<A, B, ObservedFrom<O>, In<D>, S> velocity(Of<B>, RelativeTo<A>, ObservedFrom<O>, In<D>)
  const {
    const auto r = at_.template position<B>() - at_.template position<A>();
    return Velocity<A, B, ObservedFrom<O>, In<D>, S>{
        detail::trusted, in<D>(at_.template velocity<B>() - at_.template velocity<A>() -
                               multibody::cross(at_.template turning<O>(), r))};
  }
  template <class B, class A, class O, class D>
  auto velocity(  // frames of the craft C; relative to the inertial one if the hub is free_in<I>
      Of<B>, RelativeTo<A>, ObservedFrom<O>, In<D>) const -> Refused = delete;

  /// Kinetic energy, and that of the modes' springs. Of a turning hub: relative to the centre of mass.
  Quantity<si::energy, S> energy() const { return Quantity<si::energy, S>::from_value(conserved().energy); }
  /// The angular momentum is about the inertial origin; of a turning hub about the centre of mass, where the
  /// momentum is zero.
  Vector<I, si::momentum, S> momentum() const {
    return {detail::trusted, detail::eigen(conserved().momentum)};
  }
  Vector<I, si::angular_momentum, S> angular_momentum() const {
    return {detail::trusted, detail::eigen(conserved().angular_momentum)};
  }

  const S* data() const { return at_.y(); }
  const detail::CraftInstant<Shape, S>& instant() const { return at_; }

 private:
  template <class D> [[gnu::always_inline]] Eigen::Matrix<S, 3, 1> in(const multibody::Column<S>& v_h) const {
    return detail::eigen(at_.template from_hub<D>(v_h));
  }
  multibody::Conserved<S> conserved() const {
    return at_.core().tree.conserved(at_.y(), multibody::zero_column<S>(), at_.work());
  }

  detail::CraftInstant<Shape, S> at_;
  double t_;
};

}  // namespace vectrix
