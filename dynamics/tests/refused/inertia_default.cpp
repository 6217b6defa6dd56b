// mistake: an inertia that nobody gave
// expect: Inertia<Body
#include <vectrix/dynamics.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto satellite() {
#ifdef REPAIRED
  const auto moment = 3.0 * si::kilogram_square_metre;
  const auto none = 0.0 * si::kilogram_square_metre;
  const Inertia<Body> J_body = inertia_from_tensor(in<Body>, moment, moment, moment, none, none, none);
#else
  const Inertia<Body> J_body;
#endif
  return J_body;
}
