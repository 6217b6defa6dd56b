// The graph whose frames have names at run time
#include <vectrix/kinematics/named/graph.hpp>

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Body : moving_frame {};
struct Camera : moving_frame {};

namespace named_graph_at_another_instant {
// mistake: a run-time graph at an instant of another type, as of a clock; its edges are functions of seconds
// expect: seconds since an epoch of your choice
struct Clock {
  Quantity<si::time> since(const Clock& start) const;
};

NamedDcm rotation(const NamedGraph& graph, const Clock& now, const Clock& start) {
  (void)start;
#ifdef REPAIRED
  return graph.at(now.since(start)).rotation(To("body"), From("camera"));
#else
  return graph.at(now).rotation(To("body"), From("camera"));
#endif
}
}  // namespace named_graph_at_another_instant

namespace named_graph_edge_that_asks {
// mistake: an edge that asks for the answer of another edge, given to a graph that passes on the time alone
// expect: Dcm<Body, Camera
Dcm<Body, Camera> towards_the_sun(const Dcm<Gcrf, Body>& R_gcrf_from_body);
Dcm<Body, Camera> swinging(Quantity<si::time> t);

void build(NamedGraph& graph) {
#ifdef REPAIRED
  graph.add_edge(edge(swinging));
#else
  graph.add_edge(edge(towards_the_sun));
#endif
}
}  // namespace named_graph_edge_that_asks

namespace named_law_of_other_operands {
// mistake: a typed law given to operands of other types than it says
// expect: a Law with the types of these operands
NamedVector<si::length> turned(const NamedDcm& R_body_from_camera, const NamedVector<si::length>& r_camera) {
  using B = Some<'b'>;
  using C = Some<'c'>;
  const auto word = [](const auto& R, const auto& r) { return R * r; };
#ifdef REPAIRED
  return typed_law<Law<Dcm<B, C>, Vector<C, si::length>>>("turned", word, R_body_from_camera, r_camera);
#else
  return typed_law<Law<Dcm<B, C>, Vector<C, si::force>>>("turned", word, R_body_from_camera, r_camera);
#endif
}
}  // namespace named_law_of_other_operands

namespace named_velocity_in_metres {
// mistake: a velocity between frames of a file, made of a position
// expect: NamedVector<(vectrix::)?si::length>
NamedVelocity velocity_of(NamedFrame camera, NamedFrame body, const NamedVector<si::length>& r_body,
                          const NamedVector<si::velocity>& v_body) {
  (void)r_body, (void)v_body;
#ifdef REPAIRED
  return velocity(Of(camera), RelativeTo(body), ObservedFrom(body), v_body);
#else
  return velocity(Of(camera), RelativeTo(body), ObservedFrom(body), r_body);
#endif
}
}  // namespace named_velocity_in_metres
