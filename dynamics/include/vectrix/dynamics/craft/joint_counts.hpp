#pragma once

#include <cstddef>
#include <vectrix/dynamics/craft/plain_spacecraft.hpp>
#include <vectrix/dynamics/multibody/kinds.hpp>

namespace vectrix::detail {

/// How many axes a joint is given, links it has in the tree, and numbers in the state. The kinds of the
/// engine say the last two; a gimbal is two hinges.
struct JointCounts {
  std::size_t axes, links, positions, speeds;
};
constexpr JointCounts counts_of(JointKind kind) {
  constexpr auto of = [](std::size_t axes, std::size_t links, auto engine) {
    return JointCounts{axes, links, links * engine.positions, links * engine.speeds};
  };
  switch (kind) {
    case JointKind::hinge:
      return of(1, 1, multibody::Hinge{});
    case JointKind::slider:
      return of(1, 1, multibody::Slider{});
    case JointKind::gimbal:
      return of(2, 2, multibody::Hinge{});
    case JointKind::ball:
      return of(0, 1, multibody::Ball{});
    case JointKind::free:
      return of(0, 1, multibody::Free{});
    case JointKind::fixed:
      break;
  }
  return of(0, 1, multibody::Fixed{});
}

}  // namespace vectrix::detail
