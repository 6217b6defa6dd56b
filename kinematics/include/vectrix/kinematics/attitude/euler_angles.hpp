#pragma once

#include <cmath>
#include <vectrix/frames/scalar/arc_tangent.hpp>
#include <vectrix/frames/scalar/sine_cosine.hpp>
#include <vectrix/frames/scalar/square_root.hpp>
#include <vectrix/kinematics/attitude/euler_sequence.hpp>
#include <vectrix/kinematics/attitude/parameters.hpp>

namespace vectrix {
namespace detail {

template <int axis, class S> Eigen::Quaternion<S> turn_about(const S& angle) {
  const auto [sine, cosine] = sine_cosine<S>(angle / S(2));
  Eigen::Quaternion<S> q(cosine, S(0), S(0), S(0));
  q.vec()(axis) = sine;
  return q;
}

}  // namespace detail

/// Three angles, rad: turning a by them about the axes of the sequence gives b:
///     R_b^a = R_i(t1) R_j(t2) R_k(t3)        EulerAngles<Intrinsic<i, j, k>, A, B>
///     R_b^a = R_k(t3) R_j(t2) R_i(t1)        EulerAngles<Extrinsic<i, j, k>, A, B>
/// The angles are in the order of the turns: the first of Intrinsic<3, 2, 1> is the yaw. Singular where the
/// first and the third axis are parallel: at a second angle of a quarter turn, or in a proper sequence, such
/// as 3-1-3, of zero or half a turn.
template <EulerSequence Sequence, Frame A, Frame B, class S = double>
class EulerAngles : public detail::AttitudeParameters<EulerAngles<Sequence, A, B, S>, A, B, S, 3> {
 public:
  using sequence = Sequence;
  using detail::AttitudeParameters<EulerAngles<Sequence, A, B, S>, A, B, S, 3>::AttitudeParameters;

  Quantity<si::angle, S> first() const { return Quantity<si::angle, S>::from_value(this->coordinates()(0)); }
  Quantity<si::angle, S> second() const { return Quantity<si::angle, S>::from_value(this->coordinates()(1)); }
  Quantity<si::angle, S> third() const { return Quantity<si::angle, S>::from_value(this->coordinates()(2)); }
  /// The distance of the second angle from the nearest singular one, where the third axis is parallel to the
  /// first.
  Quantity<si::angle, S> distance_from_singularity() const {
    using std::abs;
    const auto [sine, cosine] = detail::sine_cosine(this->coordinates()(1));
    const S s = abs(sine), c = abs(cosine);
    return Quantity<si::angle, S>::from_value(Sequence::proper ? detail::arc_tangent(s, c)
                                                               : detail::arc_tangent(c, s));
  }

  /// Entries that are only products of sines and cosines stay accurate near the singularity.
  friend Dcm<A, B, S> dcm(const EulerAngles& x_ab) {
    // In the axes i, j, l, as in euler_angles_of().
    constexpr int i = Sequence::first, j = Sequence::second, l = Sequence::other;
    const S sign(Sequence::handedness * (Sequence::intrinsic ? 1 : -1));
    detail::Column<S> s, c;
    for (int turn = 0; turn < 3; ++turn) {
      const auto [sine, cosine] = detail::sine_cosine(x_ab.coordinates()(turn));
      s(turn) = sign * sine;
      c(turn) = cosine;
    }
    const S cc = c(0) * c(2), ss = s(0) * s(2), cs = c(0) * s(2), sc = s(0) * c(2);
    detail::Square<S> R;
    if constexpr (Sequence::proper) {
      R(i, i) = c(1), R(i, j) = s(1) * s(2), R(i, l) = s(1) * c(2);
      R(j, i) = s(0) * s(1), R(j, j) = cc - c(1) * ss, R(j, l) = -cs - c(1) * sc;
      R(l, i) = -c(0) * s(1), R(l, j) = sc + c(1) * cs, R(l, l) = c(1) * cc - ss;
    } else {
      R(i, i) = c(1) * c(2), R(i, j) = -c(1) * s(2), R(i, l) = s(1);
      R(j, i) = cs + s(1) * sc, R(j, j) = cc - s(1) * ss, R(j, l) = -s(0) * c(1);
      R(l, i) = ss - s(1) * cc, R(l, j) = sc + s(1) * cs, R(l, l) = c(0) * c(1);
    }
    if constexpr (!Sequence::intrinsic) R.transposeInPlace();
    return {detail::trusted, R};
  }
  /// The sign of the quaternion is arbitrary.
  friend Quaternion<A, B, S> quaternion(const EulerAngles& x_ab) {
    const auto q1 = detail::turn_about<Sequence::first, S>(x_ab.coordinates()(0));
    const auto q2 = detail::turn_about<Sequence::second, S>(x_ab.coordinates()(1));
    const auto q3 = detail::turn_about<Sequence::third, S>(x_ab.coordinates()(2));
    return {detail::trusted,
            [&]() -> Eigen::Quaternion<S> { return Sequence::intrinsic ? q1 * q2 * q3 : q3 * q2 * q1; }};
  }

  static std::string name() { return "Euler angles " + Sequence::name(); }
  static const char* singularity() {
    return Sequence::proper ? "the second angle none or half a turn" : "the second angle a quarter turn";
  }
  static const char* unit_symbol(int derivative) {
    return derivative == 0 ? "rad" : derivative == 1 ? "rad/s" : "rad/s^2";
  }
};

template <class Sequence, class A, class B, class S>
inline constexpr bool detail::is_framed<EulerAngles<Sequence, A, B, S>> = true;

namespace detail {

template <class Sequence, class A, class B, class S>
using EulerAnglesOf = typename std::enable_if_t<EulerSequence<Sequence> && !std::integral<S>,
                                                std::type_identity<EulerAngles<Sequence, A, B, S>>>::type;

}  // namespace detail

/// Claims that turning a by the angles, in the order of the sequence, gives b. Throws BadInput when an angle
/// is not finite; any finite angle is valid.
template <class Sequence, Frame B, Frame A, class S>
detail::OfTwo<B, A, detail::EulerAnglesOf<Sequence, A, B, S>> euler_angles(
    Sequence, Of<B>, RelativeTo<A>, const Quantity<si::angle, S>& first, const Quantity<si::angle, S>& second,
    const Quantity<si::angle, S>& third) {
  using Angles = EulerAngles<Sequence, A, B, S>;
  const detail::Column<S> angles(first.value(), second.value(), third.value());
  detail::require_finite<Angles>(angles, "euler_angles");
  return Angles{detail::trusted, angles};
}
template <class Sequence, class OfFrame, class RelativeToFrame, class First, class Second, class Third>
auto euler_angles(  // a sequence, no axis twice in a row; of<B>, relative_to<A>: two frames; angles in rad
    const Sequence&, const OfFrame&, const RelativeToFrame&, const First&, const Second&, const Third&)
    -> Refused = delete;

namespace detail {

template <EulerSequence Sequence, class A, class B, class S>
EulerAngles<Sequence, A, B, S> euler_angles_of(const Dcm<A, B, S>& R_a_from_b) {
  constexpr int i = Sequence::first, j = Sequence::second, l = Sequence::other;
  // In the axes i, j, l, with the angles multiplied by the handedness, the 12 sequences have only two forms.
  // The inverse of an extrinsic product is the intrinsic product of the opposite angles.
  const S sign(Sequence::handedness * (Sequence::intrinsic ? 1 : -1));
  Square<S> R = R_a_from_b.matrix();
  if constexpr (!Sequence::intrinsic) R = R_a_from_b.matrix().transpose().eval();

  const S s3 = Sequence::proper ? S(sign * R(i, j)) : S(-R(i, j));
  const S c3 = Sequence::proper ? S(sign * R(i, l)) : S(R(i, i));
  const S h = square_root(S(s3 * s3 + c3 * c3));
  const auto singular = h <= singular_angle<S>();
  const S zero(0);  // added to an ordinate: -0 becomes 0, so that half a turn is pi, not -pi
  const S opposite = Sequence::proper ? h : S(sign * R(i, l) + zero);
  const S adjacent = Sequence::proper ? R(i, i) : h;
  const S second = arc_tangent(opposite, adjacent);
  if constexpr (Differentiated<S>) {
    if (singular) {
      refuse_singular<EulerAngles<Sequence, A, B, S>>(without_derivatives(h), "euler_angles");
    }
  }
  const S length = select<S>(singular, S(1), h);
  const S c = select<S>(singular, S(1), S(c3 / length));
  const S s = select<S>(singular, S(0), S(s3 / length));
  const S c1 = Sequence::proper ? S(c * R(j, j) - s * R(j, l)) : S(s * R(j, i) + c * R(j, j));
  const S s1 = Sequence::proper ? S(c * R(l, j) - s * R(l, l)) : S(s * R(l, i) + c * R(l, j));
  const S first = arc_tangent(S(sign * s1 + zero), c1);
  const S third = select<S>(singular, zero, S(arc_tangent(S(sign * s + zero), c)));
  return {trusted, Column<S>(first, second, third)};
}

}  // namespace detail

/// The angles of R_b^a, or of a quaternion q_b^a. The first and third are from -pi to pi, and pi for an exact
/// half turn; the second is from -pi/2 to pi/2, or from 0 to pi in a proper sequence. None is -0. Each is an
/// arc tangent of two entries; for the first, the third turn is undone before. Near the singularity rounding
/// of R spoils the first and third angle, but their sum (or difference) stays accurate. Within eight
/// roundings of the singularity the third angle is set to zero, and numbers with derivatives throw BadInput,
/// because the angles have no derivative there. x.distance_from_singularity() gives the distance.
template <EulerSequence Sequence, class Rotation>
auto euler_angles(Sequence, const Rotation& R_a_from_b)
    -> decltype(detail::euler_angles_of<Sequence>(detail::as_dcm(R_a_from_b))) {
  return detail::euler_angles_of<Sequence>(detail::as_dcm(R_a_from_b));
}

}  // namespace vectrix
