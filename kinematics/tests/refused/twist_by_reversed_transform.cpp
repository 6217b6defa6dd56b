// mistake: a twist taken to another frame by the inverse transform
// expect: Transform<Body, Camera
// expect: Twist<Gcrf, Body, (vectrix::)?At<Body>, (vectrix::)?In<Body>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};
struct Tip : vectrix::named_point {};

using namespace vectrix;

auto motion(const Twist<Gcrf, Body, At<Body>, In<Body>>& V_ib, const Transform<Body, Camera>& X_b_from_c) {
#ifdef REPAIRED
  return inverse(X_b_from_c) * V_ib;
#else
  return X_b_from_c * V_ib;
#endif
}
