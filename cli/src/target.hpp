#pragma once

#include <string>
#include <variant>
#include <vector>

#include "attitude_record.hpp"
#include "flown_orbit.hpp"

namespace vectrix::cli {

/// What an axis of the body may look at: the centre of a body, or along the velocity relative to GCRF.
enum class Target { sun, moon, earth, velocity };
std::string name_of(Target target);
/// Whether it is a body of the sky, which may be seen with a correction.
bool is_in_sky(Target target);

using SkyCorrection = std::variant<Geometric, LightTime, Apparent>;

/// The unit vector to the target at every sample, along the axes of the reference. The Sun is seen from the
/// centre of the Earth, at rest there, if there is no orbit; the other targets need one. The correction is
/// that of the Sun and the Moon. Throws BadInput as the orbit does, and for a line of no length.
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
