// mistake: the rate of the old observer relative to the new one, reversed
// expect: AngularVelocity<Body, Gcrf
// expect: Velocity<Gcrf, Tip, (vectrix::)?ObservedFrom<Body>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};
struct Tip : vectrix::named_point {};

using namespace vectrix;

auto motion(const Velocity<Gcrf, Tip, ObservedFrom<Body>, In<Body>>& v_b,
            const Displacement<Gcrf, Tip, In<Body>>& r_b,
            const AngularVelocity<Body, Gcrf, In<Body>>& w_bi_b) {
#ifdef REPAIRED
  return transport(observed_from<Gcrf>, v_b, r_b, -w_bi_b);
#else
  return transport(observed_from<Gcrf>, v_b, r_b, w_bi_b);
#endif
}
