// mistake: the position between the same points, reversed
// expect: Displacement<Tip, Gcrf
// expect: Velocity<Gcrf, Tip, (vectrix::)?ObservedFrom<Body>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};
struct Tip : vectrix::named_point {};

using namespace vectrix;

auto motion(const Velocity<Gcrf, Tip, ObservedFrom<Body>, In<Body>>& v_b,
            const Displacement<Tip, Gcrf, In<Body>>& r_b,
            const AngularVelocity<Gcrf, Body, In<Body>>& w_ib_b) {
#ifdef REPAIRED
  return transport(observed_from<Gcrf>, v_b, -r_b, w_ib_b);
#else
  return transport(observed_from<Gcrf>, v_b, r_b, w_ib_b);
#endif
}
