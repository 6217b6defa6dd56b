// Orbits
#include <vectrix/space.hpp>

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Itrf : moving_frame {};
struct Ship : moving_frame {};
struct Lvlh : moving_frame {};

namespace orbit_frame_of_velocity_observed_from_the_earth {
// mistake: an orbit frame of the velocity relative to the rotating Earth: not the plane of the orbit
// expect: FromFrame = (vectrix::)?From<Lvlh>
// expect: ObservedFrom<Itrf>
// expect: observed from one inertial a
auto axes(const Displacement<Gcrf, Ship, In<Itrf>>& r_itrf,
          const Velocity<Gcrf, Ship, ObservedFrom<Itrf>, In<Itrf>>& v_itrf,
          const MovingDcm<Gcrf, Itrf>& earth) {
#ifdef REPAIRED
  const auto w_itrf = earth.angular_velocity;
  const auto v_gcrf = earth.rotation * transport(observed_from<Gcrf>, v_itrf, r_itrf, w_itrf);
  return lvlh(from<Lvlh>, earth.rotation * r_itrf, v_gcrf);
#else
  static_cast<void>(earth);
  return lvlh(from<Lvlh>, r_itrf, v_itrf);
#endif
}
}  // namespace orbit_frame_of_velocity_observed_from_the_earth

namespace orbit_frame_of_vectors_in_two_frames {
// mistake: position and velocity of an orbit frame expressed in different frames
// expect: In<Itrf>
// expect: In<Gcrf>
auto axes(const Displacement<Gcrf, Ship, In<Itrf>>& r_itrf,
          const Velocity<Gcrf, Ship, ObservedFrom<Gcrf>, In<Gcrf>>& v_gcrf,
          const Dcm<Gcrf, Itrf>& R_gcrf_from_itrf) {
#ifdef REPAIRED
  return ric(from<Lvlh>, R_gcrf_from_itrf * r_itrf, v_gcrf);
#else
  static_cast<void>(R_gcrf_from_itrf);
  return ric(from<Lvlh>, r_itrf, v_gcrf);
#endif
}
}  // namespace orbit_frame_of_vectors_in_two_frames

namespace orbit_frame_said_to_be_inertial {
// mistake: an orbit frame declared inertial: it turns once in each orbit
// expect: FromFrame = (vectrix::)?From<.*Axes>
// expect: Gcrf
#ifdef REPAIRED
struct Axes : moving_frame {};
#else
struct Axes : inertial_frame {};
#endif
auto axes(const PointMotion<Gcrf, Ship, Gcrf>& motion) {
  return vnb(from<Axes>, motion);
}
}  // namespace orbit_frame_said_to_be_inertial

namespace perifocal_frame_without_attraction {
// mistake: the perifocal frame of a motion, without the attraction that makes a conic of it
// expect: FromFrame = (vectrix::)?From<Lvlh>
// expect: PointMotion<Gcrf, Ship
auto axes(const PointMotion<Gcrf, Ship, Gcrf>& motion, const Quantity<si::gravitational_parameter>& mu) {
#ifdef REPAIRED
  return perifocal(from<Lvlh>, mu, motion);
#else
  static_cast<void>(mu);
  return perifocal(from<Lvlh>, motion);
#endif
}
}  // namespace perifocal_frame_without_attraction

namespace perifocal_frame_of_velocity_observed_from_the_earth {
// mistake: the perifocal frame of the velocity relative to the rotating Earth
// expect: PointMotion<Gcrf, Ship, Itrf
// expect: of one inertial a
auto axes(const Quantity<si::gravitational_parameter>& mu,
          const PointMotion<Gcrf, Ship, Itrf>& seen_from_earth, const PointMotion<Gcrf, Ship, Gcrf>& motion) {
#ifdef REPAIRED
  static_cast<void>(seen_from_earth);
  return perifocal(from<Lvlh>, mu, motion);
#else
  static_cast<void>(motion);
  return perifocal(from<Lvlh>, mu, seen_from_earth);
#endif
}
}  // namespace perifocal_frame_of_velocity_observed_from_the_earth

namespace orbit_frame_of_a_jerk_observed_from_elsewhere {
// mistake: the derivative of the acceleration taken by an observer on the rotating Earth
// expect: Derivative<Itrf, Gcrf
// expect: observed from one inertial a
auto motion(const PointMotion<Gcrf, Ship, Gcrf>& orbit,
            const Acceleration<Gcrf, Ship, ObservedFrom<Gcrf>, In<Gcrf>>& a,
            const Derivative<Itrf, Gcrf, si::acceleration>& jerk, const MovingDcm<Gcrf, Itrf>& earth) {
#ifdef REPAIRED
  const auto w_gcrf = earth.rotation * earth.angular_velocity;
  return ntw(from<Lvlh>, orbit, a, transport(observed_from<Gcrf>, jerk, a.vector(), w_gcrf));
#else
  static_cast<void>(earth);
  return ntw(from<Lvlh>, orbit, a, jerk);
#endif
}
}  // namespace orbit_frame_of_a_jerk_observed_from_elsewhere

namespace acceleration_across_an_orbit_frame_without_jerk {
// mistake: the angular acceleration of an orbit frame made without the jerk
// expect: AccelerationOn<(vectrix::)?Link<Gcrf, Lvlh>
auto change(const PointMotion<Gcrf, Ship, Gcrf>& orbit,
            const Acceleration<Gcrf, Ship, ObservedFrom<Gcrf>, In<Gcrf>>& a,
            const Derivative<Gcrf, Gcrf, si::acceleration>& jerk) {
#ifdef REPAIRED
  const auto graph = frame_graph(edge([=](Quantity<si::time>) { return lvlh(from<Lvlh>, orbit, a, jerk); }));
#else
  static_cast<void>(jerk);
  const auto graph = frame_graph(edge([=](Quantity<si::time>) { return lvlh(from<Lvlh>, orbit, a); }));
#endif
  return graph.at(0.0 * si::second).angular_acceleration(of<Lvlh>, relative_to<Gcrf>, in<Lvlh>);
}
}  // namespace acceleration_across_an_orbit_frame_without_jerk

namespace two_body_motion_observed_from_the_earth {
// mistake: two-body motion from the velocity relative to the rotating Earth
// expect: PointMotion<Itrf, Ship, Itrf>
// expect: observed from an inertial frame
auto later(const Quantity<si::gravitational_parameter>& mu, const PointMotion<Itrf, Ship, Itrf>& motion_itrf,
           const PointMotion<Itrf, Ship, Gcrf>& motion_gcrf, Quantity<si::time> dt) {
#ifdef REPAIRED
  static_cast<void>(motion_itrf);
  return two_body(mu, motion_gcrf, dt);
#else
  static_cast<void>(motion_gcrf);
  return two_body(mu, motion_itrf, dt);
#endif
}
}  // namespace two_body_motion_observed_from_the_earth

namespace two_body_motion_by_an_energy {
// mistake: a quantity that is no gravitational parameter
// expect: si::energy
// expect: si::gravitational_parameter
auto later(const PointMotion<Gcrf, Ship, Gcrf>& motion, Quantity<si::time> dt) {
#ifdef REPAIRED
  const auto mu = 3.986004415e14 * si::metre * si::metre * si::metre / (si::second * si::second);
#else
  const auto mu = 3.986004415e14 * si::joule;
#endif
  return two_body(mu, motion, dt);
}
}  // namespace two_body_motion_by_an_energy

namespace orbit_acceleration_of_a_position_in_the_earth_frame {
// mistake: the attraction as an acceleration observed from a rotating frame
// expect: Displacement<Itrf, Ship, (vectrix::)?In<Itrf>
// expect: in an inertial frame
auto fall(const Quantity<si::gravitational_parameter>& mu, const Displacement<Itrf, Ship, In<Itrf>>& r_itrf,
          const Dcm<Gcrf, Itrf>& R_gcrf_from_itrf) {
#ifdef REPAIRED
  return two_body_acceleration(mu, R_gcrf_from_itrf * r_itrf);
#else
  static_cast<void>(R_gcrf_from_itrf);
  return two_body_acceleration(mu, r_itrf);
#endif
}
}  // namespace orbit_acceleration_of_a_position_in_the_earth_frame

namespace mean_anomaly_for_a_true_one {
// mistake: a mean anomaly given for an eccentric one
// expect: MeanAnomaly
// expect: EccentricAnomaly
auto direction_of(const MeanAnomaly& M, double e) {
#ifdef REPAIRED
  return true_anomaly(eccentric_anomaly(M, e), e);
#else
  return true_anomaly(M, e);
#endif
}
}  // namespace mean_anomaly_for_a_true_one

namespace elements_of_velocity_observed_from_the_earth {
// mistake: orbital elements of the velocity relative to the rotating Earth
// expect: PointMotion<Itrf, Ship, Itrf>
// expect: a inertial
auto shape(const Quantity<si::gravitational_parameter>& mu, const PointMotion<Itrf, Ship, Itrf>& motion_itrf,
           const PointMotion<Itrf, Ship, Gcrf>& motion_gcrf) {
#ifdef REPAIRED
  static_cast<void>(motion_itrf);
  return keplerian_elements(mu, motion_gcrf);
#else
  static_cast<void>(motion_gcrf);
  return keplerian_elements(mu, motion_itrf);
#endif
}
}  // namespace elements_of_velocity_observed_from_the_earth

namespace elements_with_a_mean_anomaly {
// mistake: a mean anomaly among Keplerian elements, which hold the true one
// expect: MeanAnomaly
// expect: node, w, nu
auto orbit(Quantity<si::length> p, double e, Quantity<si::angle> i, Quantity<si::angle> node,
           Quantity<si::angle> w, const MeanAnomaly& M) {
#ifdef REPAIRED
  const auto anomaly = true_anomaly(eccentric_anomaly(M, e), e);
#else
  const auto anomaly = M;
#endif
  return keplerian_elements(of<Ship>, relative_to<Gcrf>, in<Gcrf>, p, e, i, node, w, anomaly);
}
}  // namespace elements_with_a_mean_anomaly

namespace equinoctial_elements_of_the_other_sense {
// mistake: prograde elements given for retrograde ones
// expect: ModifiedEquinoctial<.*Prograde>
// expect: ModifiedEquinoctial<.*Retrograde>
ModifiedEquinoctial<Gcrf, Ship, Gcrf, Retrograde> elements(const Quantity<si::gravitational_parameter>& mu,
                                                           const PointMotion<Gcrf, Ship, Gcrf>& motion) {
#ifdef REPAIRED
  return modified_equinoctial(retrograde, mu, motion);
#else
  return modified_equinoctial(prograde, mu, motion);
#endif
}
}  // namespace equinoctial_elements_of_the_other_sense

namespace equinoctial_elements_in_a_moving_frame {
// mistake: equinoctial elements in the axes of the rotating Earth
// expect: In<Itrf>
// expect: a inertial
auto elements(Quantity<si::length> p, Quantity<si::angle> L) {
#ifdef REPAIRED
  return modified_equinoctial(prograde, of<Ship>, relative_to<Gcrf>, in<Gcrf>, p, 0.0, 0.0, 0.0, 0.0, L);
#else
  return modified_equinoctial(prograde, of<Ship>, relative_to<Gcrf>, in<Itrf>, p, 0.0, 0.0, 0.0, 0.0, L);
#endif
}
}  // namespace equinoctial_elements_in_a_moving_frame

namespace osculating_elements_of_mean_ones {
// mistake: osculating elements made of the mean elements of SGP4, without its theory
// expect: MeanElements
// expect: a inertial
auto shape(const Quantity<si::gravitational_parameter>& mu, const MeanElements& elements) {
#ifdef REPAIRED
  return keplerian_elements(mu, Sgp4<Ship>(elements, at_most(72.0 * si::hour)).at(elements.epoch));
#else
  return keplerian_elements(mu, elements);
#endif
}
}  // namespace osculating_elements_of_mean_ones

namespace motion_of_mean_elements {
// mistake: the motion of mean elements as if they were osculating: several km off in a low orbit
// expect: osculating elements; mean ones have a motion by their theory alone
// expect: MeanElements
auto motion(const Quantity<si::gravitational_parameter>& mu, const TwoLineElements& set) {
#ifdef REPAIRED
  static_cast<void>(mu);
  return Sgp4<Ship>(set, at_most(72.0 * si::hour)).at(set.epoch());
#else
  return point_motion(mu, set.mean_elements());
#endif
}
}  // namespace motion_of_mean_elements

namespace sgp4_taken_for_gcrf {
// mistake: the position of SGP4 taken for one in Gcrf: 44 km off in a low orbit in 2026
// expect: Gcrf
// expect: Teme
auto on_the_earth(const Sgp4<Ship>& orbit, const Epoch& epoch,
                  const Dcm<earth::Itrf, earth::Gcrf>& R_itrf_from_gcrf,
                  const Dcm<earth::Itrf, earth::Teme>& R_itrf_from_teme) {
#ifdef REPAIRED
  static_cast<void>(R_itrf_from_gcrf);
  return R_itrf_from_teme * orbit.at(epoch).position;
#else
  static_cast<void>(R_itrf_from_teme);
  return R_itrf_from_gcrf * orbit.at(epoch).position;
#endif
}
}  // namespace sgp4_taken_for_gcrf

namespace sgp4_without_a_longest_age {
// mistake: SGP4 without the longest age of its elements
// expect: TwoLineElements
// expect: the longest age
auto orbit(const TwoLineElements& set) {
#ifdef REPAIRED
  return Sgp4<Ship>(set, at_most(72.0 * si::hour));
#else
  return Sgp4<Ship>(set);
#endif
}
}  // namespace sgp4_without_a_longest_age

namespace longest_age_in_another_dimension {
// mistake: a longest age that is no time
// expect: si::length
// expect: a time, the longest age
auto longest_age() {
#ifdef REPAIRED
  return at_most(72.0 * si::hour);
#else
  return at_most(72.0 * si::metre);
#endif
}
}  // namespace longest_age_in_another_dimension

namespace attraction_by_an_image {
// mistake: the attraction by the Sun where it is seen, not where it is
// expect: Image<(vectrix::)?(sky::)?Sun, (vectrix::)?Apparent>
// expect: geometric
auto pull(const Ephemeris<sky::Sun>& sun, const Epoch& t,
          const PointMotion<earth::Gcrf, Ship, earth::Gcrf>& motion) {
#ifdef REPAIRED
  return third_body_acceleration(motion.position, sun.motion(t).position);
#else
  const auto r_sun = motion.position + sun.line_of_sight(t, motion, apparent);
  return third_body_acceleration(motion.position, r_sun);
#endif
}
}  // namespace attraction_by_an_image

namespace attraction_from_two_origins {
// mistake: the Moon relative to the ship for the Moon relative to the Earth
// expect: Displacement<Ship, (vectrix::)?(sky::)?Moon
// expect: relative to one p
auto pull(const Displacement<earth::Gcrf, Ship, In<earth::Gcrf>>& r_ship,
          const Displacement<Ship, sky::Moon, In<earth::Gcrf>>& r_ship_moon) {
#ifdef REPAIRED
  return third_body_acceleration(r_ship, r_ship + r_ship_moon);
#else
  return third_body_acceleration(r_ship, r_ship_moon);
#endif
}
}  // namespace attraction_from_two_origins

namespace attraction_by_the_mu_of_another_body {
// mistake: the attraction of the Moon by the parameter of the Sun
// expect: GravitationalParameter<(vectrix::)?(sky::)?Sun
// expect: Displacement<(earth::)?Gcrf, (vectrix::)?(sky::)?Moon
// expect: mu of b
auto attraction(const Displacement<Gcrf, Ship, In<Gcrf>>& r_ship,
                const Displacement<Gcrf, sky::Moon, In<Gcrf>>& r_moon) {
#ifdef REPAIRED
  const auto mu = gravitational_parameter(of<sky::Moon>, sky::moon_mu);
#else
  const auto mu = gravitational_parameter(of<sky::Sun>, sky::sun_mu);
#endif
  return third_body_acceleration(mu, r_ship, r_moon);
}
}  // namespace attraction_by_the_mu_of_another_body

namespace attraction_by_the_mu_of_no_body {
// mistake: the attraction of the Moon by a parameter that does not say whose it is
// expect: Quantity<(vectrix::)?si::gravitational_parameter
// expect: mu of b
auto attraction(const Displacement<Gcrf, Ship, In<Gcrf>>& r_ship,
                const Displacement<Gcrf, sky::Moon, In<Gcrf>>& r_moon) {
#ifdef REPAIRED
  return third_body_acceleration(r_ship, r_moon);
#else
  return third_body_acceleration(sky::sun_mu, r_ship, r_moon);
#endif
}
}  // namespace attraction_by_the_mu_of_no_body

namespace attraction_by_a_body_without_its_mu {
// mistake: the attraction by a planet, whose parameter has to be given
// expect: Displacement<(earth::)?Gcrf, (vectrix::)?(sky::)?Jupiter
// expect: mu of b
auto attraction(const Displacement<Gcrf, Ship, In<Gcrf>>& r_ship,
                const Displacement<Gcrf, sky::Jupiter, In<Gcrf>>& r_jupiter,
                const Quantity<si::gravitational_parameter>& mu) {
#ifdef REPAIRED
  return third_body_acceleration(gravitational_parameter(of<sky::Jupiter>, mu), r_ship, r_jupiter);
#else
  return third_body_acceleration(r_ship, r_jupiter);
#endif
}
}  // namespace attraction_by_a_body_without_its_mu

namespace parameter_of_a_body_without_a_unit {
// mistake: the parameter of a body by a number without a unit
// expect: Mu = double
// expect: mu in m\^3/s\^2
auto parameter(const double jupiter_mu) {
#ifdef REPAIRED
  const auto mu = Quantity<si::gravitational_parameter>::from_value(jupiter_mu);
#else
  const double mu = jupiter_mu;
#endif
  return gravitational_parameter(of<sky::Jupiter>, mu);
}
}  // namespace parameter_of_a_body_without_a_unit

namespace two_body_acceleration_of_a_bare_number {
// mistake: the acceleration of an orbit by a number without a unit
// expect: Mu = double
// expect: mu in m\^3/s\^2
auto acceleration(const Displacement<Gcrf, Ship, In<Gcrf>>& r, const GravityField& field) {
#ifdef REPAIRED
  const auto mu = field.mu();
#else
  const double mu = field.mu().value();
#endif
  return two_body_acceleration(mu, r);
}
}  // namespace two_body_acceleration_of_a_bare_number

namespace jerk_of_a_bare_number {
// mistake: the jerk of an orbit by a number without a unit
// expect: Mu = double
// expect: mu in m\^3/s\^2
auto jerk(const PointMotion<Gcrf, Ship, Gcrf>& motion, const GravityField& field) {
#ifdef REPAIRED
  const auto mu = field.mu();
#else
  const double mu = field.mu().value();
#endif
  return two_body_jerk(mu, motion);
}
}  // namespace jerk_of_a_bare_number

namespace velocity_seen_from_the_earth_taken_for_inertial {
// mistake: turns the velocity that is seen from the Earth into the axes of GCRF, and takes it for the inertial one
// expect: ObservedFrom<Itrf
// expect: ObservedFrom<Gcrf|A = Gcrf
auto motion(const PointMotion<Gcrf, Ship, Itrf>& m, const MovingDcm<Gcrf, Itrf>& earth) {
  const auto& R_gcrf_from_itrf = earth.rotation;
#ifdef REPAIRED
  const auto v_itrf = transport(observed_from<Gcrf>, m.velocity, m.position, earth.angular_velocity);
#else
  const auto v_itrf = m.velocity;
#endif
  return PointMotion<Gcrf, Ship, Gcrf>{R_gcrf_from_itrf * m.position, R_gcrf_from_itrf * v_itrf};
}
}  // namespace velocity_seen_from_the_earth_taken_for_inertial

namespace mean_anomaly_of_two_lines_for_a_true_one {
// mistake: the mean anomaly of two-line elements taken for a true one
// expect: MeanAnomaly
// expect: no other anomaly
auto anomaly(const Quantity<si::gravitational_parameter>& mu, const MeanElements& elements) {
#ifdef REPAIRED
  const Sgp4<Ship> orbit(elements, at_most(72.0 * si::hour));
  return keplerian_elements(mu, orbit.at(elements.epoch)).true_anomaly();
#else
  static_cast<void>(mu);
  return TrueAnomaly{elements.mean_anomaly};
#endif
}
}  // namespace mean_anomaly_of_two_lines_for_a_true_one
