// mistake: both vectors of an observation are in the body: they say nothing of its attitude
// expect: Measured = vectrix::Vector<Body|Vector<Body.*Vector<Body
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto observe(const Vector<Body, si::length>& sun_b, const Vector<Gcrf, si::length>& sun_i,
             const Dcm<Body, Gcrf>& R_b_from_i) {
#ifdef REPAIRED
  static_cast<void>(R_b_from_i);
  return observation(sun_b, sun_i, 0.01 * si::radian);
#else
  return observation(sun_b, R_b_from_i * sun_i, 0.01 * si::radian);
#endif
}
