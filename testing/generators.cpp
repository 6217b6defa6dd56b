#include "testing/generators.hpp"

namespace rc {
template class Gen<bool>;
template class Gen<int>;
template class Gen<std::int64_t>;
template class Gen<std::size_t>;
template class Gen<double>;
}  // namespace rc
