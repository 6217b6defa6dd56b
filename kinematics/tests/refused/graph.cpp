// The frame graph with motion
#include <vectrix/kinematics.hpp>

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Itrf : moving_frame {};
struct Body : moving_frame {};
struct Camera : moving_frame {};
struct Ground : moving_frame {};

namespace graph_acceleration_across_moving_place {
// mistake: an acceleration across an edge whose acceleration is not known
// expect: AccelerationOn<(vectrix::)?Link<Body, Camera>
AcceleratingTransform<Gcrf, Body> orbit(Quantity<si::time> t);
MovingTransform<Body, Camera> camera(Quantity<si::time> t);

auto motion(const Quantity<si::time>& t) {
  const auto graph = frame_graph(edge(orbit), edge(camera));
#ifdef REPAIRED
  return graph.at(t).velocity(of<Camera>, relative_to<Gcrf>, observed_from<Gcrf>, in<Gcrf>);
#else
  return graph.at(t).acceleration(of<Camera>, relative_to<Gcrf>, observed_from<Gcrf>, in<Gcrf>);
#endif
}
}  // namespace graph_acceleration_across_moving_place

namespace graph_acceleration_of_rate_edge {
// mistake: an acceleration asked across an edge that knows its rate only
// expect: Lacking = (vectrix::)?AccelerationOn<(vectrix::)?Link<Gcrf, Body>
MovingDcm<Gcrf, Body> attitude(Quantity<si::time> t);
AcceleratingDcm<Body, Camera> camera(Quantity<si::time> t);

auto motion() {
#ifdef REPAIRED
  const auto graph = frame_graph(edge(attitude), edge(camera));
  return graph.at(0.0 * si::second).angular_acceleration(of<Camera>, relative_to<Body>, in<Camera>);
#else
  const auto graph = frame_graph(edge(attitude), edge(camera));
  return graph.at(0.0 * si::second).angular_acceleration(of<Camera>, relative_to<Gcrf>, in<Camera>);
#endif
}
}  // namespace graph_acceleration_of_rate_edge

namespace graph_acceleration_of_sampled_edge {
// mistake: the acceleration across samples joined by slerp: its rate jumps from one to the next
// expect: AccelerationOn<(vectrix::)?Link<Gcrf, Body
auto acceleration(const std::vector<AttitudeSample<Gcrf, Body>>& samples, const Quantity<si::time>& t) {
#ifdef REPAIRED
  const auto graph = frame_graph(edge(RotationSpline<Gcrf, Body>(samples, 10.0 * si::second, natural_ends)));
#else
  const auto graph = frame_graph(sampled_edge(samples, 10.0 * si::second));
#endif
  return graph.at(t).angular_acceleration(of<Body>, relative_to<Gcrf>, in<Body>);
}
}  // namespace graph_acceleration_of_sampled_edge

namespace graph_acceleration_of_positions_joined_by_cubics {
// mistake: the acceleration of a place across samples joined by cubics: it jumps from one to the next
// expect: AccelerationOn<(vectrix::)?Link<Gcrf, Body
auto acceleration(const std::vector<PositionSample<Gcrf, Body>>& samples, const Quantity<si::time>& t) {
#ifdef REPAIRED
  const auto graph = frame_graph(sampled_edge(samples, Hermite{7}, 10.0 * si::second));
#else
  const auto graph = frame_graph(sampled_edge(samples, 10.0 * si::second));
#endif
  return graph.at(t).acceleration(of<Body>, relative_to<Gcrf>, observed_from<Gcrf>, in<Gcrf>);
}
}  // namespace graph_acceleration_of_positions_joined_by_cubics

namespace graph_place_across_turning_edge {
// mistake: the place of a frame of which the rotation alone is known
// expect: PlaceOn<(vectrix::)?Link<Body, Camera>
AcceleratingTransform<Gcrf, Body> orbit(Quantity<si::time> t);
AcceleratingDcm<Body, Camera> camera(Quantity<si::time> t);

auto motion(const Quantity<si::time>& t) {
  const auto graph = frame_graph(edge(orbit), edge(camera));
#ifdef REPAIRED
  return graph.at(t).position(of<Body>, relative_to<Gcrf>, in<Camera>);
#else
  return graph.at(t).position(of<Camera>, relative_to<Gcrf>, in<Camera>);
#endif
}
}  // namespace graph_place_across_turning_edge

namespace graph_rate_across_static_edge {
// mistake: a rate asked across a chain in which one edge has none
// expect: Lacking = (vectrix::)?RateOn<(vectrix::)?Link<Body, Camera>
MovingDcm<Gcrf, Body> attitude(Quantity<si::time> t);
const Dcm<Body, Camera> mounting = aligned(to<Body>, from<Camera>);

auto motion() {
#ifdef REPAIRED
  const auto graph = frame_graph(edge(attitude), rigid_edge(mounting));
  return graph.at(0.0 * si::second).angular_velocity(of<Camera>, relative_to<Gcrf>, in<Gcrf>);
#else
  const auto graph = frame_graph(edge(attitude), static_edge(mounting));
  return graph.at(0.0 * si::second).angular_velocity(of<Camera>, relative_to<Gcrf>, in<Gcrf>);
#endif
}
}  // namespace graph_rate_across_static_edge

namespace graph_rate_in_unknown_frame {
// mistake: a rate asked in a frame that the graph does not have
// expect: Lacking = (vectrix::)?UnknownFrame<Ground>
MovingDcm<Gcrf, Body> attitude(Quantity<si::time> t);
AcceleratingDcm<Body, Camera> camera(Quantity<si::time> t);

auto motion() {
#ifdef REPAIRED
  const auto graph = frame_graph(edge(attitude), rigid_edge(aligned(to<Body>, from<Camera>)));
  return graph.at(0.0 * si::second).angular_velocity(of<Camera>, relative_to<Gcrf>, in<Gcrf>);
#else
  const auto graph = frame_graph(edge(attitude), edge(camera));
  return graph.at(0.0 * si::second).angular_velocity(of<Camera>, relative_to<Gcrf>, in<Ground>);
#endif
}
}  // namespace graph_rate_in_unknown_frame

namespace graph_rate_of_frame_relative_to_itself {
// mistake: the rate of a frame relative to itself
// expect: Lacking = (vectrix::)?OtherFrameThan<Body>
MovingDcm<Gcrf, Body> attitude(Quantity<si::time> t);
AcceleratingDcm<Body, Camera> camera(Quantity<si::time> t);

auto motion() {
#ifdef REPAIRED
  const auto graph = frame_graph(edge(attitude), edge(camera));
  return graph.at(0.0 * si::second).angular_velocity(of<Body>, relative_to<Gcrf>, in<Gcrf>);
#else
  const auto graph = frame_graph(edge(attitude), edge(camera));
  return graph.at(0.0 * si::second).angular_velocity(of<Body>, relative_to<Body>, in<Gcrf>);
#endif
}
}  // namespace graph_rate_of_frame_relative_to_itself

namespace graph_transform_across_turning_edge {
// mistake: the transform across an edge of which the rotation alone is known
// expect: PlaceOn<(vectrix::)?Link<Body, Camera>
AcceleratingTransform<Gcrf, Body> orbit(Quantity<si::time> t);
AcceleratingDcm<Body, Camera> camera(Quantity<si::time> t);

auto motion(const Quantity<si::time>& t) {
  const auto graph = frame_graph(edge(orbit), edge(camera));
#ifdef REPAIRED
  return graph.at(t).rotation(to<Gcrf>, from<Camera>);
#else
  return graph.at(t).transform(to<Gcrf>, from<Camera>);
#endif
}
}  // namespace graph_transform_across_turning_edge

namespace graph_velocity_across_fixed_place {
// mistake: a velocity across an edge whose motion is not known
// expect: RateOn<(vectrix::)?Link<Body, Camera>
AcceleratingTransform<Gcrf, Body> orbit(Quantity<si::time> t);
Transform<Body, Camera> camera(Quantity<si::time> t);

auto motion(const Quantity<si::time>& t) {
  const auto graph = frame_graph(edge(orbit), edge(camera));
#ifdef REPAIRED
  return graph.at(t).position(of<Camera>, relative_to<Gcrf>, in<Gcrf>);
#else
  return graph.at(t).velocity(of<Camera>, relative_to<Gcrf>, observed_from<Gcrf>, in<Gcrf>);
#endif
}
}  // namespace graph_velocity_across_fixed_place

namespace graph_velocity_seen_from_unknown_frame {
// mistake: a velocity seen from a frame that is not in the graph
// expect: UnknownFrame<Itrf>
AcceleratingTransform<Gcrf, Body> orbit(Quantity<si::time> t);
MovingTransform<Body, Camera> camera(Quantity<si::time> t);

auto motion(const Quantity<si::time>& t) {
  const auto graph = frame_graph(edge(orbit), edge(camera));
#ifdef REPAIRED
  return graph.at(t).velocity(of<Camera>, relative_to<Gcrf>, observed_from<Body>, in<Gcrf>);
#else
  return graph.at(t).velocity(of<Camera>, relative_to<Gcrf>, observed_from<Itrf>, in<Gcrf>);
#endif
}
}  // namespace graph_velocity_seen_from_unknown_frame

namespace graph_edge_asks_for_rate_of_static_edge {
// mistake: an edge that follows from a rate which an edge before it does not know
// expect: Fault = (vectrix::)?EdgeAsksFor<(vectrix::)?Link<Body, Camera>
// expect: (vectrix::)?RateOn<(vectrix::)?Link<Gcrf, Body
Dcm<Body, Camera> camera(const AngularVelocity<Gcrf, Body, In<Body>>& w_ib_b) {
  return turned_z(to<Body>, from<Camera>, norm(w_ib_b) * (1.0 * si::second));
}
auto sight(const Dcm<Gcrf, Body>& R_gcrf_from_body) {
#ifdef REPAIRED
  return frame_graph(rigid_edge(R_gcrf_from_body), edge(camera));
#else
  return frame_graph(static_edge(R_gcrf_from_body), edge(camera));
#endif
}
}  // namespace graph_edge_asks_for_rate_of_static_edge

namespace graph_velocity_without_an_observer {
// mistake: a velocity that does not say from which frame it is seen
// expect: of<Q>, relative_to<P>, observed_from<A>, in<C>
// expect: Q = Camera
AcceleratingTransform<Gcrf, Camera> orbit(Quantity<si::time> t);

auto motion(const Quantity<si::time>& t) {
  const auto graph = frame_graph(edge(orbit));
#ifdef REPAIRED
  return graph.at(t).velocity(of<Camera>, relative_to<Gcrf>, observed_from<Gcrf>, in<Gcrf>);
#else
  return graph.at(t).velocity(of<Camera>, relative_to<Gcrf>, in<Gcrf>);
#endif
}
}  // namespace graph_velocity_without_an_observer

namespace graph_acceleration_without_an_observer {
// mistake: an acceleration that does not say from which frame it is seen
// expect: of<Q>, relative_to<P>, observed_from<A>, in<C>
// expect: Q = Camera
AcceleratingTransform<Gcrf, Camera> orbit(Quantity<si::time> t);

auto motion(const Quantity<si::time>& t) {
  const auto graph = frame_graph(edge(orbit));
#ifdef REPAIRED
  return graph.at(t).acceleration(of<Camera>, relative_to<Gcrf>, observed_from<Gcrf>, in<Gcrf>);
#else
  return graph.at(t).acceleration(of<Camera>, relative_to<Gcrf>, in<Gcrf>);
#endif
}
}  // namespace graph_acceleration_without_an_observer
