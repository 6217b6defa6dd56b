// mistake: a rotation where an edge is wanted
// expect: Fault = .*NotAnEdge<(vectrix::)?Dcm<Body, Gcrf
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto spacecraft(const Dcm<Body, Gcrf>& R_body_from_gcrf) {
#ifdef REPAIRED
  return frame_graph(static_edge(R_body_from_gcrf));
#else
  return frame_graph(R_body_from_gcrf);
#endif
}
