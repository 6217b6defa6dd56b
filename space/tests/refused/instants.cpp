// Instants
#include <vectrix/space.hpp>

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Body : moving_frame {};

namespace graph_at_epoch_of_edges_in_seconds {
// mistake: an epoch for the instant of a graph whose edge takes seconds
// expect: RefusingEdge = .*Link<Body, Gcrf>
// expect: Epoch
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
}  // namespace graph_at_epoch_of_edges_in_seconds
