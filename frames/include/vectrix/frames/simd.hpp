#pragma once

#include <Eigen/Core>
#include <experimental/simd>
#include <limits>

/// Several attitudes at once: std::experimental::simd<double, Abi> as the scalar of every type of the
/// library,
///     using Lanes = std::experimental::native_simd<double>;
///     Dcm<B, A, Lanes>, Vector<B, si::length, Lanes>, CentralInertia<B, Lanes>
/// Each lane is computed as a double is. A door refuses the whole when one lane is bad. What needs more than
/// a choice between two results, nearest_dcm() and the checked doors of Inertia, goes lane by lane.
/// clang refuses batches that want more alignment than Eigen's matrices have: fixed_size_simd<double, 4>
/// without AVX. A header of its own, which <vectrix/frames.hpp> does not bring: <experimental/simd> takes
/// long to compile.
template <class Abi>
struct Eigen::NumTraits<std::experimental::simd<double, Abi>>
    : Eigen::GenericNumTraits<std::experimental::simd<double, Abi>> {
  using Literal = double;
  enum { IsSigned = 1, RequireInitialization = 0 };

  static double epsilon() { return std::numeric_limits<double>::epsilon(); }
  static double dummy_precision() { return Eigen::NumTraits<double>::dummy_precision(); }
  static double highest() { return std::numeric_limits<double>::max(); }
  static double lowest() { return std::numeric_limits<double>::lowest(); }
  static int digits10() { return std::numeric_limits<double>::digits10; }
};
