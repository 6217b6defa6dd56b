#pragma once

#include <Eigen/Core>
#include <concepts>
#include <type_traits>
#include <utility>

#include <vectrix/frames/graph/snapshot.hpp>
#include <vectrix/kinematics/points/point_motion.hpp>
#include <vectrix/space/earth/earth_orientation.hpp>
#include <vectrix/space/sky/bodies.hpp>
#include <vectrix/space/time/epoch.hpp>

namespace vectrix::detail {

/// Position, m, and velocity, m/s, of the point p relative to the centre of the Earth, along the axes of
/// GCRF.
template <class P, class... Edges>
Eigen::Vector3d observer_position(const GraphSnapshot<Epoch, Edges...>& now) {
  using earth::Gcrf;
  if constexpr (std::same_as<P, Gcrf>) {
    return Eigen::Vector3d::Zero();
  } else {
    return now.position(of<P>, relative_to<Gcrf>, in<Gcrf>).coordinates();
  }
}
template <class P, class... Edges>
Eigen::Vector3d observer_velocity(const GraphSnapshot<Epoch, Edges...>& now) {
  using earth::Gcrf;
  if constexpr (std::same_as<P, Gcrf>) {
    return Eigen::Vector3d::Zero();
  } else {
    return now.velocity(of<P>, relative_to<Gcrf>, observed_from<Gcrf>, in<Gcrf>).coordinates();
  }
}

/// What a graph lacks to see from p along the axes of a: p's motion, or the rotation; Nothing if it can.
template <class... Edges, class P, class C, class A>
constexpr auto sight_lacks(const GraphSnapshot<Epoch, Edges...>&, SeenFrom<P>, C, In<A>) {
  using earth::Gcrf;
  using Question = std::conditional_t<std::same_as<C, Apparent>, AskVelocity<P, Gcrf, Gcrf, Gcrf>,
                                      AskPosition<P, Gcrf, Gcrf>>;
  if constexpr (!std::same_as<P, Gcrf> && !std::same_as<LackOf<Question, Topology<Edges...>>, Nothing>) {
    return Question::template lacking<Topology<Edges...>>();
  } else if constexpr (!std::same_as<A, Gcrf>) {
    return AskRotation<A, Gcrf>::template lacking<Topology<Edges...>>();
  } else {
    return std::type_identity<Nothing>{};
  }
}
constexpr auto sight_lacks(...) {  // a question without a graph
  return std::type_identity<Nothing>{};
}
template <class... Given>
using SightLack = typename decltype(sight_lacks(std::declval<const Given&>()...))::type;

/// An x in GCRF along the axes of a.
template <class A, class X, class... Edges>
auto seen_in(In<A>, const GraphSnapshot<Epoch, Edges...>& now, const X& x_gcrf) {
  if constexpr (std::same_as<A, earth::Gcrf>) {
    return x_gcrf;
  } else {
    return now.rotation(to<A>, from<earth::Gcrf>) * x_gcrf;
  }
}

}  // namespace vectrix::detail
