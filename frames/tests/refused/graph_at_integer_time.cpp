// mistake: an instant in whole seconds
// expect: RefusingEdge = .*Link<Body, Gcrf>
// expect: does not take this instant
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto attitude(const Quantity<si::angular_velocity>& rate) {
  const auto graph = frame_graph(
      edge([=](const Quantity<si::time>& t) { return turned_z(to<Body>, from<Gcrf>, rate * t); }));
#ifdef REPAIRED
  return graph.at(1.0 * si::second).rotation(to<Body>, from<Gcrf>);
#else
  return graph.at(1 * si::second).rotation(to<Body>, from<Gcrf>);
#endif
}
