#pragma once

#include <vector>
#include <vectrix/dynamics/craft/plain_spacecraft.hpp>
#include <vectrix/frames/units.hpp>

namespace vectrix {

/// Absolute tolerances by unit: of unit quaternions and angles, of rates, lengths, velocities, and modes,
/// kg^1/2 m and kg^1/2 m/s. There is no default.
struct CraftTolerances {
  Quantity<si::angle> angle;
  Quantity<si::angular_velocity> rate;
  Quantity<si::length> length;
  Quantity<si::velocity> velocity;
  double mode;
};

/// One for each number of the state of a craft. Throws BadInput with its name if one that the craft needs is
/// zero, as one that was left out is.
VECTRIX_EXPORT std::vector<double> absolute_tolerances(const PlainSpacecraft& craft,
                                                       const CraftTolerances& by);

}  // namespace vectrix
