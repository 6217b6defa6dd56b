// mistake: an angle without a unit
// expect: turned_z
#include <vectrix/frames.hpp>

struct Itrf : vectrix::moving_frame {};
struct Gcrf : vectrix::inertial_frame {};

using namespace vectrix;

auto earth() {
#ifdef REPAIRED
  return turned_z(to<Itrf>, from<Gcrf>, 0.5 * si::radian);
#else
  return turned_z(to<Itrf>, from<Gcrf>, 0.5);
#endif
}
