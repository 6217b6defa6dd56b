#pragma once

#include <vectrix/space/orbit/elements.hpp>
#include <vectrix/space/orbit/orbit_frames.hpp>

namespace vectrix {

/// Smallest eccentricity from which perifocal() makes a frame of a motion. The rounding of r and v turns the
/// frame by about 1e-16/e, and its rate is good to 1e-16/e^2 of the mean motion.
inline constexpr double nearly_circular = 1e-7;

namespace detail {

struct PerifocalAxes : RicAxes {
  static constexpr const char* name = "perifocal";
};

/// e = v x h/mu - r/|r| and its derivatives.
template <class S, std::size_t N> Jet<S, N - 1> eccentricity_of(const S& mu, const Jet<S, N>& r) {
  using std::sqrt;
  Jet<S, N - 1> v;
  for (std::size_t i = 0; i + 1 < N; ++i) v[i] = r[i + 1];
  Jet<S, N - 1> e = cross_of(v, normal_of(r));
  const S distance = sqrt(r[0].squaredNorm());
  const Column<S> u = r[0] / distance;
  e[0] = e[0] / mu - u;
  if constexpr (N > 2) {
    const S rate = u.dot(r[1]);
    const Column<S> udot = (r[1] - rate * u) / distance;
    e[1] = e[1] / mu - udot;
    if constexpr (N > 3) {
      const S second = udot.dot(r[1]) + u.dot(r[2]);
      e[2] = e[2] / mu - (r[2] - S(2) * rate * udot - second * u) / distance;
    }
  }
  return e;
}

template <Frame B, class P, class Q, class A, class S, std::size_t N>
auto perifocal_of(const Quantity<si::gravitational_parameter, S>& mu, const OrbitPath<P, Q, A, S, N>& path) {
  const S m = mu.value();
  if (!(all(m > S(0)) && all(m - m == S(0)))) [[unlikely]]
    throw BadInput(orbit_frame_place<PerifocalAxes, B, P, Q>() + "mu is " + text(m) +
                   " m^3/s^2; it must be positive and finite");
  require_orbital_plane<PerifocalAxes, B, P, Q>(path.r[0], path.r[1]);
  const auto e = eccentricity_of(m, path.r);
  for (const Column<S>& derivative : e) {
    const S sum = derivative.sum();
    if (!all(sum - sum == S(0))) [[unlikely]]
      throw BadInput(orbit_frame_place<PerifocalAxes, B, P, Q>() + "with mu " + text(m) +
                     " m^3/s^2 the eccentricity or a derivative of it is not finite");
  }
  const S size = scaled_norm(e[0]);
  if (!all(size > number<S>(door_tolerance<S>(nearly_circular)))) [[unlikely]]
    throw BadInput(orbit_frame_place<PerifocalAxes, B, P, Q>() + "the eccentricity is " + text(size) +
                   "; a circle has no periapsis");
  return frame_of<PerifocalAxes, A, B>(FollowingTriad<S, N - 1>(e, normal_of(path.r)));
}

template <class B, class S, class... Motion>
using PerifocalOf =
    std::enable_if_t<!InertialFrame<B>,
                     decltype(perifocal_of<B>(std::declval<const Quantity<si::gravitational_parameter, S>&>(),
                                              orbit_path(std::declval<const Motion&>()...)))>;
template <class FromFrame, class Mu, class... Motion> inline constexpr bool is_perifocal = false;
template <class B, class S, class... Motion>
  requires requires {
    typename PerifocalOf<B, S, Motion...>;
  }
inline constexpr bool is_perifocal<From<B>, Quantity<si::gravitational_parameter, S>, Motion...> = true;

}  // namespace detail

/// The perifocal frame of the conic on which q moves about p at this instant (PQW): x to periapsis, along
///     e = v x h/mu - r/|r|,  h = r x v
/// z along h, y = z x x. What is given decides what is known, as in lvlh(): with a the rate of the axes, with
/// the jerk their acceleration; of two_body() both are zero, to rounding. Throws BadInput if mu is not
/// positive and finite, distance_from_singularity() is below nearly_rectilinear, the eccentricity below
/// nearly_circular, or it or a derivative not finite.
template <class B, class S, class... Motion>
detail::PerifocalOf<B, S, Motion...> perifocal(From<B>, const Quantity<si::gravitational_parameter, S>& mu,
                                               const Motion&... motion) {
  return detail::perifocal_of<B>(mu, detail::orbit_path(motion...));
}
/// The same of elements, for every eccentricity: on a circle periapsis is where the elements say.
///     x = cos w n + sin w m, y = cos w m - sin w n, z = n x m
/// with the argument of periapsis w, n to the ascending node and m a quarter of a turn ahead in the orbit.
template <class B, class P, class Q, class A>
std::enable_if_t<!InertialFrame<B>, Dcm<A, B>> perifocal(From<B>,
                                                         const KeplerianElements<P, Q, A>& elements) {
  return {detail::trusted, detail::perifocal_axes(elements.numbers())};
}
template <class FromFrame, class Mu, class... Motion>
  requires(!detail::is_perifocal<FromFrame, Mu, Motion...>)
auto perifocal(  // from<B>: not inertial; mu, r, v, then a and da/dt of one inertial a, in a; or elements
    FromFrame, const Mu&, const Motion&...) -> Refused = delete;

}  // namespace vectrix
