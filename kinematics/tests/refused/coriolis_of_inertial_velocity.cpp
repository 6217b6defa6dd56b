// mistake: the Coriolis acceleration of the inertial observer's velocity
// expect: Velocity<Gcrf, Tip, (vectrix::)?ObservedFrom<Gcrf>
// expect: AngularVelocity<Gcrf, Body
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};
struct Tip : vectrix::named_point {};

using namespace vectrix;

auto motion(const Velocity<Gcrf, Tip, ObservedFrom<Gcrf>, In<Body>>& v_i,
            const Displacement<Gcrf, Tip, In<Body>>& r_b,
            const AngularVelocity<Gcrf, Body, In<Body>>& w_ib_b) {
#ifdef REPAIRED
  return coriolis_acceleration(w_ib_b, transport(observed_from<Body>, v_i, r_b, -w_ib_b));
#else
  return static_cast<void>(r_b), coriolis_acceleration(w_ib_b, v_i);
#endif
}
