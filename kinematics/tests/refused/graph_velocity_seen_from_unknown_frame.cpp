// mistake: a velocity seen from a frame that is not in the graph
// expect: UnknownFrame<Itrf>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};
struct Itrf : vectrix::moving_frame {};

using namespace vectrix;

AcceleratingTransform<Gcrf, Body> orbit(Quantity<si::time> t);
MovingTransform<Body, Camera> camera(Quantity<si::time> t);

auto motion(const Quantity<si::time>& t) {
  const auto graph = frame_graph(edge(orbit), edge(camera));
#ifdef REPAIRED
  return graph.at(t).velocity(of<Camera>, relative_to<Gcrf>, observed_from<Body>, in<Gcrf>);
#else
  return graph.at(t).velocity(of<Camera>, relative_to<Gcrf>, observed_from<Itrf>, in<Gcrf>);
#endif
}
