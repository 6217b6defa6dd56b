#pragma once

#include <utility>

#include <vectrix/space/sky/ephemeris_table.hpp>
#include <vectrix/space/sky/observer.hpp>

namespace vectrix::detail {

template <class B, class P, class C> using LineOfSight = Displacement<P, Seen<B, C>, In<earth::Gcrf>>;

/// The body B, or its image, relative to the point p: from p's position, from its position and velocity, or
/// from a snapshot of a frame graph. An apparent place needs the velocity.
template <class B, class P, Correction C>
  requires(!std::same_as<C, Apparent>)
LineOfSight<B, P, C> line_of_sight(Of<B>, const EphemerisTable& table, const Epoch& epoch,
                                   const Displacement<earth::Gcrf, P, In<earth::Gcrf>>& r_ep, C correction) {
  return LineOfSight<B, P, C>{trusted, table.line(correction, epoch, r_ep.coordinates())};
}
template <class B, class P, Correction C>
LineOfSight<B, P, C> line_of_sight(Of<B> body, const EphemerisTable& table, const Epoch& epoch,
                                   const PointMotion<earth::Gcrf, P, earth::Gcrf>& motion, C correction) {
  if constexpr (std::same_as<C, Apparent>) {
    return LineOfSight<B, P, C>{
        trusted, table.line(correction, epoch, motion.position.coordinates(), motion.velocity.coordinates())};
  } else {
    return line_of_sight(body, table, epoch, motion.position, correction);
  }
}

template <class B, class P, class... Edges, Correction C, class A>
  requires(std::same_as<SightLack<GraphSnapshot<Epoch, Edges...>, SeenFrom<P>, C, In<A>>, Nothing>)
Displacement<P, Seen<B, C>, In<A>> line_of_sight(Of<B>, const EphemerisTable& table,
                                                 const GraphSnapshot<Epoch, Edges...>& now, SeenFrom<P>,
                                                 C correction, In<A>) {
  const Epoch& epoch = now.instant();
  const auto r = observer_position<P>(now);
  if constexpr (std::same_as<C, Apparent>) {
    const auto v = observer_velocity<P>(now);
    return seen_in(in<A>, now, LineOfSight<B, P, C>{trusted, table.line(correction, epoch, r, v)});
  } else {
    return seen_in(in<A>, now, LineOfSight<B, P, C>{trusted, table.line(correction, epoch, r)});
  }
}

template <class B, class... Given>
using LineOf =
    decltype(line_of_sight(of<B>, std::declval<const EphemerisTable&>(), std::declval<const Given&>()...));
template <class B, class... Given>
concept HasLine = requires {
  typename LineOf<B, Given...>;
};
template <class Line> using DirectionOf = Vector<typename Line::expressed, si::dimensionless>;

}  // namespace vectrix::detail
