// mistake: a free vector moved as if it were a position
// expect: Transform<Body, Gcrf
// expect: Vector<Gcrf
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};
struct Tip : vectrix::named_point {};

using namespace vectrix;

auto motion(const Transform<Body, Gcrf>& X_b_from_i, const Vector<Gcrf, si::length>& r_i) {
#ifdef REPAIRED
  return X_b_from_i.rotation * r_i;
#else
  return X_b_from_i * r_i;
#endif
}
