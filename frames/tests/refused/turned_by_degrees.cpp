// mistake: degrees given for radians
// expect: turned_z
#include <vectrix/frames.hpp>

struct Itrf : vectrix::moving_frame {};
struct Gcrf : vectrix::inertial_frame {};

using namespace vectrix;

auto earth() {
#ifdef REPAIRED
  return turned_z(to<Itrf>, from<Gcrf>, convert<si::angle>(30.0 * si::degree));
#else
  return turned_z(to<Itrf>, from<Gcrf>, 30.0 * si::degree);
#endif
}
