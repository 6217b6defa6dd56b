// Any file is a DAF file or is refused; then it is an attitude or an ephemeris kernel, whose attitudes are
// unit quaternions and whose motions are finite, or is refused.
#include <cmath>

#include <vectrix/space/files/attitude_kernel.hpp>
#include <vectrix/space/files/ephemeris_kernel.hpp>

#include "input_file.hpp"

namespace {

using namespace vectrix;

struct Reference : inertial_frame {};
struct Body : moving_frame {};

SpacecraftClock clock() {
  return SpacecraftClock::of(
      TextKernel::parse("\\begindata\nSCLK_DATA_TYPE_77=1 SCLK01_N_FIELDS_77=2 SCLK01_MODULI_77=(1e12 100)"
                        "SCLK01_OFFSETS_77=(0 0) SCLK_PARTITION_START_77=0 SCLK_PARTITION_END_77=1e13 "
                        "SCLK01_COEFFICIENTS_77=(0 0 1)\n"),
      -77);
}

// Ends the fuzzer if reading asks for more than the file has.
void read_all(const DafFile& daf) {
  for (const DafFile::Array& array : daf.arrays()) {
    if (daf.read(array, 0, array.size).size() != array.size) std::abort();
  }
  fuzz::accepted([&] { return daf.comments(); });
}

void read_attitudes(const std::filesystem::path& file) {
  static const SpacecraftClock ticks = clock();
  const auto kernel = fuzz::accepted([&] { return AttitudeKernel::open(file, ticks); });
  if (!kernel) return;
  constexpr double rounding = 1e-14;
  for (const auto& segment : kernel->segments()) {
    const auto a = called<Reference>(std::to_string(segment.reference));
    const auto b = called<Body>(std::to_string(segment.frame));
    const TimeSpan span = from_until(segment.start, segment.end);
    const auto samples =
        fuzz::accepted([&] { return kernel->samples(of<Body>, relative_to<Reference>, span, a, b); });
    if (samples) {
      for (const auto& sample : *samples) {
        if (!(std::abs(sample.q_a_from_b.eigen().norm() - 1.0) < rounding)) std::abort();
      }
    }
    const auto attitude =
        fuzz::accepted([&] { return kernel->attitude(of<Body>, relative_to<Reference>, span, a, b); });
    if (!attitude) continue;
    for (const double part : {0.0, 0.3, 1.0}) {
      const Epoch t = span.start() + part * (span.end() - span.start());
      const auto now = fuzz::accepted([&] { return (*attitude)(t); });
      if (now && !(now->rotation.matrix() * now->rotation.matrix().transpose()).isIdentity(1e-12))
        std::abort();
    }
  }
}

void read_orbits(const std::filesystem::path& file) {
  const auto kernel = fuzz::accepted([&] { return EphemerisKernel::open(file); });
  if (!kernel) return;
  for (const auto& segment : kernel->segments()) {
    const auto a = called<Reference>("J2000", std::to_string(segment.center));
    const auto q = called<Body>(std::to_string(segment.target));
    const TimeSpan span = from_until(segment.start, segment.end);
    const auto orbit =
        fuzz::accepted([&] { return kernel->motion(of<Body>, relative_to<Reference>, span, a, q); });
    if (!orbit) continue;
    for (const double part : {0.0, 0.3, 1.0}) {
      const Epoch t = span.start() + part * (span.end() - span.start());
      const auto now = fuzz::accepted([&] { return orbit->at(t); });
      if (now && !now->position.coordinates().allFinite()) std::abort();
    }
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  const fuzz::InputFile file(bytes, size);
  if (const auto daf = fuzz::accepted([&] { return DafFile::open(file.path()); })) read_all(*daf);
  read_attitudes(file.path());
  read_orbits(file.path());
  return 0;
}
