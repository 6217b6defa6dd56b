// mistake: the rotating observer's velocity taken for the inertial one's
// expect: Velocity<Gcrf, Tip, (vectrix::)?ObservedFrom<Body>
// expect: Velocity<Gcrf, Tip, (vectrix::)?ObservedFrom<Gcrf>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};
struct Tip : vectrix::named_point {};

using namespace vectrix;

Velocity<Gcrf, Tip, ObservedFrom<Gcrf>, In<Body>> motion(
    const Velocity<Gcrf, Tip, ObservedFrom<Body>, In<Body>>& v_b,
    const Displacement<Gcrf, Tip, In<Body>>& r_b, const AngularVelocity<Gcrf, Body, In<Body>>& w_ib_b) {
#ifdef REPAIRED
  return transport(observed_from<Gcrf>, v_b, r_b, w_ib_b);
#else
  return static_cast<void>(r_b), static_cast<void>(w_ib_b), v_b;
#endif
}
