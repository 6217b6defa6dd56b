#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "message_text.hpp"
#include "selection.hpp"

namespace vectrix::cli {

/// The names of the columns of a table of an orbit, and what its numbers mean.
struct OrbitColumns {
  std::string time;
  TimeScale scale = scale::utc;
  std::vector<std::string> position, velocity;  // three each
  bool in_kilometres = false;                   // and km/s; else m and m/s
  std::string reference;                        // EME2000, GCRF or ITRF
};
struct OrbitFile {
  std::filesystem::path file;
  std::optional<OrbitColumns> columns{};  // of a table; a message says them itself
  Selection selection{};
};

/// An orbit as a file has it, in m, m/s and m/s^2: kilometres have the same digits.
struct OrbitRecord {
  std::string file;
  TimeScale time_scale = scale::utc;
  std::optional<MessageText> message{};  // of a message
  detail::OrbitLines lines;
  std::vector<std::string> computed{};  // which numbers are not those of the file, and why
};

/// Throws BadInput as the message or the table does, for times that do not increase, for fewer than two
/// samples, and for a table in a frame that is none of earth_frame_name().
OrbitRecord read_orbit_file(const OrbitFile& source);

/// In another frame of earth_frame_name() instead, observed from it:
///     r^new = R_old^new r^old,    v^new = R_old^new (v^old + w x r^old),    w of the old axes relative to
///     the new
/// Covariances keep their frame, and name it. Accelerations are left out where axes turn. Throws BadInput for
/// an orbit in another frame, in one of date that REF_FRAME_EPOCH stops, or about another centre than the
/// Earth where axes turn, and as earth_frame() does.
OrbitRecord relative_to_frame(OrbitRecord record, const std::string& reference,
                              const std::optional<EarthOrientation>& orientation);

}  // namespace vectrix::cli
