#pragma once

#include <vectrix/kinematics/estimation/estimate_motion.hpp>
#include <vectrix/kinematics/estimation/mean_rotation.hpp>
#include <vectrix/kinematics/estimation/triad.hpp>
#include <vectrix/kinematics/estimation/wahba.hpp>
#include <vectrix/kinematics/named/attitude.hpp>
#include <vectrix/kinematics/named/covariance.hpp>
#include <vectrix/kinematics/named/motions.hpp>
#include <vectrix/kinematics/named/sampled_edge.hpp>

namespace vectrix {

// Attitude and motion from measurements between frames known at run time: the words of
// kinematics/estimation/, with the same laws and errors.

using NamedObservation = Named<Observation<Some<'a'>, Some<'b'>>>;
using NamedWeightedObservation = Named<WeightedObservation<Some<'a'>, Some<'b'>>>;
using NamedWeightedRotation = Named<WeightedRotation<Some<'a'>, Some<'b'>>>;

// The results, with the members of the typed ones.
struct NamedTriadEstimate {
  NamedDcm rotation;
  NamedCovariance<si::angle> covariance;
  Quantity<si::angle> mismatch;
};
struct NamedAttitudeFit {
  NamedDcm rotation;
  double loss, observability;
  NamedVector<si::dimensionless> least_observed;
};
struct NamedAttitudeEstimate : NamedAttitudeFit {
  NamedCovariance<si::angle> covariance;
};
struct NamedMeanRotation {
  NamedDcm rotation;
  NamedCovariance<si::angle> scatter;
  double agreement;
};
struct NamedMotionEstimate {
  NamedAcceleratingDcm motion;
  NamedCovariance<si::angle> attitude_covariance;
  NamedCovariance<si::angular_velocity> rate_covariance;
  NamedCovariance<si::angular_acceleration> acceleration_covariance;
  double loss;
  std::size_t freedom;
};

namespace detail {

template <class B, class A> struct Relabel<Observation<B, A>> {
  template <class X> static Observation<B, A> of(const X& x) {
    return {trusted, relabelled<Vector<B, si::dimensionless>>(x.measured()),
            relabelled<Vector<A, si::dimensionless>>(x.reference()), x.weight(), x.deviation().value()};
  }
};
template <class B, class A> struct Relabel<WeightedObservation<B, A>> {
  template <class X> static WeightedObservation<B, A> of(const X& x) {
    return {trusted, relabelled<Vector<B, si::dimensionless>>(x.measured()),
            relabelled<Vector<A, si::dimensionless>>(x.reference()), x.weight()};
  }
};
template <class B, class A> struct Relabel<WeightedRotation<B, A>> {
  template <class X> static WeightedRotation<B, A> of(const X& x) {
    return {relabelled<Dcm<B, A>>(x.rotation), x.weight};
  }
};
template <class A, class B> struct Relabel<AttitudeSample<A, B>> {
  static AttitudeSample<A, B> of(const NamedSample& sample) {
    return {sample.time, relabelled<Quaternion<A, B>>(sample.q_a_from_b)};
  }
};
template <> struct NamedFor<AttitudeSample<Some<'a'>, Some<'b'>>> : std::type_identity<NamedSample> {};
template <> struct Naming<NamedSample> {
  using form = AttitudeSample<Some<'a'>, Some<'b'>>;
  static std::array<NamedFrame, 2> frames(const NamedSample& sample) {
    return Naming<NamedQuaternion>::frames(sample.q_a_from_b);
  }
  template <class Typed> static NamedSample make(const std::array<NamedFrame, 2>& f, const Typed& sample) {
    return {sample.time, Naming<NamedQuaternion>::make(f, sample.q_a_from_b)};
  }
};

/// wahba() or mean_rotation(): a word of to, from and a list of X_b_from_a, which gives a tuple.
template <class X, class Word, class Given>
auto of_list(std::string_view name, const Word& word, To<NamedFrame> b, From<NamedFrame> a,
             const std::vector<Given>& list) {
  using namespace letters;
  return typed_law<Law<To<B>, From<A>, std::vector<X>>>(name, word, b, a, list);
}
}  // namespace detail

/// Claims that r_b and r_a are the same vector in b and in a. Throws BadInput as the typed doors, and when
/// both are in one frame.
template <class U>
NamedObservation observation(const NamedVector<U>& r_b, const NamedVector<U>& r_a,
                             const Quantity<si::angle>& sigma) {
  using namespace detail::letters;
  detail::require_two("observation", r_b.in(), r_a.in());
  return typed_law<Law<Vector<B, U>, Vector<A, U>>>(
      "observation", [&](const auto&... x) { return observation(x..., sigma); }, r_b, r_a);
}
template <class U>
NamedObservation observation(const NamedVector<U>& r_b, const NamedVector<U>& r_a,
                             const Quantity<si::angle>& sigma, double weight) {
  using namespace detail::letters;
  detail::require_two("observation", r_b.in(), r_a.in());
  return typed_law<Law<Vector<B, U>, Vector<A, U>>>(
      "observation", [&](const auto&... x) { return observation(x..., sigma, weight); }, r_b, r_a);
}
template <class U>
NamedWeightedObservation weighted_observation(const NamedVector<U>& r_b, const NamedVector<U>& r_a,
                                              double weight) {
  using namespace detail::letters;
  detail::require_two("weighted_observation", r_b.in(), r_a.in());
  return typed_law<Law<Vector<B, U>, Vector<A, U>>>(
      "weighted_observation", [&](const auto&... x) { return weighted_observation(x..., weight); }, r_b, r_a);
}

/// R_a^b from two vectors given in both frames, or from two observations, the more accurate one first.
template <class U, class V>
NamedDcm triad(To<NamedFrame> b, From<NamedFrame> a, const NamedVector<U>& r_b, const NamedVector<U>& r_a,
               const NamedVector<V>& s_b, const NamedVector<V>& s_a) {
  using namespace detail::letters;
  return typed_law<Law<To<B>, From<A>, Vector<B, U>, Vector<A, U>, Vector<B, V>, Vector<A, V>>>(
      "triad", [](const auto&... x) { return triad(x...); }, b, a, r_b, r_a, s_b, s_a);
}
inline NamedTriadEstimate triad(To<NamedFrame> b, From<NamedFrame> a, const NamedObservation& first,
                                const NamedObservation& second) {
  using namespace detail::letters;
  const auto [rotation, covariance, mismatch] =
      typed_law<Law<To<B>, From<A>, Observation<B, A>, Observation<B, A>>>(
          "triad",
          [](const auto&... x) {
            const auto found = triad(x...);
            return std::tuple(found.rotation, found.covariance, found.mismatch);
          },
          b, a, first, second);
  return {rotation, covariance, mismatch};
}

/// Wahba's problem of several observations.
inline NamedAttitudeEstimate wahba(To<NamedFrame> b, From<NamedFrame> a,
                                   const std::vector<NamedObservation>& observations) {
  using namespace detail::letters;
  const auto [rotation, loss, observability, axis, covariance] = detail::of_list<Observation<B, A>>(
      "wahba",
      [](const auto&... x) {
        const auto fit = wahba(x...);
        return std::tuple(fit.rotation, fit.loss, fit.observability, fit.least_observed, fit.covariance);
      },
      b, a, observations);
  return {{rotation, loss, observability, axis}, covariance};
}
inline NamedAttitudeFit wahba(To<NamedFrame> b, From<NamedFrame> a,
                              const std::vector<NamedWeightedObservation>& observations) {
  using namespace detail::letters;
  const auto [rotation, loss, observability, axis] = detail::of_list<WeightedObservation<B, A>>(
      "wahba",
      [](const auto&... x) {
        const auto fit = wahba(x...);
        return std::tuple(fit.rotation, fit.loss, fit.observability, fit.least_observed);
      },
      b, a, observations);
  return {rotation, loss, observability, axis};
}

/// A rotation with a weight for mean_rotation(), which takes a list of these, or of NamedDcm or
/// NamedQuaternion with equal weights.
template <detail::NamedRotation R> NamedWeightedRotation weighted(const R& R_b_from_a, double weight) {
  return detail::of_one(
      "weighted", [&](const auto& x) { return weighted(x, weight); }, R_b_from_a);
}
template <class Given>
  requires(detail::NamedRotation<Given> || std::same_as<Given, NamedWeightedRotation>)
NamedMeanRotation mean_rotation(To<NamedFrame> b, From<NamedFrame> a, const std::vector<Given>& rotations) {
  using namespace detail::letters;
  using Typed = std::conditional_t<
      std::same_as<Given, NamedDcm>, Dcm<B, A>,
      std::conditional_t<std::same_as<Given, NamedQuaternion>, Quaternion<B, A>, WeightedRotation<B, A>>>;
  const auto [rotation, scatter, agreement] = detail::of_list<Typed>(
      "mean_rotation",
      [](const auto&... x) {
        const auto mean = mean_rotation(x...);
        return std::tuple(mean.rotation, mean.scatter, mean.agreement);
      },
      b, a, rotations);
  return {rotation, scatter, agreement};
}

/// The motion at t by least squares from noisy samples.
template <int degree = 3>
NamedMotionEstimate estimate_motion(const std::vector<NamedSample>& samples, const Quantity<si::time>& t,
                                    const Quantity<si::time>& half_width, const Quantity<si::angle>& sigma) {
  using namespace detail::letters;
  if (samples.empty()) throw BadInput("estimate_motion: the number of samples is 0");
  const auto [motion, attitude, rate, acceleration, loss, freedom] =
      typed_law<Law<std::vector<AttitudeSample<A, B>>>>(
          "estimate_motion",
          [&](const auto& x) {
            const auto found = estimate_motion<degree>(x, t, half_width, sigma);
            return std::tuple(found.motion, found.attitude_covariance, found.rate_covariance,
                              found.acceleration_covariance, found.loss, found.freedom);
          },
          samples);
  return {motion, attitude, rate, acceleration, loss, freedom};
}

}  // namespace vectrix
