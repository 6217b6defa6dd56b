#pragma once

#include <gtest/gtest.h>

#include <vectrix/frames/scalar/lanes.hpp>

namespace vectrix_test {

/// Batches of doubles, as wide as a register and otherwise. clang puts none into Eigen's matrices that wants
/// more alignment than the machine's registers.
#ifdef __clang__
using Batches = testing::Types<std::experimental::native_simd<double>,
                               std::experimental::simd<double, std::experimental::simd_abi::scalar>>;
#else
using Batches =
    testing::Types<std::experimental::native_simd<double>, std::experimental::fixed_size_simd<double, 4>>;
#endif

}  // namespace vectrix_test
