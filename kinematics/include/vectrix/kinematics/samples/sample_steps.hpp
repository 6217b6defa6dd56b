#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>
#include <vectrix/kinematics/samples/instant.hpp>

namespace vectrix::detail {

/// The steps between the instants of samples, and the search for the step that contains an instant. Steps are
/// [t_i, t_(i+1)); the last one is closed. `place` names the sampled quantity at the start of messages.
template <Instant I> class SampleSteps {
 public:
  using Scalar = InstantScalar<I>;

  /// Throws BadInput for fewer than two instants, for instants that are not finite or do not increase, and
  /// for a longest gap that is not positive and finite.
  SampleSteps(std::string place, const std::vector<I>& instants, const Scalar& longest_gap)
      : place_(std::move(place)), longest_gap_(longest_gap) {
    require_instants(place_, instants, 2);
    if (!(longest_gap > Scalar(0)) || !(longest_gap - longest_gap == Scalar(0)))
      refuse("the longest gap is " + text(longest_gap) + " s");
    for (std::size_t i = 1; i < instants.size(); ++i)
      steps_.push_back({instants[i - 1], Scalar((instants[i] - instants[i - 1]).value())});
    steps_.push_back({instants.back(), Scalar(0)});
    const Scalar whole = (instants.back() - instants.front()).value();
    if (!(whole - whole == Scalar(0))) refuse("the samples span " + text(whole) + " s");
    steps_per_second_ = Scalar(static_cast<double>(size())) / whole;
  }

  /// Throws BadInput for fewer than `least` instants, or for instants that are not finite or do not increase.
  static void require_instants(const std::string& place, const std::vector<I>& instants, std::size_t least) {
    const auto refuse = [&](const std::string& why) { throw BadInput(place + ": " + why); };
    if (instants.size() < least)
      refuse("the number of samples is " + text(instants.size()) + ", at least " + text(least) +
             " are needed");
    for (std::size_t i = 0; i < instants.size(); ++i) {
      const I& t = instants[i];
      if (!((t - t).value() == Scalar(0))) refuse("the time of sample " + text(i) + " is " + instant_text(t));
      if (i == 0) continue;
      const I& before = instants[i - 1];
      const std::string pair = "samples " + text(i - 1) + " and " + text(i);
      const Scalar step = (t - before).value();
      if (t < before)
        refuse("the time of sample " + text(i) + ", " + instant_text(t) + ", is before that of sample " +
               text(i - 1) + ", " + instant_text(before));
      if (!(before < t)) refuse(pair + " have one time, " + instant_text(t));
      // 1/step^2 must be finite, too.
      const Scalar inverse = Scalar(1) / (step * step);
      if (!(inverse - inverse == Scalar(0)) || !(step - step == Scalar(0)))
        refuse(pair + " are " + text(step) + " s apart");
    }
  }

  std::size_t size() const { return steps_.size() - 1; }
  const Scalar& duration(std::size_t i) const { return steps_[i].duration; }

  struct Found {
    std::size_t step;
    Scalar since;  ///< s, since the start of the step
  };
  /// Throws BadInput outside the samples and inside a step longer than the longest gap. The last sample
  /// before a gap belongs to the step before it.
  Found at(const I& t) const {
    const Scalar since_first = (t - steps_.front().start).value();
    if (!(since_first >= Scalar(0)) || steps_.back().start < t) [[unlikely]]
      refuse_range(t);
    // Equal steps are found directly, others by bisection.
    const auto guess = static_cast<std::size_t>(
        static_cast<double>(without_derivatives(Scalar(since_first * steps_per_second_))));
    const std::size_t i = std::min(guess, size() - 1);
    const Scalar since = (t - steps_[i].start).value();
    if (since >= Scalar(0) && since < steps_[i].duration && steps_[i].duration <= longest_gap_) [[likely]]
      return {i, since};
    return searched(t);
  }

  [[noreturn]] void refuse(const std::string& why) const { throw BadInput(place_ + ": " + why); }

 private:
  struct Step {
    I start;
    Scalar duration;
  };

  [[gnu::noinline]] Found searched(const I& t) const {
    const auto above = std::upper_bound(steps_.begin(), steps_.end() - 1, t,
                                        [](const I& time, const Step& step) { return time < step.start; });
    const auto here = above - 1;
    const auto i = static_cast<std::size_t>(here - steps_.begin());
    if (here->duration <= longest_gap_) return {i, Scalar((t - here->start).value())};
    if (!(here->start < t) && i > 0 && (here - 1)->duration <= longest_gap_)
      return {i - 1, (here - 1)->duration};
    refuse_gap(t, *here);
  }
  [[noreturn, gnu::cold, gnu::noinline]] void refuse_range(const I& t) const {
    refuse("the time " + instant_text(t) + " is outside the samples, [" + instant_text(steps_.front().start) +
           ", " + instant_text(steps_.back().start) + "]");
  }
  [[noreturn, gnu::cold, gnu::noinline]] void refuse_gap(const I& t, const Step& gap) const {
    refuse("the time " + instant_text(t) + " is in a gap of " + text(gap.duration) +
           " s after the sample at " + instant_text(gap.start) + "; the longest allowed is " +
           text(longest_gap_) + " s");
  }

  std::string place_;
  Scalar longest_gap_;
  Scalar steps_per_second_;
  std::vector<Step> steps_;  // the last sample is a step of zero duration
};

}  // namespace vectrix::detail
