#pragma once

#include <Eigen/Core>
#include <type_traits>

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

VECTRIX_EXPORT PlainMotion geocentric_motion(Body body, const Epoch& epoch);

}  // namespace detail

/// Position and velocity of the Sun, the Moon or a planet relative to the centre of the Earth, geometric, by
/// ERFA's series:
///     Sun       eraEpv00, 0.006 arcsec from JPL's DE430          about 30 microseconds
///     Moon      eraMoon98, 7.6 arcsec and 15 km at most          about 4 microseconds
///     planets   eraPlan94, relative to the Sun, and eraEpv00     about 30 microseconds
/// The planets are approximate. Of their positions relative to the Sun, Simon and others (1994) give as
/// largest errors, in longitude and distance: Mercury 4 arcsec, 300 km; Venus 5, 800; Mars 17, 7700; Jupiter
/// 71, 76,000; Saturn 81, 267,000; Uranus 86, 712,000; Neptune 11, 253,000. Near the Earth a planet is
/// seen with up to four times these angles. Their velocities are wrong by 0.4 m/s (Mercury) to 20 m/s.
/// eraEpv00 and eraPlan94 are meant for TDB and are given TT, which is at most 1.7 ms off: the Sun by 51 m,
/// 7e-5 arcsec, and a planet by 160 m. Ephemeris answers in a thousandth of the Sun's time. Throws BadInput
/// outside the years 1900 to 2099.
template <class B>
std::enable_if_t<SkyBody<B>, PointMotion<earth::Gcrf, B, earth::Gcrf>> geocentric(Of<B>, const Epoch& epoch) {
  const auto plain = detail::geocentric_motion(detail::body_of<B>, epoch);
  return point_motion(of<B>, relative_to<earth::Gcrf>, observed_from<earth::Gcrf>,
                      vector<si::length>(in<earth::Gcrf>, plain.position),
                      vector<si::velocity>(in<earth::Gcrf>, plain.velocity));
}
template <class OfBody, class Given>
auto geocentric(  // of<sky::Sun>, the Moon or a planet from Mercury to Neptune; an Epoch
    OfBody, const Given&) -> Refused = delete;

}  // namespace vectrix
