#pragma once

#include <algorithm>
#include <vector>
#include <vectrix/frames/covariance.hpp>
#include <vectrix/kinematics/attitude/log.hpp>
#include <vectrix/kinematics/estimation/attitude_profile.hpp>
#include <vectrix/kinematics/estimation/observation.hpp>

namespace vectrix {

/// Smallest agreement of rotations that mean_rotation() accepts. Below it rounding decides the mean.
inline constexpr double nearly_without_mean = 1e-10;

template <Frame B, Frame A, class S = double> struct WeightedRotation {
  Dcm<B, A, S> rotation;
  S weight;
};

/// A rotation with a weight for mean_rotation(); the weight is relative to the others. Throws BadInput unless
/// the weight is positive and finite.
template <class B, class A, class S>
WeightedRotation<B, A, S> weighted(const Dcm<B, A, S>& R_b_from_a, const std::type_identity_t<S>& weight) {
  return {R_b_from_a, detail::checked_weight<S>(weight, [] { return detail::dcm_door<B, A>("weighted"); })};
}
template <class B, class A, class S>
WeightedRotation<B, A, S> weighted(const Quaternion<B, A, S>& q_b_from_a,
                                   const std::type_identity_t<S>& weight) {
  return weighted(dcm(q_b_from_a), weight);
}

template <Frame B, Frame A, class S = double> struct MeanRotation {
  Dcm<B, A, S> rotation;
  /// sum_i w_i e_i e_i^T / sum_i w_i, where e_i is the turn between the mean and rotation i, expressed in b.
  Covariance<B, si::angle, S> scatter;
  /// 1 if all rotations are the same; 0 if no single rotation is nearest to all, as for two rotations half a
  /// turn apart.
  S agreement;
};

namespace detail {

template <class B, class A, class S>
MeanRotation<B, A, S> mean_of(const std::vector<WeightedRotation<B, A, S>>& rotations) {
  const std::string door = dcm_door<B, A>("mean_rotation");
  if (rotations.empty()) throw BadInput(door + "the number of rotations is 0");
  S largest = rotations.front().weight;
  for (const auto& one : rotations) largest = std::max(largest, one.weight);
  Square<S> profile = Square<S>::Zero();
  S total = S(0);
  for (const auto& one : rotations) {
    const S weight = checked_weight<S>(one.weight, [&] { return door; }) / largest;
    profile += weight * one.rotation.matrix();
    total += weight;
  }
  const auto found = profile_rotation<S>(profile / total);
  const S agreement = found.margin / S(2);
  if (!(agreement > S(door_tolerance<S>(nearly_without_mean)))) {
    throw BadInput(door + "the rotations have no mean: their agreement is " + text(agreement) +
                   ", at least " + text(door_tolerance<S>(nearly_without_mean)) + " is needed");
  }
  Square<S> scatter = Square<S>::Zero();
  for (const auto& one : rotations) {
    const Dcm<B, A, S> turn{trusted, one.rotation.matrix() * found.rotation.transpose()};
    const Column<S> e = log(turn).coordinates();
    scatter += one.weight / largest / total * e * e.transpose();
  }
  return {Dcm<B, A, S>{trusted, found.rotation}, Covariance<B, si::angle, S>{trusted, scatter}, agreement};
}
template <class B, class A, class S, class Rotations>
MeanRotation<B, A, S> equally_weighted_mean(const Rotations& rotations) {
  std::vector<WeightedRotation<B, A, S>> counted;
  for (const auto& one : rotations) counted.push_back(weighted(one, S(1)));
  return mean_of(counted);
}
template <class B, class A, class S>
MeanRotation<B, A, S> mean_of(const std::vector<Dcm<B, A, S>>& rotations) {
  return equally_weighted_mean<B, A, S>(rotations);
}
template <class B, class A, class S>
MeanRotation<B, A, S> mean_of(const std::vector<Quaternion<B, A, S>>& rotations) {
  return equally_weighted_mean<B, A, S>(rotations);
}
template <class B, class A, class Given>
using MeanOf = decltype(mean_of<B, A>(std::declval<const std::vector<Given>&>()));
template <class B, class A, class Given>
concept HasMean = requires {
  typename MeanOf<B, A, Given>;
};

}  // namespace detail

/// The rotation with the least sum_i w_i |R_a^b - R_i|^2 (Frobenius), which is the dominant eigenvector of
/// sum_i w_i q_i q_i^T: Markley, Cheng, Crassidis and Oshman, Averaging Quaternions (2007). Takes a
/// std::vector of weighted(R, w), or of Dcm or Quaternion with equal weights. The signs of quaternions and
/// the order do not matter. A constant rotation of frame a or b rotates the mean by the same.
/// Throws BadInput for no rotation, and when the agreement is below nearly_without_mean.
template <Frame B, Frame A, class Given>
detail::MeanOf<B, A, Given> mean_rotation(To<B>, From<A>, const std::vector<Given>& rotations) {
  return detail::mean_of<B, A>(rotations);
}
template <class ToFrame, class FromFrame, class Given>
  requires(!detail::HasMean<ToFrame, FromFrame, Given>)
auto mean_rotation(  // to<B>, from<A>: two frames; rotations to b from a
    To<ToFrame>, From<FromFrame>, const std::vector<Given>&) -> Refused = delete;

}  // namespace vectrix
