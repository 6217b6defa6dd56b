#pragma once

#include <utility>

#include <vectrix/frames/graph/snapshot.hpp>
#include <vectrix/space/sky/ephemeris_table.hpp>

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

template <class B, class P, class Snapshot, class C>
LineOfSight<B, P, C> line_in_gcrf(Of<B> body, const EphemerisTable& table, const Snapshot& now,
                                  C correction) {
  using earth::Gcrf;
  const Epoch& epoch = now.instant();
  if constexpr (std::same_as<P, Gcrf> && std::same_as<C, Apparent>) {
    const Eigen::Vector3d zero = Eigen::Vector3d::Zero();
    return LineOfSight<B, P, C>{trusted, table.line(correction, epoch, zero, zero)};
  } else if constexpr (std::same_as<P, Gcrf>) {
    return LineOfSight<B, P, C>{trusted, table.line(correction, epoch, Eigen::Vector3d::Zero())};
  } else if constexpr (std::same_as<C, Apparent>) {
    const PointMotion<Gcrf, P, Gcrf> motion{
        now.position(of<P>, relative_to<Gcrf>, in<Gcrf>),
        now.velocity(of<P>, relative_to<Gcrf>, observed_from<Gcrf>, in<Gcrf>)};
    return line_of_sight(body, table, epoch, motion, correction);
  } else {
    return line_of_sight(body, table, epoch, now.position(of<P>, relative_to<Gcrf>, in<Gcrf>), correction);
  }
}
template <class B, class P, class... Edges, Correction C, class A>
Displacement<P, Seen<B, C>, In<A>> line_of_sight(Of<B> body, const EphemerisTable& table,
                                                 const GraphSnapshot<Epoch, Edges...>& now, SeenFrom<P>,
                                                 C correction, In<A>) {
  const auto line = line_in_gcrf<B, P>(body, table, now, correction);
  if constexpr (std::same_as<A, earth::Gcrf>) {
    return line;
  } else {
    return now.rotation(to<A>, from<earth::Gcrf>) * line;
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
