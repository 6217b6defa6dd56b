// Any file is an attitude ephemeris message or is refused. The text of a message reads back as the same text,
// and its attitudes have unit quaternions.
#include <vectrix/space/files/attitude_ephemeris_message.hpp>

#include "input_file.hpp"

namespace {

struct Reference : vectrix::moving_frame {};
struct Body : vectrix::moving_frame {};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace vectrix;
  const fuzz::InputFile file(bytes, size);
  const auto message = fuzz::accepted([&] { return AttitudeEphemerisMessage::read(file.path()); });
  if (!message) return 0;
  const std::string text = message->text();
  if (AttitudeEphemerisMessage::parse(text).text() != text) std::abort();
  constexpr double rounding = 1e-15;
  for (const auto& segment : message->segments()) {
    const auto a = called<Reference>(segment.ref_frame_a());
    const auto b = called<Body>(segment.ref_frame_b());
    const auto nearest = segment.nearest_samples<Reference, Body>(a, b);
    for (const auto& sample : nearest.samples) {
      if (!(std::abs(sample.q_a_from_b.eigen().norm() - 1.0) < rounding)) std::abort();
    }
    if (nearest.distance <= unit_norm_tolerance) static_cast<void>(segment.samples<Reference, Body>(a, b));
    fuzz::accepted([&] { return segment.angular_velocities<Reference, Body>(in<Body>, a, b); });
  }
  return 0;
}
