// mistake: an acceleration asked across an edge that knows its rate only
// expect: Lacking = (vectrix::)?AccelerationOn<(vectrix::)?Link<Gcrf, Body>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

MovingDcm<Gcrf, Body> attitude(Quantity<si::time> t);
AcceleratingDcm<Body, Camera> camera(Quantity<si::time> t);

auto motion() {
#ifdef REPAIRED
  const auto graph = frame_graph(edge(attitude), edge(camera));
  return graph.at(0.0 * si::second).angular_acceleration(of<Camera>, relative_to<Body>, in<Camera>);
#else
  const auto graph = frame_graph(edge(attitude), edge(camera));
  return graph.at(0.0 * si::second).angular_acceleration(of<Camera>, relative_to<Gcrf>, in<Camera>);
#endif
}
