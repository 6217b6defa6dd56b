// mistake: a step on the group with a rate expressed in the reference frame
// expect: munthe_kaas_step
// expect: InReference|in_reference
// expect: A = Gcrf
// expect: B = Body
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

struct InReference {
  AngularVelocity<Gcrf, Body, In<Gcrf>> operator()(const Quantity<si::time>& t,
                                                   const Dcm<Gcrf, Body>& R_gcrf_from_body) const;
};

auto step(const InReference& in_reference, const Dcm<Gcrf, Body>& R_gcrf_from_body,
          const Quantity<si::time>& t, const Quantity<si::time>& dt) {
#ifdef REPAIRED
  const auto in_body = [&](const Quantity<si::time>& now, const Dcm<Gcrf, Body>& R) {
    return inverse(R) * in_reference(now, R);
  };
  return munthe_kaas_step<4>(in_body, R_gcrf_from_body, t, dt);
#else
  return munthe_kaas_step<4>(in_reference, R_gcrf_from_body, t, dt);
#endif
}
