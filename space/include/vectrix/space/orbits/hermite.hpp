#pragma once

#include <vectrix/frames/errors.hpp>
#include <vectrix/frames/vector.hpp>

namespace vectrix {

/// A position in F and its derivative seen from F.
template <Frame F> struct PositionVelocity {
  Vector<F, si::length> position;
  Vector<F, si::velocity> velocity;
};

/// Position and velocity at the time t after the sample `start`, with `end` a time h after it: the cubic that
/// has both positions and velocities (Hermite), and its derivative. With s = t/h:
///     r = r0 + s^2 (3 - 2s) (r1 - r0) + s (1 - s) h ((1 - s) v0 - s v1)
/// In the middle it is h^4/384 times the fourth derivative of r away.
/// Throws BadInput when h is not positive and finite, or t is outside [0, h].
template <Frame F>
PositionVelocity<F> hermite(const PositionVelocity<F>& start, const PositionVelocity<F>& end,
                            const Quantity<si::time>& h, const Quantity<si::time>& t) {
  const double s = t.value() / h.value();
  if (!(h.value() > 0.0 && h.value() - h.value() == 0.0 && s >= 0.0 && s <= 1.0)) {
    throw BadInput("hermite in " + frame_name<F>() + ": the time " + detail::text(t.value()) +
                   " s is outside [0, " + detail::text(h.value()) + "] s");
  }
  const auto step = end.position - start.position;
  return {start.position + s * s * (3.0 - 2.0 * s) * step +
              s * (1.0 - s) * (h * ((1.0 - s) * start.velocity - s * end.velocity)),
          6.0 * s * (1.0 - s) * (step / h) + (1.0 - s) * (1.0 - 3.0 * s) * start.velocity +
              s * (3.0 * s - 2.0) * end.velocity};
}

}  // namespace vectrix
