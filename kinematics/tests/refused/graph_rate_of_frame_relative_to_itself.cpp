// mistake: the rate of a frame relative to itself
// expect: Lacking = (vectrix::)?OtherFrameThan<Body>
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
  return graph.at(0.0 * si::second).angular_velocity(of<Body>, relative_to<Gcrf>, in<Gcrf>);
#else
  const auto graph = frame_graph(edge(attitude), edge(camera));
  return graph.at(0.0 * si::second).angular_velocity(of<Body>, relative_to<Body>, in<Gcrf>);
#endif
}
