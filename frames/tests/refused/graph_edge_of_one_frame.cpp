// mistake: an edge from a frame to itself
// expect: Fault = .*OneFrameTwice<Body>
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto spacecraft(const Dcm<Body, Gcrf>& R_body_from_gcrf, const Dcm<Gcrf, Body>& R_gcrf_from_body) {
#ifdef REPAIRED
  return frame_graph(static_edge(R_body_from_gcrf * (R_gcrf_from_body * R_body_from_gcrf)));
#else
  return frame_graph(static_edge(R_body_from_gcrf * R_gcrf_from_body));
#endif
}
