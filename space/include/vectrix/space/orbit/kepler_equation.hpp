#pragma once

#include <vectrix/frames/export.hpp>
#include <vectrix/frames/units.hpp>

namespace vectrix {

/// The three anomalies of a conic of eccentricity e, from periapsis, rad. They are different types, because
/// each is an angle and none is another. Beyond a half turn they count the revolutions.
/// The mean anomaly grows with time, by sqrt(mu/|a|^3).
struct MeanAnomaly {
  Quantity<si::angle> angle;
  explicit constexpr MeanAnomaly(const Quantity<si::angle>& M) : angle(M) {}
  operator Quantity<si::angle>() const = delete;  // no other anomaly: eccentric_anomaly(M, e)
};
/// E of an ellipse; of a hyperbola F, r = a (1 - e cosh F), which is no angle in space.
struct EccentricAnomaly {
  Quantity<si::angle> angle;
  explicit constexpr EccentricAnomaly(const Quantity<si::angle>& E) : angle(E) {}
};
/// The angle at the attracting centre.
struct TrueAnomaly {
  Quantity<si::angle> angle;
  explicit constexpr TrueAnomaly(const Quantity<si::angle>& nu) : angle(nu) {}
};

/// Kepler's equation, solved for the eccentric anomaly to rounding at every e, also next to 1:
///     E - e sin E = M, 0 <= e < 1          e sinh F - F = M, e > 1
/// Throws BadInput if M is not finite, e is negative or not finite, or e = 1, where E and M are zero: a
/// parabola has true_anomaly(time, ...).
VECTRIX_EXPORT EccentricAnomaly eccentric_anomaly(const MeanAnomaly& M, double e);
VECTRIX_EXPORT MeanAnomaly mean_anomaly(const EccentricAnomaly& E, double e);
template <class Given> auto mean_anomaly(const Given&, double) -> Refused = delete;  // of an EccentricAnomaly

/// tan nu/2 = sqrt((1 + e)/(1 - e)) tan E/2, or sqrt((e + 1)/(e - 1)) tanh F/2. Throws BadInput as above, and
/// for a true anomaly outside the asymptotes of a hyperbola, 1 + e cos nu <= 0.
VECTRIX_EXPORT TrueAnomaly true_anomaly(const EccentricAnomaly& E, double e);
VECTRIX_EXPORT EccentricAnomaly eccentric_anomaly(const TrueAnomaly& nu, double e);
template <class Given> auto true_anomaly(const Given&, double) -> Refused = delete;  // of an EccentricAnomaly
template <class Given>
auto eccentric_anomaly(const Given&, double) -> Refused = delete;  // of a MeanAnomaly or a TrueAnomaly

/// The same for every e >= 0, the parabola included, from the time since periapsis and the periapsis
/// distance q:
///     (mu/q^3)^1/2 t = s + e s^3 c_3((1 - e) s^2)
///     tan nu/2 = (1 + e)^1/2 tan(x)/(1 - e)^1/2,  x = (1 - e)^1/2 s/2
/// which is Barker's equation at e = 1. Throws BadInput if mu or q is not positive or a number is not finite.
VECTRIX_EXPORT TrueAnomaly true_anomaly(const Quantity<si::time>& since_periapsis,
                                        const Quantity<si::gravitational_parameter>& mu,
                                        const Quantity<si::length>& periapsis_distance, double e);
VECTRIX_EXPORT Quantity<si::time> time_since_periapsis(const TrueAnomaly& nu,
                                                       const Quantity<si::gravitational_parameter>& mu,
                                                       const Quantity<si::length>& periapsis_distance,
                                                       double e);

}  // namespace vectrix
