#pragma once

#include <vectrix/frames/scalar/sine_cosine.hpp>
#include <vectrix/kinematics/attitude/euler_angles.hpp>

namespace vectrix {
namespace detail {

/// A column turned by the angle of cosine c and sine s about the axis.
template <int axis, class S> Column<S> turned_about(const Column<S>& x, const S& c, const S& s) {
  constexpr int next = (axis + 1) % 3;
  constexpr int last = (axis + 2) % 3;
  Column<S> y = x;
  y(next) = c * x(next) - s * x(last);
  y(last) = s * x(next) + c * x(last);
  return y;
}

/// u_n is the axis of the n-th turn, moved by the turns before it (intrinsic) or after it (extrinsic):
///     w_ab     = u1 t1' + u2 t2' + u3 t3'
///     alpha_ab = u1 t1'' + u2 t2'' + u3 t3'' +- (t1' t2' u1 x u2 + t1' t3' u1 x u3 + t2' t3' u2 x u3)
/// with + for an intrinsic sequence and - for an extrinsic one. u2 is normal to u1 and u3. The triple product
/// of the three is plus or minus the cosine of the second angle, or its sine in a proper sequence.
template <class Sequence, class A, class B, class S, bool expressed_in_turned>
struct KinematicsOf<EulerAngles<Sequence, A, B, S>, expressed_in_turned> {
  using Angles = EulerAngles<Sequence, A, B, S>;

  static Column<S> rate(const Angles& x, const Column<S>& w) { return solved(x, axes(x), w, "rate"); }
  static Column<S> velocity(const Angles& x, const Column<S>& xdot) { return axes(x) * xdot; }
  static Column<S> second_rate(const Angles& x, const Column<S>& xdot, const Column<S>&,
                               const Column<S>& alpha) {
    const Square<S> u = axes(x);
    return solved(x, u, alpha - turning_of(u, xdot), "second_rate");
  }
  static Column<S> acceleration(const Angles& x, const Column<S>& xdot, const Column<S>& xddot) {
    const Square<S> u = axes(x);
    return u * xddot + turning_of(u, xdot);
  }

 private:
  // The three axes as columns, in the frame of the rate.
  static Square<S> axes(const Angles& x) {
    constexpr int i = Sequence::first, j = Sequence::second, k = Sequence::third;
    constexpr int sign = Sequence::intrinsic ? 1 : -1;
    const auto& t = x.coordinates();
    const auto [s2, c2] = sine_cosine(t(1));
    Square<S> u;
    if constexpr (Sequence::intrinsic != expressed_in_turned) {
      const auto [sine, c1] = sine_cosine(t(0));
      const S s1 = S(sign) * sine;
      u.col(0) = unit(i);
      u.col(1) = turned_about<i>(unit(j), c1, s1);
      u.col(2) = turned_about<i>(turned_about<j>(unit(k), c2, S(S(sign) * s2)), c1, s1);
    } else {
      const auto [sine, c3] = sine_cosine(t(2));
      const S s3 = S(-sign) * sine;
      u.col(2) = unit(k);
      u.col(1) = turned_about<k>(unit(j), c3, s3);
      u.col(0) = turned_about<k>(turned_about<j>(unit(i), c2, S(S(-sign) * s2)), c3, s3);
    }
    return u;
  }
  static Column<S> unit(int axis) { return Column<S>::Unit(axis); }

  // Solves u xdot = w for xdot.
  static Column<S> solved(const Angles& x, const Square<S>& u, const Column<S>& w, const char* action) {
    const Column<S> n1 = u.col(1).cross(u.col(2));
    const Column<S> n3 = u.col(0).cross(u.col(1));
    const S triple = u.col(0).dot(n1);
    if (!is_regular(triple)) {
      const auto [sine, cosine] = sine_cosine(without_derivatives(x.coordinates()(1)));
      refuse_singular<Angles>(Sequence::proper ? sine : cosine, action);
    }
    return {n1.dot(w) / triple, u.col(1).dot(w), n3.dot(w) / triple};
  }

  static Column<S> turning_of(const Square<S>& u, const Column<S>& xdot) {
    const Column<S> u1 = u.col(0) * xdot(0);
    const Column<S> u2 = u.col(1) * xdot(1);
    const Column<S> u3 = u.col(2) * xdot(2);
    const Column<S> sum = u1.cross(u2) + Column<S>(u1 + u2).cross(u3);
    return Sequence::intrinsic ? sum : Column<S>(-sum);
  }
};

}  // namespace detail

/// Claims that the three rates, in the order of the angles, are the derivatives of x_ab. Throws BadInput when
/// one is not finite.
template <class Sequence, class A, class B, class S>
ParameterRate<EulerAngles<Sequence, A, B, S>> parameter_rate(
    const EulerAngles<Sequence, A, B, S>& x_ab,
    const std::type_identity_t<Quantity<si::angular_velocity, S>>& first,
    const std::type_identity_t<Quantity<si::angular_velocity, S>>& second,
    const std::type_identity_t<Quantity<si::angular_velocity, S>>& third) {
  return parameter_rate(x_ab, detail::Column<S>(first.value(), second.value(), third.value()));
}

}  // namespace vectrix
