#include <vectrix/dynamics/ode/solution.hpp>

#include <utility>

#include <vectrix/frames/errors.hpp>

#include "interpolant.hpp"
#include "record.hpp"

namespace vectrix::ode {
namespace {

void check_index(const char* what, std::size_t index, std::size_t count) {
  if (index < count) return;
  throw BadInput(std::string("ode::Solution: no ") + what + " with index " + vectrix::detail::text(index) +
                 ", there are " + vectrix::detail::text(count));
}

}  // namespace

Solution::Solution(std::shared_ptr<const Record> record) : record_(std::move(record)) {}

std::size_t Solution::dimension() const {
  return record_->dimension;
}
double Solution::start() const {
  return record_->start;
}
double Solution::end() const {
  return record_->times.empty() ? record_->start : record_->times.back();
}
bool Solution::stopped() const {
  return record_->stopped;
}

std::size_t Solution::node_count() const {
  return record_->times.size();
}

Node Solution::node(std::size_t index) const& {
  check_index("node", index, node_count());
  return {record_->times[index], record_->state(index), record_->rate(index)};
}

std::size_t Solution::segment_count() const {
  return record_->segments.size();
}

std::size_t Solution::segment_begin(std::size_t segment) const {
  if (segment == segment_count()) return node_count();
  check_index("segment", segment, segment_count());
  return record_->segments[segment];
}

std::span<const double> Solution::output_times() const& {
  return record_->output_times;
}

std::span<const double> Solution::output(std::size_t index) const& {
  check_index("output", index, record_->output_times.size());
  return {record_->outputs.data() + index * dimension(), dimension()};
}

const std::vector<Event>& Solution::events() const& {
  return record_->events;
}
std::vector<Event> Solution::events() && {
  return record_->events;
}

Statistics Solution::statistics() const {
  return record_->statistics;
}

std::vector<double> Solution::at(double t) const {
  std::vector<double> state(dimension());
  at(t, state);
  return state;
}

void Solution::at(double t, std::span<double> state) const {
  if (node_count() == 0) throw BadInput("ode::Solution::at: the run failed before its first node");
  if (!(t >= start() && t <= end())) {
    throw BadInput("ode::Solution::at: time " + vectrix::detail::text(t) + " is outside [" +
                   vectrix::detail::text(start()) + ", " + vectrix::detail::text(end()) + "]");
  }
  if (state.size() != dimension()) {
    throw BadInput("ode::Solution::at: the state has " + vectrix::detail::text(dimension()) +
                   " components, the span " + vectrix::detail::text(state.size()));
  }
  interpolate(*record_, t, state);
}

}  // namespace vectrix::ode
