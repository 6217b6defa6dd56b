#pragma once

#include <vectrix/frames/covariance.hpp>
#include <vectrix/kinematics/named/algebra.hpp>

namespace vectrix {

/// P^a, the covariance of a vector in the unit U, in the axes of a frame known at run time: Covariance with
/// the same doors, laws and errors.
template <VectorUnit U> using NamedCovariance = Named<Covariance<Some<'a'>, U>>;

template <VectorUnit U, detail::Matrix3x3d Matrix>
NamedCovariance<U> covariance(In<NamedFrame> a, const Matrix& P_a) {
  using namespace detail::letters;
  return typed_law<Law<In<A>>>(
      "covariance", [&](const auto& in_a) { return covariance<U>(in_a, P_a); }, a);
}
template <VectorUnit U, detail::Matrix3x3d Matrix>
NamedCovariance<U> trust_covariance(In<NamedFrame> a, const Matrix& P_a) {
  using namespace detail::letters;
  return typed_law<Law<In<A>>>(
      "trust_covariance", [&](const auto& in_a) { return trust_covariance<U>(in_a, P_a); }, a);
}
template <class U>
NamedCovariance<U> covariance_from_standard_deviations(In<NamedFrame> a, const Quantity<U>& x,
                                                       const Quantity<U>& y, const Quantity<U>& z) {
  using namespace detail::letters;
  return typed_law<Law<In<A>>>(
      "covariance_from_standard_deviations",
      [&](const auto& in_a) { return covariance_from_standard_deviations(in_a, x, y, z); }, a);
}

// P^b = R_a^b P^a (R_a^b)^T, and cov(r + s) of independent r and s
template <class F, class U>
NamedCovariance<U> product(const NamedDcm& R_b_from_a, const Named<Covariance<F, U>>& P_a) {
  using namespace detail::letters;
  return typed_law<Law<Dcm<B, A>, Covariance<A, U>>>(
      "product", [](const auto& R, const auto& P) { return R * P; }, R_b_from_a, P_a);
}
template <class F, class U>
NamedCovariance<U> sum(const Named<Covariance<F, U>>& P_a, const Named<Covariance<F, U>>& Q_a) {
  using namespace detail::letters;
  return typed_law<Law<Covariance<A, U>, Covariance<A, U>>>(
      "sum", [](const auto& P, const auto& Q) { return P + Q; }, P_a, Q_a);
}
/// n^T P n, and the length of r in standard deviations.
template <class F, class U>
Quantity<unit_product<U, U>> variance_along(const Named<Covariance<F, U>>& P_a,
                                            const NamedVector<si::dimensionless>& n_a) {
  using namespace detail::letters;
  return typed_law<Law<Covariance<A, U>, Vector<A, si::dimensionless>>>(
      "variance_along", [](const auto&... x) { return variance_along(x...); }, P_a, n_a);
}
template <class F, class U>
Quantity<si::dimensionless> mahalanobis_distance(const Named<Covariance<F, U>>& P_a,
                                                 const NamedVector<U>& r_a) {
  using namespace detail::letters;
  return typed_law<Law<Covariance<A, U>, Vector<A, U>>>(
      "mahalanobis_distance", [](const auto&... x) { return mahalanobis_distance(x...); }, P_a, r_a);
}

}  // namespace vectrix
