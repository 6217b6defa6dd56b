#pragma once

#include <cstddef>
#include <exception>
#include <span>
#include <string>
#include <vector>

#include <vectrix/dynamics/ode/solve.hpp>

namespace vectrix::ode {

/// The right-hand side of the problem in the form an integrator calls. It throws nothing and keeps errors. It
/// remembers the last evaluation, because integrators ask again for the rate at the end of an accepted step.
class Rate {
 public:
  explicit Rate(const Problem& problem);

  void enter_segment(double start, double end);
  /// The time of the caller at a time since the start of the segment.
  [[nodiscard]] double time(double elapsed) const;
  /// The right-hand side at a time since the start of the segment. False if the function threw or a component
  /// is not finite. Then trouble() and cause() tell why, and the function is not called again.
  bool operator()(double elapsed, std::span<const double> y, std::span<double> ydot) noexcept;

  [[nodiscard]] std::size_t evaluations() const { return evaluations_; }
  [[nodiscard]] bool failed() const { return cause_ || !trouble_.empty(); }
  [[nodiscard]] const std::string& trouble() const { return trouble_; }
  [[nodiscard]] std::exception_ptr cause() const { return cause_; }
  [[nodiscard]] double trouble_time() const { return time(last_elapsed_); }

 private:
  void evaluate(double elapsed, std::span<const double> y, std::span<double> ydot);

  const Problem& problem_;
  double segment_start_ = 0.0;
  double segment_end_ = 0.0;
  bool remembers_ = false;
  double last_elapsed_ = 0.0;
  std::vector<double> last_state_;
  std::vector<double> last_rate_;
  std::size_t evaluations_ = 0;
  std::string trouble_;
  std::exception_ptr cause_;
};

}  // namespace vectrix::ode
