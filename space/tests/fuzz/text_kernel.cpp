// Any file is a text kernel or is refused. Its frames are mounted by rotations, a clock in it writes what it
// reads, and its leap seconds are a table; or they are refused.
#include <cmath>

#include <vectrix/space/files/frame_kernel.hpp>
#include <vectrix/space/files/leap_second_kernel.hpp>
#include <vectrix/space/files/spacecraft_clock.hpp>

#include "input_file.hpp"

namespace {

using namespace vectrix;

struct Base : moving_frame {};
struct Mounted : moving_frame {};

void mount(const FrameKernel& frames) {
  constexpr double rounding = 1e-12;
  for (const KernelFrame& one : frames.frames()) {
    for (const KernelFrame& other : frames.frames()) {
      const auto R = fuzz::accepted([&] {
        return frames.nearest_rotation(to<Base>, from<Mounted>, called<Base>(one.name),
                                       called<Mounted>(other.name));
      });
      if (R && !(R->rotation.matrix() * R->rotation.matrix().transpose()).isIdentity(rounding)) std::abort();
    }
  }
}

void count(const TextKernel& kernel, std::int32_t id) {
  const auto clock = fuzz::accepted([&] { return SpacecraftClock::of(kernel, id); });
  if (!clock) return;
  for (const double ticks : {0.0, 17.0, 1e6, 1e12}) {
    const auto text = fuzz::accepted([&] { return clock->text({ticks}); });
    if (text) fuzz::accepted([&] { return clock->ticks(*text); });
    const auto epoch = fuzz::accepted([&] { return clock->epoch({ticks}); });
    if (epoch) fuzz::accepted([&] { return clock->ticks(*epoch); });
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const fuzz::InputFile file(bytes, size);
  const auto kernel = fuzz::accepted([&] { return TextKernel::read(file.path()); });
  if (!kernel) return 0;
  fuzz::accepted([&] { return leap_seconds_of(*kernel); });
  for (const std::int32_t id : {-77, -152950}) count(*kernel, id);
  if (const auto frames = fuzz::accepted([&] { return FrameKernel::of(*kernel); })) mount(*frames);
  return 0;
}
