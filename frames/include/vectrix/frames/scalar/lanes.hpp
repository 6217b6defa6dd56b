#pragma once

#include <Eigen/Core>
#include <experimental/simd>
#include <limits>

/// Several attitudes at once: std::experimental::simd<double, Abi>, or of floats, as the scalar of every type
/// of the library,
///     using Lanes = std::experimental::native_simd<double>;
///     Dcm<B, A, Lanes>, Vector<B, si::length, Lanes>, CentralInertia<B, Lanes>
/// Each lane is computed as a double is. A door refuses the whole when one lane is bad. What needs more than
/// a choice between two results, nearest_dcm() and the checked doors of Inertia, goes lane by lane.
/// clang refuses batches that want more alignment than Eigen's matrices have: fixed_size_simd<double, 4>
/// without AVX. A header of its own, which <vectrix/frames.hpp> does not bring: <experimental/simd> takes
/// long to compile.
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
