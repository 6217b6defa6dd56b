// mistake: parts joined whose centres of mass are given from different origins
// expect: MassProperties<Body
// expect: MassProperties<Wheel
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Wheel : vectrix::moving_frame {};
struct Satellite : vectrix::moving_frame {};
struct Hinge : vectrix::named_point {};

using namespace vectrix;

auto satellite(const MassProperties<Body>& body, const MassProperties<Wheel, Wheel, In<Body>>& wheel,
               const Displacement<Wheel, Body, In<Body>>& r_wb) {
#ifdef REPAIRED
  return join(of<Satellite>, body, shift(wheel, r_wb));
#else
  return static_cast<void>(r_wb), join(of<Satellite>, body, wheel);
#endif
}
