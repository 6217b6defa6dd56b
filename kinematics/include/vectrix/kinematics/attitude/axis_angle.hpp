#pragma once

#include <cmath>
#include <vectrix/frames/scalar/arc_tangent.hpp>
#include <vectrix/frames/scalar/sine_cosine.hpp>
#include <vectrix/kinematics/attitude/along_axis.hpp>
#include <vectrix/kinematics/attitude/rotation_vector.hpp>

namespace vectrix {

/// (phi, n), of type AxisAngle<A, B>: turning a by the angle phi about the unit axis n gives b; the axis has
/// the same coordinates in a and in b.
///     R_b^a = I + sin phi [n]x + (1 - cos phi) ([n]x)^2        q_b^a = (cos phi/2, sin phi/2 n)
/// (phi, n), (-phi, -n) and (phi + 2 pi, n) are the same rotation. Singular where phi is zero or a full turn:
/// there the axis is arbitrary.
template <Frame A, Frame B, class S = double>
class AxisAngle : public detail::AttitudeParameters<AxisAngle<A, B, S>, A, B, S, 4> {
  using Base = detail::AttitudeParameters<AxisAngle<A, B, S>, A, B, S, 4>;

 public:
  using Base::Base;
  template <class Derived>
  AxisAngle(detail::Trusted, const S& angle, const Eigen::MatrixBase<Derived>& axis)
      : Base(detail::trusted, (Eigen::Matrix<S, 4, 1>() << angle, axis).finished()) {}

  Quantity<si::angle, S> angle() const { return Quantity<si::angle, S>::from_value(this->coordinates()(0)); }
  /// The axis, expressed in a or in b.
  Vector<A, si::dimensionless, S> in_reference() const {
    return {detail::trusted, this->coordinates().template tail<3>()};
  }
  Vector<B, si::dimensionless, S> in_turned() const {
    return {detail::trusted, this->coordinates().template tail<3>()};
  }
  /// The distance of the angle from the nearest whole number of turns.
  Quantity<si::angle, S> distance_from_singularity() const {
    using std::abs;
    const S half = this->coordinates()(0) / S(2);
    const auto turn = detail::sine_cosine(half);
    return Quantity<si::angle, S>::from_value(S(2) *
                                              detail::arc_tangent(S(abs(turn.sine)), S(abs(turn.cosine))));
  }

  /// The inverse, with the opposite axis: turning b by it gives a.
  AxisAngle<B, A, S> operator-() const {
    return {detail::trusted, this->coordinates()(0), -in_turned().coordinates()};
  }

  /// Angle times axis, not reduced to the shortest turn.
  RotationVector<A, B, S> rotation_vector() const {
    return {detail::trusted, this->coordinates()(0) * this->coordinates().template tail<3>()};
  }
  friend Quaternion<A, B, S> quaternion(const AxisAngle& x_ab) {
    const S half = x_ab.coordinates()(0) / S(2);
    const auto turn = detail::sine_cosine(half);
    const detail::Column<S> v = turn.sine * x_ab.coordinates().template tail<3>();
    return {detail::trusted, [&] { return Eigen::Quaternion<S>(turn.cosine, v.x(), v.y(), v.z()); }};
  }
  friend Dcm<A, B, S> dcm(const AxisAngle& x_ab) { return dcm(quaternion(x_ab)); }

  static const char* name() { return "angle and axis"; }
  static const char* singularity() { return "no turn or a full one"; }
  static const char* unit_symbol(int derivative) {
    return derivative == 0 ? "(rad, 1)" : derivative == 1 ? "(rad/s, 1/s)" : "(rad/s^2, 1/s^2)";
  }
};

template <class A, class B, class S> inline constexpr bool detail::is_framed<AxisAngle<A, B, S>> = true;

/// Claims that turning a by the angle about the axis, expressed in a or in b, gives b. Any finite angle is
/// valid. Throws BadInput when the angle is not finite, or the length of the axis differs from 1 by more than
/// unit_norm_tolerance.
template <Frame B, Frame A, class C, class S>
detail::OfTwo<B, A, detail::InOneOf<C, A, B, AxisAngle<A, B, S>>> axis_angle(
    Of<B>, RelativeTo<A>, const Vector<C, si::dimensionless, S>& axis, const Quantity<si::angle, S>& angle) {
  const AxisAngle<A, B, S> x{detail::trusted, angle.value(), axis.coordinates()};
  detail::require_finite<AxisAngle<A, B, S>>(x.coordinates(), "axis_angle");
  // |n|^2 - 1 is twice |n| - 1.
  const S square = axis.coordinates().squaredNorm();
  const S error = detail::select(square > S(1), S(square - S(1)), S(S(1) - square)) / S(2);
  const double tolerance = detail::door_tolerance<S>(unit_norm_tolerance);
  if (!detail::all(error <= detail::number<S>(tolerance))) {
    throw BadInput(detail::parameters_name<AxisAngle<A, B, S>>("axis_angle") +
                   "the square of the axis differs from 1 by " + detail::text(S(S(2) * error)) +
                   ", tolerance " + detail::text(2 * tolerance) + "; direction() projects");
  }
  return x;
}
template <class OfFrame, class RelativeToFrame, class Axis, class Angle>
auto axis_angle(  // of<B>, relative_to<A>: two frames; a direction in one of them; an angle in rad
    const OfFrame&, const RelativeToFrame&, const Axis&, const Angle&) -> Refused = delete;

namespace detail {

template <class A, class B, class S> AxisAngle<A, B, S> axis_angle_of(const Quaternion<A, B, S>& q_a_from_b) {
  const Eigen::Quaternion<S> q = shorter_way(q_a_from_b.eigen());
  const Column<S> v = q.vec();
  const S largest = v.cwiseAbs().maxCoeff();
  const auto none = largest == S(0);
  if constexpr (Differentiated<S>) {
    if (none) {
      refuse_singular<AxisAngle<A, B, S>>(without_derivatives(largest), "axis_angle");
    }
  }
  // Scaled against underflow. For zero rotation the axis is x.
  const S scale = select<S>(none, S(1), largest);
  const Column<S> scaled(select<S>(none, S(1), S(v.x() / scale)), S(v.y() / scale), S(v.z() / scale));
  const S norm = scaled.norm();
  return {trusted, S(2) * arc_tangent(S(norm * largest), q.w()), scaled / norm};
}

}  // namespace detail

/// The shortest turn of a quaternion q_b^a or of R_b^a, 0 <= phi <= pi. At half a turn, where n and -n are
/// the same rotation, the first non-zero component of n is positive. For zero rotation the axis is arbitrary;
/// x is chosen. Numbers with derivatives throw BadInput there, because the axis has no derivative.
template <class Rotation>
auto axis_angle(const Rotation& R_a_from_b)
    -> decltype(detail::axis_angle_of(detail::as_quaternion(R_a_from_b))) {
  return detail::axis_angle_of(detail::as_quaternion(R_a_from_b));
}

/// Claims that the numbers, rad/s and then 1/s, are the derivative of angle and axis. Throws BadInput when
/// one is not finite, or the axis would not stay a unit vector: |n . n'| exceeds orthonormality_tolerance
/// |n'|.
template <class A, class B, class S, class Derived>
  requires(std::same_as<typename Derived::PlainObject, Eigen::Matrix<S, 4, 1>>)
ParameterRate<AxisAngle<A, B, S>> parameter_rate(const AxisAngle<A, B, S>& x_ab,
                                                 const Eigen::MatrixBase<Derived>& numbers) {
  detail::require_finite<AxisAngle<A, B, S>>(numbers, "parameter_rate");
  const detail::Column<S> ndot = numbers.template tail<3>();
  const S along = x_ab.coordinates().template tail<3>().dot(ndot);
  const S tolerance(detail::door_tolerance<S>(orthonormality_tolerance));
  if (!detail::all(along * along <= tolerance * tolerance * ndot.squaredNorm())) {
    throw BadInput(detail::parameters_name<AxisAngle<A, B, S>>("parameter_rate") +
                   "the rate of the axis along the axis is " + detail::text(along) +
                   " 1/s; a unit vector keeps its length");
  }
  return {detail::trusted, numbers};
}

namespace detail {

/// With the upper sign for a rate expressed in b, the lower for one in a:
///     phi' = n . w        n' = 1/2 (+- n x w + cot(phi/2) (w - n (n . w)))
///     w = n phi' + sin phi n' -+ (1 - cos phi) n x n'
/// and their derivatives. Throws BadInput for an n'' that does not keep n a unit vector.
template <class A, class B, class S, bool expressed_in_turned>
struct KinematicsOf<AxisAngle<A, B, S>, expressed_in_turned> {
  using Numbers = Eigen::Matrix<S, 4, 1>;

  static Numbers rate(const AxisAngle<A, B, S>& x, const Column<S>& w) {
    const Column<S> n = x.coordinates().template tail<3>();
    const S along = n.dot(w);
    const Column<S> across = w - n * along;
    return joined(along, (turn(n, w) + cotangent(x, "rate") * across) / S(2));
  }
  static Column<S> velocity(const AxisAngle<A, B, S>& x, const Numbers& xdot) {
    const Column<S> n = x.coordinates().template tail<3>();
    const Column<S> ndot = xdot.template tail<3>();
    return n * xdot(0) + sine_cosine(x.coordinates()(0)).sine * ndot - versine(x) * turn(n, ndot);
  }
  static Numbers second_rate(const AxisAngle<A, B, S>& x, const Numbers& xdot, const Column<S>& w,
                             const Column<S>& alpha) {
    const Column<S> n = x.coordinates().template tail<3>();
    const Column<S> ndot = xdot.template tail<3>();
    const S cot = cotangent(x, "second_rate");
    const S cot_dot = -(S(1) + cot * cot) * xdot(0) / S(2);
    const S along = n.dot(w);
    const S along_dot = ndot.dot(w) + n.dot(alpha);
    const Column<S> across = w - n * along;
    const Column<S> across_dot = alpha - ndot * along - n * along_dot;
    return joined(along_dot, (turn(ndot, w) + turn(n, alpha) + cot_dot * across + cot * across_dot) / S(2));
  }
  static Column<S> acceleration(const AxisAngle<A, B, S>& x, const Numbers& xdot, const Numbers& xddot) {
    const Column<S> n = x.coordinates().template tail<3>();
    const Column<S> ndot = xdot.template tail<3>();
    const Column<S> nddot = xddot.template tail<3>();
    require_unit_axis(n.dot(nddot), ndot.squaredNorm(), nddot.norm());
    const auto [s, c] = sine_cosine(x.coordinates()(0));
    return n * xddot(0) + (S(1) + c) * xdot(0) * ndot + s * nddot - s * xdot(0) * turn(n, ndot) -
           versine(x) * turn(n, nddot);
  }

 private:
  // n . n'' = -|n'|^2 for every unit vector.
  static void require_unit_axis(const S& along, const S& square, const S& largest) {
    const S apart = along + square;
    const S allowed = number<S>(door_tolerance<S>(orthonormality_tolerance)) * (square + largest);
    if (!all(apart <= allowed) || !all(-apart <= allowed)) {
      throw BadInput(parameters_name<AxisAngle<A, B, S>>("angular_acceleration") +
                     "the second rate of the axis along the axis is " + text(along) +
                     " 1/s^2; that of a unit vector is -|n'|^2, " + text(S(-square)) + " 1/s^2");
    }
  }
  static Numbers joined(const S& first, const Column<S>& rest) {
    Numbers four;
    four << first, rest;
    return four;
  }
  static Column<S> turn(const Column<S>& n, const Column<S>& w) {
    return turn_of<expressed_in_turned, S>(n, w);
  }
  // 1 - cos phi
  static S versine(const AxisAngle<A, B, S>& x) {
    const S s = sine_cosine<S>(x.coordinates()(0) / S(2)).sine;
    return S(2) * s * s;
  }
  static S cotangent(const AxisAngle<A, B, S>& x, const char* action) {
    const S half = x.coordinates()(0) / S(2);
    const auto [s, c] = sine_cosine<S>(half);
    require_regular<AxisAngle<A, B, S>>(S(2) * s, action);
    return c / s;
  }
};

}  // namespace detail
}  // namespace vectrix
