// Any file is an orbit parameter message or is refused. The text of a message reads back as the same text,
// and the distance of its elements is a number.
#include <vectrix/space/files/orbit_parameter_message.hpp>

#include <cmath>

#include "input_file.hpp"

namespace {

struct Axes : vectrix::inertial_frame {};
struct Satellite : vectrix::moving_frame {};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace vectrix;
  const fuzz::InputFile file(bytes, size);
  const auto message = fuzz::accepted([&] { return OrbitParameterMessage::read(file.path()); });
  if (!message) return 0;
  const std::string text = message->text();
  if (OrbitParameterMessage::parse(text).text() != text) std::abort();
  const auto& state = message->state();
  const auto axes = called<Axes>(state.ref_frame(), state.metadata().center_name);
  if (state.samples<Axes, Satellite>(axes).size() != 1) std::abort();
  if (message->elements() && std::isnan(message->elements_distance().position.value())) std::abort();
  return 0;
}
