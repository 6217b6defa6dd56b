#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <vectrix/dynamics/ode/solve.hpp>
#include <vectrix/dynamics/ode/stepper.hpp>

#include "record.hpp"

namespace vectrix::ode {

/// A zero, and where it was seen: its function had its old sign at `from` and its new one at `to`, in time
/// since the start of the segment.
struct Zero {
  Event event;
  double from, to;
};

/// Finds the zeros of the problem's root functions. A change of sign between two nodes, or in a quarter of
/// a step that has its own interpolant, is kept as a bracket; it is located on the dense output when the
/// nodes around it are known. SUNDIALS' own search uses ARKODE's cubic interpolant, far less accurate than
/// its steps. A root function that throws or is not finite causes a Trouble: start() throws it, later ones
/// are kept, since an earlier zero may end the run.
class RootFinder {
 public:
  explicit RootFinder(const Problem& problem);

  void start(double t, std::span<const double> y);
  /// Examines the last step, up to where a function does not answer; true if it brackets a root that stops
  /// the run or ends the segment.
  bool advance(const Record& record);
  /// Why a function did not answer in the last step, and the last instant in it at which all did, in time
  /// since the start of the segment.
  [[nodiscard]] const std::optional<Trouble>& trouble() const { return trouble_; }
  [[nodiscard]] double answered() const { return answered_; }
  /// The number of brackets in the last step.
  [[nodiscard]] std::size_t bracketed() const { return brackets_.size() - previous_brackets_; }
  /// Whether the function of an event has no longer the sign it had before its zero.
  [[nodiscard]] bool has_crossed(const Event& event, double t, std::span<const double> y) const;
  /// Undoes the last advance.
  void retreat();
  /// Whether a root stops the run or ends the segment.
  [[nodiscard]] bool ends(std::size_t root) const {
    return problem_.roots[root].stop || problem_.roots[root].ends_segment;
  }

  /// A bracket whose function did not answer within it.
  struct Lost {
    std::size_t root;
    Direction direction;
    double from, to;
    Trouble trouble;
  };
  struct Zeros {
    std::vector<Zero> located;  ///< in order of time
    std::vector<Lost> lost;
  };
  /// Locates the zeros in all brackets, which it takes.
  [[nodiscard]] Zeros take(const Record& record);
  /// Throws if it is not known that a zero is the first that stops the run or ends the segment: a function
  /// does not answer at it, or has a lost zero before it.
  void require_known(const Zero& first, const Zeros& zeros) const;

 private:
  struct Bracket {
    std::size_t root;
    std::size_t left;
    double from;  ///< a part of the step, in time since the start of the segment
    double to;
    double left_value;
    double right_value;
  };

  [[nodiscard]] double value(std::size_t root, double t, std::span<const double> y) const;
  [[nodiscard]] bool has_crossed(std::size_t root, Direction direction, double t,
                                 std::span<const double> y) const;
  [[nodiscard]] Event locate(const Record& record, const Bracket& bracket) const;
  /// Looks for changes of sign in the part of a step that ends with y.
  bool examine(std::size_t left, double from, double to, double t, std::span<const double> y);

  const Problem& problem_;
  std::vector<double> values_;
  std::vector<double> previous_values_;
  std::vector<double> state_;
  std::vector<Bracket> brackets_;
  std::size_t previous_brackets_ = 0;
  std::optional<Trouble> trouble_;
  double answered_ = 0.0;
};

}  // namespace vectrix::ode
