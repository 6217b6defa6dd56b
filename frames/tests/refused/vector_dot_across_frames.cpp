// mistake: a dot product of two vectors expressed in different frames
// expect: Left = (vectrix::)?Vector<Itrf
// expect: Right = (vectrix::)?Vector<Gcrf
// expect: two vectors in one frame
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Itrf : vectrix::moving_frame {};

using namespace vectrix;

auto product(const Dcm<Itrf, Gcrf>& R_itrf_from_gcrf, const Vector<Itrf, si::length>& r_itrf,
             const Vector<Gcrf, si::force>& F_gcrf) {
#ifdef REPAIRED
  return dot(r_itrf, R_itrf_from_gcrf * F_gcrf);
#else
  static_cast<void>(R_itrf_from_gcrf);
  return dot(r_itrf, F_gcrf);
#endif
}
