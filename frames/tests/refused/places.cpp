// Frames and places
#include <vectrix/frames.hpp>

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Body : moving_frame {};
struct Camera : moving_frame {};
struct CentreOfMass : named_point {};
struct Thruster : named_point {};
struct Hinge : named_point {};
struct Tip : named_point {};

namespace displacement_expressed_in_two_frames {
// mistake: displacements expressed in different frames added
// expect: Displacement<Body, CentreOfMass, (vectrix::)?In<Body>
// expect: Displacement<CentreOfMass, Thruster, (vectrix::)?In<Gcrf>
auto position(const Displacement<Body, CentreOfMass, In<Body>>& r_bc_b,
              const Displacement<CentreOfMass, Thruster, In<Gcrf>>& r_ct_i,
              const Dcm<Body, Gcrf>& R_b_from_i) {
#ifdef REPAIRED
  return r_bc_b + R_b_from_i * r_ct_i;
#else
  return static_cast<void>(R_b_from_i), r_bc_b + r_ct_i;
#endif
}
}  // namespace displacement_expressed_in_two_frames

namespace displacement_from_velocity {
// mistake: metres per second at a door for metres
// expect: si::velocity
auto position(const Vector<Body, si::velocity>& v_b, const Quantity<si::time>& t) {
#ifdef REPAIRED
  return displacement(of<Thruster>, relative_to<Body>, v_b * t);
#else
  return static_cast<void>(t), displacement(of<Thruster>, relative_to<Body>, v_b);
#endif
}
}  // namespace displacement_from_velocity

namespace displacement_of_one_point {
// mistake: a point given a place relative to itself
// expect: Q = Body
// expect: P = Body
// expect: two points
auto place(const Vector<Body, si::length>& r_body) {
#ifdef REPAIRED
  return displacement(of<Hinge>, relative_to<Body>, r_body);
#else
  return displacement(of<Body>, relative_to<Body>, r_body);
#endif
}
}  // namespace displacement_of_one_point

namespace displacement_plus_free_vector {
// mistake: a free vector added to a displacement, whose end it would not name
// expect: Displacement<Body, CentreOfMass, (vectrix::)?In<Body>
// expect: Vector<Body
auto position(const Displacement<Body, CentreOfMass, In<Body>>& r_bc_b, const Vector<Body, si::length>& s_b) {
#ifdef REPAIRED
  return r_bc_b + displacement(of<Thruster>, relative_to<CentreOfMass>, s_b);
#else
  return r_bc_b + s_b;
#endif
}
}  // namespace displacement_plus_free_vector

namespace displacement_points_do_not_chain {
// mistake: displacements between points that do not chain
// expect: Displacement<Body, CentreOfMass, (vectrix::)?In<Body>
// expect: Displacement<Body, Thruster, (vectrix::)?In<Body>
auto position(const Displacement<Body, CentreOfMass, In<Body>>& r_bc_b,
              const Displacement<Body, Thruster, In<Body>>& r_bt_b) {
#ifdef REPAIRED
  return -r_bc_b + r_bt_b;
#else
  return r_bc_b + r_bt_b;
#endif
}
}  // namespace displacement_points_do_not_chain

namespace frame_inertial_and_moving {
// mistake: a frame that is inertial and moving at once
// expect: Earth
struct Earth : vectrix::inertial_frame, vectrix::moving_frame {};
struct MovingEarth : vectrix::moving_frame {};

auto attitude() {
#ifdef REPAIRED
  return aligned(to<Body>, from<MovingEarth>);
#else
  return aligned(to<Body>, from<Earth>);
#endif
}
}  // namespace frame_inertial_and_moving

namespace frame_with_data {
// mistake: a frame that is not an empty type
// expect: Camera
template <class Data> struct Camera : vectrix::moving_frame { Data focal_length; };
template <> struct Camera<void> : vectrix::moving_frame {};

auto mounting() {
#ifdef REPAIRED
  return aligned(to<Camera<void>>, from<Body>);
#else
  return aligned(to<Camera<int>>, from<Body>);
#endif
}
}  // namespace frame_with_data

namespace frame_without_motion {
// mistake: a frame that is neither inertial nor moving
// expect: Camera
struct Camera {};
struct MovingCamera : vectrix::moving_frame {};

auto mounting() {
#ifdef REPAIRED
  return aligned(to<MovingCamera>, from<Body>);
#else
  return aligned(to<Camera>, from<Body>);
#endif
}
}  // namespace frame_without_motion

namespace transform_inner_frames {
// mistake: transforms whose inner frames do not cancel
// expect: Transform<Camera, Body
// expect: Transform<Gcrf, Body
auto motion(const Transform<Camera, Body>& X_c_from_b, const Transform<Gcrf, Body>& X_i_from_b) {
#ifdef REPAIRED
  return X_c_from_b * inverse(X_i_from_b);
#else
  return X_c_from_b * X_i_from_b;
#endif
}
}  // namespace transform_inner_frames

namespace transform_of_free_vector {
// mistake: a free vector moved as if it were a position
// expect: Transform<Body, Gcrf
// expect: Vector<Gcrf
auto motion(const Transform<Body, Gcrf>& X_b_from_i, const Vector<Gcrf, si::length>& r_i) {
#ifdef REPAIRED
  return X_b_from_i.rotation * r_i;
#else
  return X_b_from_i * r_i;
#endif
}
}  // namespace transform_of_free_vector

namespace transform_of_position_from_another_origin {
// mistake: a position relative to a point that is not the origin of the frame
// expect: Transform<Body, Gcrf
// expect: Displacement<Camera, Tip, (vectrix::)?In<Gcrf>
auto motion(const Transform<Body, Gcrf>& X_b_from_i, const Displacement<Camera, Tip, In<Gcrf>>& r_ct_i,
            const Displacement<Gcrf, Camera, In<Gcrf>>& r_ic_i) {
#ifdef REPAIRED
  return X_b_from_i * (r_ic_i + r_ct_i);
#else
  return static_cast<void>(r_ic_i), X_b_from_i * r_ct_i;
#endif
}
}  // namespace transform_of_position_from_another_origin

namespace transform_reversed {
// mistake: a transform assigned to its inverse
// expect: Transform<Body, Gcrf
// expect: Transform<Gcrf, Body
Transform<Gcrf, Body> motion(const Transform<Body, Gcrf>& X_b_from_i) {
#ifdef REPAIRED
  return inverse(X_b_from_i);
#else
  return X_b_from_i;
#endif
}
}  // namespace transform_reversed

namespace transform_with_reversed_translation {
// mistake: the translation from the wrong origin, in the wrong frame
// expect: Displacement<Gcrf, Body|'Body' vs. 'Gcrf'
auto motion(const Dcm<Body, Gcrf>& R_b_from_i, const Displacement<Gcrf, Body, In<Gcrf>>& r_ib_i) {
#ifdef REPAIRED
  return Transform{R_b_from_i, -(R_b_from_i * r_ib_i)};
#else
  return Transform{R_b_from_i, r_ib_i};
#endif
}
}  // namespace transform_with_reversed_translation
