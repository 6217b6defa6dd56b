// mistake: a graph with one edge in float and one in double
// expect: Fault = .*ScalarsDiffer<float, double>
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto spacecraft(const Dcm<Body, Gcrf, float>& R_body_from_gcrf, const Dcm<Camera, Body>& R_camera_from_body) {
#ifdef REPAIRED
  return frame_graph(static_edge(dcm(to<Body>, from<Gcrf>, R_body_from_gcrf.matrix().cast<double>())),
                     static_edge(R_camera_from_body));
#else
  return frame_graph(static_edge(R_body_from_gcrf), static_edge(R_camera_from_body));
#endif
}
