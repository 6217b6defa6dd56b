#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

#include "sources.hpp"

namespace vectrix::cli {

struct ConvertOptions {
  AttitudeSource attitude;
  std::filesystem::path out;  // .aem or .csv says what is written
  std::string frame{};        // EME2000 or GCRF, in which the attitude is to be; empty for that of the file
  // Of a message; of another message they are taken from that if they are empty.
  std::string object_name{}, object_id{}, originator{}, body{};
  std::string version = "2.0";
  std::string creation_date{};
  bool force = false;
};

/// Writes an attitude as an AEM, or as a table with the scalar first, where R(q) takes coordinates to the
/// reference. Times and numbers are those of the file to the last digit, in another order or with another sign,
/// unless `out` is told what had to be computed. Throws BadInput, before anything is written.
void convert(const ConvertOptions& options, std::ostream& out);

}  // namespace vectrix::cli
