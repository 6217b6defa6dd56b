#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vectrix/kinematics/points/moving_transform.hpp>
#include <vectrix/kinematics/rates/hat.hpp>
#include <vectrix/kinematics/samples/instant.hpp>

namespace vectrix {
namespace detail {

/// The derivative of f(s) at s = 0 from five points a step h apart; its error is h^4/30 times the fifth
/// derivative.
template <class F> auto central_difference(const F& f, double h) {
  return ((f(-2 * h) - f(2 * h) + 8.0 * (f(h) - f(-h))) / (12 * h)).eval();
}

/// Rounding error of a central difference, relative to size/h, for values of that size.
inline constexpr double difference_rounding = 256 * std::numeric_limits<double>::epsilon();

template <class A, class B, class F, class Claimed>
void require_law(const char* what, const char* of, const F& f, const Claimed& claimed, double size, double h,
                 double tolerance, const std::string& instant) {
  const auto found = central_difference(f, h);
  const double error = (found - claimed).norm();
  const double largest = std::max<double>(found.norm(), claimed.norm());
  if (!(error <= tolerance * largest + difference_rounding * size / h)) {
    throw BadInput(std::string{what} + " of " + frame_name<B>() + " relative to " + frame_name<A>() + " at " +
                   instant + " is not the derivative of its " + of + ": it is off by " + text(error) + ", " +
                   text(error / largest) + " of the larger of the two");
  }
}

}  // namespace detail

/// Checks a moving edge of the user's at one instant. The value of f must obey these laws, up to its level:
///     R^T R = I    d/dt R_b^a = R_b^a [w_ab^b]x    d/dt w_ab^b = alpha_ab^b
///     d/dt r_ab^a = v_ab|a^a    d/dt v_ab|a^a = a_ab|a^a
/// each to the relative error `tolerance`. The derivatives are central differences over two steps to either
/// side, where f must be smooth; for a motion of time scale T their relative error is (step/T)^4/30. The
/// check finds a rate in the wrong axes, of the wrong sign, in degrees, or left at zero. Throws BadInput that
/// names the law, the frames, the instant and the error.
template <class Function, Instant I>
void require_motion_laws(const Function& f, const I& t, const Quantity<si::time>& step,
                         double tolerance = 1e-6) {
  using Value = std::remove_cvref_t<decltype(f(t))>;
  using Known = LevelOf<Value>;
  using A = typename Known::first;
  using B = typename Known::second;
  using Matrix = std::remove_cvref_t<decltype(rotation_of(std::declval<Value>()).matrix())>;
  using Column = Eigen::Matrix<typename Matrix::Scalar, 3, 1>;
  const double h = step.value();
  if (!(h > 0.0 && std::isfinite(h)))
    throw BadInput("require_motion_laws: the step is " + detail::text(h) + " s");
  const auto at = [&](double s) { return f(t + Quantity<si::time>::from_value(s)); };
  const auto law = [&](const char* what, const char* of, const auto& value, const auto& claimed) {
    detail::require_law<A, B>(what, of, value, claimed, value(0.0).norm(), h, tolerance,
                              detail::instant_text(t));
  };

  const Value now = at(0.0);
  const auto rotation = [&](double s) -> Matrix { return rotation_of(at(s)).matrix(); };
  const Matrix R = rotation(0.0);
  const double apart =
      (R.transpose() * R - Matrix::Identity()).cwiseAbs().template maxCoeff<Eigen::PropagateNaN>();
  if (!(apart <= tolerance)) {
    throw BadInput("the rotation of " + frame_name<B>() + " relative to " + frame_name<A>() + " at " +
                   detail::instant_text(t) + " is none: R^T R differs from I by " + detail::text(apart));
  }
  if constexpr (Known::level >= Level::rate) {
    const Matrix Rdot = R * hat(angular_velocity_of(now).coordinates());
    law("the rate", "rotation", rotation, Rdot);
    if constexpr (Known::placed) {
      const auto position = [&](double s) -> Column { return at(s).translation.coordinates(); };
      law("the velocity", "position", position, now.velocity.coordinates());
    }
  }
  if constexpr (Known::level >= Level::acceleration) {
    const auto rate = [&](double s) -> Column { return angular_velocity_of(at(s)).coordinates(); };
    law("the angular acceleration", "rate", rate,
        angular_acceleration_of(accelerating_part(now)).coordinates());
    if constexpr (Known::placed) {
      const auto velocity = [&](double s) -> Column { return at(s).velocity.coordinates(); };
      law("the acceleration", "velocity", velocity, now.acceleration.coordinates());
    }
  }
}

}  // namespace vectrix
