// mistake: a step on the group with the rate of another body
// expect: commutator_free_step
// expect: OfCamera
// expect: A = Gcrf
// expect: B = Body
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

struct OfCamera {
  AngularVelocity<Gcrf, Camera, In<Camera>> operator()(const Quantity<si::time>& t,
                                                       const Dcm<Gcrf, Body>& R_gcrf_from_body) const;
};
struct OfBody {
  AngularVelocity<Gcrf, Body, In<Body>> operator()(const Quantity<si::time>& t,
                                                   const Dcm<Gcrf, Body>& R_gcrf_from_body) const;
};

auto step([[maybe_unused]] const OfBody& of_body, [[maybe_unused]] const OfCamera& of_camera,
          const Dcm<Gcrf, Body>& R_gcrf_from_body, const Quantity<si::time>& t,
          const Quantity<si::time>& dt) {
#ifdef REPAIRED
  return commutator_free_step(of_body, R_gcrf_from_body, t, dt);
#else
  return commutator_free_step(of_camera, R_gcrf_from_body, t, dt);
#endif
}
