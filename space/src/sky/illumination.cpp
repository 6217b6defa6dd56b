#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/sky/illumination.hpp>

namespace vectrix::detail {
namespace {

// 1 - cos x, without cancellation.
double versine(double x) {
  const double half = std::sin(0.5 * x);
  return 2.0 * half * half;
}

double angle_between(const Eigen::Vector3d& x, const Eigen::Vector3d& y) {
  return std::atan2(x.cross(y).norm(), x.dot(y));
}

double radius_of_sun(const Eigen::Vector3d& to_sun, double sun_radius) {
  const double distance = to_sun.norm();
  if (!(sun_radius > 0.0 && distance > sun_radius)) {
    throw BadInput("visible_sun: the Sun, of radius " + text(sun_radius) + " m, is " + text(distance) +
                   " m away");
  }
  return std::asin(sun_radius / distance);
}

// The angle from the centre of the ellipsoid to its limb, seen from s, in the plane of s and p, on the side
// of p. Along u = cos(t) n + sin(t) p, where n is to the centre and p across, a tangent obeys (u.As)^2 =
// (u.Au)(s.As - 1), A = diag(1/a^2, 1/a^2, 1/b^2), which is a quadratic equation for cot(t).
double limb(const Eigen::Vector3d& s, const Eigen::Vector3d& p, const Eigen::Vector3d& A) {
  const Eigen::Vector3d As = A.cwiseProduct(s);
  const double outside = s.dot(As) - 1.0;
  const double pAs = p.dot(As);
  const double pAp = p.dot(A.cwiseProduct(p));
  const double root = std::sqrt(outside * ((outside + 1.0) * pAp - pAs * pAs));
  return std::atan2(outside + 1.0, s.norm() * (pAs + root));
}

// The solid angle that two caps on the unit sphere share, of angular radii a and b, their centres c apart,
// |a - b| < c < a + b. Of the triangle with these sides:
//     lens = 2 [alpha (1 - cos a) + beta (1 - cos b) - E]
// with the angles alpha and beta at the centres of a and b by their half tangents, and the spherical excess E
// by l'Huilier's theorem.
double lens(double a, double b, double c) {
  const double s = 0.5 * (a + b + c);
  const double s_a = 0.5 * ((b - a) + c);
  const double s_b = 0.5 * ((a - b) + c);
  const double s_c = 0.5 * ((a + b) - c);
  const double alpha =
      2.0 * std::atan2(std::sqrt(std::sin(s_a) * std::sin(s_c)), std::sqrt(std::sin(s) * std::sin(s_b)));
  const double beta =
      2.0 * std::atan2(std::sqrt(std::sin(s_b) * std::sin(s_c)), std::sqrt(std::sin(s) * std::sin(s_a)));
  const double excess = 4.0 * std::atan(std::sqrt(std::tan(0.5 * s) * std::tan(0.5 * s_a) *
                                                  std::tan(0.5 * s_b) * std::tan(0.5 * s_c)));
  return 2.0 * (alpha * versine(a) + beta * versine(b) - excess);
}

// The part of a cap of radius a that a cap of radius b, c away, leaves free.
double free_part(double a, double b, double c) {
  if (c >= a + b) return 1.0;
  if (c <= b - a) return 0.0;
  if (c <= a - b) return 1.0 - versine(b) / versine(a);
  return 1.0 - lens(a, b, c) / (2.0 * std::numbers::pi * versine(a));
}

}  // namespace

double visible_past_sphere(const Eigen::Vector3d& to_sun, const Eigen::Vector3d& to_body, double radius,
                           double sun_radius) {
  const double distance = to_body.norm();
  if (!(radius > 0.0 && distance >= radius)) {
    throw BadInput("visible_sun: the body, of radius " + text(radius) + " m, is " + text(distance) +
                   " m away");
  }
  const double a = radius_of_sun(to_sun, sun_radius);
  if (distance >= to_sun.norm()) return 1.0;
  return free_part(a, std::asin(radius / distance), angle_between(to_sun, to_body));
}

double visible_past_ellipsoid(const Eigen::Vector3d& to_sun, const Eigen::Vector3d& to_centre,
                              double equatorial, double polar, double sun_radius) {
  const Eigen::Vector3d A = Eigen::Vector3d(equatorial, equatorial, polar).cwiseAbs2().cwiseInverse();
  const double distance = to_centre.norm();
  if (!(to_centre.dot(A.cwiseProduct(to_centre)) >= 1.0)) {
    throw BadInput("visible_sun: the point is inside the ellipsoid, " + text(distance) +
                   " m from its centre");
  }
  const double a = radius_of_sun(to_sun, sun_radius);
  if (distance >= to_sun.norm()) return 1.0;
  const Eigen::Vector3d n = to_centre / distance;
  const Eigen::Vector3d across = to_sun - to_sun.dot(n) * n;
  // On the axis through the centre every plane will do.
  const Eigen::Vector3d p =
      across.norm() > 1e-12 * to_sun.norm() ? Eigen::Vector3d(across.normalized()) : n.unitOrthogonal();
  return free_part(a, limb(-to_centre, p, A), angle_between(to_sun, to_centre));
}

}  // namespace vectrix::detail
