// mistake: a rate and a position expressed in different frames
// expect: AngularVelocity<Gcrf, Body, (vectrix::)?In<Gcrf>
// expect: Displacement<Gcrf, Tip, (vectrix::)?In<Body>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};
struct Tip : vectrix::named_point {};

using namespace vectrix;

auto motion(const AngularVelocity<Gcrf, Body, In<Gcrf>>& w_ib_i, const Displacement<Gcrf, Tip, In<Body>>& r_b,
            const Dcm<Body, Gcrf>& R_b_from_i) {
#ifdef REPAIRED
  return centrifugal_acceleration(R_b_from_i * w_ib_i, r_b);
#else
  return static_cast<void>(R_b_from_i), centrifugal_acceleration(w_ib_i, r_b);
#endif
}
