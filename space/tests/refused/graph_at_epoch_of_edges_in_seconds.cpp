// mistake: an epoch for the instant of a graph whose edge takes seconds
// expect: RefusingEdge = .*Link<Body, Gcrf>
// expect: Epoch
#include <vectrix/space.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto attitude(const Epoch& start, const Epoch& epoch, const Quantity<si::angular_velocity>& rate) {
  const auto graph = frame_graph(
      edge([=](const Quantity<si::time>& t) { return turned_z(to<Body>, from<Gcrf>, rate * t); }));
#ifdef REPAIRED
  return graph.at(epoch - start).rotation(to<Body>, from<Gcrf>);
#else
  static_cast<void>(start);
  return graph.at(epoch).rotation(to<Body>, from<Gcrf>);
#endif
}
