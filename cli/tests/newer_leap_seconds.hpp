#pragma once

#include <string>
#include <vector>

#include <vectrix/space.hpp>

#include "temporary_folder.hpp"

namespace vectrix::cli {

/// The process has its leap seconds again when this ends.
class KeptLeapSeconds {
 public:
  KeptLeapSeconds() = default;
  KeptLeapSeconds(const KeptLeapSeconds&) = delete;
  KeptLeapSeconds& operator=(const KeptLeapSeconds&) = delete;
  ~KeptLeapSeconds() { use_leap_seconds(table_); }

 private:
  std::vector<LeapSecond> table_ = leap_seconds();
};

/// A kernel with all leap seconds but the last, that of 2017, and then these: "37, @2017-JAN-1".
inline std::string leap_second_kernel(const std::string& last) {
  std::string text = content(VECTRIX_SOURCE_DIR "/space/tests/data/naif0012.tls");
  const std::string known = "37,   @2017-JAN-1";
  return text.replace(text.find(known), known.size(), last);
}
inline constexpr const char* with_an_invented_one = "37, @2017-JAN-1\n38, @2035-JAN-1";

}  // namespace vectrix::cli
