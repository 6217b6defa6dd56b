// mistake: an acceleration transported as if it were a velocity, without Euler and Coriolis
// expect: Acceleration<Gcrf, Tip, (vectrix::)?ObservedFrom<Body>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};
struct Tip : vectrix::named_point {};

using namespace vectrix;

auto motion(const Acceleration<Gcrf, Tip, ObservedFrom<Body>, In<Body>>& a_b,
            const Velocity<Gcrf, Tip, ObservedFrom<Body>, In<Body>>& v_b,
            const Displacement<Gcrf, Tip, In<Body>>& r_b,
            const AngularAcceleration<Gcrf, Body, In<Body>>& alpha_ib_b,
            const AngularVelocity<Gcrf, Body, In<Body>>& w_ib_b) {
#ifdef REPAIRED
  return transport(observed_from<Gcrf>, a_b, v_b, r_b, alpha_ib_b, w_ib_b);
#else
  return static_cast<void>(alpha_ib_b), static_cast<void>(v_b),
         transport(observed_from<Gcrf>, a_b, r_b, w_ib_b);
#endif
}
