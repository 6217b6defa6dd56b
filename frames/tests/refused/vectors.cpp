// Vectors and units
#include <array>
#include <vectrix/frames.hpp>

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Itrf : moving_frame {};
struct Body : moving_frame {};
template <int I> struct Wheel : moving_frame {};

namespace angle_between_frames {
// mistake: the angle between vectors expressed in two frames
// expect: Left = (vectrix::)?Vector<Body
// expect: Right = (vectrix::)?Vector<Wheel<1>
// expect: angle_between.r_a, s_a.: in one frame
auto off_axis(const Dcm<Body, Wheel<1>>& R_body_from_wheel, const Vector<Body, si::dimensionless>& axis_body,
              const Vector<Wheel<1>, si::dimensionless>& axis_wheel) {
#ifdef REPAIRED
  return angle_between(axis_body, R_body_from_wheel * axis_wheel);
#else
  static_cast<void>(R_body_from_wheel);
  return angle_between(axis_body, axis_wheel);
#endif
}
}  // namespace angle_between_frames

namespace quantity_in_unit_of_other_dimension {
// mistake: seconds of an angle
// expect: UnitConstant<(vectrix::)?si::time>
// expect: a unit of the same dimension
double number(const Quantity<si::angle>& angle) {
#ifdef REPAIRED
  return angle.in(si::arcsecond);
#else
  return angle.in(si::second);
#endif
}
}  // namespace quantity_in_unit_of_other_dimension

namespace quantity_energy_for_torque {
// mistake: an energy given for a torque
// expect: Quantity<
// expect: si::torque
void apply(Quantity<si::torque> given);

void use() {
#ifdef REPAIRED
  apply(2.0 * si::newton_metre);
#else
  apply(2.0 * si::joule);
#endif
}
}  // namespace quantity_energy_for_torque

namespace quantity_kilometres_for_metres {
// mistake: kilometres given for metres
// expect: Quantity<
// expect: si::kilometre_unit
void apply(Quantity<si::length> given);

void use() {
#ifdef REPAIRED
  apply(convert<si::length>(400.0 * si::kilometre));
#else
  apply(400.0 * si::kilometre);
#endif
}
}  // namespace quantity_kilometres_for_metres

namespace quantity_norm_as_velocity {
// mistake: the length of a position given for a speed
// expect: [Qq]uantity
// expect: si::velocity
void apply(Quantity<si::velocity> given);

void use(const Vector<Gcrf, si::length>& r_gcrf, const Vector<Gcrf, si::velocity>& v_gcrf) {
#ifdef REPAIRED
  static_cast<void>(r_gcrf);
  apply(norm(v_gcrf));
#else
  static_cast<void>(v_gcrf);
  apply(norm(r_gcrf));
#endif
}
}  // namespace quantity_norm_as_velocity

namespace vector_added_in_place_across_frames {
// mistake: a vector of another frame added in place
// expect: Left = (vectrix::)?Vector<Body
// expect: Right = (vectrix::)?Vector<Gcrf
// expect: a sum of the same type
void shift(Vector<Body, si::length>& r_body, const Dcm<Body, Gcrf>& R_body_from_gcrf,
           const Vector<Gcrf, si::length>& shift_gcrf) {
#ifdef REPAIRED
  r_body += R_body_from_gcrf * shift_gcrf;
#else
  r_body += shift_gcrf;
#endif
}
}  // namespace vector_added_in_place_across_frames

namespace vector_assigned_across_frames {
// mistake: a vector of one frame assigned to a variable of another
// expect: Vector<Gcrf, (vectrix::)?si::length
// expect: Vector<Body, (vectrix::)?si::length
Vector<Body, si::length> position(const Dcm<Body, Gcrf>& R_body_from_gcrf,
                                  const Vector<Gcrf, si::length>& r_gcrf) {
#ifdef REPAIRED
  return R_body_from_gcrf * r_gcrf;
#else
  static_cast<void>(R_body_from_gcrf);
  return r_gcrf;
#endif
}
}  // namespace vector_assigned_across_frames

namespace vector_cross_across_frames {
// mistake: a cross product of two vectors expressed in different frames
// expect: Left = (vectrix::)?Vector<Itrf
// expect: Right = (vectrix::)?Vector<Gcrf
// expect: expressed in one frame
auto product(const Dcm<Itrf, Gcrf>& R_itrf_from_gcrf, const Vector<Itrf, si::length>& r_itrf,
             const Vector<Gcrf, si::force>& F_gcrf) {
#ifdef REPAIRED
  return cross(r_itrf, R_itrf_from_gcrf * F_gcrf);
#else
  static_cast<void>(R_itrf_from_gcrf);
  return cross(r_itrf, F_gcrf);
#endif
}
}  // namespace vector_cross_across_frames

namespace vector_default {
// mistake: a vector without a value
// expect: Vector<Body, (vectrix::)?si::length
auto position() {
#ifdef REPAIRED
  const Vector<Body, si::length> r_body = zero<si::length>(in<Body>);
  return r_body;
#else
  const Vector<Body, si::length> r_body;
  return r_body;
#endif
}
}  // namespace vector_default

namespace vector_difference_across_frames {
// mistake: a difference of two vectors expressed in different frames
// expect: Left = (vectrix::)?Vector<Gcrf
// expect: Right = (vectrix::)?Vector<Body
// expect: one frame and one unit
auto position(const Dcm<Gcrf, Body>& R_gcrf_from_body, const Vector<Gcrf, si::length>& r_gcrf,
              const Vector<Body, si::length>& s_body) {
#ifdef REPAIRED
  return r_gcrf - R_gcrf_from_body * s_body;
#else
  static_cast<void>(R_gcrf_from_body);
  return r_gcrf - s_body;
#endif
}
}  // namespace vector_difference_across_frames

namespace vector_dot_across_frames {
// mistake: a dot product of two vectors expressed in different frames
// expect: Left = (vectrix::)?Vector<Itrf
// expect: Right = (vectrix::)?Vector<Gcrf
// expect: two vectors in one frame
auto product(const Dcm<Itrf, Gcrf>& R_itrf_from_gcrf, const Vector<Itrf, si::length>& r_itrf,
             const Vector<Gcrf, si::force>& F_gcrf) {
#ifdef REPAIRED
  return dot(r_itrf, R_itrf_from_gcrf * F_gcrf);
#else
  static_cast<void>(R_itrf_from_gcrf);
  return dot(r_itrf, F_gcrf);
#endif
}
}  // namespace vector_dot_across_frames

namespace vector_force_for_torque {
// mistake: the cross product r x F returned as a force
// expect: si::torque
// expect: si::force
auto load(const Vector<Body, si::length>& r_body, const Vector<Body, si::force>& F_body) {
#ifdef REPAIRED
  const Vector<Body, si::torque> load_body = cross(r_body, F_body);
  return load_body;
#else
  const Vector<Body, si::force> load_body = cross(r_body, F_body);
  return load_body;
#endif
}
}  // namespace vector_force_for_torque

namespace vector_from_bare_eigen {
// mistake: three bare numbers that nobody has claimed to be coordinates of a frame
// expect: Vector<Body, (vectrix::)?si::length
Vector<Body, si::length> position(const Eigen::Vector3d& numbers) {
#ifdef REPAIRED
  return vector<si::length>(in<Body>, numbers);
#else
  return numbers;
#endif
}
}  // namespace vector_from_bare_eigen

namespace vector_length_plus_velocity {
// mistake: a displacement and a velocity added
// expect: Left = (vectrix::)?Vector<Gcrf, (vectrix::)?si::length
// expect: Right = (vectrix::)?Vector<Gcrf, (vectrix::)?si::velocity
// expect: one frame and one unit
auto next(const Vector<Gcrf, si::length>& r_gcrf, const Vector<Gcrf, si::velocity>& v_gcrf,
          Quantity<si::time> dt) {
#ifdef REPAIRED
  return r_gcrf + v_gcrf * dt;
#else
  static_cast<void>(dt);
  return r_gcrf + v_gcrf;
#endif
}
}  // namespace vector_length_plus_velocity

namespace vector_of_an_array {
// mistake: three numbers that are not Eigen's
// expect: U = (vectrix::)?si::length
// expect: InFrame = (vectrix::)?In<Body>
// expect: <U>.in<F>, Eigen::Vector3d.
auto position(const std::array<double, 3>& numbers) {
#ifdef REPAIRED
  return vector<si::length>(in<Body>, Eigen::Vector3d::Map(numbers.data()));
#else
  return vector<si::length>(in<Body>, numbers);
#endif
}
}  // namespace vector_of_an_array

namespace vector_of_bare_numbers {
// mistake: three numbers without a unit
// expect: InFrame = (vectrix::)?In<Body>
// expect: Given = .double, double, double
// expect: one SI vector unit for all: 1.0 . si::metre
auto position() {
#ifdef REPAIRED
  return vector(in<Body>, 1.0 * si::metre, 2.0 * si::metre, 3.0 * si::metre);
#else
  return vector(in<Body>, 1.0, 2.0, 3.0);
#endif
}
}  // namespace vector_of_bare_numbers

namespace vector_of_energy {
// mistake: an energy given for a torque: no vector is an energy
// expect: UnitGiven = (vectrix::)?si::energy
// expect: one SI vector unit
auto torque() {
#ifdef REPAIRED
  return vector(in<Body>, 1.0 * si::newton_metre, 2.0 * si::newton_metre, 3.0 * si::newton_metre);
#else
  return vector(in<Body>, 1.0 * si::joule, 2.0 * si::joule, 3.0 * si::joule);
#endif
}
}  // namespace vector_of_energy

namespace vector_of_kilometres {
// mistake: kilometres given for metres
// expect: InFrame = (vectrix::)?In<Gcrf>
// expect: one SI vector unit for all: .* or convert<U>
auto position() {
#ifdef REPAIRED
  const auto zero = 0.0 * si::metre;
  return vector(in<Gcrf>, convert<si::length>(7000.0 * si::kilometre), zero, zero);
#else
  return vector(in<Gcrf>, 7000.0 * si::kilometre, 0.0 * si::kilometre, 0.0 * si::kilometre);
#endif
}
}  // namespace vector_of_kilometres

namespace vector_of_mixed_units {
// mistake: three coordinates with different units
// expect: InFrame = (vectrix::)?In<Body>
// expect: UnitGiven = (vectrix::)?si::length
// expect: one SI vector unit
auto position() {
#ifdef REPAIRED
  return vector(in<Body>, 1.0 * si::metre, 2.0 * si::metre, 3.0 * si::metre);
#else
  return vector(in<Body>, 1.0 * si::metre, 2.0 * si::metre, 3.0 * si::second);
#endif
}
}  // namespace vector_of_mixed_units

namespace vector_of_four_numbers {
// mistake: a column of four numbers, as of a quaternion or a homogeneous position
// expect: U = (vectrix::)?si::length
// expect: Given = .*Eigen::Matrix<double, 4, 1
// expect: <U>.in<F>, Eigen::Vector3d.
auto position(const Eigen::Vector4d& homogeneous) {
#ifdef REPAIRED
  return vector<si::length>(in<Body>, homogeneous.head<3>());
#else
  return vector<si::length>(in<Body>, homogeneous);
#endif
}
}  // namespace vector_of_four_numbers

namespace vector_of_numbers_in_kilometres {
// mistake: bare numbers in a unit that is not coherent
// expect: U = (vectrix::)?si::kilometre_unit
// expect: InFrame = (vectrix::)?In<Body>
// expect: one SI vector unit for all: .* or convert<U>
auto position(const Eigen::Vector3d& kilometres) {
#ifdef REPAIRED
  const double metres = convert<si::length>(1.0 * si::kilometre).value();
  return vector<si::length>(in<Body>, metres * kilometres);
#else
  return vector<si::kilometre_unit>(in<Body>, kilometres);
#endif
}
}  // namespace vector_of_numbers_in_kilometres

namespace vector_of_two_quantities {
// mistake: a coordinate forgotten
// expect: InFrame = (vectrix::)?In<Body>
// expect: one SI vector unit for all: 1.0 . si::metre
auto position() {
#ifdef REPAIRED
  return vector(in<Body>, 1.0 * si::metre, 2.0 * si::metre, 0.0 * si::metre);
#else
  return vector(in<Body>, 1.0 * si::metre, 2.0 * si::metre);
#endif
}
}  // namespace vector_of_two_quantities

namespace vector_of_two_columns {
// mistake: the first two columns of a matrix
// expect: U = (vectrix::)?si::length
// expect: Eigen::Block
// expect: <U>.in<F>, Eigen::Vector3d.
auto position(const Eigen::Matrix3d& columns) {
#ifdef REPAIRED
  return vector<si::length>(in<Body>, columns.block<3, 1>(0, 0));
#else
  return vector<si::length>(in<Body>, columns.block<3, 2>(0, 0));
#endif
}
}  // namespace vector_of_two_columns

namespace vector_over_vector {
// mistake: the quotient of two vectors
// expect: Left = (vectrix::)?Vector<Body
// expect: Right = (vectrix::)?Vector<Body
// expect: a vector over a number
double ratio(const Vector<Body, si::length>& r_body, const Vector<Body, si::length>& s_body) {
#ifdef REPAIRED
  return norm(r_body) / norm(s_body);
#else
  return r_body / s_body;
#endif
}
}  // namespace vector_over_vector

namespace vector_without_frame {
// mistake: three numbers without the frame of their axes
// expect: U = (vectrix::)?si::length
// expect: <U>.in<F>, Eigen::Vector3d.
auto position(const Eigen::Vector3d& numbers) {
#ifdef REPAIRED
  return vector<si::length>(in<Body>, numbers);
#else
  return vector<si::length>(numbers);
#endif
}
}  // namespace vector_without_frame

namespace vector_without_unit {
// mistake: three numbers without their unit
// expect: U = void
// expect: InFrame = (vectrix::)?In<Body>
// expect: <U>.in<F>, Eigen::Vector3d.
auto position(const Eigen::Vector3d& numbers) {
#ifdef REPAIRED
  return vector<si::length>(in<Body>, numbers);
#else
  return vector(in<Body>, numbers);
#endif
}
}  // namespace vector_without_unit

namespace vector_passed_across_frames {
// mistake: a vector of one frame passed to a function that takes another
// expect: Vector<Wheel<2>
// expect: Vector<Body
void apply(const Vector<Body, si::torque>& tau_body);

void control(const Dcm<Body, Wheel<2>>& R_body_from_wheel, const Vector<Wheel<2>, si::torque>& tau_wheel) {
#ifdef REPAIRED
  apply(R_body_from_wheel * tau_wheel);
#else
  static_cast<void>(R_body_from_wheel);
  apply(tau_wheel);
#endif
}
}  // namespace vector_passed_across_frames

namespace vector_scaled_in_place_by_time {
// mistake: a product that would change the unit, in place
// expect: Left = (vectrix::)?Vector<Body, (vectrix::)?si::velocity
// expect: a product of the same type
void faster(Vector<Body, si::velocity>& v_body, const Quantity<si::time>& step) {
#ifdef REPAIRED
  v_body *= step / (1.0 * si::second);
#else
  v_body *= step;
#endif
}
}  // namespace vector_scaled_in_place_by_time

namespace vector_subtracted_in_place_across_units {
// mistake: a velocity subtracted from a position in place
// expect: si::length
// expect: si::velocity
// expect: a difference of the same type
void back(Vector<Body, si::length>& r_body, const Vector<Body, si::velocity>& v_body,
          const Quantity<si::time>& step) {
#ifdef REPAIRED
  r_body -= v_body * step;
#else
  r_body -= v_body;
#endif
}
}  // namespace vector_subtracted_in_place_across_units

namespace vector_sum_across_frames {
// mistake: a sum of two vectors expressed in different frames
// expect: Left = (vectrix::)?Vector<Gcrf
// expect: Right = (vectrix::)?Vector<Body
// expect: one frame and one unit
auto position(const Dcm<Gcrf, Body>& R_gcrf_from_body, const Vector<Gcrf, si::length>& r_gcrf,
              const Vector<Body, si::length>& s_body) {
#ifdef REPAIRED
  return r_gcrf + R_gcrf_from_body * s_body;
#else
  static_cast<void>(R_gcrf_from_body);
  return r_gcrf + s_body;
#endif
}
}  // namespace vector_sum_across_frames

namespace vector_torque_plus_force {
// mistake: a torque and a force added
// expect: Left = (vectrix::)?Vector<Body, (vectrix::)?si::torque
// expect: Right = (vectrix::)?Vector<Body, (vectrix::)?si::force
// expect: one frame and one unit
auto load(const Vector<Body, si::torque>& tau_body, const Vector<Body, si::length>& r_body,
          const Vector<Body, si::force>& F_body) {
#ifdef REPAIRED
  return tau_body + cross(r_body, F_body);
#else
  static_cast<void>(r_body);
  return tau_body + F_body;
#endif
}
}  // namespace vector_torque_plus_force

namespace vector_type_of_kilometres {
// mistake: a type of vectors in kilometres: vectors are in the units of SI
// expect: kilometre_unit
// expect: VectorUnit
#ifdef REPAIRED
using Position = Vector<Gcrf, si::length>;
#else
using Position = Vector<Gcrf, si::kilometre_unit>;
#endif
}  // namespace vector_type_of_kilometres
