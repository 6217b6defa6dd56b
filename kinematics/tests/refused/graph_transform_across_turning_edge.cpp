// mistake: the transform across an edge of which the rotation alone is known
// expect: PlaceOn<(vectrix::)?Link<Body, Camera>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};
struct Itrf : vectrix::moving_frame {};

using namespace vectrix;

AcceleratingTransform<Gcrf, Body> orbit(Quantity<si::time> t);
AcceleratingDcm<Body, Camera> camera(Quantity<si::time> t);

auto motion(const Quantity<si::time>& t) {
  const auto graph = frame_graph(edge(orbit), edge(camera));
#ifdef REPAIRED
  return graph.at(t).rotation(to<Gcrf>, from<Camera>);
#else
  return graph.at(t).transform(to<Gcrf>, from<Camera>);
#endif
}
