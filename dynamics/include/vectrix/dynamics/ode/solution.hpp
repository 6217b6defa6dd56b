#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <vectrix/frames/export.hpp>

namespace vectrix::ode {

/// Sense in which a root function passes through zero as time grows.
enum class Direction { rising, falling, any };

/// One accepted step: time, state and its rate. The rate is f(t, y) with the ARKODE methods, and with the
/// CVODE methods the slope of the integrator's polynomial, equal to f(t, y) within the tolerance (at the
/// start of a segment, f(t, y)). The spans live as long as any copy of the solution.
struct Node {
  double t;
  std::span<const double> y;
  std::span<const double> ydot;
};

/// One zero of a root function: the root's place in Problem::roots and its name, the first time at which the
/// function has its new sign (or is 0), the state there, and `rising` or `falling`.
struct Event {
  std::size_t root;
  std::string name;
  double time;
  std::vector<double> state;
  Direction direction;
};

struct Statistics {
  std::size_t steps = 0;  ///< accepted steps, the repeated ones in front of a stop included
  std::size_t rhs_evaluations = 0;
  std::size_t error_test_failures = 0;
};

struct Record;

/// What a run computed, immutable and cheap to copy. A failed run's solution ends at its last accepted step.
///
/// Nodes are ordered by time. Smooth segments lie between consecutive breakpoints; a breakpoint is a node of
/// both its segments, with the same state and its two one-sided rates. A temporary gives no view of itself.
class VECTRIX_EXPORT Solution {
 public:
  explicit Solution(std::shared_ptr<const Record> record);

  [[nodiscard]] std::size_t dimension() const;
  [[nodiscard]] double start() const;
  /// Time of the last node: Problem::end, the time of the stopping event, or the last step before a failure.
  [[nodiscard]] double end() const;
  /// A root with `stop` ended the run: events().back() is it.
  [[nodiscard]] bool stopped() const;

  [[nodiscard]] std::size_t node_count() const;
  [[nodiscard]] Node node(std::size_t index) const&;
  Node node(std::size_t index) && = delete;  // the spans would outlive the solution
  [[nodiscard]] std::size_t segment_count() const;
  /// Index of the first node of a segment; segment_count() gives node_count().
  [[nodiscard]] std::size_t segment_begin(std::size_t segment) const;

  /// The output times that were reached, and the states there, which are at(time).
  [[nodiscard]] std::span<const double> output_times() const&;
  std::span<const double> output_times() && = delete;  // the span would outlive the solution
  [[nodiscard]] std::span<const double> output(std::size_t index) const&;
  std::span<const double> output(std::size_t index) && = delete;  // the span would outlive the solution

  [[nodiscard]] const std::vector<Event>& events() const&;
  [[nodiscard]] std::vector<Event> events() &&;
  [[nodiscard]] Statistics statistics() const;

  /// State at any time in [start, end]: the Hermite polynomial through (y, ydot) of up to six nodes around t
  /// within its smooth segment (degree 11 or less); at a node exactly the node's state.
  /// BadInput if t is outside [start, end] or not a number.
  [[nodiscard]] std::vector<double> at(double t) const;
  void at(double t, std::span<double> state) const;

 private:
  std::shared_ptr<const Record> record_;
};

}  // namespace vectrix::ode
