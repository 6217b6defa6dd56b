// Any file is a table of leap seconds, or is refused.
#include <vectrix/frames/errors.hpp>
#include <vectrix/space/time/leap_seconds.hpp>

#include "input_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) try {
  const vectrix::fuzz::InputFile file(bytes, size);
  vectrix::use_leap_seconds(vectrix::read_leap_seconds(file.path()));
  return 0;
} catch (const vectrix::BadInput&) {
  return 0;
}
