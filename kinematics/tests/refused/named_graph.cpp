// The graph whose frames have names at run time
#include <vectrix/kinematics/named/graph.hpp>

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Body : moving_frame {};

namespace named_graph_edge_with_place {
// mistake: the place of an edge given to a graph that would forget it
// expect: Transform<Gcrf, Body
void build(NamedGraph& graph, const Transform<Gcrf, Body>& X_gcrf_from_body) {
#ifdef REPAIRED
  graph.add_edge(static_edge(X_gcrf_from_body.rotation));
#else
  graph.add_edge(static_edge(X_gcrf_from_body));
#endif
}
}  // namespace named_graph_edge_with_place
