// mistake: the derivative of a rotation applied to a vector that is not expressed in its inner frame
// expect: Left = (vectrix::)?DcmRate<Gcrf, Body
// expect: Right = (vectrix::)?Vector<Gcrf
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto velocity(const DcmRate<Gcrf, Body>& Rdot_gcrf_from_body, const Vector<Gcrf, si::length>& r_gcrf,
              const Vector<Body, si::length>& r_body) {
#ifdef REPAIRED
  static_cast<void>(r_gcrf);
  return Rdot_gcrf_from_body * r_body;
#else
  static_cast<void>(r_body);
  return Rdot_gcrf_from_body * r_gcrf;
#endif
}
