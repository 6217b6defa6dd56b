#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <vectrix/space/earth/earth_orientation.hpp>

namespace vectrix::detail {

/// The complete rows of a file in the format finals2000A; see EarthOrientation::read.
std::pair<std::vector<Epoch>, std::vector<EarthOrientationParameters>> read_finals2000A(
    const std::filesystem::path& file);

/// The epoch in UTC where UTC is known, else in TT, for messages.
std::string shown(const Epoch& epoch);

}  // namespace vectrix::detail
