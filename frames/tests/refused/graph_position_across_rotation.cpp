// mistake: the position of a frame of which the graph has the rotation alone
// expect: PlaceOn<(vectrix::)?Link<Body, Camera>
#include <vectrix/frames.hpp>

struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};

using namespace vectrix;

auto lever_arm(const Dcm<Body, Camera>& R_body_from_camera,
               const Displacement<Body, Camera, In<Body>>& r_body_camera) {
#ifdef REPAIRED
  const auto graph = frame_graph(static_edge(Transform{R_body_from_camera, r_body_camera}));
#else
  static_cast<void>(r_body_camera);
  const auto graph = frame_graph(static_edge(R_body_from_camera));
#endif
  return graph.at(0.0 * si::second).position(of<Camera>, relative_to<Body>, in<Body>);
}
