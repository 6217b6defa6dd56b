#pragma once

#include <algorithm>
#include <vector>
#include <vectrix/frames/covariance.hpp>
#include <vectrix/kinematics/estimation/attitude_profile.hpp>
#include <vectrix/kinematics/estimation/observation.hpp>
#include <vectrix/kinematics/rates/hat.hpp>

namespace vectrix {

/// Smallest observability that wahba() accepts. Below it rounding decides the turn about the least observed
/// axis.
inline constexpr double nearly_unobservable = 1e-10;

/// The rotation that fits the observations best.
template <Frame B, Frame A, class S = double> struct AttitudeFit {
  Dcm<B, A, S> rotation;
  /// sum_i w_i |b_i - R_a^b a_i|^2 / 2. With w_i = 1/sigma_i^2 twice the loss of n observations has the
  /// chi-square distribution of 2 n - 3 degrees of freedom.
  S loss;
  /// The share of the weights that a turn about the least observed axis changes: at most 2/3, for directions
  /// evenly distributed in space; 0 if that turn does not change the loss.
  S observability;
  Vector<B, si::dimensionless, S> least_observed;
};

/// The same with the covariance of the small turn from the true to the estimated attitude.
template <Frame B, Frame A, class S = double> struct AttitudeEstimate : AttitudeFit<B, A, S> {
  Covariance<B, si::angle, S> covariance;
};

namespace detail {

/// Weights are divided by the largest, so that no sum overflows.
template <class Observations> auto largest_weight(const Observations& observations) {
  auto largest = observations.front().weight();
  for (const auto& one : observations) largest = std::max(largest, one.weight());
  return largest;
}

template <class B, class A, class S, class Observations>
AttitudeFit<B, A, S> fit_attitude(const Observations& observations) {
  const std::string door = dcm_door<B, A>("wahba");
  if (observations.size() < 2) {
    throw BadInput(door + "the number of observations is " + text(observations.size()) +
                   "; two directions fix a rotation");
  }
  const S largest = largest_weight(observations);
  Square<S> profile = Square<S>::Zero();
  S total = S(0);
  for (const auto& one : observations) {
    const S weight = one.weight() / largest;
    profile += weight * one.measured().coordinates() * one.reference().coordinates().transpose();
    total += weight;
  }
  const ProfileRotation<S> found = profile_rotation<S>(profile / total);
  if (!(found.margin > S(door_tolerance<S>(nearly_unobservable)))) {
    const Column<S>& n = found.least_axis;
    throw BadInput(
        door + "only the share " + text(found.margin) + " of the weights feels a turn about (" + text(n.x()) +
        ", " + text(n.y()) + ", " + text(n.z()) + ") in " + frame_name<B>() + ", at least " +
        text(door_tolerance<S>(nearly_unobservable)) +
        " is needed: the directions are parallel, contradict each other, or one outweighs the rest");
  }
  S loss = S(0);
  for (const auto& one : observations) {
    loss += one.weight() / S(2) *
            (one.measured().coordinates() - found.rotation * one.reference().coordinates()).squaredNorm();
  }
  return {Dcm<B, A, S>{trusted, found.rotation}, loss, found.margin,
          Vector<B, si::dimensionless, S>{trusted, found.least_axis}};
}

// P = sum_i T_i T_i^T with T_i = w_i sigma_i M^-1 [b_i]x, where I - b b^T is [b]x [b]x^T.
template <class B, class A, class S>
AttitudeEstimate<B, A, S> solve_wahba(const std::vector<Observation<B, A, S>>& observations) {
  const AttitudeFit<B, A, S> fit = fit_attitude<B, A, S>(observations);
  const S largest = largest_weight(observations);
  std::vector<Square<S>> across;
  Square<S> M = Square<S>::Zero();
  for (const auto& one : observations) {
    across.push_back(hat((fit.rotation * one.reference()).coordinates()));
    M += one.weight() / largest * across.back() * across.back().transpose();
  }
  const Square<S> inverse = M.inverse();
  Square<S> P = Square<S>::Zero();
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const S share = observations[i].weight() / largest;
    const Square<S> turn = share * observations[i].deviation().value() * inverse * across[i];
    P += turn * turn.transpose();
  }
  return {fit, Covariance<B, si::angle, S>{trusted, P}};
}
template <class B, class A, class S>
AttitudeFit<B, A, S> solve_wahba(const std::vector<WeightedObservation<B, A, S>>& observations) {
  return fit_attitude<B, A, S>(observations);
}
template <class B, class A, class Given>
using WahbaOf = decltype(solve_wahba<B, A>(std::declval<const std::vector<Given>&>()));
template <class B, class A, class Given>
concept WahbaSolves = requires {
  typename WahbaOf<B, A, Given>;
};

}  // namespace detail

/// Wahba's problem: the R_a^b with the least sum_i w_i |b_i - R_a^b a_i|^2 / 2, by Markley's singular value
/// method. It needs no first guess and has no singular attitude. For Observations it returns an
/// AttitudeEstimate, with
///     P = M^-1 (sum_i w_i^2 sigma_i^2 (I - c_i c_i^T)) M^-1,    M = sum_i w_i (I - c_i c_i^T)
/// with the fitted directions c_i = R_a^b a_i, to first order in the errors; for w_i = 1/sigma_i^2 it is the
/// inverse of the Fisher information, M^-1 (Shuster 1989). For WeightedObservations it returns an
/// AttitudeFit, without covariance. Throws BadInput for fewer than two observations and when the
/// observability is below nearly_unobservable.
template <Frame B, Frame A, class Given>
detail::WahbaOf<B, A, Given> wahba(To<B>, From<A>, const std::vector<Given>& observations) {
  return detail::solve_wahba<B, A>(observations);
}
template <class ToFrame, class FromFrame, class Given>
  requires(!detail::WahbaSolves<ToFrame, FromFrame, Given>)
auto wahba(  // to<B>, from<A>: two frames; observations (r_b, r_a) of them
    To<ToFrame>, From<FromFrame>, const std::vector<Given>&) -> Refused = delete;

}  // namespace vectrix
