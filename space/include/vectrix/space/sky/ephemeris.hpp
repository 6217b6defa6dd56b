#pragma once

#include <vectrix/space/sky/line_of_sight.hpp>

namespace vectrix {

/// The Sun, the Moon or a planet over a span of time, from Chebyshev series through those of geocentric(),
/// whose accuracy it has: Ephemeris<sky::Sun>(span). A call takes a thousandth of eraEpv00's time, and a year
/// 20 kB, for the Moon 45 kB. The position is within 10 m of geocentric()'s, of a planet 1 m, of the Moon
/// 1 cm; the velocity is the derivative of the position, for a planet up to 40 m/s from eraPlan94's. It never
/// changes, so threads may share it. Throws BadInput for a span outside the years 1900 to 2099, and for an
/// epoch outside the span.
///
/// How the body is seen from a point is a question with a correction, geometric, light_time or apparent:
///     sun.line_of_sight(now, seen_from<Satellite>, apparent, in<Camera>)       r_pb, m, from p to the body
///     sun.direction(now, seen_from<Satellite>, apparent, in<Camera>)           the unit vector
/// where `now` is a snapshot at an epoch of a frame graph that knows the satellite relative to earth::Gcrf.
/// Without a graph, in earth::Gcrf, from a PointMotion or, unless apparent, a Displacement of the satellite:
///     sun.line_of_sight(epoch, motion, apparent)
/// Throws BadInput if the light takes more than 1000 s, from a planet 20,000 s. The deflection of light by
/// gravity is left out: below 1e-4 arcsec for the Sun and the Moon, 1.8 arcsec for a planet at the Sun's
/// limb.
template <SkyBody B> class Ephemeris {
  using Gcrf = earth::Gcrf;

 public:
  explicit Ephemeris(const TimeSpan& span) : table_(detail::body_of<B>, span) {}

  [[nodiscard]] const TimeSpan& span() const { return table_.span(); }

  /// Position and velocity relative to the centre of the Earth, geometric.
  [[nodiscard]] PointMotion<Gcrf, B, Gcrf> motion(const Epoch& epoch) const {
    const auto plain = table_.motion(epoch);
    return {Displacement<Gcrf, B, In<Gcrf>>{detail::trusted, plain.position},
            Velocity<Gcrf, B, ObservedFrom<Gcrf>, In<Gcrf>>{detail::trusted, plain.velocity}};
  }

  /// The body, or its image, relative to the point p.
  template <class... Given>
  [[nodiscard]] detail::LineOf<B, Given...> line_of_sight(const Given&... given) const {
    return detail::line_of_sight(of<B>, table_, given...);
  }
  template <class... Given, class Lacking = detail::SightLack<Given...>>
    requires(!detail::HasLine<B, Given...>)
  auto
  line_of_sight(  // with a correction: (now, seen_from<P>, apparent, in<A>), (t, motion, ...); see Lacking
      const Given&...) const -> Refused = delete;

  /// The unit vector along the line of sight.
  template <class... Given>
  [[nodiscard]] detail::DirectionOf<detail::LineOf<B, Given...>> direction(const Given&... given) const {
    return vectrix::direction(line_of_sight(given...).vector());
  }
  template <class... Given, class Lacking = detail::SightLack<Given...>>
    requires(!detail::HasLine<B, Given...>)
  auto direction(  // with a correction: (now, seen_from<P>, apparent, in<A>), (t, motion, ...); see Lacking
      const Given&...) const -> Refused = delete;

 private:
  detail::EphemerisTable table_;
};

}  // namespace vectrix
