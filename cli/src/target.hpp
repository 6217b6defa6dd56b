#pragma once

#include <functional>
#include <string>
#include <variant>
#include <vector>

#include "attitude_record.hpp"
#include "flown_orbit.hpp"

namespace vectrix::cli {

/// What an axis of the body may look at: the centre of a body, or along the velocity relative to GCRF or to
/// ITRF.
enum class Target { sun, moon, earth, velocity, velocity_in_itrf };
std::string name_of(Target target);
/// Whether it is a body of the sky, which may be seen with a correction.
bool is_in_sky(Target target);

using SkyCorrection = std::variant<Geometric, LightTime, Apparent>;
/// "geometric", "with light time", "apparent"
std::string words_of(const SkyCorrection& correction);

using SatelliteMotion = PointMotion<earth::Gcrf, Satellite, earth::Gcrf>;
/// At every time; without an orbit at rest in the centre of the Earth. `counted` is called after each.
std::vector<SatelliteMotion> motions_at(
    const std::vector<Epoch>& times, const FlownOrbit& orbit, const std::function<void()>& counted = [] {});

/// The lines to the target in GCRF, of any length. The correction is that of the Sun and the Moon.
std::vector<Eigen::Vector3d> lines_to(Target target, const std::vector<Epoch>& times,
                                      const std::vector<SatelliteMotion>& motions,
                                      const SkyCorrection& correction);
/// The unit vectors of lines in GCRF along the axes of the reference. Throws BadInput, with the name of the
/// target, for a line of no length.
std::vector<Eigen::Vector3d> directions_of(std::vector<Eigen::Vector3d> lines, const AttitudeRecord& record,
                                           const std::string& target);

/// The unit vector to the target at every sample, along the axes of the reference. The Sun is seen from the
/// centre of the Earth, at rest there, if there is no orbit; the other targets need one. Throws BadInput as
/// the orbit does, and for a line of no length.
std::vector<Eigen::Vector3d> directions(const AttitudeRecord& record, Target target, SkyCorrection correction,
                                        const FlownOrbit& orbit);
/// Throws BadInput if the target needs the orbit that is not there.
void require_orbit_for(Target target, const FlownOrbit& orbit);

/// Throws BadInput unless --axis is finite and not zero.
void require_axis(const Eigen::Vector3d& axis);
/// "(0, 0, -1)"
std::string name_of(const Eigen::Vector3d& axis);

/// rad. Of any lengths but zero.
double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b);

/// R_reference^gcrf.
Eigen::Matrix3d gcrf_from(const std::string& reference);

}  // namespace vectrix::cli
