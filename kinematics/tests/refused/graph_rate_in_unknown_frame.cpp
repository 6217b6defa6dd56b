// mistake: a rate asked in a frame that the graph does not have
// expect: Lacking = (vectrix::)?UnknownFrame<Ground>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};
struct Ground : vectrix::moving_frame {};

using namespace vectrix;

MovingDcm<Gcrf, Body> attitude(Quantity<si::time> t);
AcceleratingDcm<Body, Camera> camera(Quantity<si::time> t);

auto motion() {
#ifdef REPAIRED
  const auto graph = frame_graph(edge(attitude), rigid_edge(aligned(to<Body>, from<Camera>)));
  return graph.at(0.0 * si::second).angular_velocity(of<Camera>, relative_to<Gcrf>, in<Gcrf>);
#else
  const auto graph = frame_graph(edge(attitude), edge(camera));
  return graph.at(0.0 * si::second).angular_velocity(of<Camera>, relative_to<Gcrf>, in<Ground>);
#endif
}
