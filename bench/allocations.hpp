#pragma once

#include <cstddef>

namespace bench {

/// How often this program has allocated memory so far, by `new`, by malloc and its relatives, as Eigen does,
/// or in a library.
std::size_t allocations();

}  // namespace bench
