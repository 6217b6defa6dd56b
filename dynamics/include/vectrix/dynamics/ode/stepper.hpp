#pragma once

#include <cstddef>
#include <exception>
#include <span>
#include <string>

#include <vectrix/frames/export.hpp>

namespace vectrix::ode {

/// Why a run ends early. A stepper throws it to the loop of solve(), which turns it into a Failure.
struct VECTRIX_EXPORT Trouble {
  int flag;
  double time;  ///< of the caller
  std::string text;
  std::exception_ptr cause;  ///< the exception of the problem's function, if there was one
};

/// The flags of a Failure that have the same meaning for all methods.
namespace flag {
inline constexpr int too_many_steps = -1;
inline constexpr int step_too_short = -3;
inline constexpr int rhs_failed = -8;
inline constexpr int root_failed = -12;
inline constexpr int no_progress = -27;
}  // namespace flag

/// What the loop of solve() asks of an integrator. Elapsed times count from the start of the smooth segment,
/// so that a late start loses no digits. What cannot be done is thrown as a Trouble.
class VECTRIX_EXPORT Stepper {
 public:
  virtual ~Stepper() = default;

  /// The smooth segment in which all that follows happens, in the caller's time.
  virtual void enter_segment(double start, double end) = 0;
  /// The right-hand side.
  virtual void evaluate(double elapsed, std::span<const double> y, std::span<double> ydot) = 0;
  /// Begins at (elapsed, y), without history. Steps end exactly at `stop` and are no longer than `longest`.
  virtual void restart(double elapsed, std::span<const double> y, double stop, double longest) = 0;
  /// The right-hand side where the last restart was.
  virtual void rate_at_restart(std::span<double> ydot) { rate(ydot); }
  /// One accepted step; returns the time reached.
  virtual double step() = 0;
  [[nodiscard]] virtual std::span<const double> state() const = 0;
  /// Slope of the solution at the end of the last step.
  virtual void rate(std::span<double> ydot) = 0;

  /// Number of terms of the method's own interpolant in a step; 0 if it has none.
  [[nodiscard]] virtual std::size_t degree() const = 0;
  /// The terms for the last step, number p of component c at [(p - 1) * size + c]:
  ///     y(t) = y_before + sum_p term_p theta^p,  theta = (t - t_before) / (length of the step).
  virtual void terms(std::span<double> terms) = 0;

  [[nodiscard]] virtual std::size_t evaluations() const = 0;
  [[nodiscard]] virtual std::size_t error_test_failures() const = 0;
  [[nodiscard]] virtual std::string flag_name(int flag) const;
  /// The component whose error is the largest in the last step; empty if that is not known.
  [[nodiscard]] virtual std::string worst_component() const { return {}; }

 protected:
  Stepper() = default;
  Stepper(const Stepper&) = delete;
  Stepper& operator=(const Stepper&) = delete;
};

}  // namespace vectrix::ode
