#pragma once

#include <cstddef>

namespace vectrix_test {

/// How often this program has allocated memory so far, by `new`, by malloc and its relatives, as Eigen does,
/// or in a library. Not under the sanitizers, which have a malloc of their own.
std::size_t allocations();

}  // namespace vectrix_test
