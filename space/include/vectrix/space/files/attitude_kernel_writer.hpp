#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include <vectrix/frames/export.hpp>
#include <vectrix/kinematics/rates/angular_velocity.hpp>
#include <vectrix/kinematics/samples/attitude_sample.hpp>
#include <vectrix/space/files/file_frame.hpp>
#include <vectrix/space/files/frame_kernel.hpp>
#include <vectrix/space/files/spacecraft_clock.hpp>

namespace vectrix {

/// What an attitude kernel that is written says of itself. Intervals end where a step is longer than the
/// longest gap: readers interpolate in all shorter ones.
struct AttitudeKernelText {
  std::string segment_name;  ///< of 40 printable characters at most
  Quantity<si::time> longest_gap;
  std::string comments{};
};

namespace detail {

/// Records of b relative to a: q_b^a as the samples have it, w_ab^a.
struct AttitudeKernelNumbers {
  std::vector<Epoch> times;
  std::vector<Eigen::Quaterniond> q_a_from_b;
  std::vector<Eigen::Vector3d> w_ab_a;  // of each, or none
};
// Of another name, for a call that is refused lists its candidates.
VECTRIX_EXPORT void write_kernel_numbers(const std::filesystem::path& file, const AttitudeKernelText& text,
                                         const AttitudeKernelNumbers& numbers, const SpacecraftClock& clock,
                                         const FrameKernel& frames, const FrameClaim& a, const FrameClaim& b);

template <class A, class B>
AttitudeKernelNumbers attitude_kernel_numbers(const std::vector<AttitudeSample<A, B, Epoch>>& samples) {
  AttitudeKernelNumbers numbers;
  for (const auto& [time, q_a_from_b] : samples) {
    numbers.times.push_back(time);
    numbers.q_a_from_b.push_back(q_a_from_b.eigen());
  }
  return numbers;
}

}  // namespace detail

/// Writes an attitude kernel of SPICE, CK of type 3, binary with the smaller byte first:
///     write_attitude_kernel("craft.bc", {"CRAFT ATTITUDE", 20.0 * si::second}, samples, rates, clock,
///     frames,
///                           called<Body>("CRAFT_COORD"))
/// The rates of the format are w_ab^a, in a; others do not compile. The ticks are those of the clock, rounded
/// to a double. Throws BadInput if there are no samples, their ticks do not increase, the clock does not know
/// them or is not that of the frame, rates are not as many, a text cannot be kept, or the file cannot be
/// written.
template <Frame A, Frame B, class... Given>
  requires(detail::are_claims<A, B, Given...>)
void write_attitude_kernel(const std::filesystem::path& file, const AttitudeKernelText& text,
                           const std::vector<AttitudeSample<A, B, Epoch>>& samples,
                           const SpacecraftClock& clock, const FrameKernel& frames, const Given&... called) {
  detail::write_kernel_numbers(file, text, detail::attitude_kernel_numbers(samples), clock, frames,
                               detail::claim_among<A>(called...), detail::claim_among<B>(called...));
}
template <Frame A, Frame B, class... Given>
  requires(detail::are_claims<A, B, Given...>)
void write_attitude_kernel(const std::filesystem::path& file, const AttitudeKernelText& text,
                           const std::vector<AttitudeSample<A, B, Epoch>>& samples,
                           const std::vector<AngularVelocity<A, B, In<A>>>& rates,
                           const SpacecraftClock& clock, const FrameKernel& frames, const Given&... called) {
  auto numbers = detail::attitude_kernel_numbers(samples);
  for (const auto& w_ab_a : rates) numbers.w_ab_a.push_back(w_ab_a.coordinates());
  if (numbers.w_ab_a.size() != samples.size())
    throw BadInput("attitude kernel " + file.string() + ": there are " + detail::text(samples.size()) +
                   " samples and " + detail::text(rates.size()) + " rates");
  detail::write_kernel_numbers(file, text, numbers, clock, frames, detail::claim_among<A>(called...),
                               detail::claim_among<B>(called...));
}
template <class Samples, class... Given>
auto write_attitude_kernel(  // file, text, samples of b relative to a by Epoch, rates in a, clock, frames
    const std::filesystem::path&, const AttitudeKernelText&, const Samples&, const Given&...)
    -> Refused = delete;

}  // namespace vectrix
