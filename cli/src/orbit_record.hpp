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

/// Throws BadInput as the message or the table does, for times that do not increase, and for fewer than two
/// samples. Of a table the reference must be EME2000 or GCRF.
OrbitRecord read_orbit_file(const OrbitFile& source);
/// The same of a table in ITRF too.
OrbitRecord read_orbit_in_any_frame(const OrbitFile& source);

/// In EME2000 or GCRF instead. Covariances keep their frame, and name it. Throws BadInput if the orbit is in
/// neither of the two.
OrbitRecord relative_to_frame(OrbitRecord record, const std::string& reference);

}  // namespace vectrix::cli
