#include "run.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>

#include <vectrix/frames/errors.hpp>

#include "check.hpp"
#include "interpolant.hpp"

namespace vectrix::ode {
namespace {

using vectrix::detail::text;

constexpr double steps_per_segment = 5.0;  // at least, so that a segment has the six nodes of dense output

std::unique_ptr<Stepper> make_stepper(const Problem& problem, Rate& rate) {
  const bool multistep = problem.method == Method::cvode_adams || problem.method == Method::cvode_bdf;
  return multistep ? make_cvode_stepper(problem, rate) : make_arkode_stepper(problem, rate);
}

}  // namespace

Run::Run(const Problem& problem)
    : problem_(problem),
      rate_(problem),
      stepper_(make_stepper(problem, rate_)),
      roots_(problem),
      record_(std::make_shared<Record>()),
      state_(problem.initial_state),
      slope_(problem.initial_state.size()) {
  record_->dimension = problem.initial_state.size();
  record_->start = problem.start;
}

Solution Run::operator()() {
  try {
    integrate();
  } catch (const Trouble& trouble) {
    fail(trouble);
  }
  fill_outputs();
  return Solution(record_);
}

void Run::integrate() {
  roots_.start(problem_.start, state_);
  segment_start_ = problem_.start;
  for (const double end : segment_ends()) {
    segment_end_ = end;
    rate_.enter_segment(segment_start_, segment_end_);
    record_->segments.push_back(record_->times.size());
    append(0.0, rate_(0.0, state_, slope_) ? 0 : flag::rhs_failed);
    integrate_segment();
    if (record_->stopped) return;
    roots_.resolve(*record_);
    segment_start_ = segment_end_;
  }
}

std::vector<double> Run::segment_ends() const {
  std::vector<double> ends;
  std::ranges::copy_if(problem_.breakpoints, std::back_inserter(ends),
                       [&](double t) { return t > problem_.start && t < problem_.end; });
  ends.push_back(problem_.end);
  return ends;
}

/// If a step passes a stopping root, that step is repeated in at least five shorter steps. The root then has
/// nodes of its own scale on both sides, and the rate is never evaluated beyond the end of the original step.
/// All times count from the start of the segment.
void Run::integrate_segment() {
  const double end = segment_end_ - segment_start_;
  const double longest = std::min(problem_.maximum_step, end / steps_per_segment);
  restart(0.0, end, longest);
  bool retaking = false;
  double target = end;
  while (true) {
    const double before = record_->elapsed.back();
    const double t = step();
    append(t, stepper_->rate(t, slope_));
    if (roots_.advance(*record_)) {
      if (retaking) {
        stop_at_first_stopping_event();
        return;
      }
      roots_.retreat();
      record_->pop();
      std::ranges::copy(record_->state(record_->times.size() - 1), state_.begin());
      retaking = true;
      target = t;
      restart(before, target, (target - before) / steps_per_segment);
    } else if (t == end) {
      return;
    } else if (t == target) {  // because of rounding, the zero is now later than this step
      retaking = false;
      target = end;
      restart(t, target, longest);
    }
  }
}

void Run::restart(double elapsed, double stop, double longest) {
  const int flag = stepper_->restart(elapsed, state_, stop, longest);
  if (flag < 0) raise(flag, time(elapsed));
}

/// The caller's time: exactly the end of the segment only there.
double Run::time(double elapsed) const {
  if (elapsed >= segment_end_ - segment_start_) return segment_end_;
  return std::min(segment_start_ + elapsed,
                  std::nextafter(segment_end_, -std::numeric_limits<double>::infinity()));
}

/// Returns the time reached, since the start of the segment; the state is in state_. Takes more steps while
/// they are too short to change the caller's time.
double Run::step() {
  const double before = record_->times.back();
  double t = record_->elapsed.back();
  while (!(time(t) > before)) {
    if (record_->statistics.steps >= problem_.max_steps) {
      throw Trouble{flag::too_many_steps, before, "max_steps = " + text(problem_.max_steps) + " reached",
                    nullptr};
    }
    const int flag = stepper_->step(t);
    if (flag < 0) raise(flag, before);
    ++record_->statistics.steps;
  }
  std::ranges::copy(stepper_->state(), state_.begin());
  return t;
}

/// Appends state_ and slope_ as a node. Raises the error if the slope could not be computed.
void Run::append(double elapsed, int rate_flag) {
  if (rate_flag < 0) raise(rate_flag, time(elapsed));
  record_->push(time(elapsed), elapsed, state_, slope_);
}

void Run::stop_at_first_stopping_event() {
  roots_.resolve(*record_);
  auto& events = record_->events;
  const auto first =
      std::ranges::find_if(events, [&](const Event& e) { return problem_.roots[e.root].stop; });
  const double stop = first->time;
  std::rotate(first, first + 1, std::ranges::upper_bound(events, stop, {}, &Event::time));
  events.erase(std::ranges::upper_bound(events, stop, {}, &Event::time), events.end());
  if (stop < record_->times.back()) {
    state_ = events.back().state;
    record_->pop();
    const double elapsed = stop - segment_start_;
    append(elapsed, rate_(elapsed, state_, slope_) ? 0 : flag::rhs_failed);
  }
  record_->stopped = true;
}

void Run::fill_outputs() {
  auto& record = *record_;
  record.statistics.rhs_evaluations = rate_.evaluations();
  record.statistics.error_test_failures = stepper_->error_test_failures();
  if (record.times.empty()) return;
  const auto reached = std::ranges::upper_bound(problem_.output_times, record.times.back());
  record.output_times.assign(problem_.output_times.begin(), reached);
  record.outputs.resize(record.output_times.size() * record.dimension);
  for (std::size_t i = 0; i < record.output_times.size(); ++i) {
    interpolate(record, record.output_times[i],
                std::span(record.outputs).subspan(i * record.dimension, record.dimension));
  }
}

/// An error of the right-hand side says more than the SUNDIALS flag that follows from it.
void Run::raise(int flag, double t) const {
  if (rate_.cause())
    throw Trouble{flag::rhs_failed, rate_.trouble_time(), "the right-hand side threw", rate_.cause()};
  if (!rate_.trouble().empty())
    throw Trouble{flag::rhs_failed, rate_.trouble_time(), rate_.trouble(), nullptr};
  throw Trouble{flag, t, stepper_->message(), nullptr};
}

void Run::fail(const Trouble& trouble) {
  auto& record = *record_;
  if (!record.segments.empty() && record.segments.back() == record.times.size()) record.segments.pop_back();
  roots_.resolve_what_can_be(record);
  fill_outputs();
  std::string message = problem_.caller + ": failed at t = " + text(trouble.time) + " after " +
                        text(record.statistics.steps) + " steps with flag " + text(trouble.flag) + " (" +
                        stepper_->flag_name(trouble.flag) + "): " + trouble.text;
  const auto failure = [&] {
    return Failure(message, trouble.time, record.statistics.steps, trouble.flag, Solution(record_));
  };
  if (!trouble.cause) {
    const std::string below = tolerance_below_rounding(problem_, state_);
    if (!below.empty()) message += "; " + below;
    throw failure();
  }
  try {
    std::rethrow_exception(trouble.cause);
  } catch (const std::exception& cause) {
    message += std::string(": ") + cause.what();
    std::throw_with_nested(failure());
  } catch (...) {
    std::throw_with_nested(failure());
  }
}

}  // namespace vectrix::ode
