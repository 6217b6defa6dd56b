#pragma once

#include <functional>
#include <string>
#include <type_traits>
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
/// What is called where a function takes no such arguments.
struct TakesAnything {
  void operator()(...) const;
};
template <class F> struct OrAnything : F, TakesAnything {
  using F::operator();
  using TakesAnything::operator();
};
template <class F> struct AndCallOperator : F, TakesAnything {};
/// Whether the result of a function of these arguments is not known, because its body has an error: the
/// compiler has said it, and what the function is given to need not refuse it again.
template <class F, class... Given> constexpr bool has_error() {
  if constexpr (!std::is_class_v<F> || std::is_final_v<F>) {
    return false;
  } else if constexpr (requires { &AndCallOperator<F>::operator(); }) {
    return false;  // F has no call operator
  } else if constexpr (std::is_invocable_v<const F&, Given...>) {
    return false;
  } else {
    return !requires(const OrAnything<F>& f, Given... given) {
      f(given...);
    };
  }
}

/// The function itself, if it is one.
template <class Door, class F> F given_function(const Door& door, F function) {
  require_function(door, function);
  return function;
}

}  // namespace vectrix::detail
