#pragma once

#include <utility>
#include <vector>
#include <vectrix/frames/graph/edge.hpp>
#include <vectrix/kinematics/points/parallel.hpp>
#include <vectrix/kinematics/samples/attitude_sample.hpp>
#include <vectrix/kinematics/samples/hermite.hpp>
#include <vectrix/kinematics/samples/sample_steps.hpp>

namespace vectrix {

/// One line of an orbit file: position and velocity of the origin of the frame q relative to a, observed from
/// a, at a time or at an instant of another type.
template <Frame A, Frame Q, Instant I = Quantity<si::time>> struct PositionSample {
  I time;
  PointMotion<A, Q, A, InstantScalar<I>> motion;
};
template <class I, class A, class Q, class S>
PositionSample(const I&, const PointMotion<A, Q, A, S>&) -> PositionSample<A, Q, I>;

/// The position between samples: hermite() of the two samples around t. Claims that the axes of q are
/// parallel to those of a, so that q does not rotate. Its acceleration, which jumps at the samples, is not
/// given: InterpolatedPosition has one, and with Hermite{3} it is this cubic. Throws BadInput as
/// SampledAttitude does.
template <Frame A, Frame Q, Instant I = Quantity<si::time>> class SampledPosition {
  using S = InstantScalar<I>;

 public:
  SampledPosition(std::vector<PositionSample<A, Q, I>> samples, const Quantity<si::time, S>& longest_gap)
      : samples_(std::move(samples)),
        steps_(detail::samples_place<A, Q>("SampledPosition"), detail::instants_of(samples_),
               longest_gap.value()) {}
  template <class Given>
  SampledPosition(  // samples of q in a
      const std::vector<Given>&, const Quantity<si::time, S>&) = delete;

  MovingTransform<A, Q, S> operator()(const I& t) const {
    const auto [i, since] = steps_.at(t);
    return parallel(hermite(samples_[i].motion, samples_[i + 1].motion,
                            Quantity<si::time, S>::from_value(steps_.duration(i)),
                            Quantity<si::time, S>::from_value(since)));
  }

 private:
  std::vector<PositionSample<A, Q, I>> samples_;
  detail::SampleSteps<I> steps_;
};

/// A SampledPosition as an edge of a frame graph.
template <class A, class Q, class I>
FunctionEdge<SampledPosition<A, Q, I>> sampled_edge(const std::vector<PositionSample<A, Q, I>>& samples,
                                                    const Quantity<si::time, InstantScalar<I>>& longest_gap) {
  return edge(SampledPosition<A, Q, I>(samples, longest_gap));
}

}  // namespace vectrix
