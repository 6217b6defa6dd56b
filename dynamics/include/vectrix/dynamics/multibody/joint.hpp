#pragma once

#include <vectrix/dynamics/multibody/body.hpp>

namespace vectrix::multibody {

/// The kinds of joints by which a body b hangs on its parent p. Each has its own header, where everything
/// that the engine needs of it stands. A gimbal of two axes is two hinges with a massless ring between them.
enum class Kind { hinge, slider, ball, free, fixed };

/// A joint in plain numbers. Made by hinge(), slider(), ball(), free() and fixed().
template <class S> struct Joint {
  Kind kind;
  Square<S> K0, K1, K2;  ///< R_b^p = K0 + cos q K1 + sin q K2 of a hinge; else K0 at zero, and no others
  Column<S> axis_p;      ///< of a hinge or slider, unit vector in the parent's axes
  Column<S> origin_p;    ///< the origin of b at zero, from that of p, in the parent's axes
};

/// Without an axis: where b is at zero, R_b^p and r_pb^p.
template <class S> Joint<S> joint(Kind kind, const Square<S>& R_p_from_b, const Column<S>& r_pb_p) {
  const Square<S> none{zero_column<S>(), zero_column<S>(), zero_column<S>()};
  return {kind, R_p_from_b, none, none, zero_column<S>(), r_pb_p};
}

}  // namespace vectrix::multibody
