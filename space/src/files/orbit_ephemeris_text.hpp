#pragma once

#include <vectrix/space/files/orbit_ephemeris_message.hpp>

#include "ephemeris_rules.hpp"

namespace vectrix::detail {

inline constexpr MessageKind orbit_ephemeris{
    "orbit ephemeris message", "CCSDS_OEM_VERS", {"1.0", "2.0", "3.0"}};
inline constexpr const char* orbit_interpolation = "INTERPOLATION";
inline constexpr int kilo = 3;  // kilometres are read as metres

}  // namespace vectrix::detail
