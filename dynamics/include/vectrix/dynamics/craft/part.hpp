#pragma once

#include <Eigen/Core>
#include <array>
#include <concepts>
#include <cstddef>
#include <vectrix/dynamics/craft/craft_core.hpp>
#include <vectrix/dynamics/craft/eigen_numbers.hpp>
#include <vectrix/dynamics/craft/joint.hpp>
#include <vectrix/dynamics/craft/joint_counts.hpp>
#include <vectrix/dynamics/craft/plain_parts.hpp>

namespace vectrix {

/// The body that carries a part: on<B>.
template <class B> struct On {};
template <Frame B> inline constexpr On<B> on{};

namespace detail {

enum class PartRole { hub, body, rotor, modes, mount };

/// How many numbers a part has in the state, and links in the tree.
struct PartCounts {
  std::size_t bodies = 0, links = 0, positions = 0, speeds = 0, rotors = 0, modes = 0, mounts = 0;

  constexpr PartCounts operator+(const PartCounts& b) const {
    return {bodies + b.bodies, links + b.links, positions + b.positions, speeds + b.speeds,
            rotors + b.rotors, modes + b.modes, mounts + b.mounts};
  }
};
template <class Given> inline constexpr bool is_mass = false;
template <class Whole, class P, class D, class S>
inline constexpr bool is_mass<MassProperties<Whole, P, D, S>> = true;
constexpr PartCounts counts_of_body(JointKind kind) {
  const JointCounts joint = counts_of(kind);
  return {1, joint.links, joint.positions, joint.speeds};
}

}  // namespace detail

// The parts of a spacecraft. Their types hold the names; their values are plain numbers already.
template <Frame H, InertialFrame I, HubMotion motion_of_hub> struct HubPart {
  using frame = H;
  using inertial = I;
  static constexpr auto role = detail::PartRole::hub;
  static constexpr HubMotion motion = motion_of_hub;
  static constexpr detail::PartCounts counts{};
  PlainSpacecraft numbers;
};
template <Frame B, JointKind kind, Frame P> struct BodyPart {
  using frame = B;
  using carrier = P;
  static constexpr auto role = detail::PartRole::body;
  static constexpr JointKind joint = kind;
  static constexpr detail::PartCounts counts = detail::counts_of_body(kind);
  PlainBody numbers;
};
template <Point W, Frame B> struct RotorPart {
  using frame = W;
  using carrier = B;
  static constexpr auto role = detail::PartRole::rotor;
  static constexpr detail::PartCounts counts{.rotors = 1};
  PlainRotor numbers;
};
template <Point A, Frame B, std::size_t count> struct ModesPart {
  using frame = A;
  using carrier = B;
  static constexpr auto role = detail::PartRole::modes;
  static constexpr detail::PartCounts counts{.modes = count};
  std::array<PlainMode, count> numbers;
};
template <Frame C, Frame B> struct MountPart {
  using frame = C;
  using carrier = B;
  static constexpr auto role = detail::PartRole::mount;
  static constexpr detail::PartCounts counts{.mounts = 1};
  detail::PlainMount numbers;
};

/// The hub of a spacecraft: body(mass, free_in<I>) or body(mass, turning_in<I>). A craft that is only turning
/// is as free, but its position is not a state. The mass properties are from the origin of b in the axes of
/// b; they may be those of a joined body with another name.
template <class Whole, class B, class I, HubMotion motion>
HubPart<B, I, motion> body(const MassProperties<Whole, B, In<B>>& mass, MovesIn<I, motion>) {
  return {detail::plain_hub(frame_name<I>, frame_name<B>, motion, detail::mass_numbers(mass))};
}
/// A body that hangs on another by a joint.
template <class Whole, class B, JointKind kind, class P>
BodyPart<B, kind, P> body(const MassProperties<Whole, B, In<B>>& mass, const BodyJoint<kind, P, B>& joint) {
  const Transform<P, B>& X_p_from_b = joint.X_p_from_b;
  return {detail::plain_body(frame_name<B>, frame_name<P>, kind, X_p_from_b.rotation.matrix(),
                             X_p_from_b.translation.coordinates(), joint.axes_b, detail::mass_numbers(mass))};
}
template <class Mass, class... Given>
  requires(detail::is_mass<Mass>)
auto body(  // body(mass, joint), the hub body(mass, free_in<I>); mass from the origin and in the axes of b
    const Mass&, const Given&...) -> Refused = delete;

/// A balanced rotor inside a body, which contains its mass: it turns about a unit vector of the body with the
/// inertia J_s. It has no place, hence no edge.
template <Point W, class B>
  requires(!std::is_same_v<W, B>)
RotorPart<W, B> rotor(Of<W>, const Vector<B, si::dimensionless>& axis_b,
                      const Quantity<si::moment_of_inertia>& J_s) {
  return {{frame_name<W>(), frame_name<B>(), axis_b.coordinates(), J_s.value()}};
}
template <class W, class Axis, class InertiaGiven>
auto rotor(  // rotor(of<W>, axis_b, J_s): a unit vector of the body b, another frame than w; kg m^2
    Of<W>, const Axis&, const InertiaGiven&) -> Refused = delete;

/// One mode of a flexible appendage on b, of mass 1, so that its coordinate has the unit kg^1/2 m: its
/// participations in rotation about b's origin, kg^1/2 m, and in translation, kg^1/2, in the axes of b.
template <Frame B> struct FlexibleMode {
  Eigen::Vector3d rotation_b, translation_b;
  Quantity<si::angular_velocity> frequency;
  double damping_ratio;
};

/// The modes of an appendage a, which is a name only, on b.
template <Point A, class B, class... Modes>
  requires(sizeof...(Modes) > 0 && !std::is_same_v<A, B> && (std::is_same_v<Modes, FlexibleMode<B>> && ...))
ModesPart<A, B, sizeof...(Modes)> modes(Of<A>, On<B>, const Modes&... mode) {
  std::size_t number = 0;
  const auto plain = [&](const FlexibleMode<B>& given) {
    ++number;
    return PlainMode{frame_name<A>() + (sizeof...(Modes) == 1 ? std::string{} : " " + detail::text(number)),
                     frame_name<B>(),
                     given.rotation_b,
                     given.translation_b,
                     given.frequency.value(),
                     given.damping_ratio};
  };
  return {{plain(mode)...}};
}
template <class A, class B, class... Given>
auto modes(  // modes(of<A>, on<B>, FlexibleMode<B>...): participations in the axes of the body b
    Of<A>, On<B>, const Given&...) -> Refused = delete;

/// A frame c that is fixed on b: a camera, a thruster. It has no mass.
template <class B, class C>
  requires(!std::is_same_v<B, C>)
MountPart<C, B> mount(const Transform<B, C>& X_b_from_c) {
  return {
      {detail::numbers(X_b_from_c.rotation.matrix()), detail::numbers(X_b_from_c.translation.coordinates())}};
}
template <class B> auto mount(const Transform<B, B>&) -> Refused = delete;  // on another frame

}  // namespace vectrix
