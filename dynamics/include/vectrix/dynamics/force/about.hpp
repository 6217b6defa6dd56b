#pragma once

#include <vectrix/frames/frame.hpp>

namespace vectrix {

/// The centre of mass of the body whose frame is B: a point. The library does not use the names CentreOfMass
/// and CenterOfMass: users can give them to points of their own, also with `using namespace vectrix`.
template <Frame B> struct CentreOfMassOf : named_point {};

/// The point of an inertia: about<P>.
template <Point P> struct About {};
template <Point P> inline constexpr About<P> about{};

}  // namespace vectrix
