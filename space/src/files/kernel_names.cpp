#include "kernel_names.hpp"

#include <charconv>

#include "kvn.hpp"

namespace vectrix::detail {
namespace {

struct KernelName {
  std::int32_t id;
  std::string_view name;
};
// The first name of a number is shown.
constexpr KernelName frame_names[] = {
    {j2000_id, "J2000"}, {ecliptic_j2000_id, "ECLIPJ2000"}, {itrf93_id, "ITRF93"}};
constexpr KernelName body_names[] = {{0, "SOLAR SYSTEM BARYCENTER"},
                                     {0, "SSB"},
                                     {1, "MERCURY BARYCENTER"},
                                     {2, "VENUS BARYCENTER"},
                                     {3, "EARTH BARYCENTER"},
                                     {3, "EARTH MOON BARYCENTER"},
                                     {3, "EMB"},
                                     {4, "MARS BARYCENTER"},
                                     {5, "JUPITER BARYCENTER"},
                                     {6, "SATURN BARYCENTER"},
                                     {7, "URANUS BARYCENTER"},
                                     {8, "NEPTUNE BARYCENTER"},
                                     {9, "PLUTO BARYCENTER"},
                                     {10, "SUN"},
                                     {199, "MERCURY"},
                                     {299, "VENUS"},
                                     {399, "EARTH"},
                                     {301, "MOON"},
                                     {499, "MARS"},
                                     {401, "PHOBOS"},
                                     {402, "DEIMOS"},
                                     {599, "JUPITER"},
                                     {699, "SATURN"},
                                     {799, "URANUS"},
                                     {899, "NEPTUNE"},
                                     {999, "PLUTO"}};

template <std::size_t N>
std::optional<std::int32_t> id_among(const KernelName (&names)[N], std::string_view name) {
  const std::string capitals = upper_case(std::string{name});
  for (const KernelName& known : names) {
    if (known.name == capitals) return known.id;
  }
  return std::nullopt;
}
template <std::size_t N>
std::optional<std::string> name_among(const KernelName (&names)[N], std::int32_t id) {
  for (const KernelName& known : names) {
    if (known.id == id) return std::string{known.name};
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::int32_t> id_of_frame(std::string_view name) {
  return id_among(frame_names, name);
}
std::optional<std::string> name_of_frame(std::int32_t id) {
  return name_among(frame_names, id);
}
std::optional<std::int32_t> id_of_body(std::string_view name) {
  return id_among(body_names, name);
}
std::optional<std::string> name_of_body(std::int32_t id) {
  return name_among(body_names, id);
}

std::optional<std::int32_t> kernel_id(std::string_view text) {
  std::int32_t id = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), id);
  if (text.empty() || error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return id;
}

}  // namespace vectrix::detail
