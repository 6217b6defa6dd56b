// The frame graph
#include <vectrix/frames.hpp>

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Itrf : moving_frame {};
struct Body : moving_frame {};
struct Camera : moving_frame {};
struct Ground : moving_frame {};

namespace graph_edge_given_twice {
// mistake: the same edge given twice
// expect: Fault = .*TwoPathsOver<(vectrix::)?Link<Gcrf, Body>
// expect: a tree of frames
const auto attitude = static_edge(aligned(to<Gcrf>, from<Body>));

auto spacecraft() {
#ifdef REPAIRED
  return frame_graph(attitude);
#else
  return frame_graph(attitude, attitude);
#endif
}
}  // namespace graph_edge_given_twice

namespace graph_edge_of_bare_matrix {
// mistake: an edge whose function returns nine numbers without frames
// expect: edge
// expect: Matrix
auto spacecraft() {
#ifdef REPAIRED
  return frame_graph(edge([](Quantity<si::time>) { return aligned(to<Gcrf>, from<Body>); }));
#else
  return frame_graph(edge([](Quantity<si::time>) -> Eigen::Matrix3d { return Eigen::Matrix3d::Identity(); }));
#endif
}
}  // namespace graph_edge_of_bare_matrix

namespace graph_edge_of_generic_function {
// mistake: an edge that does not say what its instant is
// expect: Returned = (vectrix::)?DependsOnInstant
// expect: of one instant and of answers
auto spacecraft() {
#ifdef REPAIRED
  return frame_graph(
      edge([](const Quantity<si::angle>& angle) { return turned_z(to<Body>, from<Gcrf>, angle); }));
#else
  return frame_graph(edge([](const auto& angle) { return turned_z(to<Body>, from<Gcrf>, angle); }));
#endif
}
}  // namespace graph_edge_of_generic_function

namespace graph_edge_of_one_frame {
// mistake: an edge from a frame to itself
// expect: Fault = .*OneFrameTwice<Body>
auto spacecraft(const Dcm<Body, Gcrf>& R_body_from_gcrf, const Dcm<Gcrf, Body>& R_gcrf_from_body) {
#ifdef REPAIRED
  return frame_graph(static_edge(R_body_from_gcrf * (R_gcrf_from_body * R_body_from_gcrf)));
#else
  return frame_graph(static_edge(R_body_from_gcrf * R_gcrf_from_body));
#endif
}
}  // namespace graph_edge_of_one_frame

namespace graph_edges_in_two_scalars {
// mistake: a graph with one edge in float and one in double
// expect: Fault = .*ScalarsDiffer<float, double>
auto spacecraft(const Dcm<Body, Gcrf, float>& R_body_from_gcrf, const Dcm<Camera, Body>& R_camera_from_body) {
#ifdef REPAIRED
  return frame_graph(static_edge(dcm(to<Body>, from<Gcrf>, R_body_from_gcrf.matrix().cast<double>())),
                     static_edge(R_camera_from_body));
#else
  return frame_graph(static_edge(R_body_from_gcrf), static_edge(R_camera_from_body));
#endif
}
}  // namespace graph_edges_in_two_scalars

namespace graph_no_path {
// mistake: two frames that no path of edges joins
// expect: Lacking = (vectrix::)?NoPath<Camera, Itrf>
const auto earth = static_edge(aligned(to<Gcrf>, from<Itrf>));
const auto mounting = static_edge(aligned(to<Body>, from<Camera>));

auto attitude() {
#ifdef REPAIRED
  const auto graph = frame_graph(earth, mounting, static_edge(aligned(to<Gcrf>, from<Body>)));
  return graph.at(0.0 * si::second).rotation(to<Camera>, from<Itrf>);
#else
  const auto graph = frame_graph(earth, mounting);
  return graph.at(0.0 * si::second).rotation(to<Camera>, from<Itrf>);
#endif
}
}  // namespace graph_no_path

namespace graph_of_rotation {
// mistake: a rotation where an edge is wanted
// expect: Fault = .*NotAnEdge<(vectrix::)?Dcm<Body, Gcrf
auto spacecraft(const Dcm<Body, Gcrf>& R_body_from_gcrf) {
#ifdef REPAIRED
  return frame_graph(static_edge(R_body_from_gcrf));
#else
  return frame_graph(R_body_from_gcrf);
#endif
}
}  // namespace graph_of_rotation

namespace graph_rate_of_static_edge {
// mistake: a rate asked across an edge whose motion is not known
// expect: Lacking = (vectrix::)?RateOn<(vectrix::)?Link<Body, Camera>
auto spacecraft() {
  return frame_graph(static_edge(aligned(to<Gcrf>, from<Body>)),
                     static_edge(aligned(to<Body>, from<Camera>)));
}

auto rate() {
#ifdef REPAIRED
  const auto graph = spacecraft();
  return graph.at(0.0 * si::second).rotation(to<Camera>, from<Body>);
#else
  const auto graph = spacecraft();
  return graph.at(0.0 * si::second).angular_velocity(of<Camera>, relative_to<Body>, in<Body>);
#endif
}
}  // namespace graph_rate_of_static_edge

namespace graph_result_transposed {
// mistake: a query from a to b assigned to the rotation from b to a
// expect: Dcm<Gcrf, ?Camera
// expect: Dcm<Camera, ?Gcrf
auto spacecraft() {
  return frame_graph(static_edge(aligned(to<Gcrf>, from<Body>)),
                     static_edge(aligned(to<Body>, from<Camera>)));
}

Dcm<Camera, Gcrf> attitude() {
#ifdef REPAIRED
  const auto graph = spacecraft();
  return graph.at(0.0 * si::second).rotation(to<Camera>, from<Gcrf>);
#else
  const auto graph = spacecraft();
  return graph.at(0.0 * si::second).rotation(to<Gcrf>, from<Camera>);
#endif
}
}  // namespace graph_result_transposed

namespace graph_snapshot_of_temporary {
// mistake: a snapshot that outlives its graph
// expect: Gcrf
// expect: give the graph a name first
auto spacecraft() {
  return frame_graph(static_edge(aligned(to<Gcrf>, from<Body>)),
                     static_edge(aligned(to<Body>, from<Camera>)));
}

auto attitude() {
#ifdef REPAIRED
  const auto graph = spacecraft();
  return graph.at(0.0 * si::second).rotation(to<Camera>, from<Gcrf>);
#else
  return spacecraft().at(0.0 * si::second).rotation(to<Camera>, from<Gcrf>);
#endif
}
}  // namespace graph_snapshot_of_temporary

namespace graph_two_paths {
// mistake: an edge between two frames that are joined already
// expect: Fault = .*TwoPathsOver<(vectrix::)?Link<Camera, Gcrf>
// expect: a tree of frames
const auto attitude = static_edge(aligned(to<Gcrf>, from<Body>));
const auto mounting = static_edge(aligned(to<Body>, from<Camera>));

auto spacecraft() {
#ifdef REPAIRED
  return frame_graph(attitude, mounting);
#else
  return frame_graph(attitude, mounting, static_edge(aligned(to<Camera>, from<Gcrf>)));
#endif
}
}  // namespace graph_two_paths

namespace graph_unknown_frame {
// mistake: a frame that the graph does not have
// expect: Lacking = (vectrix::)?UnknownFrame<Ground>
auto spacecraft() {
  return frame_graph(static_edge(aligned(to<Gcrf>, from<Body>)),
                     static_edge(aligned(to<Body>, from<Camera>)));
}

auto attitude() {
#ifdef REPAIRED
  const auto graph = spacecraft();
  return graph.at(0.0 * si::second).rotation(to<Camera>, from<Gcrf>);
#else
  const auto graph = spacecraft();
  return graph.at(0.0 * si::second).rotation(to<Camera>, from<Ground>);
#endif
}
}  // namespace graph_unknown_frame

namespace graph_edge_of_later_edge {
// mistake: an edge that follows from an edge listed after it
// expect: Fault = (vectrix::)?EdgeAsksFor<(vectrix::)?Link<Body, Camera>, (vectrix::)?UnknownFrame<Itrf>
// expect: an edge asks those before it
Dcm<Body, Camera> camera(const Dcm<Body, Itrf>& R_body_from_itrf) {
  return R_body_from_itrf * aligned(to<Itrf>, from<Camera>);
}
auto sight(const Dcm<Gcrf, Body>& R_gcrf_from_body) {
  const auto earth = static_edge(aligned(to<Gcrf>, from<Itrf>));
#ifdef REPAIRED
  return frame_graph(static_edge(R_gcrf_from_body), earth, edge(camera));
#else
  return frame_graph(static_edge(R_gcrf_from_body), edge(camera), earth);
#endif
}
}  // namespace graph_edge_of_later_edge

namespace graph_position_across_rotation {
// mistake: the position of a frame of which the graph has the rotation alone
// expect: PlaceOn<(vectrix::)?Link<Body, Camera>
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
}  // namespace graph_position_across_rotation

namespace graph_edge_of_two_instants {
// mistake: an edge of two instants, of which both would be the one that the graph is asked at
// expect: Returned = (vectrix::)?Dcm<Gcrf, Itrf
// expect: of one instant and of answers
auto earth(const Dcm<Gcrf, Body>& R_gcrf_from_body) {
#ifdef REPAIRED
  const auto start = 100.0 * si::second;
  const auto turn = [=](Quantity<si::time> t, const Dcm<Gcrf, Body>& R) -> Dcm<Gcrf, Itrf> {
    return R * turned_z(to<Body>, from<Itrf>, (t - start).value() * si::radian);
  };
#else
  const auto turn = [](Quantity<si::time> t, const Dcm<Gcrf, Body>& R,
                       Quantity<si::time> start = 100.0 * si::second) -> Dcm<Gcrf, Itrf> {
    return R * turned_z(to<Body>, from<Itrf>, (t - start).value() * si::radian);
  };
#endif
  return frame_graph(static_edge(R_gcrf_from_body), edge(turn));
}
}  // namespace graph_edge_of_two_instants
