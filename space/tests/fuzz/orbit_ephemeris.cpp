// Any file is an orbit ephemeris message or is refused. The text of a message reads back as the same text,
// and its samples make a motion or are refused.
#include <vectrix/space/files/orbit_ephemeris_message.hpp>

#include "input_file.hpp"

namespace {

struct Axes : vectrix::inertial_frame {};
struct Satellite : vectrix::moving_frame {};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace vectrix;
  const fuzz::InputFile file(bytes, size);
  const auto message = fuzz::accepted([&] { return OrbitEphemerisMessage::read(file.path()); });
  if (!message) return 0;
  const std::string text = message->text();
  if (OrbitEphemerisMessage::parse(text).text() != text) std::abort();
  for (const auto& segment : message->segments()) {
    const auto claim = called<Axes>(segment.ref_frame(), segment.metadata().center_name);
    const auto samples = segment.samples<Axes, Satellite>(claim);
    const auto motion =
        fuzz::accepted([&] { return segment.sampled_edge<Axes, Satellite>(1e6 * si::second, claim); });
    if (motion) fuzz::accepted([&] { return (*motion)(samples.front().time); });
  }
  return 0;
}
