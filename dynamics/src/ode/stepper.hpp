#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include <sundials/sundials_nvector.h>
#include <vectrix/dynamics/ode/solve.hpp>

#include "rate.hpp"

namespace vectrix::ode {

/// Return flags set by this library; CVODE and ARKODE share these values.
namespace flag {
inline constexpr int too_many_steps = -1;
inline constexpr int rhs_failed = -8;
inline constexpr int root_failed = -12;
inline constexpr int no_progress = -27;
}  // namespace flag

/// A SUNDIALS integrator in one-step mode.
///
/// SUNDIALS adds up the steps without compensation, so that rounding errors accumulate in its clock: 1e-10 s
/// in a thousand seconds of small steps, more than the error of the states. This class starts the clock at 0
/// at each restart. It keeps the same sum with compensation, and corrects all times given to and taken from
/// SUNDIALS. Its times count from the start of the segment, so that a late start loses no digits.
class Stepper {
 public:
  virtual ~Stepper() = default;

  /// Restarts at (t, y), without history; stops exactly at `stop` and takes no step longer than `longest`.
  int restart(double t, std::span<const double> y, double stop, double longest);
  /// Takes one accepted step and sets t. Returns SUNDIALS' flag, negative on failure.
  int step(double& t);
  [[nodiscard]] virtual std::span<const double> state() const = 0;
  /// Rate at the time t of the last step; returns a negative flag on failure.
  virtual int rate(double t, std::span<double> ydot);
  [[nodiscard]] std::size_t error_test_failures() const {
    return failures_before_ + failures_since_restart();
  }
  [[nodiscard]] virtual std::string flag_name(int flag) const = 0;
  /// The last error text of SUNDIALS.
  [[nodiscard]] const std::string& message() const { return message_; }

 protected:
  explicit Stepper(Rate& rate) : rate_(rate) {}
  Stepper(const Stepper&) = delete;
  Stepper& operator=(const Stepper&) = delete;

  virtual int reinitialize(std::span<const double> y, double longest) = 0;
  virtual int set_stop(double clock) = 0;
  /// One step towards the stop: sets the new clock time and the length of the step.
  virtual int advance(double& clock, double& length) = 0;
  [[nodiscard]] virtual std::size_t failures_since_restart() const = 0;

  /// SUNDIALS' callback: the user data is the Stepper.
  static int call_rate(double clock, N_Vector y, N_Vector ydot, void* stepper);

  Rate& rate_;
  double clock_ = 0.0;  ///< SUNDIALS' time, 0 at the last restart
  std::string message_;

 private:
  [[nodiscard]] double time(double clock) const { return origin_ + (clock + clock_error_); }

  double origin_ = 0.0;
  double stop_ = 0.0;
  double elapsed_ = 0.0;       ///< sum of the steps since the origin
  double elapsed_rest_ = 0.0;  ///< rounding error of elapsed_
  double clock_error_ = 0.0;   ///< compensated sum minus clock_
  std::size_t failures_before_ = 0;
};

std::unique_ptr<Stepper> make_cvode_stepper(const Problem& problem, Rate& rate);
std::unique_ptr<Stepper> make_arkode_stepper(const Problem& problem, Rate& rate);

}  // namespace vectrix::ode
