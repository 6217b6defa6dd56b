// Any file has messages of mean elements, each of which SGP4 takes or refuses, or is refused.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include <vectrix/space/orbit/orbit_mean_elements_message.hpp>
#include <vectrix/space/orbit/sgp4.hpp>

#include "input_file.hpp"

namespace {

struct Satellite : vectrix::moving_frame {};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) try {
  using namespace vectrix;
  const fuzz::InputFile file(bytes, size);
  for (const auto& message : OrbitMeanElementsMessage::read(file.path())) {
    const Sgp4<Satellite> orbit(message, at_most(24.0 * si::hour));
    if (!orbit.at(message.epoch()).position.coordinates().allFinite()) std::abort();
  }
  return 0;
} catch (const vectrix::BadInput&) {
  return 0;
}
