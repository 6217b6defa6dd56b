#include "sgp4_resonance.hpp"

#include <cmath>
#include <numbers>

namespace vectrix::detail::sgp4 {
namespace {

constexpr double step = 720.0;  // min

// A polynomial in e, lowest power first.
double polynomial(double e, double c0, double c1, double c2, double c3) {
  return c0 + e * (c1 + e * (c2 + e * c3));
}

}  // namespace

Resonance::Resonance(const Elements& epoch, const ZonalRates& rates, double perigee_rate, double theta)
    : n_(epoch.n), perigee_(epoch.perigee), perigee_rate_(perigee_rate), theta_(theta) {
  constexpr double one_day_from = 0.0034906585, one_day_to = 0.0052359877;
  constexpr double half_day_from = 8.26e-3, half_day_to = 9.24e-3, half_day_least_e = 0.5;
  if (epoch.n > one_day_from && epoch.n < one_day_to) {
    kind_ = Kind::one_day;
    lambda_ = epoch.M + epoch.node + epoch.perigee - theta;
    offset_ = rates.M + rates.perigee + rates.node - earth_rate - epoch.n;
    set_one_day(epoch);
  } else if (epoch.n >= half_day_from && epoch.n <= half_day_to && epoch.e >= half_day_least_e) {
    kind_ = Kind::half_day;
    lambda_ = epoch.M + 2.0 * epoch.node - 2.0 * theta;
    offset_ = rates.M + 2.0 * (rates.node - earth_rate) - epoch.n;
    set_half_day(epoch);
  }
}

// A = 3 n^2 a^-l q F(i) G(e), of the harmonics (l, m) = (3, 1), (2, 2) and (3, 3).
void Resonance::set_one_day(const Elements& x) {
  constexpr double q31 = 2.1460748e-6, q22 = 1.7891679e-6, q33 = 2.2123015e-7;
  constexpr double phase_31 = 0.13130908, phase_22 = 2.8843198, phase_33 = 0.37448087;
  const double e2 = x.e * x.e, c = std::cos(x.i), s = std::sin(x.i), c1 = 1.0 + c;
  const double per_a = 1.0 / semi_major_axis(x.n), pull = 3.0 * x.n * x.n * per_a * per_a;
  const double G200 = 1.0 + e2 * (-2.5 + 0.8125 * e2), G310 = 1.0 + 2.0 * e2,
               G300 = 1.0 + e2 * (-6.0 + 6.60937 * e2);
  const double F220 = 0.75 * c1 * c1, F311 = 0.9375 * s * s * (1.0 + 3.0 * c) - 0.75 * c1,
               F330 = 1.875 * c1 * c1 * c1;
  add(pull * F311 * G310 * q31 * per_a, 1, 0, phase_31);
  add(2.0 * pull * F220 * G200 * q22, 2, 0, 2.0 * phase_22);
  add(3.0 * pull * F330 * G300 * q33 * per_a, 3, 0, 3.0 * phase_33);
}

// A = 3 n^2 a^-l q F_lmp(i) G_lpq(e), twice for m = 4; G by fits in pieces of the eccentricity.
void Resonance::set_half_day(const Elements& x) {
  constexpr double q22 = 1.7891679e-6, q32 = 3.7393792e-7, q44 = 7.3636953e-9, q52 = 1.1428639e-7,
                   q54 = 2.1765803e-9;
  constexpr double phase_22 = 5.7686396, phase_32 = 0.95240898, phase_44 = 1.8014998, phase_52 = 1.0508330,
                   phase_54 = 4.4108898;
  const double e = x.e;
  const auto G = [e](double c0, double c1, double c2, double c3) { return polynomial(e, c0, c1, c2, c3); };
  const double G201 = -0.306 - 0.440 * (e - 0.64);
  const bool low = e <= 0.65;
  const double G211 = low ? G(3.616, -13.2470, 16.2900, 0.0) : G(-72.099, 331.819, -508.738, 266.724);
  const double G310 =
      low ? G(-19.302, 117.3900, -228.4190, 156.5910) : G(-346.844, 1582.851, -2415.925, 1246.113);
  const double G322 =
      low ? G(-18.9068, 109.7927, -214.6334, 146.5816) : G(-342.585, 1554.908, -2366.899, 1215.972);
  const double G410 =
      low ? G(-41.122, 242.6940, -471.0940, 313.9530) : G(-1052.797, 4758.686, -7193.992, 3651.957);
  const double G422 =
      low ? G(-146.407, 841.8800, -1629.014, 1083.4350) : G(-3581.690, 16178.110, -24462.770, 12422.520);
  const double G520 = low         ? G(-532.114, 3017.977, -5740.032, 3708.2760)
                      : e > 0.715 ? G(-5149.66, 29936.92, -54087.36, 31324.56)
                                  : G(1464.74, -4664.75, 3763.64, 0.0);
  const bool below = e < 0.7;
  const double G533 =
      below ? G(-919.22770, 4988.6100, -9064.7700, 5542.21) : G(-37995.780, 161616.52, -229838.20, 109377.94);
  const double G521 = below ? G(-822.71072, 4568.6173, -8491.4146, 5337.524)
                            : G(-51752.104, 218913.95, -309468.16, 146349.42);
  const double G532 =
      below ? G(-853.66600, 4690.2500, -8624.7700, 5341.4) : G(-40023.880, 170470.89, -242699.48, 115605.82);

  const double c = std::cos(x.i), s = std::sin(x.i), c2 = c * c, s2 = s * s;
  const double F220 = 0.75 * (1.0 + 2.0 * c + c2), F221 = 1.5 * s2;
  const double F321 = 1.875 * s * (1.0 - 2.0 * c - 3.0 * c2), F322 = -1.875 * s * (1.0 + 2.0 * c - 3.0 * c2);
  const double F441 = 35.0 * s2 * F220, F442 = 39.3750 * s2 * s2;
  const double F522 =
      9.84375 * s * (s2 * (1.0 - 2.0 * c - 5.0 * c2) + 0.33333333 * (-2.0 + 4.0 * c + 6.0 * c2));
  const double F523 =
      s * (4.92187512 * s2 * (-2.0 - 4.0 * c + 10.0 * c2) + 6.56250012 * (1.0 + 2.0 * c - 3.0 * c2));
  const double F542 = 29.53125 * s * (2.0 - 8.0 * c + c2 * (-12.0 + 8.0 * c + 10.0 * c2));
  const double F543 = 29.53125 * s * (-2.0 - 8.0 * c + c2 * (12.0 + 8.0 * c - 10.0 * c2));

  const double per_a = 1.0 / semi_major_axis(x.n);
  const double l2 = 3.0 * x.n * x.n * per_a * per_a, l3 = l2 * per_a, l4 = l3 * per_a, l5 = l4 * per_a;
  add(l2 * q22 * F220 * G201, 1, 2, phase_22);
  add(l2 * q22 * F221 * G211, 1, 0, phase_22);
  add(l3 * q32 * F321 * G310, 1, 1, phase_32);
  add(l3 * q32 * F322 * G322, 1, -1, phase_32);
  add(2.0 * l4 * q44 * F441 * G410, 2, 2, phase_44);
  add(2.0 * l4 * q44 * F442 * G422, 2, 0, phase_44);
  add(l5 * q52 * F522 * G520, 1, 1, phase_52);
  add(l5 * q52 * F523 * G532, 1, -1, phase_52);
  add(2.0 * l5 * q54 * F542 * G521, 2, 1, phase_54);
  add(2.0 * l5 * q54 * F543 * G533, 2, -1, phase_54);
}

Resonance::Derivatives Resonance::derivatives(double t, double lambda, double n) const {
  const double perigee = perigee_ + perigee_rate_ * t;
  Derivatives d{n + offset_, 0.0, 0.0};
  for (int k = 0; k < size_; ++k) {
    const Term& term = terms_[k];
    const double angle = term.lambda * lambda + term.perigee * perigee - term.phase;
    d.n += term.amplitude * std::sin(angle);
    d.n_dot += term.lambda * term.amplitude * std::cos(angle);
  }
  d.n_dot *= d.lambda;  // the perigee counts as fixed, as in the report
  return d;
}

template <class T> void Resonance::apply(const T& t, ElementsOf<T>& x) const {
  if (kind_ == Kind::none) return;
  double lambda = lambda_, n = n_, time = 0.0;
  const double end = value_of(t), h = end < 0.0 ? -step : step;
  Derivatives d = derivatives(time, lambda, n);
  while (std::abs(end - time) >= step) {
    lambda += d.lambda * h + d.n * (0.5 * h * h);
    n += d.n * h + d.n_dot * (0.5 * h * h);
    time += h;
    d = derivatives(time, lambda, n);
  }
  const T rest = t - time;
  x.n = n + d.n * rest + 0.5 * d.n_dot * rest * rest;
  const T longitude = lambda + d.lambda * rest + 0.5 * d.n * rest * rest;
  const T turned = theta_ + t * earth_rate;
  const T theta = less_turns(turned, std::fmod(value_of(turned), 2.0 * std::numbers::pi));
  if (kind_ == Kind::half_day) {
    x.M = longitude - 2.0 * x.node + 2.0 * theta;
  } else {
    x.M = longitude - x.node - x.perigee + theta;
  }
}
template void Resonance::apply(const double& t, Elements& x) const;
template void Resonance::apply(const Accelerating& t, ElementsOf<Accelerating>& x) const;
template void Resonance::apply(const Jerking& t, ElementsOf<Jerking>& x) const;

}  // namespace vectrix::detail::sgp4
