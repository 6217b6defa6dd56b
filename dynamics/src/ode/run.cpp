#include "run.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

#include <vectrix/frames/errors.hpp>

#include "check.hpp"
#include "interpolant.hpp"

namespace vectrix::ode {
namespace {

using vectrix::detail::text;

/// At least, so that a segment has the six nodes of dense output, if the method has no interpolant of its
/// own.
constexpr double steps_per_segment = 5.0;
/// With fewer on average it is not the method that needs many steps, but the changes that make many segments.
constexpr std::size_t steps_of_short_segments = 10;

}  // namespace

Run::Run(const Problem& problem, std::unique_ptr<Stepper> stepper)
    : problem_(problem),
      stepper_(std::move(stepper)),
      roots_(problem),
      record_(std::make_shared<Record>()),
      state_(problem.initial_state),
      slope_(problem.initial_state.size()),
      terms_(stepper_->degree() * problem.initial_state.size()) {
  record_->dimension = problem.initial_state.size();
  record_->start = problem.start;
  record_->degree = stepper_->degree();
  record_->sparse = record_->degree > 0 && !problem.dense_output;
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
  const std::vector<double> ends = segment_ends();
  std::vector<Event> ended_by;
  segment_start_ = problem_.start;
  for (auto end = ends.begin(); end != ends.end();) {
    if (problem_.at_segment_start) change(ended_by);
    roots_.start(segment_start_, state_);
    segment_end_ = *end;
    stepper_->enter_segment(segment_start_, segment_end_);
    record_->segments.push_back(record_->times.size());
    ended_by = integrate_segment();
    if (record_->stopped) return;
    RootFinder::Zeros zeros = roots_.take(*record_);
    for (Zero& zero : zeros.located) record_->events.push_back(std::move(zero.event));
    if (!zeros.lost.empty()) throw Trouble(zeros.lost.front().trouble);
    segment_start_ = record_->times.back();
    if (segment_start_ == segment_end_) ++end;
  }
}

void Run::change(std::span<const Event> ended_by) {
  try {
    problem_.at_segment_start(segment_start_, state_, ended_by);
  } catch (...) {
    throw Trouble{flag::rhs_failed, segment_start_,
                  "the change at the start of the segment at t = " + text(segment_start_) + " threw",
                  std::current_exception()};
  }
  const auto bad = std::ranges::find_if_not(state_, [](double y) { return std::isfinite(y); });
  if (bad == state_.end()) return;
  throw Trouble{flag::rhs_failed, segment_start_,
                "the change at the start of the segment at t = " + text(segment_start_) + " sets " +
                    detail::component_name(problem_, static_cast<std::size_t>(bad - state_.begin())) +
                    " to " + text(*bad),
                nullptr};
}

std::vector<double> Run::segment_ends() const {
  std::vector<double> ends;
  std::ranges::copy_if(problem_.breakpoints, std::back_inserter(ends),
                       [&](double t) { return t > problem_.start && t < problem_.end; });
  ends.push_back(problem_.end);
  return ends;
}

/// Returns the events that end the segment early. A root that stops the run or ends the segment is located on
/// the method's own interpolant. Without one, the step that passes it is repeated in at least five shorter
/// steps: the root then has nodes of its own scale on both sides. The rate is never evaluated beyond the end
/// of the step that passes the root. All times count from the start of the segment.
std::vector<Event> Run::integrate_segment() {
  const bool own_interpolant = record_->degree > 0;
  const double end = segment_end_ - segment_start_;
  const double longest =
      own_interpolant ? problem_.maximum_step : std::min(problem_.maximum_step, end / steps_per_segment);
  choose_stop(0.0);
  stepper_->restart(0.0, state_, stop_, longest);
  stepper_->rate_at_restart(slope_);
  record_->push(segment_start_, 0.0, state_, slope_);
  bool retaking = false;
  while (true) {
    const double before = record_->elapsed.back();
    const double t = step();
    stepper_->rate(slope_);
    record_->push(time(t), t, state_, slope_);
    if (own_interpolant) keep_terms();
    const bool ends = roots_.advance(*record_);
    if (ends ? own_interpolant || retaking : roots_.trouble().has_value()) return end_at_first_ending_event();
    if (!kept_for_good_ && roots_.bracketed() == 0) record_->drop_terms();
    if (ends) {
      stop_ = t, stop_time_ = record_->times.back();
      if (roots_.bracketed() > 1) look_again_.push_back(stop_time_);
      roots_.retreat();
      record_->pop();
      std::ranges::copy(record_->state(record_->times.size() - 1), state_.begin());
      retaking = true;
      stepper_->restart(before, state_, stop_, (stop_ - before) / steps_per_segment);
    } else if (t == end) {
      return {};
    } else if (t == stop_) {  // where to look again; or because of rounding a zero is now later
      retaking = false;
      choose_stop(t);
      stepper_->restart(t, state_, stop_, longest);
    }
  }
}

/// The end of the segment, or a time before it where to look again.
void Run::choose_stop(double elapsed) {
  stop_ = segment_end_ - segment_start_, stop_time_ = segment_end_;
  std::erase_if(look_again_,
                [&](double t) { return !(t > segment_start_ + elapsed && t - segment_start_ > elapsed); });
  for (const double t : look_again_)
    if (t < stop_time_) stop_ = t - segment_start_, stop_time_ = t;
}

/// Records the method's interpolant for the last step, if anything asks for it; roots do for the time of the
/// step alone. An interval of several steps has none and needs none: it is some roundings of time long.
void Run::keep_terms() {
  const double from = record_->elapsed.end()[-2], to = record_->elapsed.back();
  const auto& outputs = problem_.output_times;
  const auto output = [&] { return outputs[next_output_] - segment_start_; };
  while (next_output_ < outputs.size() && output() <= from) ++next_output_;
  kept_for_good_ = problem_.dense_output || (next_output_ < outputs.size() && output() < to);
  if (parts_ > 1) return record_->need_no_terms();
  if (!kept_for_good_ && problem_.roots.empty()) return;
  try {
    stepper_->terms(terms_);
  } catch (const Trouble&) {
    // Without them the outputs within the step have no state, and its zeros are not known.
    if (record_->sparse || !problem_.roots.empty()) record_->pop();
    throw;
  }
  record_->add_terms(terms_);
}

/// The caller's time: exactly that of the stop only there.
double Run::time(double elapsed) const {
  if (elapsed >= stop_) return stop_time_;
  return std::min(segment_start_ + elapsed,
                  std::nextafter(stop_time_, -std::numeric_limits<double>::infinity()));
}

std::string Run::what_limits_the_steps() const {
  const std::size_t segments = record_->segments.size();
  if (steps_of_short_segments * segments > record_->statistics.steps) {
    const auto& events = record_->events;
    return ": they are in " + text(segments) + " smooth segments" +
           (!events.empty() && events.back().time == segment_start_
                ? ", the last of which begins at the zero of " + problem_.roots[events.back().root].name
                : "");
  }
  const std::string worst = stepper_->worst_component();
  const std::vector<double>& times = record_->times;
  if (worst.empty() || times.size() < 2) return "";
  return ": the error of " + worst + " allows steps of " + text(times.back() - times[times.size() - 2]) +
         " s; a stiff problem needs radau_iia_7";
}

/// Returns the time reached, since the start of the segment; the state is in state_. Takes more steps while
/// they are too short to change the caller's time.
double Run::step() {
  const double before = record_->times.back();
  double t = record_->elapsed.back();
  for (parts_ = 0; !(time(t) > before); ++parts_) {
    if (record_->statistics.steps >= problem_.max_steps) {
      throw Trouble{flag::too_many_steps, before,
                    "max_steps = " + text(problem_.max_steps) + " reached" + what_limits_the_steps(),
                    nullptr};
    }
    t = stepper_->step();
    ++record_->statistics.steps;
  }
  std::ranges::copy(stepper_->state(), state_.begin());
  return t;
}

/// Ends the record at the first instant at which a root stops the run or ends the segment. If that is not
/// known, because a function did not answer, the run fails: its record ends at the last instant before at
/// which all root functions answered.
std::vector<Event> Run::end_at_first_ending_event() {
  RootFinder::Zeros zeros = roots_.take(*record_);
  const auto ends = [&](const Event& e) { return roots_.ends(e.root); };
  const auto first = std::ranges::find_if(zeros.located, ends, &Zero::event);
  const bool found = first != zeros.located.end();
  try {
    if (!found) throw Trouble(roots_.trouble() ? *roots_.trouble() : zeros.lost.front().trouble);
    roots_.require_known(*first, zeros);
    return end_at(first->event, zeros.located);
  } catch (const Trouble&) {
    double known = found ? std::min(roots_.answered(), first->from) : roots_.answered();
    for (const auto& lost : zeros.lost) known = std::min(known, lost.from);
    keep_until(known);
    for (Zero& zero : zeros.located)
      if (zero.event.time <= record_->times.back() && !ends(zero.event))
        record_->events.push_back(std::move(zero.event));
    throw;
  }
}

/// Takes back the last step, or the part of it after `known`.
void Run::keep_until(double known) {
  Record& record = *record_;
  const std::size_t left = record.times.size() - 2;
  if (known >= record.elapsed[left + 1]) return;
  if (known > record.elapsed[left]) {
    Interpolant(record, left).at(known, state_);
    try {
      stepper_->evaluate(known, state_, slope_);
      return record.shorten(time(known), known, state_, slope_);
    } catch (const Trouble&) {  // the first one says why the run fails
    }
  }
  record.drop_terms();
  record.pop();
}

/// Returns the events at the instant of `first`, which ends the segment: one that stops the run is the last
/// event of all. Zeros after it will be found again, in the next segment, whose steps end where these were
/// seen. A function that had its old sign before this instant and has it no longer there, because of rounding
/// or as it is zero for a while, would not be: its zero is at this instant too.
std::vector<Event> Run::end_at(const Event& first, std::vector<Zero> zeros) {
  const auto stops = [&](const Event& e) { return problem_.roots[e.root].stop; };
  const auto ends = [&](const Event& e) { return roots_.ends(e.root); };
  const double t = first.time, elapsed = t - segment_start_;
  state_ = first.state;
  const bool shorter = t < record_->times.back();
  if (shorter) stepper_->evaluate(elapsed, state_, slope_);
  std::vector<Event> added;
  for (Zero& zero : zeros) {
    Event& event = zero.event;
    if (event.time > t) {
      if (!(zero.from < elapsed && roots_.has_crossed(event, t, state_))) {
        look_again_.insert(look_again_.end(), {time(zero.from), time(zero.to)});
        continue;
      }
      event.time = t, event.state = state_;
    }
    added.push_back(std::move(event));
  }
  auto& events = record_->events;
  std::ranges::move(added, std::back_inserter(events));
  const auto together = std::ranges::lower_bound(events, t, {}, &Event::time);
  if (shorter) record_->shorten(t, elapsed, state_, slope_);
  const auto stopping = std::find_if(together, events.end(), stops);
  record_->stopped = stopping != events.end();
  if (record_->stopped) std::rotate(stopping, stopping + 1, events.end());
  std::vector<Event> ending;
  std::copy_if(together, events.end(), std::back_inserter(ending), ends);
  return ending;
}

void Run::fill_outputs() {
  auto& record = *record_;
  record.statistics.rhs_evaluations = stepper_->evaluations();
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

void Run::fail(const Trouble& trouble) {
  auto& record = *record_;
  if (!record.segments.empty() && record.segments.back() == record.times.size()) record.segments.pop_back();
  for (Zero& zero : roots_.take(record).located) record.events.push_back(std::move(zero.event));
  fill_outputs();
  std::string message = problem_.caller + ": failed at t = " + text(trouble.time) + " after " +
                        text(record.statistics.steps) + " steps with flag " + text(trouble.flag) + " (" +
                        stepper_->flag_name(trouble.flag) + "): " + trouble.text;
  const auto failure = [&] {
    return Failure(message, trouble.time, record.statistics.steps, trouble.flag, Solution(record_));
  };
  if (!trouble.cause) throw failure();
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
