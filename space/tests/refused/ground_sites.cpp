// Ground sites
#include <vectrix/space.hpp>

using namespace vectrix;
using earth::Gcrf, earth::Itrf;

struct Station : east_north_up_frame {};
struct Runway : north_east_down_frame {};
struct Satellite : moving_frame {};

namespace north_east_down_axes_for_east_north_up {
// mistake: the east-north-up axes of a place for a frame that is said to be north-east-down
// expect: From<Runway>
// expect: struct S : east_north_up_frame
auto axes(const Geodetic& place) {
#ifdef REPAIRED
  return north_east_down(from<Runway>, place);
#else
  return east_north_up(from<Runway>, place);
#endif
}
}  // namespace north_east_down_axes_for_east_north_up

namespace site_of_a_plain_frame {
// mistake: a place for a frame that does not say which axes it has
// expect: From<.*Antenna>
// expect: struct S : east_north_up_frame
#ifdef REPAIRED
struct Antenna : east_north_up_frame {};
#else
struct Antenna : moving_frame {};
#endif
auto axes(const Geodetic& place) {
  return east_north_up(from<Antenna>, place);
}
}  // namespace site_of_a_plain_frame

namespace site_given_as_a_position {
// mistake: a position in ITRF for the latitude, longitude and height of a place
// expect: Vector<(vectrix::)?(earth::)?Itrf
// expect: from<S>, Geodetic
auto axes(const Vector<Itrf, si::length>& r_itrf) {
#ifdef REPAIRED
  return east_north_up(from<Station>, wgs84::geodetic(r_itrf));
#else
  return east_north_up(from<Station>, r_itrf);
#endif
}
}  // namespace site_given_as_a_position

namespace look_angles_in_the_earth_frame {
// mistake: azimuth and elevation of a displacement along the axes of ITRF
// expect: Displacement<Station, Satellite, (vectrix::)?In<(vectrix::)?(earth::)?Itrf
// expect: s the origin of an east_north_up_frame
auto seen(const Displacement<Station, Satellite, In<Itrf>>& r_itrf, const Transform<Itrf, Station>& site) {
#ifdef REPAIRED
  return look_angles(inverse(site.rotation) * r_itrf);
#else
  static_cast<void>(site);
  return look_angles(r_itrf);
#endif
}
}  // namespace look_angles_in_the_earth_frame

namespace look_angles_in_north_east_down {
// mistake: azimuth and elevation of a displacement along north, east and down
// expect: In<Runway>
// expect: s the origin of an east_north_up_frame
auto seen(const Displacement<Runway, Satellite, In<Runway>>& r_ned, const Transform<Itrf, Runway>& runway,
          const Transform<Itrf, Station>& station) {
#ifdef REPAIRED
  return look_angles(inverse(station) * (runway * r_ned));
#else
  static_cast<void>(runway), static_cast<void>(station);
  return look_angles(r_ned);
#endif
}
}  // namespace look_angles_in_north_east_down

namespace look_angles_from_the_centre_of_the_earth {
// mistake: azimuth and elevation of the position relative to the centre of the Earth
// expect: Displacement<(vectrix::)?(earth::)?Itrf, Satellite, (vectrix::)?In<Station>
// expect: s the origin of an east_north_up_frame
auto seen(const Displacement<Itrf, Satellite, In<Station>>& r_enu, const Transform<Itrf, Station>& site) {
#ifdef REPAIRED
  return look_angles(r_enu - inverse(site.rotation) * site.translation);
#else
  static_cast<void>(site);
  return look_angles(r_enu);
#endif
}
}  // namespace look_angles_from_the_centre_of_the_earth

namespace look_rates_of_an_inertial_velocity {
// mistake: rates of azimuth and elevation from the velocity that is observed from GCRF
// expect: ObservedFrom<(vectrix::)?(earth::)?Gcrf
// expect: with rates of r_sq_s, v_sq_s_s
auto seen(const Displacement<Station, Satellite, In<Station>>& r,
          const Velocity<Station, Satellite, ObservedFrom<Gcrf>, In<Station>>& v,
          const AngularVelocity<Gcrf, Station, In<Station>>& w) {
#ifdef REPAIRED
  return look_angles(r, transport(observed_from<Station>, v, r, -w));
#else
  static_cast<void>(w);
  return look_angles(r, v);
#endif
}
}  // namespace look_rates_of_an_inertial_velocity

namespace right_ascension_in_the_earth_frame {
// mistake: right ascension along the axes of ITRF, which turn with the Earth
// expect: Vector<(vectrix::)?(earth::)?Itrf
// expect: inertial, or of date
auto star(const Vector<Itrf, si::dimensionless>& n_itrf, const Dcm<Gcrf, Itrf>& R_gcrf_from_itrf) {
#ifdef REPAIRED
  return right_ascension_declination(R_gcrf_from_itrf * n_itrf);
#else
  static_cast<void>(R_gcrf_from_itrf);
  return right_ascension_declination(n_itrf);
#endif
}
}  // namespace right_ascension_in_the_earth_frame

namespace star_in_the_earth_frame {
// mistake: a direction along the axes of ITRF from a right ascension
// expect: In<(vectrix::)?(earth::)?Itrf
// expect: inertial, or of date
auto star(const RightAscensionDeclination& place, const Dcm<Itrf, Gcrf>& R_itrf_from_gcrf) {
#ifdef REPAIRED
  return R_itrf_from_gcrf * direction_at(in<Gcrf>, place);
#else
  static_cast<void>(R_itrf_from_gcrf);
  return direction_at(in<Itrf>, place);
#endif
}
}  // namespace star_in_the_earth_frame

namespace star_by_two_angles {
// mistake: a direction by two angles, which do not say which is the right ascension
// expect: Quantity<(vectrix::)?si::angle
// expect: RightAscensionDeclination
auto star(const Quantity<si::angle>& right_ascension, const Quantity<si::angle>& declination) {
#ifdef REPAIRED
  return direction_at(in<Gcrf>, {right_ascension, declination});
#else
  return direction_at(in<Gcrf>, right_ascension, declination);
#endif
}
}  // namespace star_by_two_angles

namespace geocentric_latitude_for_geodetic {
// mistake: the geocentric latitude of a place for its geodetic one, which is up to 21 km away
// expect: GeocentricLatitude
// expect: GeodeticLatitude
auto place(const earth::Spherical& spherical) {
#ifdef REPAIRED
  return wgs84::geodetic(earth::position(spherical));
#else
  return Geodetic{spherical.latitude, spherical.longitude, 0.0 * si::metre};
#endif
}
}  // namespace geocentric_latitude_for_geodetic

namespace latitude_that_does_not_say_which {
// mistake: an angle for a latitude: geodetic, or geocentric?
// expect: GeodeticLatitude
auto place(const Quantity<si::angle>& latitude, const Quantity<si::angle>& longitude) {
#ifdef REPAIRED
  return wgs84::position({GeodeticLatitude(latitude), longitude, 0.0 * si::metre});
#else
  return wgs84::position(Geodetic{latitude, longitude, 0.0 * si::metre});
#endif
}
}  // namespace latitude_that_does_not_say_which

namespace place_from_a_station_for_one_from_the_centre {
// mistake: the position relative to a station for that relative to the centre of the Earth
// expect: Displacement<Station, Satellite, (vectrix::)?In<(vectrix::)?(earth::)?Itrf
// expect: Displacement<earth::Itrf, Q, In<earth::Itrf>>
auto place(const Displacement<Itrf, Station, In<Itrf>>& r_station,
           const Displacement<Station, Satellite, In<Itrf>>& r_from_station) {
#ifdef REPAIRED
  return wgs84::geodetic(r_station + r_from_station);
#else
  static_cast<void>(r_station);
  return wgs84::geodetic(r_from_station);
#endif
}
}  // namespace place_from_a_station_for_one_from_the_centre

namespace latitude_and_longitude_exchanged {
// mistake: the longitude first, and the latitude after it
// expect: the angle of a latitude: latitude.angle
Geodetic place(const Quantity<si::angle>& latitude, const Quantity<si::angle>& longitude,
               const Quantity<si::length>& height) {
#ifdef REPAIRED
  return Geodetic{GeodeticLatitude(latitude), longitude, height};
#else
  return Geodetic{longitude, GeodeticLatitude(latitude), height};
#endif
}
}  // namespace latitude_and_longitude_exchanged

namespace latitude_in_degrees {
// mistake: a latitude in degrees, which are not the unit of an angle
// expect: degree_unit
// expect: GeodeticLatitude\(angle\)
GeodeticLatitude latitude() {
#ifdef REPAIRED
  return GeodeticLatitude(convert<si::angle>(40.0 * si::degree));
#else
  return GeodeticLatitude(40.0 * si::degree);
#endif
}
}  // namespace latitude_in_degrees
