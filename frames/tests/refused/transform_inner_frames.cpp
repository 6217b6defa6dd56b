// mistake: transforms whose inner frames do not cancel
// expect: Transform<Camera, Body
// expect: Transform<Gcrf, Body
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};
struct Tip : vectrix::named_point {};

using namespace vectrix;

auto motion(const Transform<Camera, Body>& X_c_from_b, const Transform<Gcrf, Body>& X_i_from_b) {
#ifdef REPAIRED
  return X_c_from_b * inverse(X_i_from_b);
#else
  return X_c_from_b * X_i_from_b;
#endif
}
