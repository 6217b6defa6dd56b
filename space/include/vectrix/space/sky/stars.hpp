#pragma once

#include <utility>

#include <vectrix/space/sky/ephemeris_table.hpp>
#include <vectrix/space/sky/observer.hpp>
#include <vectrix/space/sky/star.hpp>

namespace vectrix {
namespace detail {

/// The motions of Earth and Sun that the directions to stars need. The observer's r, m, and v, m/s, are
/// relative to the centre of the Earth, along the axes of GCRF. Throws BadInput outside the span.
class VECTRIX_EXPORT StarSight {
 public:
  explicit StarSight(const TimeSpan& span) : sun_("Stars", Body::sun, span) {}

  [[nodiscard]] const TimeSpan& span() const { return sun_.span(); }
  [[nodiscard]] Eigen::Vector3d direction(LightTime, const Star& star, const Epoch& epoch,
                                          const Eigen::Vector3d& r) const;
  [[nodiscard]] Eigen::Vector3d direction(Apparent, const Star& star, const Epoch& epoch,
                                          const Eigen::Vector3d& r, const Eigen::Vector3d& v) const;

 private:
  EphemerisTable sun_;
};

using StarDirection = Vector<earth::Gcrf, si::dimensionless>;

template <class P>
StarDirection star_direction(const StarSight& sight, const Star& star, const Epoch& epoch,
                             const Displacement<earth::Gcrf, P, In<earth::Gcrf>>& r_ep, LightTime) {
  return {trusted, sight.direction(light_time, star, epoch, r_ep.coordinates())};
}
template <class P>
StarDirection star_direction(const StarSight& sight, const Star& star, const Epoch& epoch,
                             const PointMotion<earth::Gcrf, P, earth::Gcrf>& motion, LightTime) {
  return {trusted, sight.direction(light_time, star, epoch, motion.position.coordinates())};
}
template <class P>
StarDirection star_direction(const StarSight& sight, const Star& star, const Epoch& epoch,
                             const PointMotion<earth::Gcrf, P, earth::Gcrf>& motion, Apparent) {
  return {trusted, sight.direction(apparent, star, epoch, motion.position.coordinates(),
                                   motion.velocity.coordinates())};
}
template <class... Edges, class P, class A>
  requires(std::same_as<SightLack<GraphSnapshot<Epoch, Edges...>, SeenFrom<P>, LightTime, In<A>>, Nothing>)
Vector<A, si::dimensionless> star_direction(const StarSight& sight, const Star& star,
                                            const GraphSnapshot<Epoch, Edges...>& now, SeenFrom<P>, LightTime,
                                            In<A>) {
  const auto r = observer_position<P>(now);
  return seen_in(in<A>, now, StarDirection{trusted, sight.direction(light_time, star, now.instant(), r)});
}
template <class... Edges, class P, class A>
  requires(std::same_as<SightLack<GraphSnapshot<Epoch, Edges...>, SeenFrom<P>, Apparent, In<A>>, Nothing>)
Vector<A, si::dimensionless> star_direction(const StarSight& sight, const Star& star,
                                            const GraphSnapshot<Epoch, Edges...>& now, SeenFrom<P>, Apparent,
                                            In<A>) {
  const auto r = observer_position<P>(now), v = observer_velocity<P>(now);
  return seen_in(in<A>, now, StarDirection{trusted, sight.direction(apparent, star, now.instant(), r, v)});
}

template <class... Given>
using StarDirectionOf =
    decltype(star_direction(std::declval<const StarSight&>(), std::declval<const Given&>()...));
template <class... Given>
concept HasStarDirection = requires {
  typename StarDirectionOf<Given...>;
};

}  // namespace detail

/// How stars are seen over a span of time:
///     stars.direction(star, now, seen_from<Tracker>, apparent, in<Tracker>)
///     stars.direction(star, epoch, motion, apparent)                              in earth::Gcrf
/// with the words, and the observers, of Ephemeris. light_time is the catalogue's place with proper motion
/// and parallax; apparent has also the aberration, up to 20.5 arcsec by the motion of the Earth and 5 more in
/// a low orbit, and the deflection of light by the Sun, 0.5 arcsec a degree from its centre. There is no
/// geometric: a catalogue says where a star is seen, not where it is. The Earth is that of eraEpv00 at TT,
/// within 10 m; at TDB it would be up to 51 m elsewhere. It never changes, so threads may share it. Throws
/// BadInput for a span outside the years 1900 to 2099, and for an epoch outside the span.
class Stars {
 public:
  explicit Stars(const TimeSpan& span) : sight_(span) {}

  [[nodiscard]] const TimeSpan& span() const { return sight_.span(); }

  /// The unit vector to the star.
  template <class... Given>
  [[nodiscard]] detail::StarDirectionOf<Given...> direction(const Given&... given) const {
    return detail::star_direction(sight_, given...);
  }
  template <class Given, class... More, class Lacking = detail::SightLack<More...>>
    requires(!detail::HasStarDirection<Given, More...>)
  auto direction(  // light_time or apparent: (star, now, seen_from<P>, apparent, in<A>); else see Lacking
      const Given&, const More&...) const -> Refused = delete;

 private:
  detail::StarSight sight_;
};

}  // namespace vectrix
