#include "kernel_chain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "attitude_kernel_record.hpp"
#include "check.hpp"
#include "resampled.hpp"
#include "sample_faults.hpp"
#include "says.hpp"
#include "scenario/replayed.hpp"
#include "space/tests/files/daf_text.hpp"

namespace vectrix::cli::kernel_chain_test {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

// A gimbal turns about its x, which is z of a craft, and that about its y, which is z of J2000:
//     q_gimbal^j2000 = (cos a + k sin a)(cos b + i sin b), with half the angles, a = A t / 2 and b = B t / 2
//     w = B i + A k of J2000, in the gimbal (B, A sin B t, A cos B t), in J2000 (B cos A t, B sin A t, A)
constexpr double A = 0.02, B = -0.03;  // rad/s
Quaterniond j2000_from_gimbal(double t) {
  const double a = 0.5 * A * t, b = 0.5 * B * t;
  return {std::cos(a) * std::cos(b), std::cos(a) * std::sin(b), std::sin(a) * std::sin(b),
          std::sin(a) * std::cos(b)};
}
Vector3d rate_in_gimbal(double t) {
  return {B, A * std::sin(B * t), A * std::cos(B * t)};
}
Vector3d rate_in_j2000(double t) {
  return {B * std::cos(A * t), B * std::sin(A * t), A};
}

constexpr int craft = -77001, gimbal = -77002, camera = -77003, j2000 = 1;
constexpr double rounding = 1e-10;  // rad, rad/s: ticks of 0.01 s have 1e-11 s near 2000

Epoch at(double seconds) {
  return Epoch::from_tt("2000-01-01T12:00:00") + seconds * si::second;
}

// Records each `step` s of a turn at a rate in the base, of a frame whose axes are those of the base at the
// start, turned.
DafTestArray turning(int frame, int base, const Vector3d& w, double step,
                     const std::vector<std::pair<double, double>>& intervals, bool has_rates = true,
                     const Quaterniond& frame_from_start = Quaterniond::Identity()) {
  std::vector<double> numbers, ticks, starts;
  for (const auto& [from, until] : intervals) {
    starts.push_back(100.0 * from);
    for (int i = 0; from + i * step <= until; ++i) {
      const double t = from + i * step;
      const Quaterniond turn(Eigen::AngleAxisd(w.norm() * t, w.normalized()));
      const Quaterniond q = frame_from_start * turn.conjugate();  // v_frame = R(q) v_base
      numbers.insert(numbers.end(), {q.w(), q.x(), q.y(), q.z()});
      if (has_rates) numbers.insert(numbers.end(), w.begin(), w.end());
      ticks.push_back(100.0 * t);
    }
  }
  numbers.insert(numbers.end(), ticks.begin(), ticks.end());
  numbers.insert(numbers.end(), starts.begin(), starts.end());
  numbers.insert(numbers.end(), {static_cast<double>(starts.size()), static_cast<double>(ticks.size())});
  return {"TURN", {ticks.front(), ticks.back()}, {frame, base, 3, has_rates ? 1 : 0}, numbers};
}
// x to y, y to z, z to x.
const Quaterniond cycle(0.5, 0.5, 0.5, 0.5);
DafTestArray of_craft(double step = 2.0, bool has_rates = true) {
  return turning(craft, j2000, {0.0, 0.0, A}, step, {{0.0, 100.0}}, has_rates, cycle.conjugate());
}
DafTestArray of_gimbal(double step = 5.0) {
  return turning(gimbal, craft, {0.0, 0.0, B}, step, {{20.0, 60.0}, {70.0, 120.0}}, true, cycle);
}

class KernelChain : public ::testing::Test {
 protected:
  [[nodiscard]] KernelWords words(const std::string& frame, const std::string& kernel = "") const {
    KernelWords words;
    words.clock =
        folder
            .written("c.tsc",
                     "\\begindata\nSCLK_DATA_TYPE_77 = 1 SCLK01_TIME_SYSTEM_77 = 2 SCLK01_N_FIELDS_77 "
                     "= 2\nSCLK01_MODULI_77 = ( 1e12 100 ) SCLK01_OFFSETS_77 = ( 0 0 )\n"
                     "SCLK_PARTITION_START_77 = 0 SCLK_PARTITION_END_77 = 1e15\n"
                     "SCLK01_COEFFICIENTS_77 = ( 0 0 1.0 )\n")
            .string();
    words.frame = frame;
    if (!kernel.empty()) words.frames = folder.written("f.tf", "\\begindata\n" + kernel).string();
    return words;
  }
  [[nodiscard]] std::filesystem::path kernel(const std::vector<DafTestArray>& segments) const {
    return folder.written("a.bc", daf_bytes("CK", segments));
  }
  [[nodiscard]] AttitudeRecord read(const std::vector<DafTestArray>& segments, const KernelWords& words,
                                    const Selection& selection = {}) const {
    return read_kernel(kernel(segments), words, selection);
  }
  [[nodiscard]] std::string refused(const std::vector<DafTestArray>& segments,
                                    const KernelWords& words) const {
    const auto file = kernel(segments);
    return complaint([&] { (void)read_kernel(file, words, {}); }, file);
  }

  TemporaryFolder folder;
};

double seconds(const Epoch& t) {
  return (t - at(0.0)).value();
}

// The samples are the craft's, which has most, where both are known; their numbers and rates those of the
// closed form, in whatever order the file has the two.
TEST_F(KernelChain, MultipliesFramesOfOneFile) {
  for (const auto& segments : {std::vector{of_craft(), of_gimbal()}, std::vector{of_gimbal(), of_craft()}}) {
    const auto record = read(segments, words("-77002"));
    EXPECT_EQ(record.reference, "GCRF");
    EXPECT_EQ(record.body, "-77002");
    std::vector<double> times;
    for (int t = 20; t <= 60; t += 2) times.push_back(t);
    for (int t = 70; t <= 100; t += 2) times.push_back(t);
    ASSERT_EQ(record.size(), times.size());
    ASSERT_EQ(record.rates.size(), times.size());
    for (std::size_t i = 0; i < times.size(); ++i) {
      EXPECT_NEAR(seconds(record.times[i]), times[i], rounding);
      EXPECT_LT(record.to_reference(i, record.stated).angularDistance(j2000_from_gimbal(times[i])), rounding);
      EXPECT_LT((record.rates[i] - rate_in_j2000(times[i])).norm(), rounding);
    }
    ASSERT_EQ(record.interval_starts.size(), 2U);
    EXPECT_NEAR(seconds(record.interval_starts[1]), 70.0, rounding);
    EXPECT_EQ(
        record.chain,
        "-77002 relative to -77001 for 90 s, -77001 relative to 'J2000' (1) for 100 s; all of them for 70 s");
  }
}

// Between samples the product is no steady turn: by slerp it would be 3e-4 rad off.
TEST_F(KernelChain, MovesBetweenItsSamplesAsItsFactors) {
  const auto record = read({of_craft(), of_gimbal()}, words("-77002"));
  for (const double t : {21.0, 44.4, 59.9, 77.7}) {
    const auto now = step_at(record, at(t)).at;
    EXPECT_LT(now.to_reference.angularDistance(j2000_from_gimbal(t)), rounding) << t;
    EXPECT_LT((now.rate - rate_in_gimbal(t)).norm(), rounding) << t;
  }
  for (const double t : {65.0, 105.0})
    EXPECT_TRUE(says(complaint([&] { (void)step_at(record, at(t)); }), "is in a gap or outside")) << t;
}

// The times that are asked for are cut from factors whose records are outside of them.
TEST_F(KernelChain, IsOfTheTimesThatAreAskedFor) {
  Selection selection;
  selection.from = at(31.0);
  selection.until = at(33.0);
  const auto record = read({of_craft(100.0), of_gimbal()}, words("-77002"), selection);
  ASSERT_EQ(record.size(), 2U);
  EXPECT_LT(record.to_reference(1, record.stated).angularDistance(j2000_from_gimbal(33.0)), rounding);
}

// A camera that is mounted on the gimbal by a quarter of a turn about z, v_gimbal = R v_camera.
TEST_F(KernelChain, GoesOnOverMountedFrames) {
  const std::string mounted =
      "FRAME_CAM = -77003 FRAME_-77003_NAME = 'CAM' FRAME_-77003_CLASS = 4 FRAME_-77003_CLASS_ID = -77003\n"
      "FRAME_-77003_CENTER = -77 TKFRAME_-77003_RELATIVE = 'GIM' TKFRAME_-77003_SPEC = 'MATRIX'\n"
      "TKFRAME_-77003_MATRIX = ( 0 1 0 -1 0 0 0 0 1 )\n"
      "FRAME_GIM = -77002 FRAME_-77002_NAME = 'GIM' FRAME_-77002_CLASS = 3 FRAME_-77002_CLASS_ID = -77002\n"
      "FRAME_-77002_CENTER = -77\n";
  const auto record = read({of_craft(), of_gimbal()}, words("CAM", mounted));
  EXPECT_EQ(record.body, "CAM");
  const Quaterniond gimbal_from_camera(std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5));
  const auto now = step_at(record, at(44.4)).at;
  EXPECT_LT(now.to_reference.angularDistance(j2000_from_gimbal(44.4) * gimbal_from_camera), rounding);
  EXPECT_LT((now.rate - gimbal_from_camera.conjugate() * rate_in_gimbal(44.4)).norm(), rounding);
  EXPECT_LT((record.rates[3] - rate_in_j2000(26.0)).norm(), rounding);
  EXPECT_TRUE(says(record.chain, "'CAM' (-77003) relative to 'GIM' (-77002), mounted, "));
}

// The ecliptic of SPICE is turned about x: a vector along its pole.
TEST_F(KernelChain, EndsInTheEclipticOrOnTheEarth) {
  constexpr int ecliptic = 17, itrf93 = 13000;
  const Vector3d none(0.0, 0.0, 1e-12);
  const auto of_ecliptic = read({turning(craft, ecliptic, none, 10.0, {{0.0, 50.0}})}, words("-77001"));
  constexpr double sine = 0.3977771559, cosine = 0.9174820621;  // of 84381.448 arcsec
  const Vector3d pole = of_ecliptic.to_reference(2, of_ecliptic.stated) * Vector3d::UnitZ();
  EXPECT_LT((pole - Vector3d(0.0, -sine, cosine)).norm(), 1e-9);  // by the digits of the constants
  EXPECT_EQ(of_ecliptic.reference, "GCRF");
  EXPECT_EQ(read({turning(craft, itrf93, none, 10.0, {{0.0, 50.0}})}, words("-77001")).reference, "ITRF");
}

TEST_F(KernelChain, RefusesWhatHasNoProduct) {
  const auto on = [](int frame, int base) {
    return turning(frame, base, {B, 0.0, 0.0}, 5.0, {{20.0, 60.0}});
  };
  EXPECT_EQ(
      refused({on(gimbal, craft)}, words("-77002")),
      "FILE: it has -77002 relative to -77001, whose attitude is neither in this file nor known: 'J2000' "
      "(1), 'ECLIPJ2000' (17) and 'ITRF93' (13000) are, and frames that a frame kernel has mounted on "
      "others");
  EXPECT_EQ(refused({on(gimbal, craft), on(craft, gimbal)}, words("-77002")),
            "FILE: the frame -77002 is relative to itself, by way of others");
  EXPECT_EQ(
      refused({on(gimbal, craft), on(gimbal, camera), of_craft()}, words("-77002")),
      "FILE: it has -77002 relative to -77003 and to -77001 in these times; times with one of them must be "
      "asked for");
  const auto later = turning(gimbal, craft, {B, 0.0, 0.0}, 5.0, {{200.0, 260.0}});
  EXPECT_EQ(
      refused({of_craft(), later}, words("-77002")),
      "FILE: it has -77002 relative to -77001 for 60 s, -77001 relative to 'J2000' (1) for 100 s; all of "
      "them for 0 s");
  const std::string fixed =
      "FRAME_CAM = -77003 FRAME_-77003_NAME = 'CAM' FRAME_-77003_CLASS = 4 FRAME_-77003_CLASS_ID = -77003\n"
      "FRAME_-77003_CENTER = -77 TKFRAME_-77003_RELATIVE = 'J2000' TKFRAME_-77003_SPEC = 'ANGLES'\n"
      "TKFRAME_-77003_UNITS = 'DEGREES' TKFRAME_-77003_ANGLES = ( 0 0 0 ) TKFRAME_-77003_AXES = ( 1 2 3 )\n";
  EXPECT_EQ(refused({of_craft()}, words("CAM", fixed)),
            "FILE: it has no attitude of 'CAM' (-77003), which is mounted on 'J2000' (1)");
}

TEST_F(KernelChain, LeavesOutRatesThatOneFactorDoesNotHave) {
  const auto record = read({of_craft(2.0, false), of_gimbal()}, words("-77002"));
  EXPECT_TRUE(record.rates.empty());
  EXPECT_TRUE(says(record.chain, "; without rates, which -77001 does not have"));
}

// The rates of the product fit its turns, and check says what was multiplied.
TEST_F(KernelChain, IsChecked) {
  CheckOptions options;
  options.attitude.file = kernel({of_craft(), of_gimbal()});
  options.attitude.kernel = words("-77002");
  std::ostringstream out;
  EXPECT_TRUE(check(options, out)) << out.str();
  EXPECT_TRUE(says(out.str(), "Multiplied from what the kernel has: -77002 relative to -77001 for 90 s, "));
}

// In a scenario, at instants between the samples.
TEST_F(KernelChain, IsReplayed) {
  const auto file = kernel({of_craft(), of_gimbal()});
  const auto made = replayed_file(folder.written(
      "s.toml", "version = 1\ntitle = \"T\"\n[time]\nstep = \"1.5 s\"\n[attitude]\nfile = \"" +
                    file.string() + "\"\nclock = \"" + words("").clock +
                    "\"\nkernel_frame = \"-77002\"\n[[measure]]\nname = \"off-Sun\"\naxis = \"x of "
                    "-77002\"\ntarget = \"sun\"\ncorrection = \"geometric\"\n"));
  const auto& attitude = made.flight.attitude;
  ASSERT_GT(attitude.size(), 40U);
  for (std::size_t i = 0; i < attitude.size(); ++i)
    EXPECT_LT(attitude.to_reference(i, attitude.stated)
                  .angularDistance(j2000_from_gimbal(seconds(attitude.times[i]))),
              rounding);
  const auto choices = made.report().choices;
  EXPECT_TRUE(std::any_of(choices.begin(), choices.end(), [](const auto& choice) {
    return choice.what == "multiplied from what the kernel has";
  }));
}

}  // namespace
}  // namespace vectrix::cli::kernel_chain_test
