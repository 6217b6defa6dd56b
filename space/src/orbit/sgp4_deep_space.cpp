#include "sgp4_deep_space.hpp"

#include <cmath>
#include <initializer_list>
#include <numbers>

namespace vectrix::detail::sgp4 {
namespace {

constexpr double pi = std::numbers::pi;

}  // namespace

DeepSpace::DeepSpace(const Elements& epoch, const ZonalRates& zonal, double day, double theta) {
  constexpr double three_degrees = 5.2359877e-2;
  const bool near_equator = epoch.i < three_degrees || epoch.i > pi - three_degrees;
  const Orbit orbit{epoch.n,
                    epoch.e,
                    std::cos(epoch.i),
                    std::sin(epoch.i),
                    std::cos(epoch.perigee),
                    std::sin(epoch.perigee),
                    near_equator};
  const double cos_node = std::cos(epoch.node), sin_node = std::sin(epoch.node);

  sun_.anomaly = 6.2565837 + 0.017201977 * day;
  sun_.rate = 1.19459e-5;
  sun_.eccentricity = 0.01675;
  add_body(sun_, orbit, {0.1945905, -0.98088458, 0.91744867, 0.39785416, cos_node, sin_node}, 2.9864797e-6);

  // The plane of the Moon's orbit, from its node on the ecliptic to the equator.
  const double ecliptic_node = std::fmod(4.5236020 - 9.2422029e-4 * day, 2.0 * pi);
  const double cosine = std::cos(ecliptic_node), sine = std::sin(ecliptic_node);
  const double cos_i = 0.91375164 - 0.03568096 * cosine, sin_i = std::sqrt(1.0 - cos_i * cos_i);
  const double sin_h = 0.089683511 * sine / sin_i, cos_h = std::sqrt(1.0 - sin_h * sin_h);
  const double perigee = 5.8351514 + 0.0019443680 * day;
  const double g = perigee - ecliptic_node +
                   std::atan2(0.39785416 * sine / sin_i, cos_h * cosine + 0.91744867 * sin_h * sine);
  moon_.anomaly = 4.7199672 + 0.22997150 * day - perigee;
  moon_.rate = 1.5835218e-4;
  moon_.eccentricity = 0.05490;
  add_body(moon_, orbit,
           {std::cos(g), std::sin(g), cos_i, sin_i, cos_h * cos_node + sin_h * sin_node,
            sin_node * cos_h - cos_node * sin_h},
           4.7968065e-7);

  // rates_ holds the Sun's and the Moon's alone from here on.
  if (!near_equator) rates_.node /= orbit.sin_i;
  rates_.perigee -= orbit.cos_i * rates_.node;
  resonance_ =
      Resonance(epoch, {zonal.M + rates_.M, zonal.perigee + rates_.perigee, zonal.node + rates_.node},
                zonal.perigee, theta);
}

// The third body's attraction, averaged over both orbits, for its direction in axes of the satellite's orbit.
void DeepSpace::add_body(Body& b, const Orbit& o, const Orientation& to, double strength) {
  const double a1 = to.cos_g * to.cos_h + to.sin_g * to.cos_i * to.sin_h;
  const double a3 = -to.sin_g * to.cos_h + to.cos_g * to.cos_i * to.sin_h;
  const double a7 = -to.cos_g * to.sin_h + to.sin_g * to.cos_i * to.cos_h;
  const double a8 = to.sin_g * to.sin_i;
  const double a9 = to.sin_g * to.sin_h + to.cos_g * to.cos_i * to.cos_h;
  const double a10 = to.cos_g * to.sin_i;
  const double a2 = o.cos_i * a7 + o.sin_i * a8, a4 = o.cos_i * a9 + o.sin_i * a10;
  const double a5 = -o.sin_i * a7 + o.cos_i * a8, a6 = -o.sin_i * a9 + o.cos_i * a10;

  const double x1 = a1 * o.cos_perigee + a2 * o.sin_perigee, x2 = a3 * o.cos_perigee + a4 * o.sin_perigee;
  const double x3 = -a1 * o.sin_perigee + a2 * o.cos_perigee, x4 = -a3 * o.sin_perigee + a4 * o.cos_perigee;
  const double x5 = a5 * o.sin_perigee, x6 = a6 * o.sin_perigee, x7 = a5 * o.cos_perigee,
               x8 = a6 * o.cos_perigee;

  const double e2 = o.e * o.e, one_less_e2 = 1.0 - e2, root = std::sqrt(one_less_e2);
  const double z31 = 12.0 * x1 * x1 - 3.0 * x3 * x3, z32 = 24.0 * x1 * x2 - 6.0 * x3 * x4,
               z33 = 12.0 * x2 * x2 - 3.0 * x4 * x4;
  const double z1 = 2.0 * (3.0 * (a1 * a1 + a2 * a2) + z31 * e2) + one_less_e2 * z31;
  const double z2 = 2.0 * (6.0 * (a1 * a3 + a2 * a4) + z32 * e2) + one_less_e2 * z32;
  const double z3 = 2.0 * (3.0 * (a3 * a3 + a4 * a4) + z33 * e2) + one_less_e2 * z33;
  const double z11 = -6.0 * a1 * a5 + e2 * (-24.0 * x1 * x7 - 6.0 * x3 * x5);
  const double z12 =
      -6.0 * (a1 * a6 + a3 * a5) + e2 * (-24.0 * (x2 * x7 + x1 * x8) - 6.0 * (x3 * x6 + x4 * x5));
  const double z13 = -6.0 * a3 * a6 + e2 * (-24.0 * x2 * x8 - 6.0 * x4 * x6);
  const double z21 = 6.0 * a2 * a5 + e2 * (24.0 * x1 * x5 - 6.0 * x3 * x7);
  const double z22 =
      6.0 * (a4 * a5 + a2 * a6) + e2 * (24.0 * (x2 * x5 + x1 * x6) - 6.0 * (x4 * x7 + x3 * x8));
  const double z23 = 6.0 * a4 * a6 + e2 * (24.0 * x2 * x6 - 6.0 * x4 * x8);

  const double s3 = strength / o.n, s2 = -0.5 * s3 / root, s4 = s3 * root, s1 = -15.0 * o.e * s4;
  const double s5 = x1 * x3 + x2 * x4, s6 = x2 * x3 + x1 * x4, s7 = x2 * x4 - x1 * x3;

  b.e2 = 2.0 * s1 * s6;
  b.e3 = 2.0 * s1 * s7;
  b.i2 = 2.0 * s2 * z12;
  b.i3 = 2.0 * s2 * (z13 - z11);
  b.l2 = -2.0 * s3 * z2;
  b.l3 = -2.0 * s3 * (z3 - z1);
  b.l4 = -2.0 * s3 * (-21.0 - 9.0 * e2) * b.eccentricity;
  b.gh2 = 2.0 * s4 * z32;
  b.gh3 = 2.0 * s4 * (z33 - z31);
  b.gh4 = -18.0 * s4 * b.eccentricity;
  b.h2 = -2.0 * s2 * z22;
  b.h3 = -2.0 * s2 * (z23 - z21);

  e_rate_ += b.rate * s1 * s5;
  i_rate_ += b.rate * s2 * (z11 + z13);
  rates_.M -= b.rate * s3 * (z1 + z3 - 14.0 - 6.0 * e2);
  rates_.perigee += b.rate * s4 * (z31 + z33 - 6.0);
  if (!o.near_equator) rates_.node -= b.rate * s2 * (z21 + z23);
}

template <class T> void DeepSpace::add_secular(const T& t, ElementsOf<T>& x) const {
  x.e += e_rate_ * t;
  x.i += i_rate_ * t;
  x.perigee += rates_.perigee * t;
  x.node += rates_.node * t;
  x.M += rates_.M * t;
  resonance_.apply(t, x);
}

template <class T> void DeepSpace::add_periodic(const T& t, ElementsOf<T>& x) const {
  using std::atan2, std::cos, std::sin;
  T e(0.0), i(0.0), l(0.0), gh(0.0), h(0.0);
  for (const Body* b : {&sun_, &moon_}) {
    const T anomaly = b->anomaly + b->rate * t;
    const T f = anomaly + 2.0 * b->eccentricity * sin(anomaly), sine = sin(f);
    const T f2 = 0.5 * sine * sine - 0.25, f3 = -0.5 * sine * cos(f);
    e += b->e2 * f2 + b->e3 * f3;
    i += b->i2 * f2 + b->i3 * f3;
    l += b->l2 * f2 + b->l3 * f3 + b->l4 * sine;
    gh += b->gh2 * f2 + b->gh3 * f3 + b->gh4 * sine;
    h += b->h2 * f2 + b->h3 * f3;
  }
  x.e += e;
  x.i += i;
  const T sin_i = sin(x.i), cos_i = cos(x.i);
  constexpr double lyddane_limit = 0.2;  // rad
  if (x.i >= lyddane_limit) {
    x.perigee += gh - cos_i * h / sin_i;
    x.node += h / sin_i;
    x.M += l;
  } else {
    // Near the equator the changes go to sin i sin(node), sin i cos(node) and the longitude (Lyddane). The
    // term i node sin i is not periodic: the node counts on from its value at the epoch, in [0, 2 pi).
    const T node = less_turns(x.node, std::fmod(value_of(x.node), 2.0 * pi));
    const T sin_node = sin(node), cos_node = cos(node);
    const T a = sin_i * sin_node + h * cos_node + i * cos_i * sin_node;
    const T b = sin_i * cos_node - h * sin_node + i * cos_i * cos_node;
    const T longitude = x.M + x.perigee + cos_i * node + l + gh - i * node * sin_i;
    const T moved = atan2(a, b) - node;
    x.node = node + less_turns(moved, std::remainder(value_of(moved), 2.0 * pi));
    x.M += l;
    x.perigee = longitude - x.M - cos_i * x.node;
  }
  if (x.i < 0.0) {
    x.i = -x.i;
    x.node += pi;
    x.perigee -= pi;
  }
}

template void DeepSpace::add_secular(const double& t, Elements& x) const;
template void DeepSpace::add_secular(const Accelerating& t, ElementsOf<Accelerating>& x) const;
template void DeepSpace::add_secular(const Jerking& t, ElementsOf<Jerking>& x) const;
template void DeepSpace::add_periodic(const double& t, Elements& x) const;
template void DeepSpace::add_periodic(const Accelerating& t, ElementsOf<Accelerating>& x) const;
template void DeepSpace::add_periodic(const Jerking& t, ElementsOf<Jerking>& x) const;

}  // namespace vectrix::detail::sgp4
