// mistake: the references come first and the measurements second in each pair
// expect: to<B>, from<A>, r_b, r_a, s_b, s_a
// expect: First = vectrix::Vector<Gcrf|Vector<Gcrf
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto attitude(const Vector<Body, si::length>& sun_b, const Vector<Gcrf, si::length>& sun_i,
              const Vector<Body, si::force>& pull_b, const Vector<Gcrf, si::force>& pull_i) {
#ifdef REPAIRED
  return triad(to<Body>, from<Gcrf>, sun_b, sun_i, pull_b, pull_i);
#else
  return triad(to<Body>, from<Gcrf>, sun_i, sun_b, pull_i, pull_b);
#endif
}
