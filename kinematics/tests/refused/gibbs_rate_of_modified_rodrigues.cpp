// mistake: the rate of modified Rodrigues parameters taken for that of a Gibbs vector
// expect: Attitude = (vectrix::)?GibbsVector<Gcrf, Body
// expect: Rate = (vectrix::)?ParameterRate<(vectrix::)?ModifiedRodrigues<Gcrf, Body
// expect: xdot the rate of that x
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto rate_of(const GibbsVector<Gcrf, Body>& g, const ModifiedRodrigues<Gcrf, Body>& sigma,
             const ParameterRate<ModifiedRodrigues<Gcrf, Body>>& sigmadot) {
#ifdef REPAIRED
  return static_cast<void>(g), sigma.angular_velocity(sigmadot, in<Body>);
#else
  return static_cast<void>(sigma), g.angular_velocity(sigmadot, in<Body>);
#endif
}
