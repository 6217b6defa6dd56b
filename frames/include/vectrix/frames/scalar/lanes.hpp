#pragma once

#include <Eigen/Core>
#include <experimental/simd>
#include <limits>

/// Several attitudes at once: std::experimental::simd<double, Abi>, or of float, as scalar of any type:
///     using Lanes = std::experimental::native_simd<double>;
///     Dcm<B, A, Lanes>, Vector<B, si::length, Lanes>, CentralInertia<B, Lanes>
/// Each lane is computed like a double. A door refuses the whole batch if one lane is bad. Algorithms that
/// need more than a choice between two results take one lane after the other: nearest_dcm() and the checked
/// doors of Inertia.
/// clang refuses batches with a larger alignment than Eigen's matrices: fixed_size_simd<double, 4> without
/// AVX. <vectrix/frames.hpp> does not include this header, because <experimental/simd> takes long to compile.
template <class Number, class Abi>
struct Eigen::NumTraits<std::experimental::simd<Number, Abi>>
    : Eigen::GenericNumTraits<std::experimental::simd<Number, Abi>> {
  using Literal = Number;
  enum { IsSigned = 1, RequireInitialization = 0 };

  static Number epsilon() { return std::numeric_limits<Number>::epsilon(); }
  static Number dummy_precision() { return Eigen::NumTraits<Number>::dummy_precision(); }
  static Number highest() { return std::numeric_limits<Number>::max(); }
  static Number lowest() { return std::numeric_limits<Number>::lowest(); }
  static int digits10() { return std::numeric_limits<Number>::digits10; }
};
