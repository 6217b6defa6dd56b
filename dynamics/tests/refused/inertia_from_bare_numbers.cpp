// mistake: moments of inertia without a unit
// expect: inertia_from_tensor
// expect: six quantities in kg m.2
// expect: double
#include <vectrix/dynamics.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto satellite() {
#ifdef REPAIRED
  const auto unit = si::kilogram_square_metre;
#else
  const double unit = 1.0;
#endif
  return inertia_from_tensor(in<Body>, 3.0 * unit, 4.0 * unit, 5.0 * unit, 0.1 * unit, 0.2 * unit,
                             0.3 * unit);
}
