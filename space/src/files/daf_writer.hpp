#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace vectrix::detail {

/// An array that is to be written: the summary without its addresses, and the numbers.
struct DafArrayToWrite {
  std::string name;
  std::vector<double> doubles;
  std::vector<std::int32_t> integers;
  std::vector<double> numbers;
};

/// Bytes in front of a line that a transfer as text would change: line ends, zeros, characters above 127.
inline constexpr std::string_view daf_transfer_check("FTPSTR:\r:\n:\r\n:\r\0:\x81:\x10\xce:ENDFTP", 28);

/// The bytes of a DAF file with one array, the smaller byte first. Lines of the comments end with a line end.
std::string daf_bytes_of(const std::string& kind, const DafArrayToWrite& array, const std::string& comments);

}  // namespace vectrix::detail
