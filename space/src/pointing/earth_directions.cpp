#include <Eigen/LU>
#include <cmath>

#include <vectrix/space/earth/ellipsoid.hpp>
#include <vectrix/space/pointing/earth_directions.hpp>
#include <vectrix/space/pointing/pointing.hpp>

#include "../earth/ellipsoid_normal.hpp"
#include "../varying.hpp"

namespace vectrix::detail {
namespace {

using Eigen::Matrix3d, Eigen::Vector3d;

constexpr double nearly_on_evolute = 1.0;  // m; the normal turns by v over the distance from it

Varying operator*(const Varying& f, const Varying& g) {
  return {f.value * g.value, f.rate * g.value + f.value * g.rate,
          f.second * g.value + 2 * f.rate * g.rate + f.value * g.second};
}
Varying square_root(const Varying& f) {
  const double root = std::sqrt(f.value), first = f.rate / (2 * root);
  return {root, first, (f.second / 2 - first * first) / root};
}
Varying square_of(const PathInItrf& u) {
  return {u[0].squaredNorm(), 2 * u[0].dot(u[1]), 2 * (u[1].squaredNorm() + u[0].dot(u[2]))};
}
PathInItrf operator*(const Varying& f, const PathInItrf& u) {
  return {f.value * u[0], f.rate * u[0] + f.value * u[1],
          f.second * u[0] + 2 * f.rate * u[1] + f.value * u[2]};
}

}  // namespace

PathInItrf geodetic_up(const Caller& name, const PathInItrf& path) {
  const auto [n, h] = normal_at(name, path[0]);
  const Vector3d D(equatorial_axis * equatorial_axis, equatorial_axis * equatorial_axis,
                   polar_axis * polar_axis);
  const Vector3d Dn = D.cwiseProduct(n);
  const double s = std::sqrt(n.dot(Dn));
  const double from_evolute = equatorial_axis * equatorial_axis * polar_axis * polar_axis / (s * s * s) + h;
  if (!(from_evolute > nearly_on_evolute)) {
    throw BadInput(name() + "the point is at the height " + text(h) + " m, " + text(from_evolute) +
                   " m from the centre of curvature of the meridian, where the normal has no rate");
  }
  Matrix3d G = -Dn * Dn.transpose() / (s * s * s);
  G.diagonal() += D / s;
  // G n = 0, and what it is applied to is normal to n: the term along n makes the matrix regular.
  const Matrix3d inverse =
      (G + h * Matrix3d::Identity() + (equatorial_axis + h) * n * n.transpose()).inverse();
  const auto across = [&n = n](const Vector3d& x) { return Vector3d(x - n.dot(x) * n); };

  const Vector3d ndot = inverse * across(path[1]);
  // rddot = Gdot ndot + G nddot + hddot n + 2 hdot ndot + h nddot
  const double hdot = n.dot(path[1]), sdot = ndot.dot(Dn) / s;
  const Vector3d Dndot = D.cwiseProduct(ndot);
  const Vector3d Gdot_ndot = -Dndot * (sdot / (s * s)) -
                             (Dndot * (s * sdot) + Dn * ndot.dot(Dndot)) / (s * s * s) +
                             Dn * (3 * sdot * sdot / (s * s * s));
  const Vector3d nddot = inverse * across(path[2] - Gdot_ndot - 2 * hdot * ndot) - ndot.squaredNorm() * n;
  return {n, ndot, nddot};
}

PathInItrf limb_of_ellipsoid(const Caller& name, double height, const PathInItrf& path,
                             const PathInItrf& towards) {
  const Vector3d axes(equatorial_axis + height, equatorial_axis + height, polar_axis + height);
  PathInItrf r, u;
  for (std::size_t i = 0; i < 3; ++i) {
    r[i] = path[i].cwiseQuotient(axes);
    u[i] = towards[i].cwiseQuotient(axes);
  }
  if (!(axes.z() > 0 && r[0].squaredNorm() > 1 && (r[0] - r[0]).isZero(0))) {
    throw BadInput(name() + "the height of the limb is " + text(height) + " m, and |r| is " +
                   text(path[0].norm()) + " m; the point must be above it");
  }
  require_two_directions(name, "directions, r and u,", path[0], towards[0]);
  const PathInItrf n = cross_of(r, u), across = cross_of(n, r);
  Varying above = square_of(r);
  above.value -= 1;
  const PathInItrf down = square_root(above * square_of(n)) * r;
  PathInItrf limb;
  for (std::size_t i = 0; i < 3; ++i) limb[i] = (across[i] - down[i]).cwiseProduct(axes);
  return limb;
}

}  // namespace vectrix::detail
