#include "roots.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include <vectrix/dynamics/ode/stepper.hpp>
#include <vectrix/frames/errors.hpp>

#include "interpolant.hpp"

namespace vectrix::ode {
namespace {

/// Those of the segments before are earlier, and in order.
void sort_from(std::size_t first, Record& record) {
  const auto begin = record.events.begin() + static_cast<std::ptrdiff_t>(first);
  std::ranges::stable_sort(begin, record.events.end(), {}, &Event::time);
}

/// True if the bracket is about as narrow as neighbouring numbers.
bool narrow(double a, double b) {
  return std::abs(b - a) <= 2.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b));
}

constexpr std::size_t parts_of_a_step = 4;      // where a step has an interpolant of its own
constexpr std::uintmax_t max_iterations = 200;  // bisection needs about 60 from a usual bracket

}  // namespace

RootFinder::RootFinder(const Problem& problem)
    : problem_(problem), values_(problem.roots.size()), state_(problem.initial_state.size()) {}

double RootFinder::value(std::size_t root, double t, std::span<const double> y) const {
  using vectrix::detail::text;
  const auto name = [&] { return "root " + text(root) + " (" + problem_.roots[root].name + ")"; };
  double result = 0.0;
  try {
    result = problem_.roots[root].function(t, y);
  } catch (...) {
    throw Trouble{flag::root_failed, t, name() + " threw", std::current_exception()};
  }
  if (!std::isfinite(result)) {
    throw Trouble{flag::root_failed, t, name() + " is " + text(result) + " at t = " + text(t), nullptr};
  }
  return result;
}

void RootFinder::start(double t, std::span<const double> y) {
  for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = value(i, t, y);
}

bool RootFinder::advance(const Record& record) {
  const std::size_t left = record.times.size() - 2;
  const double begin = record.elapsed[left], length = record.elapsed[left + 1] - begin;
  const double start = record.times[record.segment_of(left).first];
  const std::size_t parts = record.has_terms(left) && !values_.empty() ? parts_of_a_step : 1;
  previous_values_ = values_;
  previous_brackets_ = brackets_.size();
  bool ends = false;
  double from = begin;
  for (std::size_t part = 1; part < parts; ++part) {
    const double to = begin + length * static_cast<double>(part) / static_cast<double>(parts);
    Interpolant(record, left).at(to, state_);
    ends = examine(left, from, to, start + to, state_) || ends;
    from = to;
  }
  return examine(left, from, record.elapsed[left + 1], record.times[left + 1], record.state(left + 1)) ||
         ends;
}

bool RootFinder::examine(std::size_t left, double from, double to, double t, std::span<const double> y) {
  bool ends = false;
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const double before = std::exchange(values_[i], value(i, t, y));
    const Root& root = problem_.roots[i];
    const bool rising = before < 0.0 && values_[i] >= 0.0 && root.direction != Direction::falling;
    const bool falling = before > 0.0 && values_[i] <= 0.0 && root.direction != Direction::rising;
    if (!rising && !falling) continue;
    brackets_.push_back({i, left, from, to, before, values_[i]});
    ends = ends || root.stop || root.ends_segment;
  }
  return ends;
}

void RootFinder::retreat() {
  values_ = previous_values_;
  brackets_.resize(previous_brackets_);
}

Event RootFinder::locate(const Record& record, const Bracket& bracket) const {
  const double start = record.times[record.segment_of(bracket.left).first];
  const double latest = record.times[bracket.left + 1];
  Event event{bracket.root, problem_.roots[bracket.root].name, latest, std::vector<double>(record.dimension),
              bracket.left_value < 0.0 ? Direction::rising : Direction::falling};
  double crossed = bracket.to;
  if (bracket.right_value != 0.0) {
    const Interpolant interpolant(record, bracket.left);
    const auto function = [&](double elapsed) {
      interpolant.at(elapsed, event.state);
      return value(bracket.root, start + elapsed, event.state);
    };
    std::uintmax_t iterations = max_iterations;
    crossed = boost::math::tools::toms748_solve(function, bracket.from, bracket.to, bracket.left_value,
                                                bracket.right_value, narrow, iterations)
                  .second;
  }
  if (bracket.right_value != 0.0 || crossed < record.elapsed[bracket.left + 1]) {
    // The caller's time, rounded to the side of the new sign.
    double t = start + crossed;
    if (t - start < crossed) t = std::nextafter(t, std::numeric_limits<double>::infinity());
    event.time = std::min(t, latest);
  }
  interpolate(record, event.time, event.state);
  // The state at the rounded time may be on the old side still: where the function rounds more than time.
  while (event.time < latest && !has_crossed(event, event.time, event.state)) {
    event.time = std::nextafter(event.time, latest);
    interpolate(record, event.time, event.state);
  }
  return event;
}

bool RootFinder::has_crossed(const Event& event, double t, std::span<const double> y) const {
  const double now = value(event.root, t, y);
  return event.direction == Direction::rising ? now >= 0.0 : now <= 0.0;
}

void RootFinder::resolve(Record& record) {
  const std::size_t before = record.events.size();
  for (const Bracket& bracket : brackets_) record.events.push_back(locate(record, bracket));
  brackets_.clear();
  sort_from(before, record);
}

void RootFinder::resolve_what_can_be(Record& record) {
  const std::size_t before = record.events.size();
  for (const Bracket& bracket : brackets_) {
    try {
      record.events.push_back(locate(record, bracket));
    } catch (const Trouble&) {
      continue;  // an earlier error has already ended the run
    }
  }
  brackets_.clear();
  sort_from(before, record);
}

}  // namespace vectrix::ode
