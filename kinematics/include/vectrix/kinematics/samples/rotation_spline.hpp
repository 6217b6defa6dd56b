#pragma once

#include <numbers>
#include <vectrix/frames/scalar/larger.hpp>
#include <vectrix/kinematics/attitude/exp.hpp>
#include <vectrix/kinematics/rates/moving_dcm.hpp>
#include <vectrix/kinematics/samples/attitude_sample.hpp>
#include <vectrix/kinematics/samples/log_motion.hpp>
#include <vectrix/kinematics/samples/sample_steps.hpp>
#include <vectrix/kinematics/samples/slerp.hpp>

namespace vectrix {

/// Smallest distance, rad, of the turn between neighbouring samples from half a turn. Nearer to it two turns
/// are equally short, and RotationSpline throws BadInput.
inline constexpr double nearly_half_a_turn = 1e-9;

/// Ends of a spline at which no rate is known: claims that alpha is zero there, as the curvature is at the
/// free ends of a beam.
struct NaturalEnds {};
inline constexpr NaturalEnds natural_ends{};

/// The twice differentiable motion through samples: from t_i to t_(i+1)
///     q_b^a(t) = q_i exp(theta(t)),   theta a cubic, theta(t_i) = 0, theta(t_(i+1)) = log(q_i^-1 q_(i+1))
/// The rates at the samples are chosen so that alpha_ab is continuous there. The spline takes the shortest
/// turn between samples. A constant rotation of a, of b or of both rotates it by the same; the motion of a
/// relative to b is the spline of the inverse samples. For a step h and given end rates the error is of order
/// h^4 in q, h^3 in w and h^2 in alpha. With natural_ends it is of order h^2, h and 1 near the ends, falling
/// by about four per sample. Throws BadInput as SampledAttitude does, but for gaps at construction; also for
/// neighbours half a turn apart, and when large turns keep the rates from converging.
template <Frame A, Frame B, Instant I = Quantity<si::time>> class RotationSpline {
  using S = InstantScalar<I>;

 public:
  RotationSpline(const std::vector<AttitudeSample<A, B, I>>& samples,
                 const Quantity<si::time, S>& longest_gap, NaturalEnds)
      : RotationSpline(detail::trusted, samples, longest_gap.value(), nullptr, nullptr) {}
  /// With the given rates w_ab^b at the first and at the last sample.
  RotationSpline(const std::vector<AttitudeSample<A, B, I>>& samples,
                 const Quantity<si::time, S>& longest_gap, const AngularVelocity<A, B, In<B>, S>& first,
                 const AngularVelocity<A, B, In<B>, S>& last)
      : RotationSpline(detail::trusted, samples, longest_gap.value(), &first.coordinates(),
                       &last.coordinates()) {}
  template <class Given, class... Ends>
  RotationSpline(  // samples of b relative to a; natural_ends, or w_ab_b at the first and the last
      const std::vector<Given>&, const Quantity<si::time, S>&, const Ends&...) = delete;

  AcceleratingDcm<A, B, S> operator()(const I& t) const {
    const auto [i, since] = steps_.at(t);
    const Segment& here = segments_[i];
    const S h = steps_.duration(i);
    const S s = since / h;
    const detail::LogMotion<S> motion{s * (here.linear + s * (here.square + s * here.cube)),
                                      (here.linear + s * (S(2) * here.square + S(3) * s * here.cube)) / h,
                                      (S(2) * here.square + S(6) * s * here.cube) / (h * h)};
    const Quaternion<A, B, S> turn = exp_quaternion(RotationVector<A, B, S>{detail::trusted, motion.theta});
    return {dcm(Quaternion<A, B, S>{detail::trusted, here.q0 * turn.eigen()}),
            AngularVelocity<A, B, In<B>, S>{detail::trusted, motion.angular_velocity()},
            AngularAcceleration<A, B, In<B>, S>{detail::trusted, motion.angular_acceleration()}};
  }

 private:
  using Column = detail::Column<S>;
  using Square = detail::Square<S>;

  struct Segment {
    Eigen::Quaternion<S> q0;
    Column linear, square, cube;  // theta(s), s from 0 to 1
  };

  RotationSpline(detail::Trusted, const std::vector<AttitudeSample<A, B, I>>& samples, const S& longest_gap,
                 const Column* first, const Column* last)
      : steps_(detail::samples_place<A, B>("RotationSpline"), detail::instants_of(samples), longest_gap) {
    using detail::text;
    std::vector<S> steps;
    std::vector<Column> turns;
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      const std::string which = "samples " + text(i) + " and " + text(i + 1) + " are ";
      steps.push_back(steps_.duration(i));
      if (steps.back() > longest_gap) {
        steps_.refuse(which + text(steps.back()) + " s apart; the longest allowed is " + text(longest_gap) +
                      " s");
      }
      turns.push_back(detail::turn_between(samples[i].q_a_from_b, samples[i + 1].q_a_from_b));
      const S angle = turns.back().norm();
      if (!(angle < S(std::numbers::pi - detail::door_tolerance<S>(nearly_half_a_turn)))) {
        steps_.refuse(which + "half a turn apart, " + text(angle) + " rad: there are two ways between them");
      }
    }
    const std::vector<Column> rates = rates_at_samples(steps, turns, first, last);
    for (std::size_t i = 0; i < turns.size(); ++i) {
      const Column at_start = steps[i] * rates[i];
      const Column at_end = steps[i] * (detail::inverse_log_jacobian(turns[i]) * rates[i + 1]);
      segments_.push_back({samples[i].q_a_from_b.eigen(), at_start,
                           S(3) * turns[i] - S(2) * at_start - at_end, at_start + at_end - S(2) * turns[i]});
    }
  }

  /// The w_i that make alpha continuous at every inner sample, with the step h before it and k after it:
  ///     2/h J_(i-1) w_(i-1) + (4/h + 4/k) w_i + 2/k J_i^-1 w_(i+1)
  ///         = 6/h^2 turn_(i-1) + 6/k^2 turn_i - J' theta'
  /// The last term is smaller than the others by the order of h^2 w^2; it is taken from the previous
  /// iteration.
  std::vector<Column> rates_at_samples(const std::vector<S>& steps, const std::vector<Column>& turns,
                                       const Column* first, const Column* last) const {
    const std::size_t n = turns.size();  // samples 0 ... n
    std::vector<Square> before(n + 1, Square::Zero()), pivot(n + 1, Square::Identity()), after = before;
    std::vector<Column> given(n + 1, Column::Zero()), solved = given, rates = given;
    for (std::size_t i = 0; i <= n; ++i) {
      if (i == 0 && first != nullptr) {
        given[i] = *first;
      } else if (i == n && last != nullptr) {
        given[i] = *last;
      } else {
        pivot[i].setZero();
        if (i > 0) {
          const S h = steps[i - 1];
          before[i] = S(2) / h * detail::log_jacobian(turns[i - 1]);
          pivot[i] += S(4) / h * Square::Identity();
          given[i] += S(6) / (h * h) * turns[i - 1];
        }
        if (i < n) {
          const S k = steps[i];
          after[i] = S(2) / k * detail::inverse_log_jacobian(turns[i]);
          pivot[i] += S(4) / k * Square::Identity();
          given[i] += S(6) / (k * k) * turns[i];
        }
      }
      const S size = pivot[i](0, 0);  // 1, or of 1/s: so that the determinant does not overflow
      if (i > 0) pivot[i] -= before[i] * pivot[i - 1] * after[i - 1];
      pivot[i] = Square(pivot[i] / size).inverse() / size;
    }
    const S enough = S(64) * S(Eigen::NumTraits<S>::epsilon());
    S change = S(0);
    for (int round = 0; round < 200; ++round) {
      for (std::size_t i = 0; i <= n; ++i) {
        Column right = given[i];
        if (i > 0 && !(i == n && last != nullptr)) {
          const Column& turn = turns[i - 1];
          const Column rate = detail::inverse_log_jacobian(turn) * rates[i];
          right -= detail::LogMotion<S>{turn, rate, Column::Zero()}.angular_acceleration();
        }
        if (i > 0) right -= before[i] * solved[i - 1];
        solved[i] = pivot[i] * right;
      }
      change = S(0);
      S largest = S(0);
      for (std::size_t i = n + 1; i-- > 0;) {
        if (i < n) solved[i] -= pivot[i] * after[i] * solved[i + 1];
        change = detail::larger(change, S((solved[i] - rates[i]).norm()));
        largest = detail::larger(largest, S(solved[i].norm()));
      }
      rates = solved;
      if (!(change - change == S(0))) break;  // the rates grew beyond all numbers
      if (change <= enough * largest) return rates;
    }
    steps_.refuse("the rates at the samples do not settle, they still change by " + detail::text(change) +
                  " rad/s: the samples are too far apart");
  }

  detail::SampleSteps<I> steps_;
  std::vector<Segment> segments_;
};

template <class A, class B, class I, class S, class... Ends>
RotationSpline(const std::vector<AttitudeSample<A, B, I>>&, const Quantity<si::time, S>&, const Ends&...)
    -> RotationSpline<A, B, I>;

}  // namespace vectrix
