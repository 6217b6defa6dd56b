// mistake: the place of an edge given to a graph that would forget it
// expect: Transform<Gcrf, Body
#include <vectrix/kinematics/named/graph.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

void build(NamedGraph& graph, const Transform<Gcrf, Body>& X_gcrf_from_body) {
#ifdef REPAIRED
  graph.add_edge(static_edge(X_gcrf_from_body.rotation));
#else
  graph.add_edge(static_edge(X_gcrf_from_body));
#endif
}
