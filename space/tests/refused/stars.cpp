// Stars
#include <vectrix/space.hpp>

using namespace vectrix;
using earth::Eme2000, earth::Gcrf;

struct Tracker : moving_frame {};

using Rate = Quantity<si::angular_velocity>;
using Motion = PointMotion<Gcrf, Tracker, Gcrf>;

namespace proper_motion_without_a_word {
// mistake: does not say whether the rate of right ascension has the cosine of the declination
// expect: proper_motion_with_cos_declination
// expect: ProperMotion
ProperMotion of_a_catalogue(const Rate& right_ascension, const Rate& declination) {
#ifdef REPAIRED
  return proper_motion_with_cos_declination(right_ascension, declination);
#else
  return ProperMotion(right_ascension, declination);
#endif
}
}  // namespace proper_motion_without_a_word

namespace geometric_star {
// mistake: asks a catalogue where the star is, when it says where the star is seen
// expect: light_time or apparent
// expect: Geometric
auto to_the_star(const Stars& stars, const Star& star, const Epoch& t, const Motion& motion) {
#ifdef REPAIRED
  return stars.direction(star, t, motion, light_time);
#else
  return stars.direction(star, t, motion, geometric);
#endif
}
}  // namespace geometric_star

namespace star_of_an_old_catalogue {
// mistake: a place along the axes of EME2000 taken for one along those of the ICRS
// expect: Eme2000
// expect: in<earth::Gcrf>
Star from_the_book(const Quantity<si::angle>& right_ascension, const Quantity<si::angle>& declination,
                   const ProperMotion& motion, const Quantity<si::angle>& parallax,
                   const Quantity<si::velocity>& radial_velocity, const Epoch& epoch) {
#ifdef REPAIRED
  const auto n_gcrf =
      inverse(eme2000_from_gcrf()) * direction_at(in<Eme2000>, {right_ascension, declination});
  return Star(in<Gcrf>, right_ascension_declination(n_gcrf), motion, parallax, radial_velocity, epoch);
#else
  return Star(in<Eme2000>, {right_ascension, declination}, motion, parallax, radial_velocity, epoch);
#endif
}
}  // namespace star_of_an_old_catalogue

namespace star_from_a_place_without_a_velocity {
// mistake: where a camera sees a star by its motion, of a graph that knows of the camera only where it is
// expect: Lacking = (vectrix::)?RateOn<(vectrix::)?Link<(vectrix::)?(earth::)?Gcrf, Tracker
auto to_the_star(const Stars& stars, const Star& star, const Motion& motion, const Epoch& t) {
#ifdef REPAIRED
  const auto graph = frame_graph(edge([=](const Epoch&) { return parallel(motion); }));
#else
  const auto graph = frame_graph(edge([=](const Epoch&) { return transform_of(parallel(motion)); }));
#endif
  const auto now = graph.at(t);
  return stars.direction(star, now, seen_from<Tracker>, apparent, in<Tracker>);
}
}  // namespace star_from_a_place_without_a_velocity

namespace star_with_a_bare_proper_motion {
// mistake: a star with one rate for its proper motion
// expect: ProperMotion
// expect: angular_velocity
Star from_the_book(const Quantity<si::angle>& right_ascension, const Quantity<si::angle>& declination,
                   const Rate& rate, const Quantity<si::angle>& parallax,
                   const Quantity<si::velocity>& radial_velocity, const Epoch& epoch) {
#ifdef REPAIRED
  const auto motion = proper_motion_with_cos_declination(rate, 0.0 * (si::radian / si::second));
#else
  const auto motion = rate;
#endif
  return Star(in<Gcrf>, {right_ascension, declination}, motion, parallax, radial_velocity, epoch);
}
}  // namespace star_with_a_bare_proper_motion
