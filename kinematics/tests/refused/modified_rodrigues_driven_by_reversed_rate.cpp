// mistake: parameters of b relative to a driven by the rate of a relative to b
// expect: Rotation = (vectrix::)?ModifiedRodrigues<Gcrf, Body
// expect: Rate = (vectrix::)?AngularVelocity<Body, Gcrf
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto rate_of(const ModifiedRodrigues<Gcrf, Body>& sigma,
             const AngularVelocity<Body, Gcrf, In<Body>>& w_bi_b) {
#ifdef REPAIRED
  return rate(sigma, -w_bi_b);
#else
  return rate(sigma, w_bi_b);
#endif
}
