// mistake: a transform assigned to its inverse
// expect: Transform<Body, Gcrf
// expect: Transform<Gcrf, Body
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};
struct Tip : vectrix::named_point {};

using namespace vectrix;

Transform<Gcrf, Body> motion(const Transform<Body, Gcrf>& X_b_from_i) {
#ifdef REPAIRED
  return inverse(X_b_from_i);
#else
  return X_b_from_i;
#endif
}
