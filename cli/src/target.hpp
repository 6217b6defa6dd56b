#pragma once

#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "attitude_record.hpp"
#include "flown_orbit.hpp"

namespace vectrix::cli {

/// What an axis of the body may look at: the centre of a body, or along the velocity relative to GCRF or to
/// ITRF.
enum class Target { sun, moon, earth, velocity, velocity_in_itrf };
/// How a star moves, and when it was at its place.
struct StarMotion {
  ProperMotion proper;
  Quantity<si::angle> parallax;
  Epoch epoch;
};
/// Of rates of right ascension and declination in arcsec in a Julian year, the first with the factor
/// cos(declination) in it or not, and of a parallax in arcsec.
StarMotion star_motion(const Eigen::Vector2d& rates, bool cos_declination_is_included, double parallax,
                       const Epoch& epoch);
/// Whether a star may have it: from 0 to 1 arcsec.
inline bool is_parallax(double arcseconds) {
  return arcseconds >= 0.0 && arcseconds <= 1.0;
}
/// Whether a star at a declination, rad, may have the rates of star_motion: Barnard's star, the fastest, has
/// 10.4 arcsec in a year.
inline bool is_proper_motion(const Eigen::Vector2d& rates, bool cos_declination_is_included,
                             double declination) {
  constexpr double fastest = 10.4;
  const double across = cos_declination_is_included ? rates.x() : rates.x() * std::cos(declination);
  return std::hypot(across, rates.y()) <= fastest;
}
/// A star, which stands still if it is not said how it moves.
struct StarTarget {
  std::string name;
  RightAscensionDeclination at;
  std::optional<StarMotion> motion{};
};
struct StationTarget {
  std::string name;
  Geodetic at;
};
using MeasureTarget = std::variant<Target, StarTarget, StationTarget>;
std::string name_of(const MeasureTarget& target);

/// The largest latitude or declination, and longitude or right ascension, of either sign; degrees.
inline constexpr double most_of_a_latitude = 90.0, most_of_a_longitude = 360.0;

using SkyCorrection = std::variant<Geometric, LightTime, Apparent>;
/// By their names: "geometric", "light_time", "apparent".
const std::map<std::string, SkyCorrection>& corrections();
/// "geometric", "with light time", "apparent"
std::string words_of(const SkyCorrection& correction);
/// The names of those by which a target may be seen, of which it needs one: the Sun and the Moon by all, a
/// star, which a catalogue gives as it is seen, by all but "geometric", other targets by none.
std::vector<std::string> corrections_of(const MeasureTarget& target);

using SatelliteMotion = PointMotion<earth::Gcrf, Satellite, earth::Gcrf>;
/// At every time; without an orbit at rest in the centre of the Earth. `counted` is called after each.
std::vector<SatelliteMotion> motions_at(
    const std::vector<Epoch>& times, const FlownOrbit& orbit, const std::function<void()>& counted = [] {});

/// The lines to the target in GCRF, of any length. The correction is that of the Sun, the Moon and stars; a
/// station needs the orientation of the Earth.
std::vector<Eigen::Vector3d> lines_to(const MeasureTarget& target, const std::vector<Epoch>& times,
                                      const std::vector<SatelliteMotion>& motions,
                                      const SkyCorrection& correction,
                                      const std::optional<EarthOrientation>& orientation = std::nullopt);
/// The unit vectors of lines in GCRF along the axes of the reference. Throws BadInput, with the name of the
/// target, for a line of no length.
std::vector<Eigen::Vector3d> directions_of(std::vector<Eigen::Vector3d> lines, const AttitudeRecord& record,
                                           const std::string& target);

/// The unit vector to the target at every sample, along the axes of the reference. The Sun is seen from the
/// centre of the Earth, at rest there, if there is no orbit; the other targets need one. Throws BadInput as
/// the orbit does, and for a line of no length.
std::vector<Eigen::Vector3d> directions(const AttitudeRecord& record, const MeasureTarget& target,
                                        const SkyCorrection& correction, const FlownOrbit& orbit,
                                        const std::optional<EarthOrientation>& orientation = std::nullopt);
/// Whether the target has no direction without an orbit: all but the Sun.
bool needs_orbit(const MeasureTarget& target);
/// Throws BadInput if the target needs the orbit that is not there.
void require_orbit_for(const MeasureTarget& target, const FlownOrbit& orbit);

/// Throws BadInput unless --axis is finite and not zero.
void require_axis(const Eigen::Vector3d& axis);
/// "(0, 0, -1)"
std::string name_of(const Eigen::Vector3d& axis);

/// rad. Of any lengths but zero.
double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// R_reference^gcrf.
Eigen::Matrix3d gcrf_from(const std::string& reference);

}  // namespace vectrix::cli
