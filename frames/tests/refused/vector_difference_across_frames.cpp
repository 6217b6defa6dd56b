// mistake: a difference of two vectors expressed in different frames
// expect: Left = (vectrix::)?Vector<Gcrf
// expect: Right = (vectrix::)?Vector<Body
// expect: one frame and one unit
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto position(const Dcm<Gcrf, Body>& R_gcrf_from_body, const Vector<Gcrf, si::length>& r_gcrf,
              const Vector<Body, si::length>& s_body) {
#ifdef REPAIRED
  return r_gcrf - R_gcrf_from_body * s_body;
#else
  static_cast<void>(R_gcrf_from_body);
  return r_gcrf - s_body;
#endif
}
