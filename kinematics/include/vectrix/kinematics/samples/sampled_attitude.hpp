#pragma once

#include <vectrix/frames/graph/edge.hpp>
#include <vectrix/kinematics/samples/attitude_sample.hpp>
#include <vectrix/kinematics/samples/slerp.hpp>

namespace vectrix {

/// The attitude between samples: the Slerp of the two beside t. Its rate is constant from one sample up to
/// the next, where it jumps; it knows no acceleration: RotationSpline does. Throws BadInput for fewer than
/// two samples or times that do not increase; and, when asked, outside the samples or inside a step longer
/// than `longest_gap`.
template <Frame A, Frame B, class S = double> class SampledAttitude {
 public:
  SampledAttitude(const std::vector<AttitudeSample<A, B, S>>& samples,
                  const Quantity<si::time, S>& longest_gap)
      : longest_gap_(longest_gap.value()) {
    detail::require_samples("SampledAttitude", samples, 2);
    detail::require_longest_gap<A, B>("SampledAttitude", longest_gap_);
    for (std::size_t i = 1; i < samples.size(); ++i) {
      const auto& from = samples[i - 1];
      const auto& until = samples[i];
      segments_.push_back({from.time.value(), until.time.value(),
                           Slerp<A, B, S>(from.time, from.q_a_from_b, until.time, until.q_a_from_b)});
    }
  }
  template <class Given>
  SampledAttitude(  // samples of b relative to a
      const std::vector<Given>&, const Quantity<si::time, S>&) = delete;

  MovingDcm<A, B, S> operator()(const Quantity<si::time, S>& t) const {
    std::size_t i = detail::segment_at<A, B>("SampledAttitude", segments_, t.value());
    if (in_gap(i)) {
      // The last sample before a gap ends the segment before it.
      if (!(t.value() == segments_[i].start && i > 0 && !in_gap(i - 1))) refuse_gap(t.value(), segments_[i]);
      --i;
    }
    return segments_[i].turn(t);
  }

 private:
  struct Segment {
    S start, end;
    Slerp<A, B, S> turn;
  };

  bool in_gap(std::size_t i) const { return segments_[i].end - segments_[i].start > longest_gap_; }
  [[noreturn, gnu::cold, gnu::noinline]] void refuse_gap(const S& t, const Segment& gap) const {
    throw BadInput(detail::samples_place<A, B>("SampledAttitude") + "time " + detail::text(t) +
                   " s is in a gap of " + detail::text(S(gap.end - gap.start)) + " s after the sample at " +
                   detail::text(gap.start) + " s; the longest allowed is " + detail::text(longest_gap_) +
                   " s");
  }

  S longest_gap_;
  std::vector<Segment> segments_;
};

/// The edge of a frame graph that a SampledAttitude is; the same word as of a NamedGraph.
template <class A, class B, class S>
FunctionEdge<SampledAttitude<A, B, S>, MovingDcm<A, B, S>> sampled_edge(
    const std::vector<AttitudeSample<A, B, S>>& samples, const Quantity<si::time, S>& longest_gap) {
  return edge(SampledAttitude<A, B, S>(samples, longest_gap));
}

}  // namespace vectrix
