#pragma once

#include <algorithm>
#include <limits>
#include <vector>
#include <vectrix/kinematics/attitude/log.hpp>

namespace vectrix {

/// One line of an attitude file, between two frames known to the compiler: q_b^a at a time. The sign of the
/// quaternion does not matter.
template <Frame A, Frame B, class S = double> struct AttitudeSample {
  Quantity<si::time, S> time;
  Quaternion<A, B, S> q_a_from_b;
};
template <class A, class B, class S>
AttitudeSample(const Quantity<si::time, S>&, const Quaternion<A, B, S>&) -> AttitudeSample<A, B, S>;

namespace detail {

/// RotationSpline of Body relative to Gcrf:
template <class A, class B> std::string samples_place(const char* what) {
  return std::string(what) + " of " + frame_name<B>() + " relative to " + frame_name<A>() + ": ";
}

/// Throws BadInput for fewer than `least` samples, and for times that are not finite or do not increase.
template <class A, class B, class S>
void require_samples(const char* what, const std::vector<AttitudeSample<A, B, S>>& samples,
                     std::size_t least) {
  const auto refuse = [&](const std::string& why) { throw BadInput(samples_place<A, B>(what) + why); };
  if (samples.size() < least) {
    refuse("the number of samples is " + text(samples.size()) + ", at least " + text(least) + " are needed");
  }
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const S t = samples[i].time.value();
    if (!(t - t == S(0))) refuse("the time of sample " + text(i) + " is " + text(t) + " s");
    if (i == 0) continue;
    const S before = samples[i - 1].time.value();
    if (t == before)
      refuse("samples " + text(i - 1) + " and " + text(i) + " have one time, " + text(t) + " s");
    if (t < before)
      refuse("the time of sample " + text(i) + ", " + text(t) + " s, is before that of sample " +
             text(i - 1) + ", " + text(before) + " s");
    // Its inverse is a number, too.
    const S step = t - before;
    if (!(S(1) / (step * step) - S(1) / (step * step) == S(0)) || !(step - step == S(0)))
      refuse("samples " + text(i - 1) + " and " + text(i) + " are " + text(step) + " s apart");
  }
}

template <class A, class B, class S> void require_longest_gap(const char* what, const S& longest_gap) {
  if (!(longest_gap > S(0)) || !(longest_gap - longest_gap == S(0))) {
    throw BadInput(samples_place<A, B>(what) + "the longest gap is " + text(longest_gap) + " s");
  }
}

/// The segment [t0, t1) of samples in which t is; the last one is closed. Throws BadInput outside of them.
template <class A, class B, class Segments, class S>
std::size_t segment_at(const char* what, const Segments& segments, const S& t) {
  if (!(t >= segments.front().start && t <= segments.back().end)) {
    throw BadInput(samples_place<A, B>(what) + "time " + text(t) + " s is outside [" +
                   text(segments.front().start) + ", " + text(segments.back().end) + "] s");
  }
  const auto above =
      std::upper_bound(segments.begin(), segments.end(), t,
                       [](const S& time, const auto& segment) { return time < segment.start; });
  return static_cast<std::size_t>(above - segments.begin()) - 1;
}

/// The turn from one sample to the next in the axes of b, by the shortest way.
template <class A, class B, class S>
Column<S> turn_between(const Quaternion<A, B, S>& from, const Quaternion<A, B, S>& until) {
  return log(Quaternion<A, B, S>{trusted, from.eigen().conjugate() * until.eigen()}).coordinates();
}

}  // namespace detail
}  // namespace vectrix
