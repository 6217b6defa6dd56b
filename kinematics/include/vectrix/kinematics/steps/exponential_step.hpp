#pragma once

#include <vectrix/frames/dcm_doors.hpp>
#include <vectrix/kinematics/rates/hat.hpp>
#include <vectrix/kinematics/steps/increment.hpp>

namespace vectrix {

/// The result of the first-order rule: a matrix near R_b^a, not a rotation and not convertible to one.
/// nearest_dcm() projects it and returns the distance.
template <Frame A, Frame B, class S = double> class FirstOrderAttitude {
 public:
  template <class Derived>
  FirstOrderAttitude(detail::Trusted, const Eigen::MatrixBase<Derived>& matrix) : matrix_(matrix) {}

  const detail::Square<S>& matrix() const& { return matrix_; }
  detail::Square<S> matrix() && { return matrix_; }
  /// The growth factor of volumes: the product of 1 + |theta|^2 over the steps.
  S determinant() const { return matrix_.determinant(); }
  /// |M^T M - I|, Frobenius, the departure from a rotation; sqrt(2) |theta|^2 after one step.
  S departure() const { return (matrix_.transpose() * matrix_ - detail::Square<S>::Identity()).norm(); }

 private:
  detail::Square<S> matrix_;
};

template <class A, class B, class S>
inline constexpr bool detail::is_framed<FirstOrderAttitude<A, B, S>> = true;

template <class A, class B, class S>
NearestDcm<A, B, S> nearest_dcm(const FirstOrderAttitude<A, B, S>& M_a_from_b) {
  return nearest_dcm(to<A>, from<B>, M_a_from_b.matrix());
}

// theta = w_ab^b dt, for a constant rate in b
template <class A, class B, class S>
Increment<A, B, S> turned_by(const AngularVelocity<A, B, In<B>, S>& w_ab_b, const Quantity<si::time, S>& dt) {
  detail::require_duration<A, B>(dt.value(), "exponential_step");
  return {detail::trusted, w_ab_b.coordinates() * dt.value()};
}

template <class Rotation, class A, class B, class S>
detail::AdvancedOf<Rotation, Increment<A, B, S>> exponential_stepped(
    const Rotation& rotation, const AngularVelocity<A, B, In<B>, S>& w_ab_b,
    const Quantity<si::time, S>& dt) {
  return advanced(rotation, turned_by(w_ab_b, dt));
}
template <class A, class B, class S>
FirstOrderAttitude<A, B, S> first_order_stepped(const Dcm<A, B, S>& R_a_from_b,
                                                const AngularVelocity<A, B, In<B>, S>& w_ab_b,
                                                const Quantity<si::time, S>& dt) {
  detail::require_duration<A, B>(dt.value(), "first_order_step");
  const detail::Square<S> generator = hat(w_ab_b.coordinates()) * dt.value();
  return {detail::trusted, R_a_from_b.matrix() + R_a_from_b.matrix() * generator};
}
template <class A, class B, class S>
FirstOrderAttitude<A, B, S> first_order_stepped(const FirstOrderAttitude<A, B, S>& M_a_from_b,
                                                const AngularVelocity<A, B, In<B>, S>& w_ab_b,
                                                const Quantity<si::time, S>& dt) {
  detail::require_duration<A, B>(dt.value(), "first_order_step");
  const detail::Square<S> generator = hat(w_ab_b.coordinates()) * dt.value();
  return {detail::trusted, M_a_from_b.matrix() + M_a_from_b.matrix() * generator};
}

namespace detail {

template <class Rotation, class Rate, class Duration>
using ExponentialStepOf = decltype(exponential_stepped(
    std::declval<const Rotation&>(), std::declval<const Rate&>(), std::declval<const Duration&>()));
template <class Rotation, class Rate, class Duration>
using FirstOrderStepOf = decltype(first_order_stepped(
    std::declval<const Rotation&>(), std::declval<const Rate&>(), std::declval<const Duration&>()));
template <template <class, class, class> class ResultOf, class... Given>
concept LawfulStep = requires {
  typename ResultOf<Given...>;
};

}  // namespace detail

/// R_b^a(t + dt) = R_b^a(t) exp([w_ab^b dt]x), for a DCM or a quaternion. Exact for a rate constant in b.
/// Otherwise of order 1 with the rate at the start of the step, of order 2 with the rate in the middle.
/// Throws BadInput when dt is not finite, and as exp().
template <class Rotation, class Rate, class Duration>
detail::ExponentialStepOf<Rotation, Rate, Duration> exponential_step(const Rotation& rotation,
                                                                     const Rate& omega, const Duration& dt) {
  return exponential_stepped(rotation, omega, dt);
}
template <class Rotation, class Rate, class Duration>
  requires(detail::is_framed<Rotation> &&
           !detail::LawfulStep<detail::ExponentialStepOf, Rotation, Rate, Duration>)
auto exponential_step(  // exponential_step(R_a_from_b, w_ab_b, dt): the rate in b's own axes
    const Rotation&, const Rate&, const Duration&) -> Refused = delete;

/// R_b^a (I + [w_ab^b dt]x). It is not a rotation: its determinant is 1 + |theta|^2. Takes a DCM, or the
/// result of the previous step. Any finite input is valid.
template <class Rotation, class Rate, class Duration>
detail::FirstOrderStepOf<Rotation, Rate, Duration> first_order_step(const Rotation& rotation,
                                                                    const Rate& omega, const Duration& dt) {
  return first_order_stepped(rotation, omega, dt);
}
template <class Rotation, class Rate, class Duration>
  requires(detail::is_framed<Rotation> &&
           !detail::LawfulStep<detail::FirstOrderStepOf, Rotation, Rate, Duration>)
auto first_order_step(  // first_order_step(R_a_from_b, w_ab_b, dt): the rate in b's own axes
    const Rotation&, const Rate&, const Duration&) -> Refused = delete;

template <class A, class B, class S>
std::ostream& print_framed(std::ostream& out, const FirstOrderAttitude<A, B, S>& M_a_from_b) {
  return detail::print_square(out, M_a_from_b.matrix()) << detail::print_to_from<A, B> << ", no rotation";
}

}  // namespace vectrix
