#pragma once

#include <vectrix/kinematics/screws/screw_jacobian.hpp>

namespace vectrix {

/// xi_dot = (theta_dot, rho_dot), the time derivative of xi_ab, rad/s and m/s. It is a twist only if the axis
/// is at rest.
///     V_ab(b)^b = J_r(xi_ab) xi_dot,  V_ab(a)^a = J_l(xi_ab) xi_dot
template <Frame A, Frame B, class S = double> class ScrewRate {
 public:
  template <class Rotation, class Translation>
  ScrewRate(detail::Trusted, const Eigen::MatrixBase<Rotation>& theta_dot,
            const Eigen::MatrixBase<Translation>& rho_dot)
      : thetadot_(theta_dot), rhodot_(rho_dot) {}

  /// theta_dot and rho_dot; their coordinates are the same in a and in b.
  const detail::Column<S>& rotation() const& { return thetadot_; }
  detail::Column<S> rotation() && { return thetadot_; }
  const detail::Column<S>& translation() const& { return rhodot_; }
  detail::Column<S> translation() && { return rhodot_; }
  /// The six bare numbers, the rotation first.
  Eigen::Matrix<S, 6, 1> coordinates() const {
    Eigen::Matrix<S, 6, 1> numbers;
    numbers << thetadot_, rhodot_;
    return numbers;
  }
  /// The derivative of xi_ba = -xi_ab.
  ScrewRate<B, A, S> operator-() const { return {detail::trusted, -thetadot_, -rhodot_}; }

 private:
  detail::Column<S> thetadot_;
  detail::Column<S> rhodot_;
};

template <class A, class B, class S> inline constexpr bool detail::is_framed<ScrewRate<A, B, S>> = true;

/// Claims that the two vectors are the derivative of xi_ab, both expressed in a or both in b.
template <Frame B, Frame A, class C, class S>
  requires(detail::is_one_of<C, A, B>)
detail::OfTwo<B, A, ScrewRate<A, B, S>> screw_rate(Of<B>, RelativeTo<A>,
                                                   const Vector<C, si::angular_velocity, S>& theta_dot,
                                                   const Vector<C, si::velocity, S>& rho_dot) {
  return {detail::trusted, theta_dot.coordinates(), rho_dot.coordinates()};
}
template <class OfFrame, class RelativeToFrame, class Rotation, class Translation>
auto screw_rate(  // of<B>, relative_to<A>: two frames; rad/s and m/s expressed in one of them
    const OfFrame&, const RelativeToFrame&, const Rotation&, const Translation&) -> Refused = delete;

/// V_ab(b)^b = J_r(xi_ab) xi_dot for in<B>, V_ab(a)^a = J_l(xi_ab) xi_dot for in<A>. Throws as
/// left_jacobian().
template <class A, class B, class C, class S>
  requires(detail::is_one_of<C, A, B>)
Twist<A, B, At<C>, In<C>, S> twist_from(const Screw<A, B, S>& xi_ab, const ScrewRate<A, B, S>& xidot_ab,
                                        In<C>) {
  const auto turn = detail::turn<Screw<A, B, S>>(detail::rotation_in<C>(xi_ab), "twist_from");
  const detail::Column<S>& theta_dot = xidot_ab.rotation();
  return {detail::trusted, detail::left_jacobian_times(turn, theta_dot),
          detail::left_jacobian_change_times(turn, detail::translation_in<C>(xi_ab), theta_dot) +
              detail::left_jacobian_times(turn, xidot_ab.translation())};
}
template <class A, class B, class S, class Rate, class Expressed>
auto twist_from(  // twist_from(xi_ab, xidot_ab, in<B>) or in<A>
    const Screw<A, B, S>&, const Rate&, const Expressed&) -> Refused = delete;

// xi_dot = J_r^-1 V_ab(b)^b = J_l^-1 V_ab(a)^a, by rate(xi_ab, V_ab). Throws BadInput at a full turn.
template <class A, class B, class C, class S>
  requires(detail::is_one_of<C, A, B>)
ScrewRate<A, B, S> attitude_rate(const Screw<A, B, S>& xi_ab, const Twist<A, B, At<C>, In<C>, S>& V_ab) {
  const auto turn = detail::invertible_turn<Screw<A, B, S>>(detail::rotation_in<C>(xi_ab), "rate");
  const detail::Column<S> theta_dot =
      detail::inverse_left_jacobian_times(turn, V_ab.angular_velocity().coordinates());
  const detail::Column<S> rest =
      V_ab.velocity().coordinates() -
      detail::left_jacobian_change_times(turn, detail::translation_in<C>(xi_ab), theta_dot);
  return {detail::trusted, theta_dot, detail::inverse_left_jacobian_times(turn, rest)};
}

template <class A, class B, class S>
std::ostream& print_framed(std::ostream& out, const ScrewRate<A, B, S>& xidot_ab) {
  const auto xidot = xidot_ab.coordinates();
  detail::print_column(out << "d/dt ", xidot.template head<3>(), "rad/s") << "; ";
  return detail::print_column(out, xidot.template tail<3>(), "m/s") << detail::print_of_relative_to<B, A>;
}

}  // namespace vectrix
