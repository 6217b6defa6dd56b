// Any file is a series that answers from its first to its last row, or is refused.
#include <vectrix/space/earth/earth_orientation.hpp>

#include "input_file.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace vectrix;
  const fuzz::InputFile file(bytes, size);
  const auto orientation = fuzz::accepted([&] { return EarthOrientation::read(file.path()); });
  if (!orientation) return 0;
  for (const auto& epoch : {orientation->first(), orientation->last()}) {
    static_cast<void>(orientation->parameters(epoch));
  }
  return 0;
}
