#pragma once

#include <concepts>
#include <cstddef>
#include <memory>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vectrix/dynamics/craft/about_frames.hpp>
#include <vectrix/dynamics/craft/shape.hpp>

namespace vectrix {

/// What a spacecraft is: a hub, and parts that hang on it or on a part before them. Frames, topology and
/// kinds of joints are types; masses, places and axes are values, which lose their names once, here: its
/// equations of motion are those of multibody::Tree, and its state has the numbers of the NamedSpacecraft of
/// the same parts, in the same order. Made by spacecraft(). Immutable and cheap to copy; threads may share
/// it.
///
/// A name of its own makes messages and signatures short:
///     struct Sat : decltype(make_sat()) { Sat() : decltype(make_sat())(make_sat()) {} };
template <class Hub, class... Parts> class Spacecraft {
 public:
  using shape = detail::CraftShape<Hub, Parts...>;
  static constexpr std::size_t state_size = shape::size;

  Spacecraft() = delete;  // spacecraft(hub, parts...)
  Spacecraft(detail::Trusted, std::shared_ptr<const detail::CraftCore> core) : core_(std::move(core)) {}

  const std::shared_ptr<const detail::CraftCore>& core() const& { return core_; }

 private:
  std::shared_ptr<const detail::CraftCore> core_;
};

template <class C>
concept CraftType = requires {
  typename C::shape;
  C::state_size;
};
/// A mistake, for messages: the craft is left out.
template <class Given> struct IsNoCraft {};

namespace detail {

template <class B, JointKind kind, class P> void lower(LoweredParts& to, const BodyPart<B, kind, P>& part) {
  to.add(part.numbers);
}
template <class W, class B> void lower(LoweredParts& to, const RotorPart<W, B>& part) {
  to.add(part.numbers);
}
template <class A, class B, std::size_t count>
void lower(LoweredParts& to, const ModesPart<A, B, count>& part) {
  for (const PlainMode& mode : part.numbers) to.add(mode);
}
template <class C, class B> void lower(LoweredParts& to, const MountPart<C, B>& part) {
  to.add(part.numbers);
}

template <class Tuple> struct CraftWith;
template <class... HubAndParts>
struct CraftWith<std::tuple<HubAndParts...>> : std::type_identity<Spacecraft<HubAndParts...>> {};
template <class... HubAndParts>
using MadeCraft = typename CraftWith<typename FlatList<HubAndParts...>::type>::type;
template <class Hub, class... Parts>
using CraftOf = typename MadeUnless<CraftFault<Hub, Parts...>, MadeCraft>::template type<Hub, Parts...>;

}  // namespace detail

/// The spacecraft of a hub and of parts, each after the body on which it hangs; each() gives several. Throws
/// BadInput with the name of the part, as NamedSpacecraft does: for a mass or an inertia that no body has, or
/// that is below 1e-90 or above 1e90 kg, kg m^2, an axis that is not a unit vector, a number that is not
/// finite, a rotor with more inertia than its body, modes in which more mass takes part than their body has,
/// a joint about which its body, without what hangs on it, has no inertia, a hub alone about one of whose
/// axes there is none.
template <class Hub, class... Parts>
detail::CraftOf<Hub, Parts...> spacecraft(const Hub& hub, const Parts&... parts) {
  if constexpr (std::is_same_v<detail::CraftFault<Hub, Parts...>, Refused>) {
    return Refused{};
  } else {
    detail::LoweredParts lowered(hub.numbers);
    (detail::for_each_part(parts, [&](const auto& part) { detail::lower(lowered, part); }), ...);
    return {detail::trusted, lowered.core()};
  }
}
template <class Hub, class... Parts, class Fault = detail::CraftFault<Hub, Parts...>>
  requires(!std::is_same_v<Fault, Nothing> && !std::is_same_v<Fault, Refused>)
auto spacecraft(  // the hub, then parts that hang on a body before them, each name once: see Fault
    const Hub&, const Parts&...) -> Refused = delete;

/// The craft in names and plain numbers; the names are those of the frames.
template <CraftType C> PlainSpacecraft plain(const C& craft) {
  return craft.core()->plain;
}

}  // namespace vectrix
