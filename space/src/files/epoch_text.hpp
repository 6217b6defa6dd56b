#pragma once

#include <string>

#include <vectrix/space/time/epoch.hpp>

namespace vectrix::detail {

/// A text of the epoch with 3, 6, 9 or 12 decimals, the first that reads back as the same epoch. If none
/// does, for the text in its scale is coarser than the epoch, the nearest of 12 decimals. Throws BadInput
/// before the first epoch of the scale, and outside the years 0 to 9999.
std::string exact_text(const Epoch& epoch, const TimeScale& scale);

}  // namespace vectrix::detail
