#include "target.hpp"

#include <cmath>

#include "figures.hpp"
#include "plain_words.hpp"

namespace vectrix::cli {
namespace {

using earth::Gcrf;
using Eigen::Vector3d;
using Motion = PointMotion<Gcrf, Satellite, Gcrf>;

Motion centre_of_the_earth() {
  return point_motion(of<Satellite>, relative_to<Gcrf>, observed_from<Gcrf>,
                      vector<si::length>(in<Gcrf>, Vector3d::Zero()),
                      vector<si::velocity>(in<Gcrf>, Vector3d::Zero()));
}

template <class Body>
std::vector<Vector3d> lines_of_sight(const std::vector<Epoch>& times, const std::vector<Motion>& motions,
                                     const SkyCorrection& correction, const std::string& place) {
  const auto body =
      in_plain_words(place, [&] { return Ephemeris<Body>(from_until(times.front(), times.back())); });
  std::vector<Vector3d> lines;
  for (std::size_t i = 0; i < times.size(); ++i)
    lines.push_back(std::visit(
        [&](auto seen) -> Vector3d { return body.line_of_sight(times[i], motions[i], seen).coordinates(); },
        correction));
  return lines;
}

// In GCRF, of any length.
std::vector<Vector3d> lines_to(Target target, const std::vector<Epoch>& times,
                               const std::vector<Motion>& motions, const SkyCorrection& correction) {
  if (target == Target::sun) return lines_of_sight<sky::Sun>(times, motions, correction, name_of(target));
  if (target == Target::moon) return lines_of_sight<sky::Moon>(times, motions, correction, name_of(target));
  std::vector<Vector3d> lines;
  for (const Motion& motion : motions)
    lines.emplace_back(target == Target::earth ? Vector3d(-motion.position.coordinates())
                                               : motion.velocity.coordinates());
  return lines;
}

}  // namespace

std::string name_of(Target target) {
  switch (target) {
    case Target::sun:
      return "the Sun";
    case Target::moon:
      return "the Moon";
    case Target::earth:
      return "the centre of the Earth";
    default:
      return "the velocity relative to GCRF";
  }
}

bool is_in_sky(Target target) {
  return target == Target::sun || target == Target::moon;
}

void require_orbit_for(Target target, const FlownOrbit& orbit) {
  if (target != Target::sun && !orbit)
    throw BadInput("the direction of " + name_of(target) + " needs an orbit: --tle or --oem");
}

std::vector<Vector3d> directions(const AttitudeRecord& record, Target target, SkyCorrection correction,
                                 const FlownOrbit& orbit) {
  require_orbit_for(target, orbit);
  std::vector<Motion> motions;
  for (const Epoch& t : record.times) motions.push_back(orbit ? orbit(t) : centre_of_the_earth());
  std::vector<Vector3d> all = lines_to(target, record.times, motions, correction);
  const Eigen::Matrix3d R_reference_from_gcrf = gcrf_from(record.reference).transpose();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (!(all[i].norm() > 0.0) || !std::isfinite(all[i].norm()))
      throw BadInput("at " + record.times[i].utc() + " UTC there is no direction of " + name_of(target) +
                     ", its length is " + detail::text(all[i].norm()));
    all[i] = R_reference_from_gcrf * all[i].normalized();
  }
  return all;
}

void require_axis(const Vector3d& axis) {
  if (!axis.allFinite() || !(axis.norm() > 0.0) || !std::isfinite(axis.norm()))
    throw BadInput("--axis (" + detail::text(axis.x()) + ", " + detail::text(axis.y()) + ", " +
                   detail::text(axis.z()) + ") has no direction");
}

std::string name_of(const Vector3d& axis) {
  return "(" + shown(axis.x()) + ", " + shown(axis.y()) + ", " + shown(axis.z()) + ")";
}

double angle_between(const Vector3d& a, const Vector3d& b) {
  struct Axes : moving_frame {};
  return vectrix::angle_between(vector<si::dimensionless>(in<Axes>, a),
                                vector<si::dimensionless>(in<Axes>, b))
      .value();
}

Eigen::Matrix3d gcrf_from(const std::string& reference) {
  if (reference == "EME2000") return inverse(eme2000_from_gcrf()).matrix();
  return Eigen::Matrix3d::Identity();
}

}  // namespace vectrix::cli
