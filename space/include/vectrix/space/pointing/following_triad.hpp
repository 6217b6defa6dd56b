#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <string>

#include <vectrix/frames/dcm.hpp>
#include <vectrix/frames/errors.hpp>

namespace vectrix::detail {

/// A vector and its derivatives, as many as are known.
template <class S, std::size_t N> using Jet = std::array<Column<S>, N>;

/// The triad that follows two vectors: x along p, z along n, n perpendicular to p, y = z x x. With indices
/// for components in the triad:
///     w1 = -ndot2/n, w2 = -pdot3/p, w3 = pdot2/p
///     alpha1 = -nddot2/n - 2 w1 ndot3/n + w2 w3
///     alpha2 = -pddot3/p - 2 w2 pdot1/p + w1 w3
///     alpha3 =  pddot2/p - 2 w3 pdot1/p - w1 w2
/// which are d/dt and d2/dt2 of p x_triad and n z_triad.
template <class S, std::size_t N> struct FollowingTriad {
  Square<S> axes;  // columns
  Column<S> w, alpha;

  FollowingTriad(const Jet<S, N>& p, const Jet<S, N>& n) {
    using std::sqrt;
    const S p_norm = sqrt(p[0].squaredNorm()), n_norm = sqrt(n[0].squaredNorm());
    const Column<S> x = p[0] / p_norm, z = n[0] / n_norm;
    axes << x, z.cross(x), z;
    if constexpr (N > 1) {
      const Column<S> pdot = axes.transpose() * p[1] / p_norm, ndot = axes.transpose() * n[1] / n_norm;
      w << -ndot(1), -pdot(2), pdot(1);
      if constexpr (N > 2) {
        const Column<S> pddot = axes.transpose() * p[2] / p_norm, nddot = axes.transpose() * n[2] / n_norm;
        alpha << -nddot(1) - S(2) * w(0) * ndot(2) + w(1) * w(2),
            -pddot(2) - S(2) * w(1) * pdot(0) + w(0) * w(2), pddot(1) - S(2) * w(2) * pdot(0) - w(0) * w(1);
      }
    }
  }
};

/// |u x v| / (|u| |v|), the sine of the angle between u and v; 0 if one of them is zero.
template <class S> S sine_between(const Column<S>& u, const Column<S>& v) {
  const S product = scaled_norm(u) * scaled_norm(v);
  const auto none = product == S(0);
  return select(none, S(0), S(scaled_norm(u.cross(v)) / select(none, S(1), product)));
}

/// Throws BadInput if the sine of the angle between u and v is not above `least`: what(|u|, |v|) begins the
/// message, `reason` ends it.
template <class S, class What>
void require_plane(double least, const Column<S>& u, const Column<S>& v, const What& what,
                   const char* reason) {
  const S u2 = u.squaredNorm(), v2 = v.squaredNorm(), n2 = u.cross(v).squaredNorm();
  const double sine = door_tolerance<S>(least);
  if (!(all(n2 > number<S>(sine * sine) * (u2 * v2)) && all(n2 - n2 == S(0)))) [[unlikely]] {
    using std::sqrt;
    throw BadInput(what(text(S(sqrt(u2))), text(S(sqrt(v2)))) + ", and the sine of the angle between them " +
                   text(sine_between<S>(u, v)) + "; " + reason);
  }
}

/// p x s and its derivatives.
template <class S, std::size_t N> Jet<S, N> cross_of(const Jet<S, N>& p, const Jet<S, N>& s) {
  Jet<S, N> n;
  n[0] = p[0].cross(s[0]);
  if constexpr (N > 1) n[1] = p[1].cross(s[0]) + p[0].cross(s[1]);
  if constexpr (N > 2) n[2] = p[2].cross(s[0]) + S(2) * p[1].cross(s[1]) + p[0].cross(s[2]);
  return n;
}

}  // namespace vectrix::detail
