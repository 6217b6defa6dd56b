// Any file has messages of mean elements, each of which SGP4 takes or refuses, or is refused. What it takes
// has a finite state at its epoch, or has decayed.
#include <vectrix/space/orbit/orbit_mean_elements_message.hpp>
#include <vectrix/space/orbit/sgp4.hpp>

#include "input_file.hpp"

namespace {

struct Satellite : vectrix::moving_frame {};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace vectrix;
  const fuzz::InputFile file(bytes, size);
  const auto messages = fuzz::accepted([&] { return OrbitMeanElementsMessage::read(file.path()); });
  if (!messages) return 0;
  for (const auto& message : *messages) {
    const auto motion = fuzz::accepted(
        [&] { return Sgp4<Satellite>(message, at_most(24.0 * si::hour)).at(message.epoch()); });
    if (motion && !motion->position.coordinates().allFinite()) std::abort();
  }
  return 0;
}
