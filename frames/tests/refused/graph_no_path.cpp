// mistake: two frames that no path of edges joins
// expect: Lacking = (vectrix::)?NoPath<Camera, Itrf>
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Itrf : vectrix::moving_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

const auto earth = static_edge(aligned(to<Gcrf>, from<Itrf>));
const auto mounting = static_edge(aligned(to<Body>, from<Camera>));

auto attitude() {
#ifdef REPAIRED
  const auto graph = frame_graph(earth, mounting, static_edge(aligned(to<Gcrf>, from<Body>)));
  return graph.at(0.0 * si::second).rotation(to<Camera>, from<Itrf>);
#else
  const auto graph = frame_graph(earth, mounting);
  return graph.at(0.0 * si::second).rotation(to<Camera>, from<Itrf>);
#endif
}
