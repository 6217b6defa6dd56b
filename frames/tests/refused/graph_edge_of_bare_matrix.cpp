// mistake: an edge whose function returns nine numbers without frames
// expect: edge
// expect: Matrix
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto spacecraft() {
#ifdef REPAIRED
  return frame_graph(edge([](Quantity<si::time>) { return aligned(to<Gcrf>, from<Body>); }));
#else
  return frame_graph(edge([](Quantity<si::time>) -> Eigen::Matrix3d { return Eigen::Matrix3d::Identity(); }));
#endif
}
