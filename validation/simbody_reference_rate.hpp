#pragma once

#include <array>
#include <memory>

namespace vectrix::validation {

/// A free rigid body in Simbody, with moments (1, 2, 3) kg m^2, behind plain types: Simbody's headers are
/// C++17.
class SimbodyRate {
 public:
  SimbodyRate();
  ~SimbodyRate();
  SimbodyRate(const SimbodyRate&) = delete;
  SimbodyRate& operator=(const SimbodyRate&) = delete;

  /// One right-hand side. It takes the attitude (scalar first) and the rate, in ground axes, and computes
  /// qdot and udot.
  void evaluate(const std::array<double, 4>& q, const std::array<double, 3>& w);

 private:
  struct System;
  std::unique_ptr<System> system_;
};

}  // namespace vectrix::validation
