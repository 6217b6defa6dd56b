#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>
#include <vectrix/frames/covariance.hpp>
#include <vectrix/kinematics/estimation/attitude_profile.hpp>
#include <vectrix/kinematics/estimation/observation.hpp>
#include <vectrix/kinematics/estimation/triad.hpp>
#include <vectrix/kinematics/rates/hat.hpp>

namespace vectrix {

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

/// The least determined turn of R, by an angle phi about n, again from the parts of the directions normal to
/// n: of sum_i w_i b_i . R(n, phi) c_i = A cos phi + B sin phi + ... with c_i = R a_i. The singular values
/// lose it in a narrow field: their error is a rounding, and the terms are squares of the field's width.
/// Returns the smallest margin at which rounding does not decide phi: of almost parallel directions, or of
/// terms that cancel, because the directions contradict each other.
template <class S, class Observations>
S turn_about_least_axis(ProfileRotation<S>& found, const Observations& observations, const S& largest,
                        const S& total) {
  const Column<S> n = found.axes.col(0);
  S in_phase = S(0), across = S(0), felt = S(0);
  for (const auto& one : observations) {
    const Column<S> b = one.measured().coordinates(), c = found.rotation * one.reference().coordinates();
    const Column<S> b_normal = b - n * n.dot(b), c_normal = c - n * n.dot(c);
    const S weight = one.weight() / largest;
    in_phase += weight * b_normal.dot(c_normal);
    across += weight * n.dot(c_normal.cross(b_normal));
    felt += weight * b_normal.norm() * c_normal.norm();
  }
  found.margin = std::hypot(in_phase, across) / total;
  found.rotation = Eigen::AngleAxis<S>(std::atan2(across, in_phase), n).toRotationMatrix() * found.rotation;
  const S sine = static_cast<S>(door_tolerance<S>(nearly_parallel));
  return std::max(sine * sine / S(4), sine * felt / total);
}

template <class B, class A, class S, class Observations>
ProfileRotation<S> best_rotation(const Observations& observations) {
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
  ProfileRotation<S> found = profile_rotation<S>(profile / total);
  const S least = turn_about_least_axis(found, observations, largest, total);
  if (!(found.margin > least)) {
    const Column<S> n = found.axes.col(0);
    throw BadInput(
        door + "only the share " + text(found.margin) + " of the weights feels a turn about (" + text(n.x()) +
        ", " + text(n.y()) + ", " + text(n.z()) + ") in " + frame_name<B>() + ", at least " + text(least) +
        " is needed: the directions are parallel, contradict each other, or one outweighs the rest");
  }
  return found;
}

template <class B, class A, class S, class Observations>
AttitudeFit<B, A, S> fit_of(const ProfileRotation<S>& found, const Observations& observations) {
  S loss = S(0);
  for (const auto& one : observations) {
    loss += one.weight() / S(2) *
            (one.measured().coordinates() - found.rotation * one.reference().coordinates()).squaredNorm();
  }
  return {Dcm<B, A, S>{trusted, found.rotation}, loss, found.margin,
          Vector<B, si::dimensionless, S>{trusted, found.axes.col(0)}};
}

/// The inverse of a positive matrix whose rows have very different sizes, with all digits of each entry.
template <class S> Square<S> graded_inverse(const Square<S>& M) {
  const Column<S> scale = M.diagonal().cwiseSqrt().cwiseInverse();
  const Square<S> even = scale.asDiagonal() * M * scale.asDiagonal();
  return scale.asDiagonal() * even.inverse() * scale.asDiagonal();
}

// P = sum_i T_i T_i^T with T_i = w_i sigma_i M^-1 [c_i]x, where I - c c^T is [c]x [c]x^T. In axes with the
// least observed one first: there the numbers of a narrow field are small, and keep their digits.
template <class B, class A, class S>
AttitudeEstimate<B, A, S> solve_wahba(const std::vector<Observation<B, A, S>>& observations) {
  const ProfileRotation<S> found = best_rotation<B, A, S>(observations);
  const Square<S>& axes = found.axes;
  const S largest = largest_weight(observations);
  std::vector<Square<S>> across;
  Square<S> M = Square<S>::Zero();
  for (const auto& one : observations) {
    across.push_back(hat(Column<S>(axes.transpose() * (found.rotation * one.reference().coordinates()))));
    M += one.weight() / largest * across.back() * across.back().transpose();
  }
  const Square<S> inverse = graded_inverse(M);
  Square<S> P = Square<S>::Zero();
  for (std::size_t i = 0; i < observations.size(); ++i) {
    const S share = observations[i].weight() / largest;
    const Square<S> turn = share * observations[i].deviation().value() * inverse * across[i];
    P += turn * turn.transpose();
  }
  const Square<S> P_b = axes * P * axes.transpose();
  return {fit_of<B, A, S>(found, observations),
          Covariance<B, si::angle, S>{trusted, (P_b + P_b.transpose()) / S(2)}};
}
template <class B, class A, class S>
AttitudeFit<B, A, S> solve_wahba(const std::vector<WeightedObservation<B, A, S>>& observations) {
  return fit_of<B, A, S>(best_rotation<B, A, S>(observations), observations);
}
template <class B, class A, class Given>
using WahbaOf = decltype(solve_wahba<B, A>(std::declval<const std::vector<Given>&>()));
template <class B, class A, class Given>
concept WahbaSolves = requires {
  typename WahbaOf<B, A, Given>;
};

}  // namespace detail

/// Wahba's problem: the R_a^b with the least sum_i w_i |b_i - R_a^b a_i|^2 / 2, by Markley's singular value
/// method, and the least determined turn once more from small differences: as accurate as triad() in a narrow
/// field. It needs no first guess and has no singular attitude. For Observations it returns an
/// AttitudeEstimate, with
///     P = M^-1 (sum_i w_i^2 sigma_i^2 (I - c_i c_i^T)) M^-1,    M = sum_i w_i (I - c_i c_i^T)
/// with the fitted directions c_i = R_a^b a_i, to first order in the errors; for w_i = 1/sigma_i^2 it is the
/// inverse of the Fisher information, M^-1 (Shuster 1989). For WeightedObservations it returns an
/// AttitudeFit, without covariance. Throws BadInput for fewer than two observations, and for directions that
/// leave a turn undetermined: parallel to nearly_parallel, as in triad(), or in contradiction.
template <Frame B, Frame A, class Given>
detail::WahbaOf<B, A, Given> wahba(To<B>, From<A>, const std::vector<Given>& observations) {
  return detail::solve_wahba<B, A>(observations);
}
template <class ToFrame, class FromFrame, class Given>
  requires(!detail::WahbaSolves<ToFrame, FromFrame, Given>)
auto wahba(  // to<B>, from<A>: two frames; observations (r_b, r_a) of them
    To<ToFrame>, From<FromFrame>, const std::vector<Given>&) -> Refused = delete;

}  // namespace vectrix
