// mistake: a time in minutes where seconds are meant; convert<si::time>() says so
// expect: (minute|scale<60)
// expect: time
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto quarter_hour() {
  Propagation<Eci, Body> how;
#ifdef REPAIRED
  how.end = convert<si::time>(15.0 * si::minute);
#else
  how.end = 15.0 * si::minute;
#endif
  return how;
}
