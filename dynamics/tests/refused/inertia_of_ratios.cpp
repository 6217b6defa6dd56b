// mistake: dimensionless ratios for moments of inertia, kg m^2
// expect: inertia_from_tensor
// expect: dimensionless
#include <vectrix/dynamics.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto satellite(const Quantity<si::dimensionless>& ratio, const Quantity<si::moment_of_inertia>& moment) {
#ifdef REPAIRED
  const Quantity<si::moment_of_inertia> product = ratio * moment;
#else
  const Quantity<si::dimensionless> product = ratio;
#endif
  return inertia_from_tensor(in<Body>, moment, moment, moment, product, product, product);
}
