// mistake: the Magnus increment of a rate expressed in the reference frame
// expect: magnus_increment
// expect: in b's own axes
// expect: InReference|in_reference
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

struct InReference {
  AngularVelocity<Gcrf, Body, In<Gcrf>> operator()(const Quantity<si::time>& t) const;
};
struct InBody {
  AngularVelocity<Gcrf, Body, In<Body>> operator()(const Quantity<si::time>& t) const;
};

auto turn([[maybe_unused]] const InBody& in_body, [[maybe_unused]] const InReference& in_reference,
          const Quantity<si::time>& t, const Quantity<si::time>& dt) {
#ifdef REPAIRED
  return magnus_increment<4>(in_body, t, dt);
#else
  return magnus_increment<4>(in_reference, t, dt);
#endif
}
