// Any file is a series that answers from its first to its last row, or is refused.
#include <vectrix/space/earth/earth_orientation.hpp>

#include "input_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) try {
  const vectrix::fuzz::InputFile file(bytes, size);
  const auto orientation = vectrix::EarthOrientation::read(file.path());
  for (const auto& epoch : {orientation.first(), orientation.last()}) {
    static_cast<void>(orientation.parameters(epoch));
  }
  return 0;
} catch (const vectrix::BadInput&) {
  return 0;
}
