#pragma once

#include <string>
#include <vector>

#include "angle_figures.hpp"
#include "pointing_error.hpp"
#include "progress.hpp"
#include "scenario/fixed_frame.hpp"
#include "scenario/scenario.hpp"

namespace vectrix::cli {

/// The attitude of a scenario, and the frames on the body.
struct FlownAttitude {
  AttitudeRecord record;  // the samples of the file
  BodyFrames frames;
};
/// Throws BadInput as read_attitude does, and for an axis or rates of a frame that is not there.
FlownAttitude read_flown_attitude(const Scenario& scenario);

/// The time that is looked at: that of the scenario, as far as there are samples. Throws BadInput, with the
/// place in the scenario, if there are none.
TimeSpan looked_at(const Scenario& scenario, const AttitudeRecord& samples);

/// Throws BadInput, with the place in the scenario, if it names an orientation of the Earth that is not known
/// at a time.
void require_orientation(const Scenario& scenario, const Epoch& t);

/// The instants of the step of a scenario; without a step, the times of the samples. Throws BadInput, with
/// the place in the scenario, for too many.
std::vector<Epoch> instants(const Scenario& scenario, const AttitudeRecord& samples);

/// A flight at the instants that are looked at.
struct Flight {
  FlownAttitude flown;
  AttitudeRecord attitude;  // relative to EME2000 or GCRF, as are
  AttitudeRecord
      samples;  // those of the file from the one before the first instant to the one after the last
  std::size_t
      instants;      // that are asked for by a step; those in gaps and outside the samples have no attitude
  FlownOrbit orbit;  // nothing if none is given
  std::vector<SatelliteMotion> motions;
  std::vector<double> visible_sun;  // empty without an orbit
};
Flight read_flight(const Scenario& scenario, Progress& progress);

/// What of the time that is asked for has no attitude, as "61 of 660 instants, in gaps or outside the
/// samples": "" if nothing.
std::string without_attitude(const Scenario& scenario, const Flight& flight);

/// What a measure finds, at every instant.
struct Measured {
  std::string what;                         // "angle between -z of body and the Sun, geometric, ..."
  std::string target;                       // "the Sun"
  std::vector<Eigen::Vector3d> directions;  // of the target, along the axes of the reference
  std::vector<Eigen::Vector3d> in_body;
  std::vector<double> angles;  // rad
  std::vector<bool> hidden;    // by the Earth; empty if it cannot be
  std::vector<bool> counts;    // at which instants the figures are; empty if at all
  std::vector<double>
      by_reading;  // the median angle by each reading of the quaternions, the stated one first
};
Measured measured(const Measure& measure, const Scenario& scenario, const Flight& flight);

/// The readings of the quaternions by which the axis looks at the target, and as stated it does not: "" if
/// there is none. None is chosen.
std::string better_readings(const Flight& flight, const Measured& measure);

/// The errors that a requirement judges, rad. Throws BadInput, with its place, if nothing is left.
std::vector<double> errors_of(const Requirement& required, const Scenario& scenario, const Flight& flight,
                              const Measured& measure);
/// Of one with a window. Throws BadInput as errors_of().
WindowErrors errors_in_windows(const Requirement& required, const Scenario& scenario, const Flight& flight,
                               const Measured& measure);

/// A verdict with its numbers.
struct Judged : Report::Verdict {
  Judgement figures;
  double limit;       // deg
  std::size_t count;  // of the samples or windows that are judged
};
/// Which requirements are fulfilled. Throws BadInput if nothing is left to be judged.
std::vector<Judged> verdicts(const Scenario& scenario, const Flight& flight,
                             const std::vector<Measured>& measures);

}  // namespace vectrix::cli
