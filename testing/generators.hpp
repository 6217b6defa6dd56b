#pragma once

#include <cstddef>
#include <cstdint>

#include <rapidcheck.h>

/// Generators of the values that most properties draw are compiled once, in generators.cpp.
namespace rc {
extern template class Gen<bool>;
extern template class Gen<int>;
extern template class Gen<std::int64_t>;
extern template class Gen<std::size_t>;
extern template class Gen<double>;
}  // namespace rc
