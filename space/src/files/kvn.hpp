#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace vectrix::detail {

/// A line of the keyword-value notation of CCSDS, its number, and the column of its value, counted from 1.
///     MEAN_MOTION = 15.49071756 [rev/day]
/// The unit is a part of the value: in names, brackets mean nothing.
struct KvnLine {
  std::string keyword, value;
  std::size_t line, column;
};

/// The line, or nothing if it is blank or a comment. `place` begins the message. Throws
/// BadInput with the column for a line without an equals sign, a keyword that is not of A-Z, 0-9 and _,
/// and characters that are not printable ASCII, which a comment may contain except for control characters.
std::optional<KvnLine> read_kvn_line(const std::string& place, std::size_t number, std::string_view line);

}  // namespace vectrix::detail
