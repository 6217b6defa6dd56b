#include "kernel_writer.hpp"

#include "figures.hpp"
#include "new_file.hpp"
#include "plain_words.hpp"
#include "word.hpp"

namespace vectrix::cli {

PlainAttitude as_in_a_kernel(PlainAttitude attitude) {
  attitude.computed.emplace_back(
      "the quaternions are divided by their norms, and ticks computed from the times");
  if (attitude.rates.empty()) return attitude;
  if (attitude.rates_in_degrees) {
    for (Eigen::Vector3d& w : attitude.rates) w /= degrees;
    attitude.computed.emplace_back("the rates are converted from deg/s to rad/s");
  }
  if (attitude.rate_axes == RateAxes::body) {
    for (std::size_t i = 0; i < attitude.rates.size(); ++i) {
      const auto& n = attitude.quaternions[i];
      attitude.rates[i] = Eigen::Quaterniond(n[0], n[1], n[2], n[3]).normalized() * attitude.rates[i];
    }
    attitude.computed.push_back("the rates are turned to the axes of " + attitude.reference);
  }
  attitude.rates_in_degrees = false;
  attitude.rate_axes = RateAxes::reference;
  return attitude;
}

void write_kernel(const PlainAttitude& attitude, const KernelWords& words, double longest_step,
                  const std::filesystem::path& out, bool force) {
  struct Body : moving_frame {};
  using earth::Gcrf;
  if (const std::string missing =
          missing_of({{"--sclk FILE", words.clock}, {"--ck-frame NAME", words.frame}});
      !missing.empty())
    throw BadInput(out.string() +
                   ": a kernel has times of a clock and a numbered frame; missing: " + missing);
  if (attitude.reference != "GCRF")
    throw BadInput(out.string() +
                   ": a kernel is relative to J2000, which is GCRF there, and the attitude to " +
                   attitude.reference + "; --frame GCRF turns it");
  std::vector<AttitudeSample<Gcrf, Body, Epoch>> samples;
  std::vector<AngularVelocity<Gcrf, Body, In<Gcrf>>> rates;
  for (std::size_t i = 0; i < attitude.times.size(); ++i) {
    const auto& n = attitude.quaternions[i];
    samples.push_back(
        {attitude.times[i],
         Quaternion<Gcrf, Body>{detail::trusted, Eigen::Quaterniond(n[0], n[1], n[2], n[3]).normalized()}});
    if (!attitude.rates.empty()) rates.emplace_back(detail::trusted, attitude.rates[i]);
  }
  in_plain_words(out.string(), [&] {
    const auto frames = words.frames.empty() ? FrameKernel() : FrameKernel::read(words.frames);
    const auto body = called<Body>(words.frame);
    const std::int32_t frame = frames.attitude_id_of(detail::claim_of<Body>(body));
    constexpr std::int32_t frames_of_a_spacecraft = 1000;
    const auto clock =
        SpacecraftClock::read(words.clock, frames.clock_of(frame).value_or(frame / frames_of_a_spacecraft));
    const AttitudeKernelText text{"ATTITUDE", longest_step * si::second};
    write_new(
        out,
        [&](const std::filesystem::path& part) {
          try {
            if (rates.empty()) {
              write_attitude_kernel(part, text, samples, clock, frames, body);
            } else {
              write_attitude_kernel(part, text, samples, rates, clock, frames, body);
            }
          } catch (const BadInput& error) {  // without the name of a part of a file
            const std::string why = error.what(), before = "attitude kernel " + part.string() + ": ";
            throw BadInput(why.starts_with(before) ? why.substr(before.size()) : why);
          }
        },
        force);
  });
}

}  // namespace vectrix::cli
