// mistake: a state relative to the rotating Earth
// expect: InertialFrame
// expect: Ecef
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Ecef : vectrix::moving_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

#ifdef REPAIRED
double start(const State<Eci, Body>& state);
#else
double start(const State<Ecef, Body>& state);
#endif
