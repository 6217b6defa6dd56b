#pragma once

#include <Eigen/Core>
#include <concepts>

#include <vectrix/frames/displacement.hpp>
#include <vectrix/space/earth/earth_orientation.hpp>

namespace vectrix {
namespace detail {

/// The frames whose origin is the centre of the Earth, and which name it.
template <class P>
inline constexpr bool is_earth = std::same_as<P, earth::Itrf> || std::same_as<P, earth::Gcrf>;

}  // namespace detail

namespace earth {

/// A position relative to the centre of the Earth, along the axes of Itrf, as functions of a place take it:
///     Displacement<Itrf, Q, In<Itrf>>     r_eq of q relative to e, Itrf or Gcrf, as a frame graph answers
///     Vector<Itrf, si::length>            r_itrf claims to be one
class PositionInItrf {
 public:
  PositionInItrf(const Vector<Itrf, si::length>& r_itrf) : coordinates_(r_itrf.coordinates()) {}
  template <class E, class Q>
    requires(detail::is_earth<E>)
  PositionInItrf(const Displacement<E, Q, In<Itrf>>& r_eq) : coordinates_(r_eq.coordinates()) {}
  template <class Given>
  PositionInItrf(  // Vector<earth::Itrf, si::length>, or Displacement<earth::Itrf, Q, In<earth::Itrf>>
      const Given&) = delete;

  /// m, without types.
  [[nodiscard]] const Eigen::Vector3d& coordinates() const { return coordinates_; }

 private:
  Eigen::Vector3d coordinates_;
};

}  // namespace earth
}  // namespace vectrix
