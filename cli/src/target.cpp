#include "target.hpp"

#include <cmath>

#include "figures.hpp"
#include "plain_words.hpp"

namespace vectrix::cli {
namespace {

using earth::Gcrf;
using Eigen::Vector3d;
using Motion = SatelliteMotion;

std::string name_of(Target target) {
  switch (target) {
    case Target::sun:
      return "the Sun";
    case Target::moon:
      return "the Moon";
    case Target::earth:
      return "the centre of the Earth";
    case Target::velocity:
      return "the velocity relative to GCRF";
    default:
      return "the velocity relative to ITRF";
  }
}

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

// v_itrf = v_gcrf - w x r. The turn of the Earth is that without observations: what they add to w, 1e-8 of
// it, turns the velocity of a low orbit by 1e-9 rad.
std::vector<Vector3d> velocities_in_itrf(const std::vector<Epoch>& times,
                                         const std::vector<Motion>& motions) {
  const auto span = from_until(times.front(), times.back());
  const EarthMotion earth(EarthOrientation::unobserved(span, 0.0 * si::second), span);
  std::vector<Vector3d> velocities;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto R_gcrf_from_itrf = earth.at(times[i]);
    const Vector3d w = R_gcrf_from_itrf.rotation.matrix() * R_gcrf_from_itrf.angular_velocity.coordinates();
    velocities.emplace_back(motions[i].velocity.coordinates() - w.cross(motions[i].position.coordinates()));
  }
  return velocities;
}

std::vector<Vector3d> lines_to_star(const StarTarget& target, const std::vector<Epoch>& times,
                                    const std::vector<Motion>& motions, const SkyCorrection& correction) {
  const auto still =
      proper_motion_with_cos_declination(0.0 * (si::radian / si::second), 0.0 * (si::radian / si::second));
  const StarMotion motion = target.motion.value_or(StarMotion{still, 0.0 * si::radian, times.front()});
  const Star star(in<Gcrf>, target.at, motion.proper, motion.parallax, 0.0 * (si::metre / si::second),
                  motion.epoch);
  const Stars stars(from_until(times.front(), times.back()));
  std::vector<Vector3d> lines;
  for (std::size_t i = 0; i < times.size(); ++i)
    lines.emplace_back(std::holds_alternative<Apparent>(correction)
                           ? stars.direction(star, times[i], motions[i], apparent).coordinates()
                           : stars.direction(star, times[i], motions[i], light_time).coordinates());
  return lines;
}

std::vector<Vector3d> lines_to_station(const StationTarget& target, const std::vector<Epoch>& times,
                                       const std::vector<Motion>& motions,
                                       const EarthOrientation& orientation) {
  const EarthMotion earth(orientation, from_until(times.front(), times.back()));
  const auto station = wgs84::position(target.at);
  std::vector<Vector3d> lines;
  for (std::size_t i = 0; i < times.size(); ++i)
    lines.emplace_back((earth.rotation(times[i]) * station).coordinates() -
                       motions[i].position.coordinates());
  return lines;
}

std::vector<Vector3d> lines_to_plain(Target target, const std::vector<Epoch>& times,
                                     const std::vector<Motion>& motions, const SkyCorrection& correction) {
  if (target == Target::sun) return lines_of_sight<sky::Sun>(times, motions, correction, name_of(target));
  if (target == Target::moon) return lines_of_sight<sky::Moon>(times, motions, correction, name_of(target));
  if (target == Target::velocity_in_itrf) return velocities_in_itrf(times, motions);
  std::vector<Vector3d> lines;
  for (const Motion& motion : motions)
    lines.emplace_back(target == Target::earth ? Vector3d(-motion.position.coordinates())
                                               : motion.velocity.coordinates());
  return lines;
}

}  // namespace

std::vector<Vector3d> lines_to(const MeasureTarget& target, const std::vector<Epoch>& times,
                               const std::vector<Motion>& motions, const SkyCorrection& correction,
                               const std::optional<EarthOrientation>& orientation) {
  if (const auto* const star = std::get_if<StarTarget>(&target))
    return lines_to_star(*star, times, motions, correction);
  if (const auto* const station = std::get_if<StationTarget>(&target)) {
    if (!orientation) throw BadInput(station->name + " needs the orientation of the Earth");
    return lines_to_station(*station, times, motions, *orientation);
  }
  return lines_to_plain(std::get<Target>(target), times, motions, correction);
}

StarMotion star_motion(const Eigen::Vector2d& rates, bool cos_declination_is_included, double parallax,
                       const Epoch& epoch) {
  constexpr double year = 365.25 * 86400.0;
  const auto of = cos_declination_is_included ? proper_motion_with_cos_declination
                                              : proper_motion_without_cos_declination;
  const auto rate = [&](double value) {
    return value / (3600.0 * degrees * year) * (si::radian / si::second);
  };
  return {of(rate(rates.x()), rate(rates.y())), parallax / (3600.0 * degrees) * si::radian, epoch};
}

std::string name_of(const MeasureTarget& target) {
  if (const auto* const star = std::get_if<StarTarget>(&target)) return star->name;
  if (const auto* const station = std::get_if<StationTarget>(&target)) return station->name;
  return name_of(std::get<Target>(target));
}

const std::map<std::string, SkyCorrection>& corrections() {
  static const std::map<std::string, SkyCorrection> all{
      {"geometric", geometric}, {"light_time", light_time}, {"apparent", apparent}};
  return all;
}

std::vector<std::string> corrections_of(const MeasureTarget& target) {
  if (std::holds_alternative<StarTarget>(target)) return {"light_time", "apparent"};
  const auto* const plain = std::get_if<Target>(&target);
  if (plain && (*plain == Target::sun || *plain == Target::moon))
    return {"geometric", "light_time", "apparent"};
  return {};
}

std::string words_of(const SkyCorrection& correction) {
  if (std::holds_alternative<Geometric>(correction)) return "geometric";
  return std::holds_alternative<LightTime>(correction) ? "with light time" : "apparent";
}

bool needs_orbit(const MeasureTarget& target) {
  const auto* const plain = std::get_if<Target>(&target);
  return !plain || *plain != Target::sun;
}

void require_orbit_for(const MeasureTarget& target, const FlownOrbit& orbit) {
  if (needs_orbit(target) && !orbit)
    throw BadInput("the direction of " + name_of(target) + " needs an orbit: --tle, --omm, --oem or --spk");
}

std::vector<Motion> motions_at(const std::vector<Epoch>& times, const FlownOrbit& orbit,
                               const std::function<void()>& counted) {
  std::vector<Motion> motions;
  for (const Epoch& t : times) {
    motions.push_back(orbit ? orbit(t) : centre_of_the_earth());
    counted();
  }
  return motions;
}

std::vector<Vector3d> directions_of(std::vector<Vector3d> lines, const AttitudeRecord& record,
                                    const std::string& target) {
  const Eigen::Matrix3d R_reference_from_gcrf = gcrf_from(record.reference).transpose();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (!(lines[i].norm() > 0.0) || !std::isfinite(lines[i].norm()))
      throw BadInput("at " + record.times[i].utc() + " UTC there is no direction of " + target +
                     ", its length is " + detail::text(lines[i].norm()));
    lines[i] = R_reference_from_gcrf * lines[i].normalized();
  }
  return lines;
}

std::vector<Vector3d> directions(const AttitudeRecord& record, const MeasureTarget& target,
                                 const SkyCorrection& correction, const FlownOrbit& orbit,
                                 const std::optional<EarthOrientation>& orientation) {
  require_orbit_for(target, orbit);
  return directions_of(
      lines_to(target, record.times, motions_at(record.times, orbit), correction, orientation), record,
      name_of(target));
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
