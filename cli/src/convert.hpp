#pragma once

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>

#include "interpolation.hpp"
#include "message_text.hpp"
#include "orbit_record.hpp"
#include "sampled_orbit.hpp"
#include "sources.hpp"

namespace vectrix::cli {

struct ConvertOptions {
  std::filesystem::path out;  // .aem, .oem, .omm, .xml, .bc, .csv, .czml or .a says what is written
  std::string frame{};        // EME2000 or GCRF, relative to which it is to be; empty for that of the file
  GivenText text{};           // of a message
  std::string body{};  // the name of its frame in a message; empty for that of the message that was read
  std::string aem_version = "2.0";
  bool force = false;
  KernelWords kernel{};                 // of a kernel of SPICE that is written: its clock and its frame
  OrbitSource orbit{};                  // to turn an attitude relative to a frame of the orbit
  std::filesystem::path orientation{};  // of the Earth, to turn one relative to ITRF
  std::optional<Interpolation> interpolation{};  // of an OEM; nothing for that of the message that was read
};

/// Writes an attitude as an AEM, or as a table with the scalar first, where R(q) takes coordinates to the
/// reference. Times and numbers are those of the file to the last digit, in another order or with another
/// sign, unless `out` is told what had to be computed. Throws BadInput, before anything is written.
void convert(const AttitudeSource& attitude, const ConvertOptions& options, std::ostream& out);

/// Writes an orbit as an OEM, of the version of the message that was read or 2.0, or as a table in m and m/s.
void convert(const OrbitFile& orbit, const ConvertOptions& options, std::ostream& out);

/// The same of one that has no samples.
void convert(const SampledOrbit& orbit, const ConvertOptions& options, std::ostream& out);

/// A file of elements for SGP4: two lines, or messages.
struct ElementFile {
  std::filesystem::path file;
};
/// Whether the file has two-line elements. Throws BadInput if it cannot be read.
bool has_two_lines(const std::filesystem::path& file);
/// Writes elements as orbit mean-elements messages, each number with the digits that it has.
void convert(const ElementFile& elements, const ConvertOptions& options, std::ostream& out);

}  // namespace vectrix::cli
