#pragma once

#include <type_traits>
#include <vectrix/kinematics/attitude/jacobian.hpp>
#include <vectrix/kinematics/steps/increment.hpp>

namespace vectrix {
namespace detail {

/// The result of a step, if the rate is of b relative to a, expressed in b. Checked by the result type: for a
/// constraint clang prints six lines more.
template <class Rate, class A, class B, class S, bool lawful = true>
using StepBy = std::enable_if_t<
    lawful &&
        std::is_same_v<std::invoke_result_t<const Rate&, const Quantity<si::time, S>&, const Dcm<A, B, S>&>,
                       AngularVelocity<A, B, In<B>, S>>,
    Dcm<A, B, S>>;

/// The angle, rad, at which J_r^-1 amplifies an error by ten. At a full turn it is singular.
inline constexpr double longest_stage = 5.7;

/// h w at the time t + c h and the attitude R exp([theta]x).
template <class A, class B, class S, class Rate> class StageRate {
 public:
  StageRate(const Rate& rate, const Dcm<A, B, S>& start, const Quantity<si::time, S>& t,
            const Quantity<si::time, S>& dt)
      : rate_(rate), start_(start), time_(t.value()), step_(dt.value()) {}

  Column<S> at(const S& c, const Dcm<A, B, S>& R_a_from_b) const {
    return step_ * rate_(Quantity<si::time, S>::from_value(time_ + c * step_), R_a_from_b).coordinates();
  }
  Dcm<A, B, S> turned(const Column<S>& theta) const {
    return advance(start_, Increment<A, B, S>{trusted, theta});
  }
  /// The rate of the rotation vector of the step, h J_r^-1 w (Bortz 1971).
  Column<S> bortz(const S& c, const Column<S>& theta) const {
    const S square = theta.squaredNorm();
    if (!all(square <= number<S>(longest_stage * longest_stage))) {
      using std::sqrt;
      const auto angle = without_derivatives(square);
      throw BadInput("munthe_kaas_step(of " + frame_name<B>() + " relative to " + frame_name<A>() +
                     "): a stage turns by " + text(decltype(angle)(sqrt(angle))) +
                     " rad, too near a full turn or beyond; take shorter steps");
    }
    return inverse_left_jacobian_times<S>(right_turn(theta), at(c, turned(theta)));
  }

 private:
  const Rate& rate_;
  const Dcm<A, B, S>& start_;
  S time_;
  S step_;
};

/// The classical rule of order 4.
template <class S, class Stage> Column<S> rule_4(const Stage& stage) {
  const S half = S(1) / S(2);
  const Column<S> k1 = stage.bortz(S(0), Column<S>::Zero());
  const Column<S> k2 = stage.bortz(half, k1 / S(2));
  const Column<S> k3 = stage.bortz(half, k2 / S(2));
  const Column<S> k4 = stage.bortz(S(1), k3);
  return (k1 + S(2) * k2 + S(2) * k3 + k4) / S(6);
}
/// The rule of order 5 by Dormand and Prince (1980).
template <class S, class Stage> Column<S> rule_5(const Stage& stage) {
  const auto r = [](int numerator, int denominator) -> S { return S(numerator) / S(denominator); };
  const Column<S> k1 = stage.bortz(S(0), Column<S>::Zero());
  const Column<S> k2 = stage.bortz(r(1, 5), r(1, 5) * k1);
  const Column<S> k3 = stage.bortz(r(3, 10), r(3, 40) * k1 + r(9, 40) * k2);
  const Column<S> k4 = stage.bortz(r(4, 5), r(44, 45) * k1 - r(56, 15) * k2 + r(32, 9) * k3);
  const Column<S> k5 = stage.bortz(
      r(8, 9), r(19372, 6561) * k1 - r(25360, 2187) * k2 + r(64448, 6561) * k3 - r(212, 729) * k4);
  const Column<S> k6 = stage.bortz(S(1), r(9017, 3168) * k1 - r(355, 33) * k2 + r(46732, 5247) * k3 +
                                             r(49, 176) * k4 - r(5103, 18656) * k5);
  return r(35, 384) * k1 + r(500, 1113) * k3 + r(125, 192) * k4 - r(2187, 6784) * k5 + r(11, 84) * k6;
}

}  // namespace detail

/// A step of R' = R [w_ab^b(t, R)]x by the method of Munthe-Kaas (1999), of order 4 or 5: a Runge-Kutta rule
/// for the rotation vector of the step, whose rate is Bortz's. The result is a rotation.
/// Throws BadInput when a stage turns by more than 5.7 rad, near a full turn, and as rate(t, R_a_from_b).
template <int Order, class Rate, class A, class B, class S>
detail::StepBy<Rate, A, B, S, Order == 4 || Order == 5> munthe_kaas_step(const Rate& rate,
                                                                         const Dcm<A, B, S>& R_a_from_b,
                                                                         const Quantity<si::time, S>& t,
                                                                         const Quantity<si::time, S>& dt) {
  const detail::StageRate<A, B, S, Rate> stage(rate, R_a_from_b, t, dt);
  if constexpr (Order == 4) {
    return stage.turned(detail::rule_4<S>(stage));
  } else {
    return stage.turned(detail::rule_5<S>(stage));
  }
}
template <int Order, class Rate, class A, class B, class Start, class Duration, class S>
auto munthe_kaas_step(  // munthe_kaas_step<4 or 5>(rate, R_a_from_b, t, dt): rate(t, R_a_from_b) is w_ab_b
    const Rate&, const Dcm<A, B, S>&, const Start&, const Duration&) -> Refused = delete;

/// A step of R' = R [w_ab^b(t, R)]x of order 4 without commutators: four values of the rate and five
/// exponentials (Celledoni, Marthinsen, Owren 2003). The result is a rotation; errors as exp(), and rate's.
template <class Rate, class A, class B, class S>
detail::StepBy<Rate, A, B, S> commutator_free_step(const Rate& rate, const Dcm<A, B, S>& R_a_from_b,
                                                   const Quantity<si::time, S>& t,
                                                   const Quantity<si::time, S>& dt) {
  using Vector = detail::Column<S>;
  const detail::StageRate<A, B, S, Rate> stage(rate, R_a_from_b, t, dt);
  const auto on = [](const Dcm<A, B, S>& R, const Vector& theta) {
    return advance(R, Increment<A, B, S>{detail::trusted, theta});
  };
  const S half = S(1) / S(2);
  const Vector k1 = stage.at(S(0), R_a_from_b);
  const Dcm<A, B, S> middle = stage.turned(k1 / S(2));
  const Vector k2 = stage.at(half, middle);
  const Vector k3 = stage.at(half, stage.turned(k2 / S(2)));
  const Vector k4 = stage.at(S(1), on(middle, k3 - k1 / S(2)));
  return on(stage.turned((S(3) * k1 + S(2) * k2 + S(2) * k3 - k4) / S(12)),
            (S(2) * k2 + S(2) * k3 + S(3) * k4 - k1) / S(12));
}
template <class Rate, class A, class B, class Start, class Duration, class S>
auto commutator_free_step(  // commutator_free_step(rate, R_a_from_b, t, dt): rate(t, R_a_from_b) is w_ab_b
    const Rate&, const Dcm<A, B, S>&, const Start&, const Duration&) -> Refused = delete;

}  // namespace vectrix
