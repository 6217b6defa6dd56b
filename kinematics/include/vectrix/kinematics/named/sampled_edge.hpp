#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>
#include <vectrix/kinematics/attitude/log.hpp>
#include <vectrix/kinematics/named/edge.hpp>
#include <vectrix/kinematics/named/quaternion.hpp>

namespace vectrix {

/// One line of an attitude file. The sign of the quaternion does not matter.
struct NamedSample {
  Quantity<si::time> time;
  NamedQuaternion q_a_from_b;
};

namespace detail {

struct CosineSine {
  double cosine, sine;
};

/// cos and sin of an angle in [0, pi/2]. Neighbouring samples are mostly near: up to a quarter radian a
/// series, whose first terms left out are below 1e-17 of the result, does without a call.
inline CosineSine small_turn(double x) {
  if (x > 0.25) return {std::cos(x), std::sin(x)};
  const double s = x * x;
  const double cosine =
      1.0 + s * (-1.0 / 2 +
                 s * (1.0 / 24 +
                      s * (-1.0 / 720 + s * (1.0 / 40320 + s * (-1.0 / 3628800 + s * (1.0 / 479001600))))));
  const double sine =
      x +
      x * s * (-1.0 / 6 + s * (1.0 / 120 + s * (-1.0 / 5040 + s * (1.0 / 362880 + s * (-1.0 / 39916800)))));
  return {cosine, sine};
}

/// Slerp between neighbouring samples (see slerp.hpp), in the form that needs one sine and one cosine:
///     q(t) = q0 cos(phi) + q0 n sin(phi),  phi = (|theta|/2) (t - t0)/(t1 - t0),  theta = |theta| n
class SampledFunction final : public EdgeFunction {
 public:
  SampledFunction(NamedFrame a, NamedFrame b, const std::vector<NamedSample>& samples, double longest_gap)
      : EdgeFunction(Level::rate),
        a_(a),
        b_(b),
        first_(samples.front().time.value()),
        last_(samples.back().time.value()),
        longest_gap_(longest_gap) {
    segments_.reserve(samples.size() - 1);
    for (std::size_t i = 1; i < samples.size(); ++i) segments_.push_back(segment(samples[i - 1], samples[i]));
    segments_per_second_ = static_cast<double>(segments_.size()) / (last_ - first_);
  }

  Square<double> rotation(double t) const override { return quaternion(t).toRotationMatrix(); }
  bool in_quaternions() const override { return true; }
  Eigen::Quaterniond quaternion(double t) const override { return quaternion(at(t), t); }
  EdgeMotion motion(double t) const override {
    const Segment& here = at(t);
    return {quaternion(here, t).toRotationMatrix(), here.w, {}};
  }

 private:
  struct Segment {
    double start, duration, half_rate;
    Eigen::Vector4d q0, q0_n;
    Column<double> w;
  };

  static Segment segment(const NamedSample& from, const NamedSample& until) {
    const Eigen::Quaterniond& q0 = from.q_a_from_b.eigen();
    const Quaternion<FirstNamed, SecondNamed> turn{trusted, q0.conjugate() * until.q_a_from_b.eigen()};
    const Column<double> theta = log(turn).coordinates();
    const double angle = scaled_norm(theta);
    const Column<double> n = angle > 0.0 ? Column<double>(theta / angle) : Column<double>::Zero();
    const double duration = until.time.value() - from.time.value();
    return {from.time.value(),
            duration,
            angle / 2 / duration,
            q0.coeffs(),
            (q0 * Eigen::Quaterniond(0.0, n.x(), n.y(), n.z())).coeffs(),
            theta / duration};
  }

  static Eigen::Quaterniond quaternion(const Segment& here, double t) {
    const double phi = here.half_rate * (t - here.start);
    const auto [cosine, sine] = small_turn(phi);
    return Eigen::Quaterniond(Eigen::Vector4d(cosine * here.q0 + sine * here.q0_n));
  }

  /// The segment [t0, t1) of t; the last one is closed.
  const Segment& at(double t) const {
    if (!(t >= first_ && t <= last_)) [[unlikely]]
      refuse_range(t);
    // Samples at equal steps are found at once, others by bisection.
    const Segment& guess = segments_[std::min(static_cast<std::size_t>((t - first_) * segments_per_second_),
                                              segments_.size() - 1)];
    const double since = t - guess.start;
    const bool right = since >= 0.0 && since < guess.duration;
    if (right && guess.duration <= longest_gap_) [[likely]]
      return guess;
    return searched(t);
  }

  [[gnu::noinline]] const Segment& searched(double t) const {
    const auto above =
        std::upper_bound(segments_.begin(), segments_.end(), t,
                         [](double time, const Segment& segment) { return time < segment.start; });
    const auto here = above - 1;
    if (here->duration <= longest_gap_) return *here;
    // The last sample before a gap ends the segment before it.
    if (t == here->start && here != segments_.begin() && (here - 1)->duration <= longest_gap_)
      return *(here - 1);
    refuse_gap(t, *here);
  }

  std::string described_at(double t) const {
    return "the edge " + in_quotes(a_) + " - " + in_quotes(b_) + ": the time " + text(t) + " s";
  }
  [[noreturn, gnu::cold, gnu::noinline]] void refuse_range(double t) const {
    throw BadInput(described_at(t) + " is outside the samples, [" + text(first_) + ", " + text(last_) +
                   "] s");
  }
  [[noreturn, gnu::cold, gnu::noinline]] void refuse_gap(double t, const Segment& gap) const {
    throw BadInput(described_at(t) + " is in a gap of " + text(gap.duration) + " s after the sample at " +
                   text(gap.start) + " s; the longest allowed is " + text(longest_gap_) + " s");
  }

  NamedFrame a_, b_;
  double first_, last_, longest_gap_, segments_per_second_;
  std::vector<Segment> segments_;
};

inline void check_samples(const std::vector<NamedSample>& samples, double longest_gap) {
  if (samples.empty()) throw BadInput("sampled_edge: 0 samples; two are needed to interpolate");
  const NamedQuaternion& q0 = samples.front().q_a_from_b;
  const auto refuse = [&q0](const std::string& what) {
    throw BadInput("sampled_edge(q" + to_from(q0.to(), q0.from()) + "): " + what);
  };
  if (samples.size() < 2) refuse(text(samples.size()) + " samples; two are needed to interpolate");
  if (!(longest_gap > 0.0) || !std::isfinite(longest_gap))
    refuse("the longest gap is " + text(longest_gap) + " s");
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const double t = samples[i].time.value();
    const NamedQuaternion& q = samples[i].q_a_from_b;
    if (!std::isfinite(t)) refuse("the time of sample " + text(i) + " is " + text(t) + " s");
    if (q.to() != q0.to() || q.from() != q0.from())
      refuse("sample " + text(i) + " is to " + in_quotes(q.to()) + " from " + in_quotes(q.from()) +
             ", the first to " + in_quotes(q0.to()) + " from " + in_quotes(q0.from()));
    if (i == 0) continue;
    const double before = samples[i - 1].time.value();
    if (t == before)
      refuse("samples " + text(i - 1) + " and " + text(i) + " have one time, " + text(t) + " s");
    if (t < before)
      refuse("the time of sample " + text(i) + ", " + text(t) + " s, is before that of sample " +
             text(i - 1) + ", " + text(before) + " s");
    if (!(t - before >= std::numeric_limits<double>::min()))
      refuse("samples " + text(i - 1) + " and " + text(i) + " are " + text(t - before) + " s apart");
  }
  const double whole = samples.back().time.value() - samples.front().time.value();
  if (!std::isfinite(whole)) refuse("the samples span " + text(whole) + " s");
}

}  // namespace detail

/// The edge that interpolates an attitude file: slerp from sample to sample, by the shortest way. Its rate is
/// that of the interpolation, constant from one sample up to the next, where it jumps; no acceleration.
/// Samples exactly half a turn apart are joined as by Slerp: which of the two ways, the data do not say.
/// Throws BadInput for fewer than two samples, times that do not increase, or frames that differ; and, when
/// asked, outside the samples or inside a step longer than `longest_gap`.
inline NamedEdge sampled_edge(const std::vector<NamedSample>& samples,
                              const Quantity<si::time>& longest_gap) {
  detail::check_samples(samples, longest_gap.value());
  const NamedQuaternion& q = samples.front().q_a_from_b;
  return {detail::trusted, q.to(), q.from(),
          std::make_unique<detail::SampledFunction>(q.to(), q.from(), samples, longest_gap.value())};
}

}  // namespace vectrix
