#include <vectrix/space/orbit/sgp4.hpp>

#include <erfa.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <numbers>
#include <optional>
#include <sstream>

#include "../earth/turn.hpp"
#include "mean_motion.hpp"
#include "sgp4_deep_space.hpp"
#include "sgp4_elements.hpp"

namespace vectrix::detail {
namespace {

using sgp4::Elements, sgp4::less_turns, sgp4::value_of, sgp4::J2, sgp4::J3, sgp4::J4, sgp4::ke,
    sgp4::earth_radius;

constexpr double two_pi = 2.0 * std::numbers::pi;
constexpr double least_eccentricity = 1e-6;      // a smaller one is raised to it
constexpr double negative_eccentricity = -1e-3;  // what drag may make of a circle
constexpr double largest_orbit = 1.5e6;          // km; the radius of the Hill sphere of the Earth
constexpr double rounding_of_the_clock = 1e-9;   // s

}  // namespace

namespace sgp4 {

/// The functions of the inclination in the periodic terms of J2 and J3.
template <class T> struct Inclination {
  T sin_i, cos_i, three_cos2_less_1, sin2, seven_cos2_less_1, aycof, xlcof;

  explicit Inclination(const T& i) {
    const auto [sine, cosine] = sine_cosine(i);
    sin_i = sine;
    cos_i = cosine;
    const T cos2 = cos_i * cos_i;
    three_cos2_less_1 = 3.0 * cos2 - 1.0;
    sin2 = 1.0 - cos2;
    seven_cos2_less_1 = 7.0 * cos2 - 1.0;
    constexpr double least = 1.5e-12;
    T one_and_cos = 1.0 + cos_i;
    if (std::abs(value_of(one_and_cos)) <= least) one_and_cos = T(least);
    aycof = -0.5 * J3 / J2 * sin_i;
    xlcof = -0.25 * J3 / J2 * sin_i * (3.0 + 5.0 * cos_i) / one_and_cos;
  }
  /// The same at all times.
  template <class Fixed>
  explicit Inclination(const Inclination<Fixed>& i)
      : sin_i(i.sin_i),
        cos_i(i.cos_i),
        three_cos2_less_1(i.three_cos2_less_1),
        sin2(i.sin2),
        seven_cos2_less_1(i.seven_cos2_less_1),
        aycof(i.aycof),
        xlcof(i.xlcof) {}
};

/// What drag changes, in powers of the time: of the semi-major axis, the eccentricity and the mean longitude;
/// unless `simple`, also with the mean anomaly.
struct Drag {
  double C1 = 0.0, C4 = 0.0, C5 = 0.0, bstar = 0.0;
  double node = 0.0, perigee = 0.0, M = 0.0;
  double D2 = 0.0, D3 = 0.0, D4 = 0.0, t2 = 0.0, t3 = 0.0, t4 = 0.0, t5 = 0.0;
  double eta = 0.0, eta_cube = 0.0, sin_M = 0.0;
  bool simple = true;

  Drag(const Elements& x, double bstar_, double node_rate_of_J2, bool deep) : bstar(bstar_) {
    const double a = semi_major_axis(x.n), e = x.e, perigee_radius = a * (1.0 - e);
    const double one_less_e2 = 1.0 - e * e, sin_i = std::sin(x.i), cos2_i = 1.0 - sin_i * sin_i;
    // The density falls as ((q0 - s)/(r - s))^4, with s lowered for low perigees.
    const double perigee_height = (perigee_radius - 1.0) * earth_radius;
    double s_height = 78.0;
    if (perigee_height < 156.0) s_height = perigee_height < 98.0 ? 20.0 : perigee_height - 78.0;
    const double s = 1.0 + s_height / earth_radius;
    const double q0_less_s = (120.0 - s_height) / earth_radius;

    const double tsi = 1.0 / (a - s);
    eta = a * e * tsi;
    const double eta2 = eta * eta, e_eta = e * eta, psi2 = std::abs(1.0 - eta2);
    const double density = std::pow(q0_less_s * tsi, 4), coefficient = density / std::pow(psi2, 3.5);
    const double three_cos2_less_1 = 3.0 * cos2_i - 1.0, J3_per_J2 = J3 / J2;
    const double C2 = coefficient * x.n *
                      (a * (1.0 + 1.5 * eta2 + e_eta * (4.0 + eta2)) +
                       0.375 * J2 * tsi / psi2 * three_cos2_less_1 * (8.0 + 3.0 * eta2 * (8.0 + eta2)));
    C1 = bstar * C2;
    constexpr double circle = 1e-4;  // below this eccentricity two terms are left out
    const double C3 = e > circle ? -2.0 * density * tsi * J3_per_J2 * x.n * sin_i / e : 0.0;
    C4 = 2.0 * x.n * coefficient * a * one_less_e2 *
         (eta * (2.0 + 0.5 * eta2) + e * (0.5 + 2.0 * eta2) -
          J2 * tsi / (a * psi2) *
              (-3.0 * three_cos2_less_1 * (1.0 - 2.0 * e_eta + eta2 * (1.5 - 0.5 * e_eta)) +
               0.75 * sin_i * sin_i * (2.0 * eta2 - e_eta * (1.0 + eta2)) * std::cos(2.0 * x.perigee)));
    t2 = 1.5 * C1;
    node = 3.5 * one_less_e2 * node_rate_of_J2 * C1;
    simple = deep || perigee_radius < 1.0 + 220.0 / earth_radius;
    if (simple) return;

    C5 = 2.0 * coefficient * a * one_less_e2 * (1.0 + 2.75 * (eta2 + e_eta) + e_eta * eta2);
    perigee = bstar * C3 * std::cos(x.perigee);
    M = e > circle ? -2.0 / 3.0 * density * bstar / e_eta : 0.0;
    eta_cube = cube(std::cos(x.M));
    sin_M = std::sin(x.M);
    D2 = 4.0 * a * tsi * C1 * C1;
    const double third = D2 * tsi * C1 / 3.0;
    D3 = (17.0 * a + s) * third;
    D4 = 0.5 * third * a * tsi * (221.0 * a + 31.0 * s) * C1;
    t3 = D2 + 2.0 * C1 * C1;
    t4 = 0.25 * (3.0 * D3 + C1 * (12.0 * D2 + 10.0 * C1 * C1));
    t5 = 0.2 * (3.0 * D4 + 12.0 * C1 * D3 + 6.0 * D2 * D2 + 15.0 * C1 * C1 * (2.0 * D2 + C1 * C1));
  }

  template <class T> [[nodiscard]] T cube(const T& cos_M) const {
    const T x = 1.0 + eta * cos_M;
    return x * x * x;
  }
};

}  // namespace sgp4

/// The theory of one set of elements, in minutes since its epoch.
struct Sgp4Theory {
  Elements epoch;
  sgp4::Inclination<double> inclination;
  sgp4::ZonalRates rates;
  sgp4::Drag drag;
  std::optional<sgp4::DeepSpace> deep;
};

namespace {

/// The motion of Brouwer: the mean motion without the secular term of J2 that Kozai's contains.
double brouwer_mean_motion(double kozai, double e, double i) {
  const double a1 = sgp4::semi_major_axis(kozai), one_less_e2 = 1.0 - e * e, c = std::cos(i);
  const double d = 0.75 * J2 * (3.0 * c * c - 1.0) / (std::sqrt(one_less_e2) * one_less_e2);
  const double first = d / (a1 * a1);
  const double a0 = a1 * (1.0 - first * (1.0 / 3.0 + first * (1.0 + first * 134.0 / 81.0)));
  return kozai / (1.0 + d / (a0 * a0));
}

sgp4::ZonalRates zonal_rates(const Elements& x, double p) {
  const double c2 = std::cos(x.i) * std::cos(x.i), c4 = c2 * c2, root = std::sqrt(1.0 - x.e * x.e);
  const double first = 1.5 * J2 / (p * p) * x.n, second = 0.5 * first * J2 / (p * p),
               fourth = -0.46875 * J4 / (p * p * p * p) * x.n;
  sgp4::ZonalRates rates;
  rates.M =
      x.n + 0.5 * first * root * (3.0 * c2 - 1.0) + 0.0625 * second * root * (13.0 - 78.0 * c2 + 137.0 * c4);
  rates.perigee = -0.5 * first * (1.0 - 5.0 * c2) + 0.0625 * second * (7.0 - 114.0 * c2 + 395.0 * c4) +
                  fourth * (3.0 - 36.0 * c2 + 49.0 * c4);
  rates.node = (-first + 0.5 * second * (4.0 - 19.0 * c2) + 2.0 * fourth * (3.0 - 7.0 * c2)) * std::cos(x.i);
  return rates;
}

/// The mean elements at t, of which a is what drag leaves, and the functions of their inclination.
template <class T> struct Mean {
  sgp4::ElementsOf<T> x;
  T a;
  sgp4::Inclination<T> inclination;
};
// m, m/s. With derivatives v stays empty: that of r is exact.
template <class T> struct Motion { std::array<T, 3> r, v; };

// The theory leaves out the square of J2 (R/p)^2, which is 1e-3 for an orbit that touches the surface: here
// 1e-4 of the motion.
constexpr double largest_flattening = 0.01;

// For messages: a millionth is more than the clock's rounding.
double rounded(double time) {
  return std::round(time * 1e6) / 1e6;
}

[[noreturn]] void fail(const std::string& name, double t, const std::string& reason) {
  throw BadInput(name + text(rounded(t)) + " min from the epoch of the elements: " + reason);
}

// Drag, the zonal harmonics, the Sun and the Moon.
template <class T> Mean<T> mean_at(const Sgp4Theory& theory, const std::string& name, const T& t) {
  using std::cos, std::sin, std::sqrt;
  const sgp4::Drag& drag = theory.drag;
  const Elements& start = theory.epoch;
  const double minutes = value_of(t);
  sgp4::ElementsOf<T> x{T(start.n), T(start.e), T(start.i), T(start.node), T(start.perigee), T(start.M)};
  x.M += theory.rates.M * t;
  x.perigee += theory.rates.perigee * t;
  x.node += theory.rates.node * t + drag.node * t * t;
  T root_a = 1.0 - drag.C1 * t, e_change = drag.bstar * drag.C4 * t, longitude = drag.t2 * t * t;
  if (!drag.simple) {
    const T shift = drag.perigee * t + drag.M * (drag.cube(T(cos(x.M))) - drag.eta_cube);
    x.M += shift;
    x.perigee -= shift;
    const T t2 = t * t, t3 = t2 * t, t4 = t3 * t;
    root_a -= drag.D2 * t2 + drag.D3 * t3 + drag.D4 * t4;
    e_change += drag.bstar * drag.C5 * (sin(x.M) - drag.sin_M);
    longitude += drag.t3 * t3 + t4 * (drag.t4 + t * drag.t5);
  }
  if (theory.deep) theory.deep->add_secular(t, x);
  if (!(x.n > 0.0)) fail(name, minutes, "the mean motion is " + text(value_of(x.n)) + " rad/min");
  if (!(root_a > 0.0))
    fail(name, minutes, "the terms of drag leave no orbit: decayed, or too far from the epoch");

  const T a = sgp4::semi_major_axis(x.n) * root_a * root_a;
  x.n = ke / (a * sqrt(a));
  x.e -= e_change;
  if (!(x.e >= negative_eccentricity && x.e < 1.0))
    fail(name, minutes, "the mean eccentricity is " + text(value_of(x.e)));
  if (x.e < least_eccentricity) x.e = T(least_eccentricity);
  x.M += start.n * longitude;
  if (!theory.deep) return {x, a, sgp4::Inclination<T>(theory.inclination)};

  theory.deep->add_periodic(t, x);
  if (!(x.e >= 0.0 && x.e < 1.0))
    fail(name, minutes, "the eccentricity with the terms of the Sun and the Moon is " + text(value_of(x.e)));
  return {x, a, sgp4::Inclination<T>(x.i)};
}

// The eccentric longitude u from the node, of the mean one, u - e sin(u - perigee), with e cos(perigee) and
// e sin(perigee).
double eccentric_longitude(double mean, double e_cos, double e_sin) {
  double u = mean;
  constexpr double largest_step = 0.95, tolerance = 1e-12;
  constexpr int most = 30;
  for (int k = 0; k < most; ++k) {
    const double c = std::cos(u), s = std::sin(u);
    const double step = std::clamp((mean - e_sin * c + e_cos * s - u) / (1.0 - e_cos * c - e_sin * s),
                                   -largest_step, largest_step);
    u += step;
    if (std::abs(step) < tolerance) break;
  }
  return u;
}
// Its sine and cosine.
SineCosine<double> solved_longitude(double mean, double e_cos, double e_sin) {
  return sine_cosine(eccentric_longitude(mean, e_cos, e_sin));
}
template <std::size_t order>
SineCosine<Taylor<order>> solved_longitude(const Taylor<order>& mean, const Taylor<order>& e_cos,
                                           const Taylor<order>& e_sin) {
  return sine_cosine_of_kepler(mean, e_sin, e_cos, eccentric_longitude(mean.c[0], e_cos.c[0], e_sin.c[0]));
}

// The periodic terms of J3 and J2, and the motion.
template <class T> Motion<T> motion_of(const Mean<T>& mean, const std::string& name, double t) {
  using std::atan2, std::sqrt;
  const sgp4::ElementsOf<T>& x = mean.x;
  const sgp4::Inclination<T>& i = mean.inclination;
  const auto [sin_perigee, cos_perigee] = sine_cosine(x.perigee);
  const T e_cos = x.e * cos_perigee, per_p = 1.0 / (mean.a * (1.0 - x.e * x.e));
  const T e_sin = x.e * sin_perigee + per_p * i.aycof;
  const T longitude = x.M + x.perigee + per_p * i.xlcof * e_cos;
  const T reduced = less_turns(longitude, std::fmod(value_of(longitude), two_pi));
  const T e2 = e_cos * e_cos + e_sin * e_sin;
  if (!(e2 < 1.0)) fail(name, t, "the eccentricity with the terms of J3 is " + text(std::sqrt(value_of(e2))));

  const auto [sin_u, cos_u] = solved_longitude(reduced, e_cos, e_sin);
  const T e_cos_E = e_cos * cos_u + e_sin * sin_u, e_sin_E = e_cos * sin_u - e_sin * cos_u;
  const T p = mean.a * (1.0 - e2), r = mean.a * (1.0 - e_cos_E), root = sqrt(1.0 - e2);
  const T part = e_sin_E / (1.0 + root), a_per_r = mean.a / r;
  const T sine = a_per_r * (sin_u - e_sin - e_cos * part), cosine = a_per_r * (cos_u - e_cos + e_sin * part);
  const T sin_2 = 2.0 * cosine * sine, cos_2 = 1.0 - 2.0 * sine * sine;

  const T k1 = 0.5 * J2 / p, k2 = k1 / p;
  const T distance = r * (1.0 - 1.5 * k2 * root * i.three_cos2_less_1) + 0.5 * k1 * i.sin2 * cos_2;
  const T latitude = atan2(sine, cosine) - 0.25 * k2 * i.seven_cos2_less_1 * sin_2;
  const T node = x.node + 1.5 * k2 * i.cos_i * sin_2;
  const T inclination = x.i + 1.5 * k2 * i.cos_i * i.sin_i * cos_2;
  if (!(distance >= 1.0))
    fail(name, t,
         "|r| is " + text(value_of(distance) * earth_radius) + " km, less than one Earth radius: decayed");

  const auto [sin_node, cos_node] = sine_cosine(node);
  const auto [sin_i, cos_i] = sine_cosine(inclination);
  const auto [sin_l, cos_l] = sine_cosine(latitude);
  const std::array<T, 2> n{cos_node, sin_node};
  const std::array<T, 3> m{-sin_node * cos_i, cos_node * cos_i, sin_i};
  const std::array<T, 3> outward{cos_l * n[0] + sin_l * m[0], cos_l * n[1] + sin_l * m[1], sin_l * m[2]};
  constexpr double metres = 1000.0 * earth_radius;
  Motion<T> motion;
  for (std::size_t k = 0; k < 3; ++k) motion.r[k] = metres * (distance * outward[k]);
  if constexpr (std::same_as<T, double>) {
    const double radial = std::sqrt(mean.a) * e_sin_E / r - x.n * k1 * i.sin2 * sin_2 / ke;
    const double transverse = std::sqrt(p) / r + x.n * k1 * (i.sin2 * cos_2 + 1.5 * i.three_cos2_less_1) / ke;
    const std::array<double, 3> forward{cos_l * m[0] - sin_l * n[0], cos_l * m[1] - sin_l * n[1],
                                        cos_l * m[2]};
    for (std::size_t k = 0; k < 3; ++k)
      motion.v[k] = metres * ke / 60.0 * (radial * outward[k] + transverse * forward[k]);
  }
  return motion;
}

void require(bool good, const std::string& name, const char* what, double value, const char* range) {
  if (!good) throw BadInput(name + "the " + what + " of the elements is " + text(value) + range);
}

Elements checked(const std::string& name, const MeanElements& x) {
  const double n = 60.0 * x.mean_motion.value(), e = x.eccentricity, i = x.inclination.value();
  require(n > 0.0 && std::isfinite(n), name, "mean motion", n / 60.0, " rad/s; it must be positive");
  require(e >= 0.0 && e < 1.0, name, "eccentricity", e, ", not in [0, 1)");
  require(i >= 0.0 && i <= std::numbers::pi, name, "inclination", i, " rad, not in [0, pi]");
  const auto finite = [&](const char* what, double value, const char* unit) {
    require(std::isfinite(value), name, what, value, unit);
  };
  finite("ascending node", x.ascending_node.value(), " rad");
  finite("argument of perigee", x.argument_of_perigee.value(), " rad");
  finite("mean anomaly", x.mean_anomaly.angle.value(), " rad");
  const double bstar = x.bstar / bstar_unit;
  require(std::abs(bstar) <= largest_bstar, name, "B*", bstar, " per Earth radius, not in [-100, 100]");
  const double a = sgp4::semi_major_axis(n), kilometres = a * earth_radius;
  const auto orbit = [&] { return " rad/s, its semi-major axis " + text(kilometres) + " km; "; };
  if (!(a * (1.0 + e) >= 1.0))
    require(false, name, "mean motion", n / 60.0, (orbit() + "the orbit is inside the Earth").c_str());
  if (!(kilometres <= largest_orbit))
    require(false, name, "mean motion", n / 60.0, (orbit() + "the Earth holds no satellite there").c_str());
  return {brouwer_mean_motion(n, e, i),
          e,
          i,
          in_one_turn(std::remainder(x.ascending_node.value(), 2.0 * std::numbers::pi)),
          x.argument_of_perigee.value(),
          x.mean_anomaly.angle.value()};
}

Sgp4Theory theory_of(const Elements& x, const MeanElements& elements) {
  constexpr double deep_space_from = 225.0;  // min, of the period
  const bool is_deep = two_pi / x.n >= deep_space_from;
  const double p = sgp4::semi_major_axis(x.n) * (1.0 - x.e * x.e);
  const auto rates = zonal_rates(x, p);
  const double node_rate_of_J2 = -1.5 * J2 / (p * p) * x.n * std::cos(x.i);
  const double bstar = elements.bstar.value() * 1000.0 * earth_radius;
  Sgp4Theory theory{x, sgp4::Inclination<double>(x.i), rates, sgp4::Drag(x, bstar, node_rate_of_J2, is_deep),
                    std::nullopt};
  if (is_deep) {
    // UTC stands for UT1, here and in the fits that made the elements. Their sidereal time is of an older
    // form, which until 2050 is within 3e-10 rad of this.
    const auto utc = elements.epoch.julian_date(scale::utc);
    theory.deep.emplace(x, rates, utc.day - 2415020.0 + utc.fraction, eraGmst82(utc.day, utc.fraction));
  }
  return theory;
}

}  // namespace

Sgp4Model::Sgp4Model(std::string name, const MeanElements& elements, const AtMost& longest)
    : name_(std::move(name)), elements_(elements), longest_age_(longest.age) {
  if (!(longest_age_.value() > 0.0 && std::isfinite(longest_age_.value())))
    throw BadInput(name_ + "the longest age is " + text(longest_age_.value()) +
                   " s; it must be positive and finite");
  theory_ = std::make_shared<const Sgp4Theory>(theory_of(checked(name_, elements), elements));
}

double Sgp4Model::minutes_to(const Epoch& epoch) const {
  const double age = (epoch - elements_.epoch).value();
  if (!(std::abs(age) <= longest_age_.value() + rounding_of_the_clock)) {
    std::ostringstream message;
    message << name_ << epoch << " is " << text(rounded(age)) << " s from the epoch of the elements, "
            << elements_.epoch << "; at most " << text(longest_age_.value()) << " s were allowed";
    throw BadInput(message.str());
  }
  return age / 60.0;
}

OrbitNumbers Sgp4Model::at(const Epoch& epoch) const {
  const double t = minutes_to(epoch);
  const auto [r, v] = motion_of(mean_at(*theory_, name_, t), name_, t);
  return {{r[0], r[1], r[2]}, {v[0], v[1], v[2]}};
}

template <std::size_t order>
std::array<Eigen::Vector3d, order + 1> Sgp4Model::derivatives(const Epoch& epoch) const {
  Taylor<order> t = minutes_to(epoch);
  t.c[1] = 1.0;
  const auto mean = mean_at(*theory_, name_, t);
  const double e = mean.x.e.c[0], p = mean.a.c[0] * (1.0 - e * e), small = J2 / (p * p);
  if (!(small <= largest_flattening))
    fail(name_, t.c[0],
         "p = a (1 - e^2) is " + text(p * earth_radius) + " km, and J2 (R/p)^2 " + text(small) + "; above " +
             text(largest_flattening) + " the derivatives of the position are no motion");
  const auto r = motion_of(mean, name_, t.c[0]).r;
  std::array<Eigen::Vector3d, order + 1> all;
  double factor = 1.0;  // k! per second^k
  for (std::size_t k = 0; k <= order; ++k) {
    if (k > 0) factor *= static_cast<double>(k) / 60.0;
    all[k] = {factor * r[0].c[k], factor * r[1].c[k], factor * r[2].c[k]};
  }
  return all;
}
template std::array<Eigen::Vector3d, 3> Sgp4Model::derivatives<2>(const Epoch&) const;
template std::array<Eigen::Vector3d, 4> Sgp4Model::derivatives<3>(const Epoch&) const;

}  // namespace vectrix::detail
