#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <vectrix/space.hpp>

#include "files/daf_text.hpp"
#include "temporary_file.hpp"

// The attitude kernels of the tests: that of a flight, and such as the tests write.
namespace vectrix::attitude_kernel_test {

using earth::Gcrf;

struct Ctim : moving_frame {};
struct Body : moving_frame {};
struct Craft : moving_frame {};

inline const std::filesystem::path examples = std::filesystem::path{VECTRIX_SOURCE_DIR} / "examples/data";

// A clock of 100 ticks a second from 2000 on, in TT.
inline SpacecraftClock clock_of(int id, const std::string& rate = "1.0") {
  const std::string end = std::to_string(-id);
  return SpacecraftClock::of(
      TextKernel::parse("\\begindata\nSCLK_DATA_TYPE_" + end + " = 1 SCLK01_TIME_SYSTEM_" + end +
                        " = 2 SCLK01_N_FIELDS_" + end + " = 2 SCLK01_MODULI_" + end +
                        " = ( 1e12 100 ) SCLK01_OFFSETS_" + end + " = ( 0 0 ) SCLK_PARTITION_START_" + end +
                        " = 0 SCLK_PARTITION_END_" + end + " = 1e15 SCLK01_COEFFICIENTS_" + end +
                        " = ( 0 0 " + rate + " )\n"),
      id);
}
inline Epoch at_ticks(double ticks) {
  return Epoch::from_tt("2000-01-01T12:00:00") + ticks / 100.0 * si::second;
}

// Ticks of 0.01 s near 0: an Epoch has 1e-11 s, here of a turn by less than 1 rad/s.
inline constexpr double clock_rounding = 1e-10;

// ---- CTIM, a cubesat in flight ----

inline SpacecraftClock ctim_clock() {
  return SpacecraftClock::read(examples / "CTIM_clock.tsc", -152950);
}
inline AttitudeKernel ctim() {
  return AttitudeKernel::open(examples / "CTIM_20230420_attitude.bc", ctim_clock());
}
inline const auto ctim_frame = called<Ctim>("-152950000");

// ---- kernels that the tests write ----

struct Turn {
  Eigen::Quaterniond q;  // v_body = R(q) v_reference
  Eigen::Vector3d w;     // in the reference
};
inline void add(std::vector<double>& numbers, const Turn& turn, double norm, bool with_rate) {
  for (const double x : {turn.q.w(), turn.q.x(), turn.q.y(), turn.q.z()}) numbers.push_back(norm * x);
  if (with_rate) numbers.insert(numbers.end(), turn.w.begin(), turn.w.end());
}
// A steady turn at w, in the reference: the body's axes turn by w t, so that q_ref_from_body = exp(w t) q0.
inline const Eigen::Vector3d w{0.03, -0.02, 0.05};
inline const Eigen::Quaterniond q0_reference_from_body = Eigen::Quaterniond(0.3, 0.5, -0.7, 0.2).normalized();
inline Turn steady(double seconds) {
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(w.norm() * seconds, w.normalized()));
  return {(turn * q0_reference_from_body).conjugate(), w};
}

inline DafTestArray segment(const std::string& name, int type, bool rates, const std::vector<double>& numbers,
                            double first, double last) {
  return {name, {first, last}, {-77001, 1, type, rates ? 1 : 0}, numbers};
}
inline void add_directory(std::vector<double>& numbers, const std::vector<double>& all) {
  for (std::size_t i = 99; i + 1 < all.size(); i += 100) numbers.push_back(all[i]);
}
/// Records of the steady turn at these ticks; of type 3 with intervals, of type 1 without.
inline DafTestArray steady_segment(const std::string& name, const std::vector<double>& ticks, bool rates,
                                   const std::vector<double>& intervals, double norm = 1.0,
                                   double offset = 0.0) {
  std::vector<double> numbers;
  for (const double t : ticks) add(numbers, steady(t / 100.0 + offset), norm, rates);
  numbers.insert(numbers.end(), ticks.begin(), ticks.end());
  add_directory(numbers, ticks);
  if (!intervals.empty()) {
    numbers.insert(numbers.end(), intervals.begin(), intervals.end());
    add_directory(numbers, intervals);
    numbers.push_back(static_cast<double>(intervals.size()));
  }
  numbers.push_back(static_cast<double>(ticks.size()));
  return segment(name, intervals.empty() ? 1 : 3, rates, numbers, ticks.front(), ticks.back());
}
inline std::vector<double> ticks_from(double first, double step, int count) {
  std::vector<double> ticks;
  for (int i = 0; i < count; ++i) ticks.push_back(first + i * step);
  return ticks;
}

inline AttitudeKernel written(const std::vector<DafTestArray>& arrays, bool big = false) {
  static std::vector<std::unique_ptr<TemporaryFile>> kept;
  kept.push_back(std::make_unique<TemporaryFile>(daf_bytes("CK", arrays, big)));
  auto kernel = AttitudeKernel::open(kept.back()->path(), clock_of(-77));
  kept.clear();  // an open file can be read on
  return kernel;
}
inline KernelAttitude<Gcrf, Body> attitude_of(const AttitudeKernel& kernel) {
  return kernel.attitude(of<Body>, relative_to<Gcrf>, kernel.span(), called<Body>("-77001"));
}

inline void expect_steady(const KernelAttitude<Gcrf, Body>& attitude, double ticks) {
  const auto now = attitude(at_ticks(ticks));
  const Turn turn = steady(ticks / 100.0);
  EXPECT_LT((inverse(now.rotation).matrix() - turn.q.toRotationMatrix()).norm(), clock_rounding) << ticks;
  EXPECT_LT((now.rotation.matrix() * now.angular_velocity.coordinates() - w).norm(), clock_rounding) << ticks;
  EXPECT_LT((attitude.recorded_rate(at_ticks(ticks)).coordinates() - w).norm(), clock_rounding) << ticks;
}

}  // namespace vectrix::attitude_kernel_test
