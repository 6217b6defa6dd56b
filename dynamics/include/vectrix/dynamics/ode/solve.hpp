#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <vectrix/dynamics/ode/solution.hpp>
#include <vectrix/frames/errors.hpp>
#include <vectrix/frames/export.hpp>

namespace vectrix::ode {

/// Integration methods. Verner's Runge-Kutta pairs and Radau IIA are of this library, the others of SUNDIALS.
///
/// | method | order | dense output | for |
/// | --- | --- | --- | --- |
/// | `verner_9` | 9 | of order 9, 9 evaluations a step | smooth problems, long segments |
/// | `verner_7` | 7 | of order 7, 5 evaluations a step | segments of few steps: a controller |
/// | `radau_iia_7` | 13 | of order 7, none | stiff problems |
/// | `arkode_dormand_prince_5`, `arkode_fehlberg_8` | 5, 8 | through six nodes | comparison |
/// | `cvode_adams` | up to 12 | through six nodes | rates that are costly to evaluate |
/// | `cvode_bdf` | up to 5 | through six nodes | stiff problems, large states |
///
/// A segment of our methods may be one step; those of SUNDIALS take at least five. The steps of Radau IIA are
/// bounded by its dense output, to the tolerance, so that its nodes are far better; its Jacobian comes from
/// differences. The error estimate of Fehlberg 7(8) cannot detect a rate that depends on time alone (a
/// quadrature): for such a problem, set `maximum_step` or choose another method. The same tolerances give
/// another error with another method.
enum class Method {
  cvode_adams,
  cvode_bdf,
  arkode_dormand_prince_5,
  arkode_fehlberg_8,
  verner_9,
  verner_7,
  radau_iia_7
};

/// ydot = f(t, y) in the smooth segment that begins at `segment_start`. A function that switches at a
/// breakpoint must decide by segment_start alone: t equals the breakpoint at the end of one segment and also
/// at the start of the next.
using RightHandSide =
    std::function<void(double segment_start, double t, std::span<const double> y, std::span<double> ydot)>;

/// A function of time and state whose zeros are found and reported. A zero is found where the function
/// changes sign, or becomes 0, from one step to the next, or within a quarter of a step of our methods.
/// Two zeros in between are not found; set `maximum_step` to prevent this. A value of 0 at the start is not
/// an event. With `stop` the solution ends at the first zero; with `ends_segment` a new smooth segment begins
/// there.
struct Root {
  std::string name;
  std::function<double(double t, std::span<const double> y)> function;
  Direction direction = Direction::any;
  bool stop = false;
  bool ends_segment = false;
};

/// Called at the start of each smooth segment, with its time and state, and with the zeros that ended the
/// segment before: none at a breakpoint. What the right-hand side and the roots depend on, besides time and
/// state, may change here and nowhere else, and so may the state. A root whose sign changes by that has no
/// event.
using SegmentStart =
    std::function<void(double segment_start, std::span<double> y, std::span<const Event> ended_by)>;

/// An initial-value problem ydot = f(t, y), y(start) = initial_state. Members without a reasonable default
/// are NaN until they are set.
struct Problem {
  RightHandSide rhs;
  std::vector<double> initial_state;
  double start = std::numeric_limits<double>::quiet_NaN();
  double end = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> output_times;  ///< strictly increasing, within [start, end]
  std::vector<double> breakpoints;   ///< strictly increasing; values outside (start, end) have no effect
  double relative_tolerance = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> absolute_tolerances;  ///< one for each component
  std::vector<Root> roots;
  SegmentStart at_segment_start;  ///< may be empty
  Method method = Method::verner_9;
  std::size_t max_steps = 10'000'000;
  double maximum_step = std::numeric_limits<double>::infinity();
  /// False: our methods make their dense output, which costs evaluations and memory, only where it is
  /// needed: for the output times and the roots. Solution::at refuses times within other steps.
  bool dense_output = true;
  std::string caller = "ode::solve";         ///< name of the calling function, for messages
  std::vector<std::string> component_names;  ///< for messages: empty, or one for each component
  /// For messages, may be empty: asked when the rates of (segment_start, t, y) are not finite, it says why,
  /// as "the motor torque is nan N m", or nothing.
  std::function<std::string(double segment_start, double t, std::span<const double> y)> why_not_finite;
};

namespace detail {

/// Name of a component of the state, for messages.
inline std::string component_name(const Problem& problem, std::size_t i) {
  return problem.component_names.empty() ? "component " + vectrix::detail::text(i)
                                         : problem.component_names.at(i);
}
/// What the problem says of rates that are not finite, after a colon; empty if it says nothing.
VECTRIX_EXPORT std::string why_not_finite(const Problem& problem, double segment_start, double t,
                                          std::span<const double> y);

}  // namespace detail

/// A run that could not be finished. `solution()` holds everything computed until then. If the right-hand
/// side or a root function threw, the failure also derives from std::nested_exception and holds that
/// exception: std::rethrow_if_nested(failure) throws it.
class VECTRIX_EXPORT Failure : public std::runtime_error {
 public:
  Failure(const std::string& text, double time, std::size_t step, int flag, Solution solution);

  [[nodiscard]] double time() const { return time_; }       ///< time of the failure
  [[nodiscard]] std::size_t step() const { return step_; }  ///< accepted steps before it
  /// SUNDIALS' return flag, which the other methods use in the same meaning; the text has its name.
  [[nodiscard]] int flag() const { return flag_; }
  [[nodiscard]] const Solution& solution() const { return solution_; }

 private:
  double time_;
  std::size_t step_;
  int flag_;
  Solution solution_;
};

/// Solves the problem from start to end, or to the first zero of a root with `stop`. Throws BadInput if the
/// problem is not well posed, Failure if it cannot be finished. Separate calls may run in separate threads.
/// The functions of the problem are called in the caller's thread.
VECTRIX_EXPORT Solution solve(const Problem& problem);

}  // namespace vectrix::ode
