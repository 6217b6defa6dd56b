#pragma once

#include <vector>

#include "target.hpp"

namespace vectrix::cli {

/// The part of the Sun's disc that is seen past the Earth, at every time: 1 in sunlight, 0 in shadow.
std::vector<double> visible_suns(const std::vector<Epoch>& times,
                                 const std::vector<SatelliteMotion>& motions);

}  // namespace vectrix::cli
