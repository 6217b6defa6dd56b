#pragma once

#include <string>
#include <vector>
#include <vectrix/kinematics/attitude/quaternion.hpp>
#include <vectrix/kinematics/samples/instant.hpp>

namespace vectrix {

/// One line of an attitude file, between two frames known at compile time: q_b^a at a time, or at an instant
/// of another type. The sign of the quaternion does not matter.
template <Frame A, Frame B, Instant I = Quantity<si::time>> struct AttitudeSample {
  I time;
  Quaternion<A, B, InstantScalar<I>> q_a_from_b;
};
template <class I, class A, class B, class S>
AttitudeSample(const I&, const Quaternion<A, B, S>&) -> AttitudeSample<A, B, I>;

namespace detail {

/// RotationSpline of Body relative to Gcrf
template <class A, class B> std::string samples_place(const char* what) {
  return std::string(what) + " of " + frame_name<B>() + " relative to " + frame_name<A>();
}

template <class Sample> auto instants_of(const std::vector<Sample>& samples) {
  std::vector<decltype(Sample::time)> instants;
  instants.reserve(samples.size());
  for (const Sample& sample : samples) instants.push_back(sample.time);
  return instants;
}

}  // namespace detail
}  // namespace vectrix
