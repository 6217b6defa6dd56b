#pragma once

#include <vectrix/dynamics/multibody/ball.hpp>
#include <vectrix/dynamics/multibody/fixed.hpp>
#include <vectrix/dynamics/multibody/free.hpp>
#include <vectrix/dynamics/multibody/hinge.hpp>
#include <vectrix/dynamics/multibody/slider.hpp>

namespace vectrix::multibody {

/// One switch, so that the code of each kind is inlined into its case.
template <class Function> [[gnu::always_inline]] inline auto with_kind(Kind kind, const Function& f) {
  switch (kind) {
    case Kind::hinge:
      return f(Hinge{});
    case Kind::slider:
      return f(Slider{});
    case Kind::ball:
      return f(Ball{});
    case Kind::free:
      return f(Free{});
    case Kind::fixed:
      break;
  }
  return f(Fixed{});
}

}  // namespace vectrix::multibody
