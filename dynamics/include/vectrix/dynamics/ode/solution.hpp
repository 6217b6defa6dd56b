#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <vectrix/frames/export.hpp>

namespace vectrix::ode {

/// Direction in which a root function crosses zero as time increases.
enum class Direction { rising, falling, any };

/// One accepted step: time, state and rate. The rate is f(t, y), except with the CVODE methods. There it is
/// the slope of the integrator's polynomial, which equals f(t, y) within the tolerance (at the start of a
/// segment it is f(t, y)). The spans are valid as long as any copy of the solution exists.
struct Node {
  double t;
  std::span<const double> y;
  std::span<const double> ydot;
};

/// One zero of a root function: the index of the root in Problem::roots, its name, the first time at which
/// the function has its new sign (or is 0), the state at that time, and `rising` or `falling`. A new sign
/// that no double sees, as it lasts for less than a rounding of time, is at the nearest one.
struct Event {
  std::size_t root;
  std::string name;
  double time;
  std::vector<double> state;
  Direction direction;
};

struct Statistics {
  std::size_t steps = 0;  ///< accepted steps; includes steps repeated before a stop
  std::size_t rhs_evaluations = 0;
  std::size_t error_test_failures = 0;
};

struct Record;

/// The result of a run. It is immutable and cheap to copy. After a failure it ends at the last accepted step;
/// if a root function did not answer in that step, at the last instant in it before which all zeros are
/// known. A zero that ends the run or a segment is never passed.
///
/// Nodes are ordered by time. Smooth segments lie between consecutive breakpoints, and zeros that end a
/// segment. Such an instant is a node of both its segments, with two one-sided rates and the same state,
/// unless Problem::at_segment_start changed it: the later node has the new one, and so has at(). A temporary
/// solution gives no spans.
class VECTRIX_EXPORT Solution {
 public:
  explicit Solution(std::shared_ptr<const Record> record);

  [[nodiscard]] std::size_t dimension() const;
  [[nodiscard]] double start() const;
  /// Time of the last node: Problem::end, the time of the stopping event, or the last instant kept before a
  /// failure.
  [[nodiscard]] double end() const;
  /// True if a root with `stop` ended the run. That event is events().back().
  [[nodiscard]] bool stopped() const;

  [[nodiscard]] std::size_t node_count() const;
  [[nodiscard]] Node node(std::size_t index) const&;
  Node node(std::size_t index) && = delete;  // the spans would outlive the solution
  [[nodiscard]] std::size_t segment_count() const;
  /// Index of the first node of a segment; segment_count() gives node_count().
  [[nodiscard]] std::size_t segment_begin(std::size_t segment) const;

  /// The output times that were reached, and the states there; these equal at(time).
  [[nodiscard]] std::span<const double> output_times() const&;
  std::span<const double> output_times() && = delete;  // the span would outlive the solution
  [[nodiscard]] std::span<const double> output(std::size_t index) const&;
  std::span<const double> output(std::size_t index) && = delete;  // the span would outlive the solution

  [[nodiscard]] const std::vector<Event>& events() const&;
  [[nodiscard]] std::vector<Event> events() &&;
  [[nodiscard]] Statistics statistics() const;

  /// State at any time in [start, end]. Verner's methods and Radau IIA have interpolants of their own, where
  /// they were kept. Else this is the Hermite polynomial through (y, ydot) of up to six nodes around t within
  /// its smooth segment (degree 11 or less). A node is reached at a time that need not be a double; at the
  /// node's rounded time this is the state at the rounded time. Throws BadInput if t is outside [start, end]
  /// or not a number, or if it is between two nodes and the dense output there was not kept
  /// (Problem::dense_output).
  [[nodiscard]] std::vector<double> at(double t) const;
  void at(double t, std::span<double> state) const;

 private:
  std::shared_ptr<const Record> record_;
};

}  // namespace vectrix::ode
