#pragma once

#include "sgp4_elements.hpp"

namespace vectrix::detail::sgp4 {

/// The turn of the Earth in a minute.
inline constexpr double earth_rate = 4.37526908801129966e-3;

/// The pull of the tesseral harmonics on orbits of one day, and on eccentric ones of half a day. It drives
/// the stroboscopic longitude
///     lambda = M + node + perigee - theta,  of half a day  M + 2 node - 2 theta
///     d lambda/dt = n + offset,  dn/dt = sum A_k sin(p_k lambda + q_k perigee - phase_k)
/// in steps of 12 hours of second order, always from the epoch, so that the answer depends on the time alone.
class Resonance {
 public:
  /// No resonance.
  Resonance() = default;
  /// `rates` are those of the zonal harmonics and of the Sun and the Moon together; theta is the sidereal
  /// angle at the epoch. `perigee_rate` is of the zonal harmonics alone.
  Resonance(const Elements& epoch, const ZonalRates& rates, double perigee_rate, double theta);

  /// Replaces n and M at t. T is double, Accelerating or Jerking.
  template <class T> void apply(const T& t, ElementsOf<T>& x) const;

 private:
  enum class Kind { none, one_day, half_day };
  struct Term {
    double amplitude;
    int lambda, perigee;
    double phase;
  };
  struct Derivatives {
    double lambda, n, n_dot;
  };

  void set_one_day(const Elements& epoch);
  void set_half_day(const Elements& epoch);
  void add(double amplitude, int lambda, int perigee, double phase) {
    terms_[size_++] = {amplitude, lambda, perigee, phase};
  }
  [[nodiscard]] Derivatives derivatives(double t, double lambda, double n) const;

  Kind kind_ = Kind::none;
  Term terms_[10] = {};
  int size_ = 0;
  double n_ = 0.0, lambda_ = 0.0, offset_ = 0.0, perigee_ = 0.0, perigee_rate_ = 0.0, theta_ = 0.0;
};

}  // namespace vectrix::detail::sgp4
