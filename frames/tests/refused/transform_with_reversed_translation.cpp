// mistake: the translation from the wrong origin, in the wrong frame
// expect: Displacement<Gcrf, Body|'Body' vs. 'Gcrf'
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};
struct Tip : vectrix::named_point {};

using namespace vectrix;

auto motion(const Dcm<Body, Gcrf>& R_b_from_i, const Displacement<Gcrf, Body, In<Gcrf>>& r_ib_i) {
#ifdef REPAIRED
  return Transform{R_b_from_i, -(R_b_from_i * r_ib_i)};
#else
  return Transform{R_b_from_i, r_ib_i};
#endif
}
