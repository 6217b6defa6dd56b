#pragma once

#include <memory>

namespace vectrix::detail {

/// The type of a member's empty default list. With `= {}` instead, g++ 12 fails with an internal error, or at
/// link time, if the member is left out of the braces of an aggregate inside another aggregate.
template <class T> using no_list = std::allocator<T>;

}  // namespace vectrix::detail
