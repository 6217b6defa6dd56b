// mistake: the frame of one wheel taken for that of another
// expect: Left = (vectrix::)?Dcm<Body, Wheel<2>
// expect: Right = (vectrix::)?Dcm<Wheel<1>, Body
// expect: the inner frames cancel
#include <vectrix/frames.hpp>

struct Body : vectrix::moving_frame {};
template <int I> struct Wheel : vectrix::moving_frame {};

using namespace vectrix;

auto mounting(const Dcm<Body, Wheel<2>>& R_body_from_wheel, const Dcm<Wheel<1>, Body>& R_wheel_from_body) {
#ifdef REPAIRED
  return R_wheel_from_body * R_body_from_wheel;
#else
  return R_body_from_wheel * R_wheel_from_body;
#endif
}
