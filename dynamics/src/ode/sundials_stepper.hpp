#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <sundials/sundials_nvector.h>
#include <vectrix/dynamics/ode/elapsed_time.hpp>
#include <vectrix/dynamics/ode/rates_of_segment.hpp>
#include <vectrix/dynamics/ode/solve.hpp>
#include <vectrix/dynamics/ode/stepper.hpp>

namespace vectrix::ode {

/// A SUNDIALS integrator in one-step mode.
///
/// SUNDIALS adds up the steps without compensation, so that rounding errors accumulate in its clock: 1e-10 s
/// in a thousand seconds of small steps, more than the error of the states. This class starts the clock at 0
/// at each restart. It keeps the same sum with compensation, and corrects all times given to and taken from
/// SUNDIALS.
class SundialsStepper : public Stepper {
 public:
  void enter_segment(double start, double end) override;
  void evaluate(double elapsed, std::span<const double> y, std::span<double> ydot) override;
  void restart(double elapsed, std::span<const double> y, double stop, double longest) override;
  void rate_at_restart(std::span<double> ydot) override { evaluate(reached_, state(), ydot); }
  double step() override;
  void rate(std::span<double> ydot) override;
  [[nodiscard]] std::size_t degree() const override { return 0; }
  void terms(std::span<double>) override {}
  [[nodiscard]] std::size_t evaluations() const override { return rates_.evaluations; }
  [[nodiscard]] std::size_t error_test_failures() const override {
    return failures_before_ + failures_since_restart();
  }

 protected:
  explicit SundialsStepper(const Problem& problem);

  virtual int reinitialize(std::span<const double> y, double longest) = 0;
  virtual int set_stop(double clock) = 0;
  /// One step towards the stop: sets the new clock time and the length of the step.
  virtual int advance(double& clock, double& length) = 0;
  [[nodiscard]] virtual std::size_t failures_since_restart() const = 0;

  /// SUNDIALS' callback: the user data is the SundialsStepper.
  static int call_rate(double clock, N_Vector y, N_Vector ydot, void* stepper);

  /// What SUNDIALS' memory has of its last step, put into a vector.
  using Getter = int (*)(void* memory, N_Vector);
  /// The component with the largest error, where the weights are 1 / tolerance; empty if SUNDIALS does not
  /// tell, or all errors are zero. The state is what it makes its vectors like.
  [[nodiscard]] std::string worst_of(void* memory, N_Vector state, Getter errors, Getter weights) const;

  /// Throws for a negative flag. An error of the right-hand side says more than the flag that follows from
  /// it.
  void require(int flag) const;

  double clock_ = 0.0;   ///< SUNDIALS' time, 0 at the last restart
  std::string message_;  ///< the last error text of SUNDIALS

 private:
  /// The rate, which is remembered, because integrators ask again for that at the end of an accepted step.
  /// False after an error of the right-hand side, which is kept; the function is not called again.
  bool find_rate(double elapsed, std::span<const double> y, std::span<double> ydot) noexcept;
  [[nodiscard]] double time(double clock) const { return origin_ + (clock + clock_error_); }

  detail::RatesByFunction rates_;
  bool remembers_ = false;
  double last_elapsed_ = 0.0;
  std::vector<double> last_state_;
  std::vector<double> last_rate_;
  double origin_ = 0.0;
  double stop_ = 0.0;
  double reached_ = 0.0;      ///< time of the last step
  ElapsedTime elapsed_;       ///< since the origin
  double clock_error_ = 0.0;  ///< compensated sum minus clock_
  std::size_t failures_before_ = 0;
};

std::unique_ptr<Stepper> make_cvode_stepper(const Problem& problem);
std::unique_ptr<Stepper> make_arkode_stepper(const Problem& problem);

}  // namespace vectrix::ode
