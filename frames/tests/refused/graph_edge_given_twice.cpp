// mistake: the same edge given twice
// expect: Fault = .*TwoPathsOver<(vectrix::)?Link<Gcrf, Body>
// expect: a tree of frames
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

const auto attitude = static_edge(aligned(to<Gcrf>, from<Body>));

auto spacecraft() {
#ifdef REPAIRED
  return frame_graph(attitude);
#else
  return frame_graph(attitude, attitude);
#endif
}
