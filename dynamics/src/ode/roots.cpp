#include "roots.hpp"

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include <vectrix/dynamics/ode/stepper.hpp>
#include <vectrix/frames/errors.hpp>

#include "interpolant.hpp"

namespace vectrix::ode {
namespace {

/// True if the bracket is about as narrow as neighbouring numbers.
bool narrow(double a, double b) {
  return std::abs(b - a) <= 2.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b));
}

double just_after(double t) {
  return std::nextafter(t, std::numeric_limits<double>::infinity());
}
/// start + elapsed, rounded up.
double rounded_up(double start, double elapsed) {
  const double t = start + elapsed;
  return t - start < elapsed ? just_after(t) : t;
}

/// A time in (t, last] with `holds` after one without it, which t is: the distance from t is doubled until it
/// holds, then halved. These are at most as many times as doubles have exponents and digits, twice: some 100
/// where last / t is not huge. Nothing if it holds at none of them.
template <class Holds> std::optional<double> first_after(double t, double last, const Holds& holds) {
  double without = t, with = t;
  for (double distance = just_after(t) - t;; distance *= 2.0) {
    if (without >= last) return std::nullopt;
    with = std::min(without + distance, last);
    if (holds(with)) break;
    without = with;
  }
  while (true) {
    const double middle = std::midpoint(without, with);
    if (!(middle > without && middle < with)) return with;
    (holds(middle) ? with : without) = middle;
  }
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
  trouble_.reset();
  answered_ = begin;
  bool ends = false;
  double from = begin;
  for (std::size_t part = 1; part < parts; ++part) {
    const double to = begin + length * static_cast<double>(part) / static_cast<double>(parts);
    Interpolant(record, left).at(to, state_);
    ends = examine(left, from, to, std::min(start + to, record.times[left + 1]), state_) || ends;
    if (trouble_) return ends;
    from = to;
  }
  return examine(left, from, record.elapsed[left + 1], record.times[left + 1], record.state(left + 1)) ||
         ends;
}

bool RootFinder::examine(std::size_t left, double from, double to, double t, std::span<const double> y) {
  bool end = false;
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const double before = values_[i];
    try {
      values_[i] = value(i, t, y);
    } catch (const Trouble& trouble) {
      if (!trouble_) trouble_ = trouble;
      continue;
    }
    const Root& root = problem_.roots[i];
    const bool rising = before < 0.0 && values_[i] >= 0.0 && root.direction != Direction::falling;
    const bool falling = before > 0.0 && values_[i] <= 0.0 && root.direction != Direction::rising;
    if (!rising && !falling) continue;
    brackets_.push_back({i, left, from, to, before, values_[i]});
    end = end || ends(i);
  }
  if (!trouble_) answered_ = to;
  return end;
}

void RootFinder::retreat() {
  values_ = previous_values_;
  brackets_.resize(previous_brackets_);
  trouble_.reset();
}

Event RootFinder::locate(const Record& record, const Bracket& bracket) const {
  const std::size_t right = bracket.left + 1;
  const double start = record.times[record.segment_of(bracket.left).first];
  const double latest = record.times[right];
  Event event{bracket.root, problem_.roots[bracket.root].name, latest, std::vector<double>(record.dimension),
              bracket.left_value < 0.0 ? Direction::rising : Direction::falling};
  const Interpolant interpolant(record, bracket.left);
  const auto time = [&](double elapsed) { return std::min(start + elapsed, latest); };
  double crossed = bracket.to;
  if (bracket.right_value != 0.0) {
    const auto function = [&](double elapsed) {
      interpolant.at(elapsed, event.state);
      return value(bracket.root, time(elapsed), event.state);
    };
    std::uintmax_t iterations = max_iterations;
    crossed = boost::math::tools::toms748_solve(function, bracket.from, bracket.to, bracket.left_value,
                                                bracket.right_value, narrow, iterations)
                  .second;
  }
  // The caller's time, rounded to the side of the new sign. The state there may be on the old side still:
  // where the function rounds more than time.
  const auto has_new_sign = [&](double t) {
    interpolate(record, t, event.state);
    return has_crossed(event, t, event.state);
  };
  const auto rounded = [&](double elapsed) {
    return elapsed < record.elapsed[right] ? std::min(rounded_up(start, elapsed), latest) : latest;
  };
  event.time = rounded(crossed);
  if (has_new_sign(event.time)) return event;
  if (const auto later = first_after(event.time, rounded(bracket.to), has_new_sign)) {
    event.time = *later;
    interpolate(record, event.time, event.state);
  } else {
    // It has its new sign for less than a rounding of time. A segment ends with the state where it was seen.
    event.time = std::max(time(crossed), just_after(start));
    if (!ends(bracket.root))
      interpolate(record, event.time, event.state);
    else if (crossed < record.elapsed[right])
      interpolant.at(crossed, event.state);
    else
      std::ranges::copy(record.state(right), event.state.begin());
  }
  return event;
}

bool RootFinder::has_crossed(const Event& event, double t, std::span<const double> y) const {
  return has_crossed(event.root, event.direction, t, y);
}

bool RootFinder::has_crossed(std::size_t root, Direction direction, double t,
                             std::span<const double> y) const {
  const double now = value(root, t, y);
  return direction == Direction::rising ? now >= 0.0 : now <= 0.0;
}

RootFinder::Zeros RootFinder::take(const Record& record) {
  Zeros zeros;
  for (const Bracket& bracket : brackets_) {
    try {
      zeros.located.push_back({locate(record, bracket), bracket.from, bracket.to});
    } catch (const Trouble& trouble) {
      const Direction direction = bracket.left_value < 0.0 ? Direction::rising : Direction::falling;
      zeros.lost.push_back({bracket.root, direction, bracket.from, bracket.to, trouble});
    }
  }
  brackets_.clear();
  std::ranges::stable_sort(zeros.located, {}, [](const Zero& zero) { return zero.event.time; });
  return zeros;
}

void RootFinder::require_known(const Zero& first, const Zeros& zeros) const {
  const double t = first.event.time;
  const std::vector<double>& state = first.event.state;
  if (trouble_)
    for (std::size_t i = 0; i < problem_.roots.size(); ++i) (void)value(i, t, state);
  for (const Lost& lost : zeros.lost)
    if (lost.to <= first.from || has_crossed(lost.root, lost.direction, t, state))
      throw Trouble(lost.trouble);
}

}  // namespace vectrix::ode
