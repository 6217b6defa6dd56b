// mistake: a Gibbs vector used as modified Rodrigues parameters
// expect: GibbsVector<Gcrf, Body
// expect: ModifiedRodrigues<Gcrf, Body
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

ModifiedRodrigues<Gcrf, Body> attitude(const GibbsVector<Gcrf, Body>& g) {
#ifdef REPAIRED
  return modified_rodrigues(quaternion(g));
#else
  return g;
#endif
}
