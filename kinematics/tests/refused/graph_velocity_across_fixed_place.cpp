// mistake: a velocity across an edge whose motion is not known
// expect: RateOn<(vectrix::)?Link<Body, Camera>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};
struct Itrf : vectrix::moving_frame {};

using namespace vectrix;

AcceleratingTransform<Gcrf, Body> orbit(Quantity<si::time> t);
Transform<Body, Camera> camera(Quantity<si::time> t);

auto motion(const Quantity<si::time>& t) {
  const auto graph = frame_graph(edge(orbit), edge(camera));
#ifdef REPAIRED
  return graph.at(t).position(of<Camera>, relative_to<Gcrf>, in<Gcrf>);
#else
  return graph.at(t).velocity(of<Camera>, relative_to<Gcrf>, observed_from<Gcrf>, in<Gcrf>);
#endif
}
