// mistake: a query from a to b assigned to the rotation from b to a
// expect: Dcm<Gcrf, ?Camera
// expect: Dcm<Camera, ?Gcrf
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto spacecraft() {
  return frame_graph(static_edge(aligned(to<Gcrf>, from<Body>)),
                     static_edge(aligned(to<Body>, from<Camera>)));
}

Dcm<Camera, Gcrf> attitude() {
#ifdef REPAIRED
  const auto graph = spacecraft();
  return graph.at(0.0 * si::second).rotation(to<Camera>, from<Gcrf>);
#else
  const auto graph = spacecraft();
  return graph.at(0.0 * si::second).rotation(to<Gcrf>, from<Camera>);
#endif
}
