#pragma once

#include <string>

#include <vectrix/frames/export.hpp>
#include <vectrix/space/time/epoch.hpp>

namespace vectrix {

/// A text of the epoch with 3, 6, 9 or 12 decimals, the first that reads back as the same epoch:
///     Epoch::from(scale::utc, exact_text(t, scale::utc)) == t
/// If none does, for the text in its scale is coarser than the epoch, the nearest of 12 decimals. Throws
/// BadInput as Epoch::text does, and outside the years 0 to 9999.
VECTRIX_EXPORT std::string exact_text(const Epoch& epoch, const TimeScale& scale);
template <ScaleType Scale> DateText<Scale> exact_text(const Epoch& epoch, const Scale& scale) {
  return DateText<Scale>{exact_text(epoch, static_cast<const TimeScale&>(scale)), scale};
}

}  // namespace vectrix
