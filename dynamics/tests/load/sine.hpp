#pragma once

#include <cmath>
#include <vectrix/dynamics/craft/joint_motion.hpp>

#include "short_units.hpp"

namespace vectrix_test {

/// A sin(W (t - t_0)) + q_0 about or along an axis, as prescribed() takes it.
struct Sine {
  double amplitude, rate, middle = 0.0, epoch = 0.0;

  double phase(double t) const { return rate * (t - epoch); }
  double q(double t) const { return middle + amplitude * std::sin(phase(t)); }
  double u(double t) const { return amplitude * rate * std::cos(phase(t)); }
  double a(double t) const { return -amplitude * rate * rate * std::sin(phase(t)); }
  auto turning(double t) const {
    using namespace short_units;
    return vectrix::JointMotion{q(t) * rad, u(t) * rad_s, a(t) * (rad_s / s)};
  }
  auto sliding(double t) const {
    using namespace short_units;
    return vectrix::JointMotion{q(t) * m, u(t) * m_s, a(t) * (m_s / s)};
  }
};
inline auto turning(const Sine& sine) {
  return [sine](const vectrix::Quantity<vectrix::si::time>& t) { return sine.turning(t.value()); };
}

}  // namespace vectrix_test
