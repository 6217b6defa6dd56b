// mistake: rates of twists added, without the bracket
// expect: Left = (vectrix::)?TwistRate<Gcrf, Body, (vectrix::)?At<Camera>, (vectrix::)?In<Body>
// expect: Right = (vectrix::)?TwistRate<Body, Camera, (vectrix::)?At<Camera>, (vectrix::)?In<Body>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

template <class A, class B> using V = Twist<A, B, At<Camera>, In<Body>>;
template <class A, class B> using Vdot = TwistRate<A, B, At<Camera>, In<Body>>;

Vdot<Gcrf, Camera> motion(const V<Gcrf, Body>& V_ab, const Vdot<Gcrf, Body>& Vdot_ab,
                          const V<Body, Camera>& V_bc, const Vdot<Body, Camera>& Vdot_bc) {
#ifdef REPAIRED
  return chain(Vdot_ab, Vdot_bc, V_ab, V_bc);
#else
  static_cast<void>(V_ab);
  static_cast<void>(V_bc);
  return Vdot_ab + Vdot_bc;
#endif
}
