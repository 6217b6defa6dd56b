// mistake: masses, kg, for moments of inertia, kg m^2
// expect: inertia_from_moments_and_products
// expect: mass_base_dimension
#include <vectrix/dynamics.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto satellite() {
#ifdef REPAIRED
  const auto unit = si::kilogram_square_metre;
#else
  const auto unit = si::kilogram;
#endif
  return inertia_from_moments_and_products(in<Body>, 3.0 * unit, 4.0 * unit, 5.0 * unit, 0.1 * unit,
                                           0.2 * unit, 0.3 * unit);
}
