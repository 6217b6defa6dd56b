#pragma once

#include <vectrix/frames/dcm.hpp>

namespace vectrix {
namespace detail {

/// A number without derivatives, not a batch: needed by an iteration that stops by its values.
template <class S>
concept SingleNumber = !Differentiated<S> && !Batch<S>;

/// One direction in b and in a, with its weight.
template <class B, class A, class S> class DirectionPair {
 public:
  using measured_in = B;
  using reference_in = A;

  DirectionPair(Trusted, const Vector<B, si::dimensionless, S>& measured,
                const Vector<A, si::dimensionless, S>& reference, const S& weight)
      : measured_(measured), reference_(reference), weight_(weight) {}

  const Vector<B, si::dimensionless, S>& measured() const { return measured_; }
  const Vector<A, si::dimensionless, S>& reference() const { return reference_; }
  const S& weight() const { return weight_; }

 private:
  Vector<B, si::dimensionless, S> measured_;
  Vector<A, si::dimensionless, S> reference_;
  S weight_;
};

template <class S, class Place> S checked_weight(const S& weight, const Place& place) {
  if (!(weight > S(0)) || !(weight - weight == S(0))) {
    throw BadInput(place() + "the weight is " + text(weight) + "; it is positive and finite");
  }
  return weight;
}
/// observation(in<Body>, in<Gcrf>):
template <class B, class A> std::string observation_door(const char* door) {
  return std::string(door) + "(in<" + frame_name<B>() + ">, in<" + frame_name<A>() + ">): ";
}

}  // namespace detail

/// One direction in two frames, as unit vectors: b = R_a^b a, except for an error of known size. The error
/// model is Shuster's QUEST model: two independent small turns, each of standard deviation sigma, about the
/// two axes normal to the direction. sigma covers the errors of the measured and the reference direction.
/// Made by observation(r_b, r_a, sigma); its weight is 1/sigma^2 unless another is given.
template <Frame B, Frame A, class S = double> class Observation : public detail::DirectionPair<B, A, S> {
 public:
  Observation(detail::Trusted, const Vector<B, si::dimensionless, S>& measured,
              const Vector<A, si::dimensionless, S>& reference, const S& weight, const S& deviation)
      : detail::DirectionPair<B, A, S>(detail::trusted, measured, reference, weight), deviation_(deviation) {}

  Quantity<si::angle, S> deviation() const { return Quantity<si::angle, S>::from_value(deviation_); }

 private:
  S deviation_;
};

/// The same with a weight and an error of unknown size. Results from it have no covariance.
template <Frame B, Frame A, class S = double>
class WeightedObservation : public detail::DirectionPair<B, A, S> {
 public:
  using detail::DirectionPair<B, A, S>::DirectionPair;
};

/// Claims that r_b and r_a are the same vector in b and in a; its length does not matter. sigma as in
/// Observation.
/// Throws BadInput for a zero vector, and unless sigma and 1/sigma^2 are positive and finite.
template <Frame B, Frame A, class U, class S>
  requires detail::SingleNumber<S> detail::OfTwo<B, A, Observation<B, A, S>> observation(
      const Vector<B, U, S>& r_b, const Vector<A, U, S>& r_a, const Quantity<si::angle, S>& sigma) {
    const S weight = S(1) / (sigma.value() * sigma.value());
    if (!(sigma.value() > S(0) && weight > S(0) && weight - weight == S(0))) {
      throw BadInput(detail::observation_door<B, A>("observation") + "the standard deviation is " +
                     detail::text(sigma.value()) +
                     " rad; it is positive, with a square that a number can hold");
    }
    return {detail::trusted, detail::direction_for("observation", r_b),
            detail::direction_for("observation", r_a), weight, sigma.value()};
  }
/// With a given weight, for example of a robust fit. sigma remains the size of the error.
template <Frame B, Frame A, class U, class S, std::convertible_to<S> Weight>
  requires detail::SingleNumber<S> detail::OfTwo<B, A, Observation<B, A, S>> observation(
      const Vector<B, U, S>& r_b, const Vector<A, U, S>& r_a, const Quantity<si::angle, S>& sigma,
      const Weight& weight) {
    return {detail::trusted, detail::direction_for("observation", r_b),
            detail::direction_for("observation", r_a),
            detail::checked_weight<S>(static_cast<S>(weight),
                                      [] { return detail::observation_door<B, A>("observation"); }),
            S(observation(r_b, r_a, sigma).deviation().value())};
  }
template <class Measured, class Reference, class Deviation, class... Weight>
auto observation(  // r_b, r_a, sigma: one direction in two frames, in one unit; an angle in rad
    const Measured&, const Reference&, const Deviation&, const Weight&...) -> Refused = delete;

/// An observation of which only the weight is known, in any unit. Throws BadInput unless it is positive and
/// finite.
template <Frame B, Frame A, class U, class S, std::convertible_to<S> Weight>
  requires detail::SingleNumber<S> detail::OfTwo<B, A, WeightedObservation<B, A, S>> weighted_observation(
      const Vector<B, U, S>& r_b, const Vector<A, U, S>& r_a, const Weight& weight) {
    return {detail::trusted, detail::direction_for("weighted_observation", r_b),
            detail::direction_for("weighted_observation", r_a),
            detail::checked_weight<S>(static_cast<S>(weight),
                                      [] { return detail::observation_door<B, A>("weighted_observation"); })};
  }
template <class Measured, class Reference, class Weight>
auto weighted_observation(  // r_b, r_a, weight: one direction in two frames, in one unit
    const Measured&, const Reference&, const Weight&) -> Refused = delete;

}  // namespace vectrix
