#include <gtest/gtest.h>

#include <string>
#include <vectrix/space.hpp>

#include "daf_text.hpp"
#include "damage.hpp"
#include "temporary_file.hpp"

// Damaged kernels: they are read, and then attitudes are rotations and orbits are finite, or a BadInput says
// what is wrong.
namespace vectrix::damaged_kernels_test {
namespace {

using earth::Gcrf;

struct Body : moving_frame {};

const DafTestArray attitude{"ATTITUDE", {0.0, 200.0}, {-77001, 1, 3, 1}, {1.0, 0.0,   0.0,   0.0,   0.1, 0.2,
                                                                          0.3, 0.8,   0.6,   0.0,   0.0, 0.1,
                                                                          0.2, 0.3,  // records
                                                                          0.6, 0.8,   0.0,   0.0,   0.1, 0.2,
                                                                          0.3, 0.0,   100.0, 200.0,  // ticks
                                                                          0.0, 200.0, 2.0,   3.0}};
DafTestArray orbit() {
  DafTestArray array{"ORBIT", {0.0, 400.0}, {-77, 399, 1, 13}, {}};
  for (int i = 0; i < 5; ++i) {
    for (int k = 0; k < 6; ++k) array.numbers.push_back(i * k + 1.0);
  }
  array.numbers.insert(array.numbers.end(), {0.0, 100.0, 200.0, 310.0, 400.0, 1.0, 5.0});
  return array;
}

SpacecraftClock clock() {
  return SpacecraftClock::of(
      TextKernel::parse("\\begindata\nSCLK_DATA_TYPE_77=1 SCLK01_N_FIELDS_77=2 SCLK01_MODULI_77=(1e12 100) "
                        "SCLK01_OFFSETS_77=(0 0) SCLK_PARTITION_START_77=0 SCLK_PARTITION_END_77=1e13 "
                        "SCLK01_COEFFICIENTS_77=(0 0 1)\n"),
      -77);
}

// Reads a damaged file to its end, or counts it as refused.
template <class Read> void run(const std::string& bytes, std::uint64_t seed, const Read& read) {
  Damage damage(seed);
  int accepted = 0, refused = 0;
  for (int i = 0; i < 1500; ++i) {
    const TemporaryFile file(damage.of(bytes));
    try {
      read(file.path());
      ++accepted;
    } catch (const BadInput& error) {
      EXPECT_NE(std::string(error.what()).find(file.path().string()), std::string::npos) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(accepted, 100);
  EXPECT_GT(refused, 100);
}

TEST(DamagedKernels, OfAttitudes) {
  const auto ticks = clock();
  for (const bool big : {false, true}) {
    run(daf_bytes("CK", {attitude}, big), 20261129, [&](const std::filesystem::path& path) {
      const auto kernel = AttitudeKernel::open(path, ticks);
      const auto now = kernel.attitude(of<Body>, relative_to<Gcrf>, kernel.span(),
                                       called<Body>("-77001"))(kernel.span().start());
      EXPECT_TRUE((now.rotation.matrix() * now.rotation.matrix().transpose()).isIdentity(1e-12));
    });
  }
}

TEST(DamagedKernels, OfOrbits) {
  run(daf_bytes("SPK", {orbit()}), 20261130, [&](const std::filesystem::path& path) {
    const auto kernel = EphemerisKernel::open(path);
    const auto now = kernel.motion(of<Body>, relative_to<Gcrf>, kernel.span(), called<Body>("-77"))
                         .at(kernel.span().start());
    EXPECT_TRUE(now.position.coordinates().allFinite());
  });
}

}  // namespace
}  // namespace vectrix::damaged_kernels_test
