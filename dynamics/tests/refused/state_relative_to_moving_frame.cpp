// mistake: a state relative to the rotating Earth
// expect: InertialFrame
// expect: Itrf
#include <vectrix/dynamics.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

#ifdef REPAIRED
double start(const State<Gcrf, Body>& state) { return state.time.value(); }
#else
double start(const State<Itrf, Body>& state) { return state.time.value(); }
#endif
