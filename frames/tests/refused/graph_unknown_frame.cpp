// mistake: a frame that the graph does not have
// expect: Lacking = (vectrix::)?UnknownFrame<Ground>
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};
struct Ground : vectrix::moving_frame {};

using namespace vectrix;

auto spacecraft() {
  return frame_graph(static_edge(aligned(to<Gcrf>, from<Body>)),
                     static_edge(aligned(to<Body>, from<Camera>)));
}

auto attitude() {
#ifdef REPAIRED
  const auto graph = spacecraft();
  return graph.at(0.0 * si::second).rotation(to<Camera>, from<Gcrf>);
#else
  const auto graph = spacecraft();
  return graph.at(0.0 * si::second).rotation(to<Camera>, from<Ground>);
#endif
}
