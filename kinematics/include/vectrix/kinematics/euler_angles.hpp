#pragma once

#include <cmath>
#include <vectrix/kinematics/euler_sequence.hpp>
#include <vectrix/kinematics/parameters.hpp>

namespace vectrix {

/// Three angles, rad, by which turning a about the axes of the sequence gives b:
///     R_b^a = R_i(t1) R_j(t2) R_k(t3)        EulerAngles<Intrinsic<i, j, k>, A, B>
///     R_b^a = R_k(t3) R_j(t2) R_i(t1)        EulerAngles<Extrinsic<i, j, k>, A, B>
/// in the order of the turns: of Intrinsic<3, 2, 1> the first is the yaw. Singular where the first and the
/// third axis are parallel: the second angle a quarter turn, or in a proper sequence, as 3-1-3, none or half.
template <EulerSequence Sequence, Frame A, Frame B, class S = double> class EulerAngles {
 public:
  using sequence = Sequence;
  using reference = A;
  using turned = B;
  using scalar = S;
  using numbers = detail::Column<S>;

  EulerAngles() = delete;  // euler_angles(intrinsic<3, 2, 1>, of<B>, relative_to<A>, yaw, pitch, roll)
  template <class Derived>
  EulerAngles(detail::Trusted, const Eigen::MatrixBase<Derived>& angles) : angles_(angles) {}

  Quantity<si::angle, S> first() const { return Quantity<si::angle, S>::from_value(angles_(0)); }
  Quantity<si::angle, S> second() const { return Quantity<si::angle, S>::from_value(angles_(1)); }
  Quantity<si::angle, S> third() const { return Quantity<si::angle, S>::from_value(angles_(2)); }
  /// The bare angles in the order of the turns, rad.
  const numbers& coordinates() const& { return angles_; }
  numbers coordinates() && { return angles_; }

  /// How far the second angle is from the nearest at which the third axis is parallel to the first.
  Quantity<si::angle, S> distance_from_singularity() const {
    using std::abs;
    using std::atan2;
    const S s = abs(detail::sine<S>(angles_(1)));
    const S c = abs(detail::cosine<S>(angles_(1)));
    return Quantity<si::angle, S>::from_value(Sequence::proper ? atan2(s, c) : atan2(c, s));
  }

  static std::string name() { return "Euler angles " + Sequence::name(); }
  static const char* singularity() {
    return Sequence::proper ? "the second angle none or half a turn" : "the second angle a quarter turn";
  }
  static const char* unit_symbol(int derivative) {
    return derivative == 0 ? "rad" : derivative == 1 ? "rad/s" : "rad/s^2";
  }

 private:
  numbers angles_;
};

template <class Sequence, class A, class B, class S>
inline constexpr bool detail::is_framed<EulerAngles<Sequence, A, B, S>> = true;

/// Claims that turning a by the angles, in the order of the sequence, gives b. Throws BadInput when an angle
/// is not finite; any finite angle is valid.
template <EulerSequence Sequence, Frame B, Frame A, class S>
  requires(!std::integral<S>)
detail::OfTwo<B, A, EulerAngles<Sequence, A, B, S>> euler_angles(Sequence, Of<B>, RelativeTo<A>,
                                                                 const Quantity<si::angle, S>& first,
                                                                 const Quantity<si::angle, S>& second,
                                                                 const Quantity<si::angle, S>& third) {
  using Angles = EulerAngles<Sequence, A, B, S>;
  const detail::Column<S> angles(first.value(), second.value(), third.value());
  detail::require_finite<Angles>(angles, "euler_angles");
  return Angles{detail::trusted, angles};
}
template <class Sequence, class OfFrame, class RelativeToFrame, class First, class Second, class Third>
auto euler_angles(  // intrinsic<3, 2, 1>, of<B>, relative_to<A>: two frames; three angles in rad
    const Sequence&, const OfFrame&, const RelativeToFrame&, const First&, const Second&, const Third&)
    -> Refused = delete;

namespace detail {

/// R x, where R turns by the angle of cosine c and sine s about the axis; x a column, or a matrix of columns.
template <int axis, class Matrix, class S> Matrix turned_about(const Matrix& x, const S& c, const S& s) {
  constexpr int next = (axis + 1) % 3;
  constexpr int last = (axis + 2) % 3;
  Matrix y = x;
  y.row(next) = c * x.row(next) - s * x.row(last);
  y.row(last) = s * x.row(next) + c * x.row(last);
  return y;
}
template <int axis, class S> Eigen::Quaternion<S> turn_about(const S& angle) {
  Eigen::Quaternion<S> q(cosine<S>(angle / S(2)), S(0), S(0), S(0));
  q.vec()(axis) = sine<S>(angle / S(2));
  return q;
}

}  // namespace detail

/// R_b^a of the angles. Entries that are products of sines and cosines alone keep all their digits near the
/// singularity.
template <class Sequence, class A, class B, class S>
Dcm<A, B, S> dcm(const EulerAngles<Sequence, A, B, S>& x_ab) {
  const detail::Column<S> s = x_ab.coordinates().unaryExpr([](const S& t) { return detail::sine(t); });
  const detail::Column<S> c = x_ab.coordinates().unaryExpr([](const S& t) { return detail::cosine(t); });
  using detail::turned_about;
  const detail::Square<S> none = detail::Square<S>::Identity();
  constexpr int i = Sequence::first, j = Sequence::second, k = Sequence::third;
  if constexpr (Sequence::intrinsic) {
    return {detail::trusted,
            turned_about<i>(turned_about<j>(turned_about<k>(none, c(2), s(2)), c(1), s(1)), c(0), s(0))};
  } else {
    return {detail::trusted,
            turned_about<k>(turned_about<j>(turned_about<i>(none, c(0), s(0)), c(1), s(1)), c(2), s(2))};
  }
}

/// q_b^a of the angles, of either sign.
template <class Sequence, class A, class B, class S>
Quaternion<A, B, S> quaternion(const EulerAngles<Sequence, A, B, S>& x_ab) {
  const auto& t = x_ab.coordinates();
  const auto q1 = detail::turn_about<Sequence::first, S>(t(0));
  const auto q2 = detail::turn_about<Sequence::second, S>(t(1));
  const auto q3 = detail::turn_about<Sequence::third, S>(t(2));
  return {detail::trusted,
          [&]() -> Eigen::Quaternion<S> { return Sequence::intrinsic ? q1 * q2 * q3 : q3 * q2 * q1; }};
}

/// The angles of R_b^a: the first and the third from -pi to pi, the second from -pi/2 to pi/2, or in a proper
/// sequence from 0 to pi. Each is an arc tangent of two entries, the first of the matrix with the third turn
/// undone: near the singularity their sum keeps its digits where the rounding of R has spoilt each.
/// At the singularity, within eight roundings, the third angle is zero by choice:
/// x.distance_from_singularity() says how near. There numbers with derivatives throw BadInput, since the
/// angles have none.
template <EulerSequence Sequence, class A, class B, class S>
EulerAngles<Sequence, A, B, S> euler_angles(Sequence, const Dcm<A, B, S>& R_a_from_b) {
  using detail::select;
  using std::atan2;
  using std::sqrt;
  constexpr int i = Sequence::first, j = Sequence::second, l = Sequence::other;
  // In the axes i, j, l, with the angles times their handedness, all 12 products have two forms. The inverse
  // of an extrinsic product is the intrinsic one of the opposite angles.
  const S sign(Sequence::handedness * (Sequence::intrinsic ? 1 : -1));
  detail::Square<S> R = R_a_from_b.matrix();
  if constexpr (!Sequence::intrinsic) R = R_a_from_b.matrix().transpose().eval();

  const S s3 = Sequence::proper ? S(sign * R(i, j)) : S(-R(i, j));
  const S c3 = Sequence::proper ? S(sign * R(i, l)) : S(R(i, i));
  const S h = sqrt(S(s3 * s3 + c3 * c3));
  const auto singular = h <= detail::singular_angle<S>();
  const S opposite = Sequence::proper ? h : S(sign * R(i, l));
  const S adjacent = Sequence::proper ? R(i, i) : h;
  const S second = atan2(opposite, adjacent);
  if constexpr (detail::Differentiated<S>) {
    if (singular) {
      detail::refuse_singular<EulerAngles<Sequence, A, B, S>>(detail::without_derivatives(h), "euler_angles");
    }
  }
  const S length = select<S>(singular, S(1), h);
  const S c = select<S>(singular, S(1), S(c3 / length));
  const S s = select<S>(singular, S(0), S(s3 / length));
  const S c1 = Sequence::proper ? S(c * R(j, j) - s * R(j, l)) : S(s * R(j, i) + c * R(j, j));
  const S s1 = Sequence::proper ? S(c * R(l, j) - s * R(l, l)) : S(s * R(l, i) + c * R(l, j));
  const S first = atan2(S(sign * s1), c1);
  const S third = select<S>(singular, S(0), S(atan2(S(sign * s), c)));
  return {detail::trusted, detail::Column<S>(first, second, third)};
}
template <EulerSequence Sequence, class A, class B, class S>
EulerAngles<Sequence, A, B, S> euler_angles(Sequence sequence, const Quaternion<A, B, S>& q_a_from_b) {
  return euler_angles(sequence, dcm(q_a_from_b));
}

}  // namespace vectrix
