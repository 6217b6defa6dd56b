// Any file is a table of leap seconds, which is one for the process and comes back from it, or is refused.
#include <vectrix/space/time/leap_seconds.hpp>

#include "input_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace vectrix;
  static const auto installed = leap_seconds();
  const fuzz::InputFile file(bytes, size);
  const auto used = fuzz::accepted([&] {
    auto table = read_leap_seconds(file.path());
    use_leap_seconds(table);
    return table;
  });
  if (used && leap_seconds() != *used) std::abort();
  use_leap_seconds(installed);
  return 0;
}
