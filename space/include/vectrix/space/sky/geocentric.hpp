#pragma once

#include <Eigen/Core>

#include <vectrix/frames/export.hpp>
#include <vectrix/kinematics/points/point_motion.hpp>
#include <vectrix/space/earth/earth_orientation.hpp>
#include <vectrix/space/sky/bodies.hpp>
#include <vectrix/space/time/epoch.hpp>

namespace vectrix {
namespace detail {

/// Position, m, and velocity, m/s, along the axes of GCRF.
struct PlainMotion {
  Eigen::Vector3d position, velocity;
};

VECTRIX_EXPORT PlainMotion geocentric_motion(Of<sky::Sun>, const Epoch& epoch);
VECTRIX_EXPORT PlainMotion geocentric_motion(Of<sky::Moon>, const Epoch& epoch);

}  // namespace detail

/// Position and velocity of the Sun or the Moon relative to the centre of the Earth, geometric, by ERFA's
/// series:
///     Sun     eraEpv00, 0.006 arcsec from JPL's DE430          about 30 microseconds
///     Moon    eraMoon98, 7.6 arcsec and 15 km at most          about 4 microseconds
/// Ephemeris answers in a thousandth of the Sun's time. Throws BadInput outside the years 1900 to 2099.
template <SkyBody B> PointMotion<earth::Gcrf, B, earth::Gcrf> geocentric(Of<B>, const Epoch& epoch) {
  const auto plain = detail::geocentric_motion(of<B>, epoch);
  return point_motion(of<B>, relative_to<earth::Gcrf>, observed_from<earth::Gcrf>,
                      vector<si::length>(in<earth::Gcrf>, plain.position),
                      vector<si::velocity>(in<earth::Gcrf>, plain.velocity));
}

}  // namespace vectrix
