#pragma once

#include <Eigen/Core>
#include <concepts>

#include <vectrix/frames/graph/snapshot.hpp>
#include <vectrix/kinematics/points/point_motion.hpp>
#include <vectrix/space/earth/earth_orientation.hpp>
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
