// mistake: a rate asked across a chain in which one edge has none
// expect: Lacking = (vectrix::)?RateOn<(vectrix::)?Link<Body, Camera>
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

MovingDcm<Gcrf, Body> attitude(Quantity<si::time> t);
const Dcm<Body, Camera> mounting = aligned(to<Body>, from<Camera>);

auto motion() {
#ifdef REPAIRED
  const auto graph = frame_graph(edge(attitude), rigid_edge(mounting));
  return graph.at(0.0 * si::second).angular_velocity(of<Camera>, relative_to<Gcrf>, in<Gcrf>);
#else
  const auto graph = frame_graph(edge(attitude), static_edge(mounting));
  return graph.at(0.0 * si::second).angular_velocity(of<Camera>, relative_to<Gcrf>, in<Gcrf>);
#endif
}
