// mistake: a rate asked across an edge whose motion is not known
// expect: Lacking = (vectrix::)?RateOn<(vectrix::)?Link<Body, Camera>
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto spacecraft() {
  return frame_graph(static_edge(aligned(to<Gcrf>, from<Body>)),
                     static_edge(aligned(to<Body>, from<Camera>)));
}

auto rate() {
#ifdef REPAIRED
  const auto graph = spacecraft();
  return graph.at(0.0 * si::second).rotation(to<Camera>, from<Body>);
#else
  const auto graph = spacecraft();
  return graph.at(0.0 * si::second).angular_velocity(of<Camera>, relative_to<Body>, in<Body>);
#endif
}
