#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vectrix/frames/export.hpp>

namespace vectrix::detail {

template <class F> inline constexpr bool may_be_empty = false;
template <class R, class... Given> inline constexpr bool may_be_empty<std::function<R(Given...)>> = true;
template <class R, class... Given> inline constexpr bool may_be_empty<R (*)(Given...)> = true;

/// Throws BadInput: the door was given an empty function.
[[noreturn]] VECTRIX_EXPORT void refuse_empty_function(const std::string& door);

/// Throws BadInput for a std::function or a pointer that holds none; `door` makes the name of the door.
template <class Door, class F> void require_function(const Door& door, const F& function) {
  if constexpr (may_be_empty<F>)
    if (!function) refuse_empty_function(door());
}
/// The function itself, if it is one.
template <class Door, class F> F given_function(const Door& door, F function) {
  require_function(door, function);
  return function;
}

}  // namespace vectrix::detail
