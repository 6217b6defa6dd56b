#pragma once

#include <optional>
#include <string>
#include <vector>

#include "convert.hpp"
#include "interpolation.hpp"
#include "sources.hpp"

namespace vectrix::cli {

/// What the options say of an attitude, or of both an attitude and an orbit, before the file tells whether it
/// is a table. Empty: not given.
struct AttitudeWords {
  std::filesystem::path file;
  std::string segment{}, from{}, until{};
  std::string time{}, scale{}, reference{};  // of a table
  std::string quaternion{}, scalar{}, maps{}, rates{}, rate_unit{}, rate_axes{};
  KernelWords kernel{};
};
/// What the options say of a table of an orbit.
struct OrbitWords {
  std::string position{}, velocity{}, unit{};
};
struct InterpolationWords {
  std::string method{}, degree{};
};
/// What the options say of a message that is to be written.
struct MessageWords {
  std::string object_name{}, object_id{}, originator{}, body{}, aem_version{};
  InterpolationWords interpolation{};
};

/// No convention is taken that nobody has stated, and no option is given in vain. Throws BadInput that names
/// the options which a table misses, or one that does not apply to this file.
/// The words of a kernel may be of the one that is written.
AttitudeSource attitude_source(const AttitudeWords& words, bool writes_kernel = false);
OrbitFile orbit_file(const AttitudeWords& words, const OrbitWords& orbit);

/// Throws BadInput for an option that is not of elements.
ElementFile element_file(const AttitudeWords& words, const OrbitWords& orbit, ConvertOptions& options,
                         const MessageWords& message);

/// Takes the satellite from the options, which have no other use for it. Throws BadInput for an option that
/// is not of an orbit without samples.
SampledOrbit sampled_orbit_of(const AttitudeWords& words, const OrbitWords& orbit, ConvertOptions& options,
                              const std::string& step);

/// What is to be converted, and what a combined message has besides, "OEM, 2 APM".
struct Content {
  enum class Kind { attitude, orbit, sampled, elements };  // sampled: an orbit that has no samples
  Kind kind;
  std::string left_out{};
};
/// Of a table, --position and --velocity say that it is an orbit; of a combined message, `kind` or `out` says
/// it. Elements are an orbit if there is a step, or `out` is of samples. Throws BadInput as
/// kind_to_convert(), and for an option that is not of such a file.
Content content_of(const AttitudeWords& words, const OrbitWords& orbit, const std::string& kind,
                   const std::filesystem::path& out, const std::string& step = "");
/// Throws BadInput for an orbit, which only an attitude can need.
void refuse_orbit_words(const ConvertOptions& options);
/// Throws BadInput for an option that what is to be written has not.
void set_message_words(ConvertOptions& options, const MessageWords& words, bool of_orbit);

/// Nothing if it is not given. Throws BadInput for half of it, and a degree that the method does not have.
std::optional<Interpolation> interpolation_of(const InterpolationWords& words);
/// Throws BadInput for an interpolation without --oem, and a satellite without elements.
void set_orbit_words(OrbitSource& orbit, const InterpolationWords& words);

}  // namespace vectrix::cli
