#pragma once

#include <vector>
#include <vectrix/frames/graph/edge.hpp>
#include <vectrix/kinematics/samples/attitude_sample.hpp>
#include <vectrix/kinematics/samples/sample_steps.hpp>
#include <vectrix/kinematics/samples/slerp.hpp>

namespace vectrix {
namespace detail {

/// The numbers of an attitude between its samples: q_b^a and w_ab^b.
template <Instant I> class SampledTurns {
  using S = InstantScalar<I>;

 public:
  template <class Samples>
  SampledTurns(const std::string& place, const Samples& samples, const S& longest_gap)
      : steps_(place, instants_of(samples), longest_gap) {
    turns_.reserve(steps_.size());
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      const auto& q0 = samples[i].q_a_from_b.eigen();
      const Column<S> theta =
          turn_between(Quaternion<FirstSample, NextSample, S>{trusted, q0},
                       Quaternion<FirstSample, NextSample, S>{trusted, samples[i + 1].q_a_from_b.eigen()});
      turns_.push_back({{q0, theta}, theta / steps_.duration(i)});
    }
  }

  Eigen::Quaternion<S> quaternion(const I& t) const {
    const auto [i, since] = steps_.at(t);
    return turns_[i].turn.at(S(since / steps_.duration(i)));
  }
  template <class Make> auto motion(const I& t, const Make& make) const {
    const auto [i, since] = steps_.at(t);
    return make(turns_[i].turn.at(S(since / steps_.duration(i))), turns_[i].rate);
  }

 private:
  struct FirstSample : moving_frame {};
  struct NextSample : moving_frame {};
  struct Turn {
    ConstantTurn<S> turn;
    Column<S> rate;
  };

  SampleSteps<I> steps_;
  std::vector<Turn> turns_;
};

}  // namespace detail

/// The attitude between samples: the Slerp of the two samples around t. Its rate is constant between samples
/// and jumps at them. It has no acceleration; RotationSpline has one. The constructor throws BadInput for
/// fewer than two samples or times that do not increase; a call does so outside the samples or inside a step
/// longer than `longest_gap`.
template <Frame A, Frame B, Instant I = Quantity<si::time>> class SampledAttitude {
  using S = InstantScalar<I>;

 public:
  SampledAttitude(const std::vector<AttitudeSample<A, B, I>>& samples,
                  const Quantity<si::time, S>& longest_gap)
      : turns_(detail::samples_place<A, B>("SampledAttitude"), samples, longest_gap.value()) {}
  template <class Given>
  SampledAttitude(  // samples of b relative to a
      const std::vector<Given>&, const Quantity<si::time, S>&) = delete;

  MovingDcm<A, B, S> operator()(const I& t) const {
    return turns_.motion(t, [](const Eigen::Quaternion<S>& q, const detail::Column<S>& w) {
      return MovingDcm<A, B, S>{dcm(Quaternion<A, B, S>{detail::trusted, q}),
                                AngularVelocity<A, B, In<B>, S>{detail::trusted, w}};
    });
  }

 private:
  detail::SampledTurns<I> turns_;
};

/// A SampledAttitude as an edge of a frame graph. A NamedGraph has a function of the same name.
template <class A, class B, class I>
FunctionEdge<SampledAttitude<A, B, I>> sampled_edge(const std::vector<AttitudeSample<A, B, I>>& samples,
                                                    const Quantity<si::time, InstantScalar<I>>& longest_gap) {
  return edge(SampledAttitude<A, B, I>(samples, longest_gap));
}

}  // namespace vectrix
