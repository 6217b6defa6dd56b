#pragma once

#include "sgp4_elements.hpp"
#include "sgp4_resonance.hpp"

namespace vectrix::detail::sgp4 {

/// What SDP4 adds for periods of 225 minutes and more: the secular and the long-periodic terms of the Sun and
/// the Moon, and the resonances with the turn of the Earth.
class DeepSpace {
 public:
  /// `day` is the epoch in days since 1899 December 31.5 (Julian date 2415020), theta the sidereal angle
  /// then.
  DeepSpace(const Elements& epoch, const ZonalRates& zonal, double day, double theta);

  // T is double, Accelerating or Jerking.
  template <class T> void add_secular(const T& t, ElementsOf<T>& x) const;
  template <class T> void add_periodic(const T& t, ElementsOf<T>& x) const;

 private:
  /// Of one body, without the common factor, in its true longitude f: a (sin^2 f/2 - 1/4) + b sin f cos f/2 +
  /// c sin f for eccentricity, inclination, mean longitude, perigee and node.
  struct Body {
    double anomaly, rate, eccentricity;  // mean anomaly at the epoch, its rate, the eccentricity
    double e2, e3, i2, i3, l2, l3, l4, gh2, gh3, gh4, h2, h3;
  };
  struct Orientation {
    double cos_g, sin_g, cos_i, sin_i, cos_h, sin_h;  // of the body's orbit; h relative to the node
  };
  struct Orbit {
    double n, e, cos_i, sin_i, cos_perigee, sin_perigee;
    bool near_equator;
  };

  void add_body(Body& body, const Orbit& orbit, const Orientation& to, double strength);

  Body sun_{}, moon_{};
  double e_rate_ = 0.0, i_rate_ = 0.0;
  ZonalRates rates_{0.0, 0.0, 0.0};
  Resonance resonance_;
};

}  // namespace vectrix::detail::sgp4
