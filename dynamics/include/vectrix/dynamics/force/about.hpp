#pragma once

#include <vectrix/frames/frame.hpp>

namespace vectrix {

/// The centre of mass of the body whose frame is B: a point. The names CentreOfMass and CenterOfMass stay
/// free for users' own points, beside `using namespace vectrix`.
template <Frame B> struct CentreOfMassOf : named_point {};

/// The point of an inertia: about<P>.
template <Point P> struct About {};
template <Point P> inline constexpr About<P> about{};

}  // namespace vectrix
