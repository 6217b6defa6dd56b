// mistake: an edge that does not say what its instant is
// expect: Returned = (vectrix::)?DependsOnInstant
// expect: of one type of instant
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto spacecraft() {
#ifdef REPAIRED
  return frame_graph(
      edge([](const Quantity<si::angle>& angle) { return turned_z(to<Body>, from<Gcrf>, angle); }));
#else
  return frame_graph(edge([](const auto& angle) { return turned_z(to<Body>, from<Gcrf>, angle); }));
#endif
}
