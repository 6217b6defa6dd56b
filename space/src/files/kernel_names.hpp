#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace vectrix::detail {

/// The numbers of frames that every kernel may use without defining them.
inline constexpr std::int32_t j2000_id = 1, ecliptic_j2000_id = 17, itrf93_id = 13000;

std::optional<std::int32_t> id_of_frame(std::string_view name);
std::optional<std::string> name_of_frame(std::int32_t id);

/// Of the solar system's barycentre, the Sun, the planets, their barycentres, and the Moon.
std::optional<std::int32_t> id_of_body(std::string_view name);
std::optional<std::string> name_of_body(std::int32_t id);

/// "-152950000". Nothing for a name.
std::optional<std::int32_t> kernel_id(std::string_view text);

}  // namespace vectrix::detail
