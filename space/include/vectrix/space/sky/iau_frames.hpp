#pragma once

#include <Eigen/Core>
#include <type_traits>

#include <vectrix/frames/export.hpp>
#include <vectrix/kinematics/attitude/euler_angles.hpp>
#include <vectrix/kinematics/points/moving_transform.hpp>
#include <vectrix/kinematics/rates/euler_rates.hpp>
#include <vectrix/kinematics/rates/moving_dcm.hpp>
#include <vectrix/space/sky/ephemeris.hpp>

namespace vectrix {

// The frames fixed to Sun, Moon and planets by the IAU's elements: z to the pole on the north side of the
// invariable plane, x to the prime meridian. Venus and Uranus turn about -z.

namespace sun {
/// x to the prime meridian of Carrington.
struct Iau : moving_frame {};
}  // namespace sun
namespace mercury {
/// The crater Hun Kal is at 20 degrees west.
struct Iau : moving_frame {};
}  // namespace mercury
namespace venus {
struct Iau : moving_frame {};
}  // namespace venus
namespace moon {
/// z to the mean pole, x to the mean Earth. On the surface about 150 m from the mean-Earth frame of JPL's
/// ephemerides, and about 900 m from their frame of principal axes.
struct Iau : moving_frame {};
}  // namespace moon
namespace mars {
struct Iau : moving_frame {};
}  // namespace mars
namespace jupiter {
/// System III, of the magnetic field.
struct Iau : moving_frame {};
}  // namespace jupiter
namespace saturn {
/// System III, of the radio emissions.
struct Iau : moving_frame {};
}  // namespace saturn
namespace uranus {
struct Iau : moving_frame {};
}  // namespace uranus
namespace neptune {
/// By features of the clouds, since the report of 2015; before, by the magnetic field, 1 % slower.
struct Iau : moving_frame {};
}  // namespace neptune

namespace detail {

/// The centre of the body to which the frame is fixed.
template <class F> struct CentreOf {};
template <> struct CentreOf<sun::Iau> : std::type_identity<sky::Sun> {};
template <> struct CentreOf<mercury::Iau> : std::type_identity<sky::Mercury> {};
template <> struct CentreOf<venus::Iau> : std::type_identity<sky::Venus> {};
template <> struct CentreOf<moon::Iau> : std::type_identity<sky::Moon> {};
template <> struct CentreOf<mars::Iau> : std::type_identity<sky::Mars> {};
template <> struct CentreOf<jupiter::Iau> : std::type_identity<sky::Jupiter> {};
template <> struct CentreOf<saturn::Iau> : std::type_identity<sky::Saturn> {};
template <> struct CentreOf<uranus::Iau> : std::type_identity<sky::Uranus> {};
template <> struct CentreOf<neptune::Iau> : std::type_identity<sky::Neptune> {};

/// The angles of the sequence 3-1-3 from GCRF to the body, rad, and their derivatives, rad/s and rad/s^2.
struct IauAngles {
  Eigen::Vector3d angles, rates, second_rates;
};
VECTRIX_EXPORT IauAngles iau_angles(Body body, const Epoch& epoch);

}  // namespace detail

/// A frame fixed to the Sun, the Moon or a planet by the IAU's elements.
template <class F>
concept IauFrame = requires {
  typename detail::CentreOf<F>::type;
};

/// The rotation of the Sun, the Moon or a planet, its rate and its acceleration, by the elements of the IAU's
/// working group on cartographic coordinates: right ascension and declination of the pole, and the angle W of
/// the prime meridian along the equator, with their trigonometric terms, at a date in TDB:
///     R_body^gcrf = R3(alpha + 90 deg) R1(90 deg - delta) R3(W)
///     R3(t) = [cos t, -sin t, 0; sin t, cos t, 0; 0, 0, 1], R1 alike: the transpose of that of the IERS
/// From the report of 2015 (Archinal and others 2018), the Moon from that of 2009 (Archinal and others 2011).
/// An edge: edge([](const Epoch& t) { return iau_rotation(of<mars::Iau>, t); }). The elements
/// were found from observations of the last centuries. Throws BadInput more than 1000 years from 2000. A call
/// takes 10 microseconds, most of it for TDB.
template <IauFrame F> AcceleratingDcm<earth::Gcrf, F> iau_rotation(Of<F>, const Epoch& epoch) {
  using Angles = EulerAngles<Intrinsic<3, 1, 3>, earth::Gcrf, F>;
  const auto plain = detail::iau_angles(detail::body_of<typename detail::CentreOf<F>::type>, epoch);
  const Angles x{detail::trusted, plain.angles};
  const ParameterRate<Angles> xdot{detail::trusted, plain.rates};
  const SecondParameterRate<Angles> xddot{detail::trusted, plain.second_rates};
  return {dcm(x), angular_velocity_from(x, xdot, in<F>), angular_acceleration_from(x, xdot, xddot, in<F>)};
}
template <class OfFrame, class... Given>
auto iau_rotation(  // of<mars::Iau>, a frame fixed to a body, not its centre; an Epoch
    OfFrame, const Given&...) -> Refused = delete;

/// The same with the place and the velocity of the body, geometric, from its ephemeris: the frame and its
/// origin relative to earth::Gcrf. An edge for spacecraft at the body, and for places on it, with an
/// Ephemeris<sky::Moon>:
///     edge([&](const Epoch& t) { return iau_motion(of<moon::Iau>, ephemeris, t); })
/// Throws BadInput for an epoch outside the span of the ephemeris.
template <IauFrame F>
MovingTransform<earth::Gcrf, F> iau_motion(Of<F>, const Ephemeris<typename detail::CentreOf<F>::type>& body,
                                           const Epoch& epoch) {
  using earth::Gcrf;
  const auto centre = body.motion(epoch);
  return {without_acceleration(iau_rotation(of<F>, epoch)),
          displacement(of<F>, relative_to<Gcrf>, centre.position.vector()),
          velocity(of<F>, relative_to<Gcrf>, observed_from<Gcrf>, centre.velocity.vector())};
}
template <class F, class Given>
auto iau_motion(  // of<moon::Iau>, and the ephemeris of the same body: Ephemeris<sky::Moon>
    Of<F>, const Given&, const Epoch&) -> Refused = delete;

}  // namespace vectrix
