#pragma once

#include <cstddef>
#include <vectrix/dynamics/craft/craft_core.hpp>
#include <vectrix/dynamics/craft/eigen_numbers.hpp>
#include <vectrix/dynamics/craft/shape.hpp>
#include <vectrix/dynamics/multibody/kinds.hpp>

namespace vectrix::detail {

template <JointKind> struct EngineKind;
template <> struct EngineKind<JointKind::hinge> : std::type_identity<multibody::Hinge> {};
template <> struct EngineKind<JointKind::slider> : std::type_identity<multibody::Slider> {};
template <> struct EngineKind<JointKind::ball> : std::type_identity<multibody::Ball> {};
template <> struct EngineKind<JointKind::free> : std::type_identity<multibody::Free> {};
template <> struct EngineKind<JointKind::fixed> : std::type_identity<multibody::Fixed> {};

/// Where the frames of a craft are at one instant, in plain numbers in the hub's axes. The links are found at
/// compile time.
template <class Shape, class S = double> class CraftInstant {
  using Column3 = multibody::Column<S>;
  using Square3 = multibody::Square<S>;

  template <class F> using CarrierOf = typename Shape::template Part<F>::carrier;
  template <class F> static constexpr bool is_inertial = std::is_same_v<F, typename Shape::inertial>;
  template <class F> static constexpr bool is_hub = std::is_same_v<F, typename Shape::hub>;
  template <class F> static constexpr bool is_mount = Shape::template is<F, PartRole::mount>;

 public:
  CraftInstant(const CraftCoreIn<S>& core, const S* y, const multibody::Work<S>& work)
      : core_(&core), y_(y), work_(&work) {}

  const CraftCoreIn<S>& core() const { return *core_; }
  const S* y() const { return y_; }
  const multibody::Work<S>& work() const { return *work_; }

  /// R_f^h v and (R_f^h)^T v.
  template <class F> [[gnu::always_inline]] Column3 to_hub(const Column3& v_f) const {
    if constexpr (is_hub<F>)
      return v_f;
    else if constexpr (is_inertial<F>)
      return multibody::transposed_times(work_->R_i_from_h, v_f);
    else
      return rotation<F>() * v_f;
  }
  template <class F> [[gnu::always_inline]] Column3 from_hub(const Column3& v_h) const {
    if constexpr (is_hub<F>)
      return v_h;
    else if constexpr (is_inertial<F>)
      return work_->R_i_from_h * v_h;
    else
      return multibody::transposed_times(rotation<F>(), v_h);
  }
  /// R_a^b
  template <class B, class A> [[gnu::always_inline]] Square3 rotation_between() const {
    if constexpr (is_inertial<B>) {
      if constexpr (is_hub<A>)
        return work_->R_i_from_h;
      else
        return work_->R_i_from_h * rotation<A>();
    } else if constexpr (is_inertial<A>) {
      return transposed(rotation_between<A, B>());
    } else if constexpr (is_hub<B>) {
      return rotation<A>();
    } else if constexpr (is_hub<A>) {
      return transposed(rotation<B>());
    } else {
      return transposed_times(rotation<B>(), rotation<A>());
    }
  }
  /// w_if
  template <class F> [[gnu::always_inline]] Column3 turning() const {
    if constexpr (is_inertial<F>)
      return multibody::zero_column<S>();
    else if constexpr (is_hub<F>)
      return work_->w;
    else if constexpr (is_mount<F>)
      return turning<CarrierOf<F>>();
    else
      return link<F>().w;
  }
  /// From the hub's origin to that of f.
  template <class F> [[gnu::always_inline]] Column3 position() const {
    if constexpr (is_inertial<F>)
      return -multibody::transposed_times(work_->R_i_from_h, hub_column(7));
    else if constexpr (is_hub<F>)
      return multibody::zero_column<S>();
    else if constexpr (is_mount<F>)
      return position<CarrierOf<F>>() + arm<F>();
    else
      return position<CarrierOf<F>>() + step<F>();
  }
  /// The velocity of the origin of f relative to that of the hub, observed from the inertial frame.
  template <class F> Column3 velocity() const {
    if constexpr (is_inertial<F>) {
      return -multibody::transposed_times(work_->R_i_from_h, hub_column(10));
    } else if constexpr (is_hub<F>) {
      return multibody::zero_column<S>();
    } else {
      using P = CarrierOf<F>;
      if constexpr (is_mount<F>) {
        return velocity<P>() + multibody::cross(turning<P>(), arm<F>());
      } else if constexpr (Shape::template has_joint_of<F, JointKind::gimbal>) {
        return velocity<P>() + multibody::cross(turning<P>(), step<F>());
      } else {
        using Kind = typename EngineKind<Shape::template Part<F>::joint>::type;
        return velocity<P>() + multibody::cross(turning<P>(), step<F>()) +
               Kind::velocity(rotation<P>(), y_ + Shape::template speed_at<F>, link<F>());
      }
    }
  }
  /// To the origin of a mount from that of its body; zero for a body.
  template <class F> [[gnu::always_inline]] Column3 arm() const {
    if constexpr (is_mount<F>)
      return to_hub<CarrierOf<F>>(mount<F>().r_bc_b);
    else
      return multibody::zero_column<S>();
  }

 private:
  template <class F> [[gnu::always_inline]] const multibody::Moving<S>& link() const {
    constexpr std::size_t number = Shape::template link_of<F>();
    return work_->links[number - 1];
  }
  /// R_f^h of a frame on the craft.
  template <class F> [[gnu::always_inline]] decltype(auto) rotation() const {
    if constexpr (is_hub<F>)
      return (work_->unit);
    else if constexpr (is_mount<F>)
      return rotation<CarrierOf<F>>() * mount<F>().R_b_from_c;
    else
      return (link<F>().R);
  }
  template <class F> [[gnu::always_inline]] const MountNumbers<S>& mount() const {
    return core_->mounts[Shape::template mount_at<F>];
  }
  /// From the parent's origin; a gimbal's body is at the origin of its ring, which is the link before.
  template <class F> [[gnu::always_inline]] const Column3& step() const {
    constexpr bool ring = Shape::template has_joint_of<F, JointKind::gimbal>;
    constexpr std::size_t number = Shape::template link_of<F>();
    return work_->links[number - (ring ? 2 : 1)].r;
  }
  Column3 hub_column(std::size_t at) const { return {y_[at], y_[at + 1], y_[at + 2]}; }

  const CraftCoreIn<S>* core_;
  const S* y_;
  const multibody::Work<S>* work_;
};

}  // namespace vectrix::detail
