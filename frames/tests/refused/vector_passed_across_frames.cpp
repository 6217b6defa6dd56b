// mistake: a vector of one frame passed to a function that takes another
// expect: Vector<Wheel<2>
// expect: Vector<Body
#include <vectrix/frames.hpp>

struct Body : vectrix::moving_frame {};
template <int I> struct Wheel : vectrix::moving_frame {};

using namespace vectrix;

void apply(const Vector<Body, si::torque>& tau_body);

void control(const Dcm<Body, Wheel<2>>& R_body_from_wheel, const Vector<Wheel<2>, si::torque>& tau_wheel) {
#ifdef REPAIRED
  apply(R_body_from_wheel * tau_wheel);
#else
  static_cast<void>(R_body_from_wheel);
  apply(tau_wheel);
#endif
}
