#include <cmath>
#include <numbers>

#include <vectrix/space/sky/illumination.hpp>
#include <vectrix/space/sky/limb.hpp>

namespace vectrix::detail {
namespace {

// 1 - cos x, without cancellation.
double versine(double x) {
  const double half = std::sin(0.5 * x);
  return 2.0 * half * half;
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
  const double b = angular_radius("visible_sun: the body", to_body, radius);
  const double a = angular_radius("visible_sun: the Sun", to_sun, sun_radius);
  const double distance = to_body.norm(), sun_distance = to_sun.norm();
  if (distance >= sun_distance) return 1.0;
  return free_part(a, b, angle_of_units<double>(to_sun / sun_distance, to_body / distance));
}

double visible_past_ellipsoid(const Eigen::Vector3d& to_sun, const Eigen::Vector3d& to_centre,
                              double equatorial, double polar, double sun_radius) {
  const double b = angular_radius_towards("visible_sun", to_sun, to_centre, equatorial, polar);
  const double a = angular_radius("visible_sun: the Sun", to_sun, sun_radius);
  const double distance = to_centre.norm(), sun_distance = to_sun.norm();
  if (distance >= sun_distance) return 1.0;
  return free_part(a, b, angle_of_units<double>(to_sun / sun_distance, to_centre / distance));
}

}  // namespace vectrix::detail
