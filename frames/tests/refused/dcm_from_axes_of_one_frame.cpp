// mistake: the axes of a frame given in itself
// expect: ToFrame = (vectrix::)?To<Body>
// expect: Vector<Body
// expect: two frames
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto attitude(const Vector<Body, si::dimensionless>& x, const Vector<Body, si::dimensionless>& y,
              const Vector<Body, si::dimensionless>& z) {
#ifdef REPAIRED
  return dcm_from_axes(to<Gcrf>, x, y, z);
#else
  return dcm_from_axes(to<Body>, x, y, z);
#endif
}
