#pragma once

#include <array>
#include <cstddef>

#include <vectrix/frames/export.hpp>

namespace vectrix::ode {

/// The Radau IIA method of 7 stages and order 13: collocation at the zeros of P_6 - P_7 on [0, 1], P
/// Legendre's polynomials, of which the last is 1:
///     Y_i = y + h sum_j a_ij f(t + c_j h, Y_j),  y_new = Y_7.
/// It is stiffly accurate and L-stable. The coefficients are computed once, see E. Hairer, G. Wanner, Solving
/// Ordinary Differential Equations II, section IV.5.
struct VECTRIX_EXPORT RadauIIA7 {
  static constexpr std::size_t stages = 7;
  static constexpr int order = 13;

  std::array<double, stages> c;
  std::array<std::array<double, stages>, stages> a;  ///< the last row has the weights

  static const RadauIIA7& table();
};

}  // namespace vectrix::ode
