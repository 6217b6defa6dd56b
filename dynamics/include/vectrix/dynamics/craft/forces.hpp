#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <type_traits>
#include <vectrix/dynamics/craft/now.hpp>
#include <vectrix/dynamics/force/wrench.hpp>

namespace vectrix {
namespace detail {

/// What acts is a number of the craft's scalar, or a double.
template <class T, class S> inline constexpr bool acts_in = std::is_same_v<T, S> || std::is_same_v<T, double>;

/// Whether a value is a torque that can act on b, and its frame.
template <class B, class S, class Given> struct TorqueOn {
  using frame = void;
  static constexpr bool about = false;
};
template <class B, class S, class D, class T>
  requires acts_in<T, S>
struct TorqueOn<B, S, Vector<D, si::torque, T>> {
  using frame = D;
  static constexpr bool about = true;
};
template <class B, class S, class P, class D, class T>
  requires acts_in<T, S>
struct TorqueOn<B, S, Torque<P, In<D>, T>> {
  using frame = D;
  static constexpr bool about = std::is_same_v<B, P>;
};

template <class Shape, class S, class B, class... Given> struct ForceOn : std::false_type {};
template <class Shape, class S, class B, class D, class T>
struct ForceOn<Shape, S, B, Vector<D, si::force, T>>
    : std::bool_constant<acts_in<T, S> && Shape::template has_frame<D>> {};
template <class Shape, class S, class B, class Q, class E, class D, class R, class T>
struct ForceOn<Shape, S, B, Displacement<B, Q, In<E>, R>, Vector<D, si::force, T>>
    : std::bool_constant<acts_in<R, S> && acts_in<T, S> && Shape::template has_frame<E> &&
                         Shape::template has_frame<D>> {};

template <class U, class S, class Given> inline constexpr bool acts_as_quantity = false;
template <class U, class S, class T>
inline constexpr bool acts_as_quantity<U, S, Quantity<U, T>> = acts_in<T, S>;

template <class Given> inline constexpr int axis_of = 0;
template <int axis> inline constexpr int axis_of<AboutAxis<axis>> = axis;
/// 1 or 2 if the first value is a word, about_axis<1> or about_axis<2>; else 0.
template <class... Given> inline constexpr int driven_axis = 0;
template <class First, class... Others> inline constexpr int driven_axis<First, Others...> = axis_of<First>;

/// Whether values are the accelerations of the axes of the joint of b, of one of the axes of a gimbal, or of
/// a rotor.
template <class Shape, class S, class B, class... Given> constexpr bool is_acceleration_of() {
  if constexpr (driven_axis<Given...> != 0) {
    return Shape::template has_joint_of<B, JointKind::gimbal> && sizeof...(Given) == 2 &&
           (... + int(acts_as_quantity<si::angular_acceleration, S, Given>)) == 1;
  } else if constexpr (Shape::template has_axes<B>) {
    constexpr JointKind kind = Shape::template Part<B>::joint;
    return sizeof...(Given) == counts_of(kind).axes &&
           (acts_as_quantity<typename JointUnits<kind>::acceleration, S, Given> && ...);
  } else if constexpr (Shape::template has_rotor<B>) {
    return sizeof...(Given) == 1 && (acts_as_quantity<si::angular_acceleration, S, Given> && ...);
  }
  return false;
}

/// Whether values are the effort of the joint of b.
template <class Shape, class S, class B, class... Given> constexpr bool is_effort_on() {
  if constexpr (Shape::template has_joint_of<B, JointKind::hinge>) {
    return sizeof...(Given) == 1 && (acts_as_quantity<si::torque, S, Given> && ...);
  } else if constexpr (Shape::template has_joint_of<B, JointKind::slider>) {
    return sizeof...(Given) == 1 && (acts_as_quantity<si::force, S, Given> && ...);
  } else if constexpr (Shape::template has_joint_of<B, JointKind::gimbal>) {
    return sizeof...(Given) == 2 && (acts_as_quantity<si::torque, S, Given> && ...);
  } else if constexpr (Shape::template has_joint_of<B, JointKind::ball> ||
                       Shape::template has_joint_of<B, JointKind::free>) {
    if constexpr (sizeof...(Given) == 1)
      return (Shape::template has_frame<typename TorqueOn<void, S, Given>::frame> && ...);
  }
  return false;
}

}  // namespace detail

/// Where a load puts its forces; those of several loads add up. Vectors may be expressed in any frame of the
/// craft. What acts on a mount acts on its body.
template <CraftType C, class S = double> class Forces {
  using Shape = typename C::shape;
  template <class Given> using FrameOf = typename detail::TorqueOn<void, S, Given>::frame;
  template <class F> static constexpr bool turns = Shape::template has_frame<F>;
  template <class F> static constexpr bool placed = Shape::template has_place<F>;
  template <class B, class Given>
  static constexpr bool is_torque = detail::TorqueOn<B, S, Given>::about&& turns<FrameOf<Given>>;
  template <class B, class... Given>
  static constexpr bool is_force = detail::ForceOn<Shape, S, B, Given...>::value;
  template <class B, class... Given>
  static constexpr bool is_effort = detail::is_effort_on<Shape, S, B, Given...>();
  template <class B, class... Given>
  static constexpr bool is_acceleration = detail::is_acceleration_of<Shape, S, B, Given...>();
  template <class B>
  static constexpr bool can_lock =
      Shape::template is<B, detail::PartRole::body> || Shape::template has_rotor<B>;

 public:
  Forces(detail::Trusted, const Now<C, S>& now, multibody::Work<S>& work)
      : at_(now.instant()), work_(&work) {}

  /// A torque on a body: a Vector, a couple; or a Torque about b's origin.
  template <class B, class Given>
    requires(placed<B>&& is_torque<B, Given>)
  void torque(Of<B>, const Given& M_d) {
    add<B>(multibody::zero_column<S>(), hub<FrameOf<Given>>(M_d.coordinates()));
  }
  template <class B, class Given>
  auto torque(  // on a body or mount b of the craft C: a torque, about b if it says so, in a frame of C
      Of<B>, const Given&) -> Refused = delete;

  /// A force on a body, through its origin: force(of<B>, F_d); or through the point q of the body:
  /// force(of<B>, r_bq_e, F_d).
  template <class B, class... Given>
    requires(placed<B>&& is_force<B, Given...>)
  void force(Of<B>, const Given&... given) { push(of<B>, given...); }
  template <class B, class... Given>
  auto force(  // on a body or mount b of the craft C: F, or r_bq from b's origin and F; in frames of C
      Of<B>, const Given&...) -> Refused = delete;

  /// A force and a torque about b's origin.
  template <class B, class D, class T>
    requires(placed<B>&& turns<D>&& detail::acts_in<T, S>)
  void wrench(Of<B>, const Wrench<B, In<D>, T>& W_b_d) {
    force(of<B>, W_b_d.force());
    torque(of<B>, W_b_d.torque());
  }
  template <class B, class Given>
  auto wrench(  // on a body or mount b of the craft C: about b's origin, in a frame of C
      Of<B>, const Given&) -> Refused = delete;

  /// A torque of the parent on the body about the axis of its hinge; a force along its slider; torques about
  /// both axes of its gimbal; a torque vector on a body that hangs on a ball joint or a free one. The parent
  /// has the reaction. Springs, dampers and motors of joints are efforts.
  template <class B, class... Given>
    requires is_effort<B, Given...>
  void effort(Of<B>, const Given&... given) {
    constexpr std::size_t first = Shape::template speed_at<B> - Shape::speeds_begin;
    if constexpr (Shape::template has_axes<B>) {
      std::size_t at = first;
      ((work_->efforts[at++] += S(given.value())), ...);
    } else {
      const auto M_b = at_.template from_hub<B>(hub<FrameOf<Given>...>(given.coordinates()...));
      work_->efforts[first] += M_b.x, work_->efforts[first + 1] += M_b.y, work_->efforts[first + 2] += M_b.z;
    }
  }
  template <class B, class... Given>
  auto effort(  // of the joint of b in the craft C: N m of a hinge, N of a slider, both N m of a gimbal
      Of<B>, const Given&...) -> Refused = delete;

  /// A torque of the body on its rotor.
  template <class W, class Given>
    requires(Shape::template has_rotor<W>&& detail::acts_as_quantity<si::torque, S, Given>)
  void motor(Of<W>, const Given& torque) {
    work_->motors[Shape::template spin_at<W> - Shape::rotors_begin] += S(torque.value());
  }
  template <class W, class Given>
  auto motor(Of<W>, const Given&) -> Refused = delete;  // on a rotor of the craft C, in N m

  /// The joint of a body, or a rotor, keeps its speed, whatever acts on it: one at rest stays where it is,
  /// one that moves goes on as it moves; lockable() stops it. Whether it is locked may change between smooth
  /// segments only, with a held value.
  template <class B>
    requires can_lock<B>
  void lock(Of<B>) {
    if constexpr (Shape::template has_rotor<B>)
      hold<B>(work_->held_rotors[rotor<B>], multibody::Hold::locked);
    else
      hold_joint<B>(multibody::Hold::locked);
  }
  template <class B>
  auto lock(Of<B>) -> Refused = delete;  // of a body of the craft C that hangs on a joint, or a rotor

  /// As lock(), but what locks or drives it as well prevails: friction does not withstand a drive.
  template <class B>
    requires can_lock<B>
  void stick(detail::Trusted, Of<B>) {
    if constexpr (Shape::template has_rotor<B>)
      hold<B>(work_->held_rotors[rotor<B>], multibody::Hold::sticks);
    else
      hold_joint<B>(multibody::Hold::sticks);
  }

  /// The joint of a body, or a rotor, has this acceleration, whatever acts on it: of a hinge, a slider or a
  /// rotor; both of a gimbal, or that about one of its axes. Throws BadInput if it is also locked, or driven
  /// twice.
  template <class B, class... Given>
    requires is_acceleration<B, Given...>
  void drive(Of<B>, const Given&... acceleration) {
    if constexpr (detail::driven_axis<Given...> != 0) {
      drive_axis<B>(acceleration...);
    } else if constexpr (Shape::template has_rotor<B>) {
      hold<B>(work_->held_rotors[rotor<B>], multibody::Hold::driven);
      ((work_->given_spins[rotor<B>] = S(acceleration.value())), ...);
    } else {
      hold_joint<B>(multibody::Hold::driven);
      std::size_t at = Shape::template speed_at<B> - Shape::speeds_begin;
      ((work_->given[at++] = S(acceleration.value())), ...);
    }
  }
  template <class B, class... Given>
  auto drive(  // of b: rad/s^2 of a hinge or rotor, m/s^2 of a slider; a gimbal: both, or about_axis<i>, one
      Of<B>, const Given&...) -> Refused = delete;

  /// Forces on the modes of an appendage, kg^1/2 m/s^2.
  template <class A>
  requires Shape::template has_modes<A> void modal(
      Of<A>, const std::array<S, Shape::template Part<A>::counts.modes>& forces) {
    for (std::size_t i = 0; i < forces.size(); ++i)
      work_->modal[Shape::template modes_at<A> - Shape::modes_begin + i] += forces[i];
  }
  template <class A, class Given>
  auto modal(Of<A>, const Given&) -> Refused = delete;  // on the modes of an appendage of the craft C

  /// A uniform field: the same acceleration for every mass.
  template <class D, class T>
    requires(turns<D>&& detail::acts_in<T, S>)
  void field(const Vector<D, si::acceleration, T>& g_d) {
    work_->field += work_->R_i_from_h * hub<D>(g_d.coordinates());
  }
  template <class Given> auto field(const Given&) -> Refused = delete;  // an acceleration in a frame of C

 private:
  using Column = multibody::Column<S>;
  template <class D, class T> [[gnu::always_inline]] Column hub(const Eigen::Matrix<T, 3, 1>& v_d) const {
    return at_.template to_hub<D>(Column{S(v_d.x()), S(v_d.y()), S(v_d.z())});
  }
  template <class B, class D, class T> void push(Of<B>, const Vector<D, si::force, T>& F_d) {
    const auto F = hub<D>(F_d.coordinates());
    add<B>(F, multibody::cross(at_.template arm<B>(), F));
  }
  template <class B, class Q, class E, class D, class R, class T>
  void push(Of<B>, const Displacement<B, Q, In<E>, R>& r_bq_e, const Vector<D, si::force, T>& F_d) {
    const auto F = hub<D>(F_d.coordinates());
    add<B>(F, multibody::cross(at_.template arm<B>() + hub<E>(r_bq_e.coordinates()), F));
  }
  template <class W> static constexpr std::size_t rotor = Shape::template spin_at<W> - Shape::rotors_begin;
  template <class B> void hold(multibody::Hold& held, multibody::Hold how) {
    using multibody::Hold;
    if (std::min(held, how) > Hold::sticks && std::max(held, how) == Hold::driven) [[unlikely]]
      detail::refuse_to_hold_twice((Shape::template has_rotor<B> ? "the rotor " : "the joint of ") +
                                   frame_name<B>());
    held = std::max(held, how);
  }
  template <class B, int axis, class Given> void drive_axis(AboutAxis<axis>, const Given& acceleration) {
    hold<B>(work_->held[Shape::template link_of<B>() - 3 + axis], multibody::Hold::driven);
    work_->given[Shape::template speed_at<B> - Shape::speeds_begin + axis - 1] = S(acceleration.value());
  }
  template <class B> void hold_joint(multibody::Hold how) {
    constexpr std::size_t end = Shape::template link_of<B>();
    for (std::size_t i = end - Shape::template Part<B>::counts.links; i < end; ++i)
      hold<B>(work_->held[i], how);
  }
  template <class B> [[gnu::always_inline]] void add(const Column& F, const Column& M) {
    constexpr std::size_t link = Shape::template link_of<B>();
    auto& I = link == 0 ? work_->hub : work_->links[link == 0 ? 0 : link - 1].I;
    I.n -= M;
    I.f -= F;
  }

  detail::CraftInstant<Shape, S> at_;
  multibody::Work<S>* work_;
};

}  // namespace vectrix
