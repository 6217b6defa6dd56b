// Rotations
#include <vectrix/frames.hpp>

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Itrf : moving_frame {};
struct Body : moving_frame {};
struct Camera : moving_frame {};
template <int I> struct Wheel : moving_frame {};

namespace aligned_of_one_frame {
// mistake: the axes of a frame, claimed to be parallel to themselves
// expect: ToFrame = (vectrix::)?To<Body>
// expect: FromFrame = (vectrix::)?From<Body>
// expect: two frames
Dcm<Body, Gcrf> start() {
#ifdef REPAIRED
  return aligned(to<Body>, from<Gcrf>);
#else
  return aligned(to<Body>, from<Body>);
#endif
}
}  // namespace aligned_of_one_frame

namespace dcm_assigned_transposed {
// mistake: R_a_from_b assigned to a variable of type R_b_from_a
// expect: Dcm<Gcrf, Body
// expect: Dcm<Body, Gcrf
void attitude(const Dcm<Gcrf, Body>& R_gcrf_from_body) {
#ifdef REPAIRED
  const Dcm<Body, Gcrf> R_body_from_gcrf = inverse(R_gcrf_from_body);
  static_cast<void>(R_body_from_gcrf);
#else
  const Dcm<Body, Gcrf> R_body_from_gcrf = R_gcrf_from_body;
  static_cast<void>(R_body_from_gcrf);
#endif
}
}  // namespace dcm_assigned_transposed

namespace dcm_chain_on_vector_of_inner_frame {
// mistake: a chain of rotations on a vector of a frame in its middle
// expect: Left = (vectrix::)?DcmChain<Camera, Gcrf
// expect: Right = (vectrix::)?Vector<Body
// expect: the inner frames cancel
auto sight(const Dcm<Camera, Body>& R_camera_from_body, const Dcm<Body, Gcrf>& R_body_from_gcrf,
           const Vector<Body, si::length>& r_body) {
#ifdef REPAIRED
  return R_camera_from_body * R_body_from_gcrf * inverse(R_body_from_gcrf) * r_body;
#else
  return R_camera_from_body * R_body_from_gcrf * r_body;
#endif
}
}  // namespace dcm_chain_on_vector_of_inner_frame

namespace dcm_chain_returned_by_name {
// mistake: a named product of rotations returned without its type
// expect: DcmChain<Camera, Gcrf|ToFrame = Camera; FromFrame = Gcrf
// expect: give the product a type
auto attitude(const Dcm<Camera, Body>& R_camera_from_body, const Dcm<Body, Gcrf>& R_body_from_gcrf) {
#ifdef REPAIRED
  const Dcm<Camera, Gcrf> R_camera_from_gcrf = R_camera_from_body * R_body_from_gcrf;
#else
  auto R_camera_from_gcrf = R_camera_from_body * R_body_from_gcrf;
#endif
  return R_camera_from_gcrf;
}
}  // namespace dcm_chain_returned_by_name

namespace dcm_default {
// mistake: a rotation without a value
// expect: Dcm<Body, Gcrf
void attitude() {
#ifdef REPAIRED
  const Dcm<Body, Gcrf> R_body_from_gcrf = aligned(to<Body>, from<Gcrf>);
  static_cast<void>(R_body_from_gcrf);
#else
  const Dcm<Body, Gcrf> R_body_from_gcrf;
  static_cast<void>(R_body_from_gcrf);
#endif
}
}  // namespace dcm_default

namespace dcm_difference {
// mistake: the difference of two rotations
// expect: Left = (vectrix::)?Dcm<Body, Gcrf
// expect: Right = (vectrix::)?Dcm<Body, Gcrf
auto error(const Dcm<Body, Gcrf>& R_body_from_gcrf, const Dcm<Body, Gcrf>& estimate) {
#ifdef REPAIRED
  return R_body_from_gcrf * inverse(estimate);
#else
  return R_body_from_gcrf - estimate;
#endif
}
}  // namespace dcm_difference

namespace dcm_door_words_swapped {
// mistake: to and from exchanged at the door
// expect: from<Gcrf>, to<Body>
// expect: ToFrame = (vectrix::)?From<Gcrf>
auto attitude(const Eigen::Matrix3d& matrix) {
#ifdef REPAIRED
  return dcm(to<Body>, from<Gcrf>, matrix);
#else
  return dcm(from<Gcrf>, to<Body>, matrix);
#endif
}
}  // namespace dcm_door_words_swapped

namespace dcm_from_axes_of_one_frame {
// mistake: the axes of a frame given in itself
// expect: ToFrame = (vectrix::)?To<Body>
// expect: Vector<Body
// expect: two frames
auto attitude(const Vector<Body, si::dimensionless>& x, const Vector<Body, si::dimensionless>& y,
              const Vector<Body, si::dimensionless>& z) {
#ifdef REPAIRED
  return dcm_from_axes(to<Gcrf>, x, y, z);
#else
  return dcm_from_axes(to<Body>, x, y, z);
#endif
}
}  // namespace dcm_from_axes_of_one_frame

namespace dcm_from_bare_matrix {
// mistake: nine numbers that nobody has claimed to be a rotation
// expect: Dcm<Body, Gcrf
Dcm<Body, Gcrf> attitude(const Eigen::Matrix3d& matrix) {
#ifdef REPAIRED
  return dcm(to<Body>, from<Gcrf>, matrix);
#else
  return matrix;
#endif
}
}  // namespace dcm_from_bare_matrix

namespace dcm_negated {
// mistake: the negative of a rotation
// expect: Dcm<Body, Gcrf
// expect: a rotation has no negative
auto reverse(const Dcm<Body, Gcrf>& R_body_from_gcrf) {
#ifdef REPAIRED
  return inverse(R_body_from_gcrf);
#else
  return -R_body_from_gcrf;
#endif
}
}  // namespace dcm_negated

namespace dcm_printed_with_a_mistake {
// mistake: a refused call that is printed: it gives no second error
// expect: Given = double
// expect: an angle in rad
void print(std::ostream& out) {
#ifdef REPAIRED
  out << turned_z(to<Body>, from<Gcrf>, 0.1 * si::radian);
#else
  out << turned_z(to<Body>, from<Gcrf>, 0.1);
#endif
}
}  // namespace dcm_printed_with_a_mistake

namespace dcm_transposed {
// mistake: the transpose, as of a matrix without frames
// expect: Dcm<Body, Gcrf
// expect: inverse\(R_b_from_a\)
Dcm<Gcrf, Body> back(const Dcm<Body, Gcrf>& R_body_from_gcrf) {
#ifdef REPAIRED
  return inverse(R_body_from_gcrf);
#else
  return R_body_from_gcrf.transpose();
#endif
}
}  // namespace dcm_transposed

namespace dcm_of_one_frame {
// mistake: one frame at two instants, under one name
// expect: ToFrame = (vectrix::)?To<Body>
// expect: FromFrame = (vectrix::)?From<Body>
// expect: two frames
auto turn(const Eigen::Matrix3d& matrix) {
#ifdef REPAIRED
  return dcm(to<Body>, from<Gcrf>, matrix);
#else
  return dcm(to<Body>, from<Body>, matrix);
#endif
}
}  // namespace dcm_of_one_frame

namespace dcm_passed_transposed {
// mistake: R_a_from_b passed to a function that takes R_b_from_a
// expect: Dcm<Gcrf, Body
// expect: Dcm<Body, Gcrf
void point(const Dcm<Body, Gcrf>& R_body_from_gcrf);

void control(const Dcm<Gcrf, Body>& R_gcrf_from_body) {
#ifdef REPAIRED
  point(inverse(R_gcrf_from_body));
#else
  point(R_gcrf_from_body);
#endif
}
}  // namespace dcm_passed_transposed

namespace dcm_product_inner_frames {
// mistake: two rotations whose inner frames do not cancel
// expect: Left = (vectrix::)?Dcm<Camera, Body
// expect: Right = (vectrix::)?Dcm<Gcrf, Body
// expect: the inner frames cancel
auto attitude(const Dcm<Camera, Body>& R_camera_from_body, const Dcm<Gcrf, Body>& R_gcrf_from_body) {
#ifdef REPAIRED
  return R_camera_from_body * inverse(R_gcrf_from_body);
#else
  return R_camera_from_body * R_gcrf_from_body;
#endif
}
}  // namespace dcm_product_inner_frames

namespace dcm_product_other_wheel {
// mistake: the frame of one wheel taken for that of another
// expect: Left = (vectrix::)?Dcm<Body, Wheel<2>
// expect: Right = (vectrix::)?Dcm<Wheel<1>, Body
// expect: the inner frames cancel
auto mounting(const Dcm<Body, Wheel<2>>& R_body_from_wheel, const Dcm<Wheel<1>, Body>& R_wheel_from_body) {
#ifdef REPAIRED
  return R_wheel_from_body * R_body_from_wheel;
#else
  return R_body_from_wheel * R_wheel_from_body;
#endif
}
}  // namespace dcm_product_other_wheel

namespace dcm_product_with_typed_result {
// mistake: the type of the result does not make a product lawful, nor the message longer
// expect: Left = (vectrix::)?Dcm<Gcrf, Body
// expect: Right = (vectrix::)?Vector<Gcrf
// expect: the inner frames cancel
auto line_of_sight(const Dcm<Gcrf, Body>& R_gcrf_from_body, const Vector<Gcrf, si::length>& r_gcrf) {
#ifdef REPAIRED
  const Vector<Body, si::length> r_body = inverse(R_gcrf_from_body) * r_gcrf;
#else
  const Vector<Body, si::length> r_body = R_gcrf_from_body * r_gcrf;
#endif
  return r_body;
}
}  // namespace dcm_product_with_typed_result

namespace dcm_product_within_chain {
// mistake: a chain whose first two rotations do not meet
// expect: Left = (vectrix::)?Dcm<Camera, Body
// expect: Right = (vectrix::)?Dcm<Gcrf, Body
// expect: the inner frames cancel
Vector<Camera, si::length> seen(const Dcm<Camera, Body>& R_camera_from_body,
                                const Dcm<Gcrf, Body>& R_gcrf_from_body,
                                const Vector<Gcrf, si::length>& r_gcrf) {
#ifdef REPAIRED
  return R_camera_from_body * inverse(R_gcrf_from_body) * r_gcrf;
#else
  return R_camera_from_body * R_gcrf_from_body * r_gcrf;
#endif
}
}  // namespace dcm_product_within_chain

namespace dcm_product_wrong_order {
// mistake: the two rotations of a chain in the wrong order
// expect: Left = (vectrix::)?Dcm<Body, Gcrf
// expect: Right = (vectrix::)?Dcm<Camera, Body
// expect: the inner frames cancel
auto attitude(const Dcm<Camera, Body>& R_camera_from_body, const Dcm<Body, Gcrf>& R_body_from_gcrf) {
#ifdef REPAIRED
  return R_camera_from_body * R_body_from_gcrf;
#else
  return R_body_from_gcrf * R_camera_from_body;
#endif
}
}  // namespace dcm_product_wrong_order

namespace dcm_times_vector_of_other_frame {
// mistake: a rotation applied to a vector that is not expressed in its inner frame
// expect: Left = (vectrix::)?Dcm<Body, Gcrf
// expect: Right = (vectrix::)?Vector<Body
// expect: the inner frames cancel
auto position(const Dcm<Body, Gcrf>& R_body_from_gcrf, const Vector<Body, si::length>& r_body) {
#ifdef REPAIRED
  return inverse(R_body_from_gcrf) * r_body;
#else
  return R_body_from_gcrf * r_body;
#endif
}
}  // namespace dcm_times_vector_of_other_frame

namespace nearest_dcm_of_one_frame {
// mistake: one frame at two instants, under one name
// expect: ToFrame = (vectrix::)?To<Body>
// expect: FromFrame = (vectrix::)?From<Body>
// expect: two frames
auto turn(const Eigen::Matrix3d& matrix) {
#ifdef REPAIRED
  return nearest_dcm(to<Body>, from<Gcrf>, matrix);
#else
  return nearest_dcm(to<Body>, from<Body>, matrix);
#endif
}
}  // namespace nearest_dcm_of_one_frame

namespace rotate_vector_of_other_frame {
// mistake: a vector turned within a frame in which it is not expressed
// expect: DcmTo = Gcrf
// expect: VectorIn = Body
// expect: r is turned within a
auto turn(const Dcm<Gcrf, Body>& R_gcrf_from_body, const Vector<Body, si::length>& r_body) {
#ifdef REPAIRED
  return rotate(R_gcrf_from_body, R_gcrf_from_body * r_body);
#else
  return rotate(R_gcrf_from_body, r_body);
#endif
}
}  // namespace rotate_vector_of_other_frame

namespace trust_dcm_of_one_frame {
// mistake: one frame at two instants, under one name
// expect: ToFrame = (vectrix::)?To<Body>
// expect: FromFrame = (vectrix::)?From<Body>
// expect: two frames
auto turn(const Eigen::Matrix3d& matrix) {
#ifdef REPAIRED
  return trust_dcm(to<Body>, from<Gcrf>, matrix);
#else
  return trust_dcm(to<Body>, from<Body>, matrix);
#endif
}
}  // namespace trust_dcm_of_one_frame

namespace turned_by_bare_number {
// mistake: an angle without a unit
// expect: turned_z
auto earth() {
#ifdef REPAIRED
  return turned_z(to<Itrf>, from<Gcrf>, 0.5 * si::radian);
#else
  return turned_z(to<Itrf>, from<Gcrf>, 0.5);
#endif
}
}  // namespace turned_by_bare_number

namespace turned_by_degrees {
// mistake: degrees given for radians
// expect: turned_z
auto earth() {
#ifdef REPAIRED
  return turned_z(to<Itrf>, from<Gcrf>, convert<si::angle>(30.0 * si::degree));
#else
  return turned_z(to<Itrf>, from<Gcrf>, 30.0 * si::degree);
#endif
}
}  // namespace turned_by_degrees

namespace turned_of_one_frame {
// mistake: a frame turned relative to itself
// expect: ToFrame = (vectrix::)?To<Body>
// expect: FromFrame = (vectrix::)?From<Body>
// expect: two frames
auto turn(const Quantity<si::angle>& angle) {
#ifdef REPAIRED
  return turned_z(to<Body>, from<Gcrf>, angle);
#else
  return turned_z(to<Body>, from<Body>, angle);
#endif
}
}  // namespace turned_of_one_frame
