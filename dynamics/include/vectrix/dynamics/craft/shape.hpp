#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <vectrix/dynamics/craft/each_part.hpp>
#include <vectrix/dynamics/craft/part.hpp>
#include <vectrix/frames/graph/lacks.hpp>

namespace vectrix {

// The mistakes in a list of parts, for messages.
template <class F, class Carrier> struct HangsOnNothing {};
template <class F, class Carrier> struct HangsOnLaterPart {};
template <class F, class Carrier> struct HangsOnWhatIsNoBody {};
template <class F> struct NamedTwice {};
template <class Given> struct NotAPart {};

namespace detail {

template <class P>
concept CraftPart = requires {
  P::role;
  P::counts;
};

/// The counts of the parts before each part, and of all.
template <std::size_t count>
constexpr std::array<PartCounts, count + 1> sums_of(const std::array<PartCounts, count>& counts) {
  std::array<PartCounts, count + 1> sums{};
  for (std::size_t i = 0; i < count; ++i) sums[i + 1] = sums[i] + counts[i];
  return sums;
}
/// The joint of a body; that of any other part is not asked for.
template <CraftPart P> constexpr JointKind joint_of() {
  if constexpr (P::role == PartRole::body)
    return P::joint;
  else
    return JointKind::fixed;
}

/// The tree of a craft as constants: which part a frame is, its link in the engine's tree, and where its
/// numbers are in the state. Part 0 is the hub.
template <class Hub, class... Parts> struct CraftShape {
  using inertial = typename Hub::inertial;
  using hub = typename Hub::frame;
  using parts = std::tuple<Hub, Parts...>;
  static constexpr HubMotion motion = Hub::motion;
  static constexpr bool free = motion == HubMotion::free;

  template <class F>
  static constexpr std::size_t part_of =
      first_of<std::is_same_v<F, hub>, std::is_same_v<F, typename Parts::frame>...>();
  template <class F> static constexpr bool has_part = part_of<F> != nowhere;
  template <class F> using Part = std::tuple_element_t<part_of<F>, parts>;

  static constexpr std::array roles{Hub::role, Parts::role...};
  template <class F, PartRole role> static constexpr bool is = has_part<F>&& roles[part_of<F>] == role;
  template <class F> static constexpr bool has_body = is<F, PartRole::hub> || is<F, PartRole::body>;
  template <class F> static constexpr bool has_place = has_body<F> || is<F, PartRole::mount>;
  /// A frame whose attitude the craft knows.
  template <class F> static constexpr bool has_frame = has_place<F> || std::is_same_v<F, inertial>;
  template <class F> static constexpr bool has_rotor = is<F, PartRole::rotor>;
  template <class F> static constexpr bool has_modes = is<F, PartRole::modes>;
  static constexpr std::array joints{joint_of<Hub>(), joint_of<Parts>()...};
  template <class F, JointKind kind>
  static constexpr bool has_joint_of = is<F, PartRole::body>&& joints[part_of<F>] == kind;
  /// A joint whose numbers are quantities: a hinge, a slider, a gimbal.
  template <class F>
  static constexpr bool has_axes = is<F, PartRole::body>&& counts_of(joints[part_of<F>]).axes > 0;

  static constexpr auto counts_before = sums_of(std::array{Hub::counts, Parts::counts...});
  static constexpr PartCounts total = counts_before.back();
  static constexpr std::size_t hub_size = free ? 13 : 7;
  static constexpr std::size_t speeds_begin = hub_size + total.positions;
  static constexpr std::size_t rotors_begin = speeds_begin + total.speeds;
  static constexpr std::size_t modes_begin = rotors_begin + total.rotors;
  static constexpr std::size_t size = modes_begin + 2 * total.modes;

  template <class F>
  static constexpr std::size_t position_at = hub_size + counts_before[part_of<F>].positions;
  template <class F> static constexpr std::size_t speed_at = speeds_begin + counts_before[part_of<F>].speeds;
  template <class F> static constexpr std::size_t spin_at = rotors_begin + counts_before[part_of<F>].rotors;
  template <class F> static constexpr std::size_t modes_at = modes_begin + counts_before[part_of<F>].modes;
  template <class F> static constexpr std::size_t body_at = counts_before[part_of<F>].bodies;
  template <class F> static constexpr std::size_t mount_at = counts_before[part_of<F>].mounts;
  /// The number in the tree of the body b, or of the body on which b is mounted; 0 for the hub.
  template <class F> static consteval std::size_t link_of() {
    if constexpr (is<F, PartRole::mount>) {
      return link_of<typename Part<F>::carrier>();
    } else {
      return counts_before[part_of<F>].links + Part<F>::counts.links;
    }
  }
};

/// The fault of part number i, and of those after it.
template <class Shape, std::size_t i> constexpr auto fault_from() {
  if constexpr (i == std::tuple_size_v<typename Shape::parts>) {
    return std::type_identity<Nothing>{};
  } else {
    using P = std::tuple_element_t<i, typename Shape::parts>;
    using F = typename P::frame;
    using On = typename P::carrier;
    if constexpr (Shape::template part_of<F> != i || std::is_same_v<F, typename Shape::inertial>) {
      return std::type_identity<NamedTwice<F>>{};
    } else if constexpr (!Shape::template has_part<On>) {
      return std::type_identity<HangsOnNothing<F, On>>{};
    } else if constexpr (!Shape::template has_body<On>) {
      return std::type_identity<HangsOnWhatIsNoBody<F, On>>{};
    } else if constexpr (Shape::template part_of<On> > i) {
      return std::type_identity<HangsOnLaterPart<F, On>>{};
    } else {
      return fault_from<Shape, i + 1>();
    }
  }
}
/// Nothing if each part hangs on a body before it, and each name is used once; Refused if a part was refused.
template <class Hub, class... Parts> constexpr auto craft_fault() {
  if constexpr ((std::is_same_v<Parts, Refused> || ... || std::is_same_v<Hub, Refused>)) {
    return std::type_identity<Refused>{};
  } else if constexpr (!requires { typename Hub::inertial; }) {
    return std::type_identity<NotAPart<Hub>>{};
  } else if constexpr (constexpr std::size_t bad = first_of<!requires { typename Parts::carrier; }...>();
                       bad != nowhere) {
    return std::type_identity<NotAPart<std::tuple_element_t<bad, std::tuple<Parts...>>>>{};
  } else {
    return fault_from<CraftShape<Hub, Parts...>, 1>();
  }
}
template <class Hub, class Tuple> struct FaultOfCraft;
template <class Hub, class... Parts>
struct FaultOfCraft<Hub, std::tuple<Parts...>> : decltype(craft_fault<Hub, Parts...>()) {};
/// Parts may be lists of parts.
template <class Hub, class... Parts>
using CraftFault = typename FaultOfCraft<Hub, typename FlatList<Parts...>::type>::type;

}  // namespace detail
}  // namespace vectrix
