#pragma once

#include <filesystem>
#include <utility>
#include <vector>

#include <vectrix/space/earth/earth_orientation.hpp>

namespace vectrix::detail {

/// The complete rows of a file in the format finals2000A, at least four, without rates; see
/// EarthOrientation::read.
std::pair<std::vector<Epoch>, std::vector<EarthOrientationParameters>> read_finals2000A(
    const std::filesystem::path& file, bool offsets_are_from_iau_2006);

}  // namespace vectrix::detail
