// Any file is an attitude parameter message or is refused. The text of a message reads back as the same text,
// and its states have unit quaternions or angular velocities.
#include <vectrix/space/files/attitude_parameter_message.hpp>

#include "input_file.hpp"

namespace {

struct Reference : vectrix::moving_frame {};
struct Body : vectrix::moving_frame {};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace vectrix;
  const fuzz::InputFile file(bytes, size);
  const auto message = fuzz::accepted([&] { return AttitudeParameterMessage::read(file.path()); });
  if (!message) return 0;
  const std::string text = message->text();
  if (AttitudeParameterMessage::parse(text).text() != text) std::abort();
  constexpr double rounding = 1e-15;
  for (const auto& state : message->states()) {
    const auto a = called<Reference>(state.ref_frame_a());
    const auto b = called<Body>(state.ref_frame_b());
    if (state.type() == AttitudeType::angular_velocity) {
      fuzz::accepted([&] { return state.angular_velocities<Reference, Body>(in<Body>, a, b); });
    } else {
      const auto nearest = state.nearest_samples<Reference, Body>(a, b);
      if (!(std::abs(nearest.samples.front().q_a_from_b.eigen().norm() - 1.0) < rounding)) std::abort();
    }
  }
  return 0;
}
