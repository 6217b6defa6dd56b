#pragma once

#include <gtest/gtest.h>

#include <vectrix/frames/scalar/lanes.hpp>

namespace vectrix_test {

/// Batches of doubles, of the width of a register and of other widths. clang cannot store a batch in Eigen's
/// matrices if it needs more alignment than the machine's registers.
#ifdef __clang__
using Batches = testing::Types<std::experimental::native_simd<double>,
                               std::experimental::simd<double, std::experimental::simd_abi::scalar>>;
#else
using Batches =
    testing::Types<std::experimental::native_simd<double>, std::experimental::fixed_size_simd<double, 4>>;
#endif

}  // namespace vectrix_test
