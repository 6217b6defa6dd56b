// mistake: a place without a velocity chained to a motion, as if it were at rest
// expect: MovingTransform<Gcrf, Body
// expect: Transform<Body, Camera
// expect: the kinds go together
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};
struct Tip : vectrix::named_point {};

using namespace vectrix;

auto motion(const MovingTransform<Gcrf, Body>& ib, const Transform<Body, Camera>& X_b_from_c,
            const MovingTransform<Body, Camera>& bc) {
#ifdef REPAIRED
  return (static_cast<void>(X_b_from_c), ib * bc);
#else
  return static_cast<void>(bc), ib * X_b_from_c;
#endif
}
