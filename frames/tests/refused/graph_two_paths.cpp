// mistake: an edge between two frames that are joined already
// expect: Fault = .*TwoPathsOver<(vectrix::)?Link<Camera, Gcrf>
// expect: a tree of frames
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

const auto attitude = static_edge(aligned(to<Gcrf>, from<Body>));
const auto mounting = static_edge(aligned(to<Body>, from<Camera>));

auto spacecraft() {
#ifdef REPAIRED
  return frame_graph(attitude, mounting);
#else
  return frame_graph(attitude, mounting, static_edge(aligned(to<Camera>, from<Gcrf>)));
#endif
}
