#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include <Eigen/LU>
#include <vectrix/dynamics/ode/elapsed_time.hpp>
#include <vectrix/dynamics/ode/radau_iia_7.hpp>
#include <vectrix/dynamics/ode/rates_of_segment.hpp>

namespace vectrix::ode {

/// Radau IIA of 7 stages for stiff problems. With Z_i = Y_i - y and A^-1 = T diag(lambda) T^-1, Newton's step
/// is
///     (lambda_k 1 - h J) (T^-1 dZ)_k = (T^-1 (h F - A^-1 Z))_k,
/// one real and three complex systems of the size of the state. The Jacobian J comes from differences, and is
/// kept while the iteration converges fast. The error is estimated by the slope of the collocation polynomial
/// at the start, q'(0), against the rate there, to order 8:
///     error = (lambda_0 1 - h J)^-1 (h f(t, y) - h q'(0)),  lambda_0 the real eigenvalue.
/// After E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, section IV.8.
class RadauStepper final : public Stepper {
 public:
  explicit RadauStepper(const Problem& problem);

  void enter_segment(double start, double end) override;
  void evaluate(double elapsed, std::span<const double> y, std::span<double> ydot) override;
  void restart(double elapsed, std::span<const double> y, double stop, double longest) override;
  double step() override;
  [[nodiscard]] std::span<const double> state() const override { return span_of(y_); }
  void rate(std::span<double> ydot) override;
  [[nodiscard]] std::size_t degree() const override { return stages; }
  void terms(std::span<double> terms) override;
  [[nodiscard]] std::size_t evaluations() const override { return rates_.evaluations; }
  [[nodiscard]] std::size_t error_test_failures() const override { return rejections_; }

  static constexpr int stages = RadauIIA7::stages;
  static constexpr int pairs = (stages - 1) / 2;  ///< of complex eigenvalues

 private:
  using Vector = Eigen::VectorXd;
  using ByStage = Eigen::Matrix<double, Eigen::Dynamic, stages>;

  static std::span<const double> span_of(const Vector& y) {
    return {y.data(), static_cast<std::size_t>(y.size())};
  }
  static std::span<double> span_of(Vector& y) { return {y.data(), static_cast<std::size_t>(y.size())}; }
  [[nodiscard]] double time() const { return origin_ + (elapsed_.sum + elapsed_.rest); }
  [[nodiscard]] double first_step(double longest);
  /// Sets unit_, the tolerance of each component, for a state of these sizes.
  void find_unit(const Vector& sizes);
  /// The rate of a trial; false if it is not finite.
  bool evaluate_trial(double elapsed);
  bool find_jacobian(double h);
  void factorise(double h);
  void guess(double h);
  bool iterate(double h);
  void find_terms();
  double error_of(double h, bool careful);
  double dense_error(double h);
  void accept(double h, bool last);
  [[noreturn]] void throw_failed(double h) const;

  const Problem& problem_;
  detail::RatesByFunction rates_;
  Vector absolute_, y_, rate_, trial_, trial_rate_, new_y_, unit_, error_;
  ByStage z_, f_;  ///< Y_i - y and f(Y_i)
  ByStage residual_, change_;
  Eigen::VectorXcd complex_residual_, complex_change_;
  ByStage terms_;       ///< of the collocation polynomial
  ByStage last_terms_;  ///< those of the last accepted step
  Eigen::MatrixXd jacobian_;
  Eigen::PartialPivLU<Eigen::MatrixXd> real_;
  std::array<Eigen::PartialPivLU<Eigen::MatrixXcd>, pairs> complex_;
  double origin_ = 0.0, stop_ = 0.0, longest_ = 0.0;
  ElapsedTime elapsed_;
  double step_ = 0.0;  ///< the last accepted one; 0 after a restart
  double next_step_ = 0.0;
  double factorised_ = 0.0;   ///< the step for which the systems are factorised; 0 for none
  double contraction_ = 1.0;  ///< theta / (1 - theta) of Newton's iteration, theta the ratio of its steps
  double slowest_ratio_ = 1.0;
  int iterations_ = 0;
  std::size_t rejections_ = 0;
  std::size_t worst_ = 0;
  bool jacobian_fresh_ = false;  ///< it is that of this state
  bool converged_ = true;        ///< Newton's iteration, in the last attempt
  bool overflowed_ = false;      ///< the last attempt
  bool jacobian_good_ = false;   ///< Newton's iteration converged fast with it
};

std::unique_ptr<Stepper> make_radau_stepper(const Problem& problem);

}  // namespace vectrix::ode
