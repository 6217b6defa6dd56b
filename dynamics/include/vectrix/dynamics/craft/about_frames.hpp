#pragma once

#include <vectrix/frames/frame.hpp>

namespace vectrix::detail {

template <class Given> inline constexpr bool is_of = false;
template <class B> inline constexpr bool is_of<Of<B>> = true;
/// Whether of<B> is among the arguments. A refusal of any arguments must have it: functions of the same name
/// with other arguments are not of this library.
template <class... Given> inline constexpr bool about_frames = (is_of<Given> || ...);

}  // namespace vectrix::detail
