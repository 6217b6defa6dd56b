#pragma once

#include <vectrix/kinematics/attitude/exp.hpp>
#include <vectrix/kinematics/attitude/log.hpp>
#include <vectrix/kinematics/rates/moving_dcm.hpp>
#include <vectrix/kinematics/samples/instant.hpp>

namespace vectrix {
namespace detail {

/// The shortest turn from one sample to the next, in the axes of b.
template <class A, class B, class S>
Column<S> turn_between(const Quaternion<A, B, S>& from, const Quaternion<A, B, S>& until) {
  return log(Quaternion<A, B, S>{trusted, from.eigen().conjugate() * until.eigen()}).coordinates();
}

/// The numbers of a Slerp: q0 exp(s theta) for s from 0 to 1, with one sine and one cosine per evaluation.
template <class S> class ConstantTurn {
 public:
  ConstantTurn(const Eigen::Quaternion<S>& q0, const Column<S>& theta)
      : q0_(q0.coeffs()),
        q0_theta_((q0 * Eigen::Quaternion<S>(S(0), theta.x(), theta.y(), theta.z())).coeffs()),
        square_(theta.squaredNorm()) {}

  Eigen::Quaternion<S> at(const S& s) const {
    const HalfTurn<S> half = half_turn(S(s * s * square_));
    return Eigen::Quaternion<S>(Eigen::Matrix<S, 4, 1>(half.scalar * q0_ + half.factor * s * q0_theta_));
  }

 private:
  Eigen::Matrix<S, 4, 1> q0_, q0_theta_;
  S square_;
};

}  // namespace detail

/// The shortest turn at constant rate from one attitude to another (Shoemake 1985):
///     q_b^a(t) = q_b^a(t0) exp(s theta),  theta = log(q_b^a(t0)^-1 q_b^a(t1)),  s = (t - t0)/(t1 - t0)
/// w_ab^b = theta / (t1 - t0) throughout. The sign of a quaternion does not matter. For attitudes exactly
/// half a turn apart log() chooses the axis.
/// The constructor throws BadInput unless t0 < t1; a call does so outside [t0, t1].
template <Frame A, Frame B, Instant I = Quantity<si::time>> class Slerp {
  using S = InstantScalar<I>;

 public:
  Slerp(const I& t0, const Quaternion<A, B, S>& q0_a_from_b, const I& t1,
        const Quaternion<A, B, S>& q1_a_from_b)
      : Slerp(t0, q0_a_from_b, t1, detail::turn_between(q0_a_from_b, q1_a_from_b)) {}

  template <class FirstTo, class FirstFrom, class LastTo, class LastFrom>
  Slerp(  // from one rotation q0_a_from_b to another of the same two frames
      const I&, const Quaternion<FirstTo, FirstFrom, S>&, const I&,
      const Quaternion<LastTo, LastFrom, S>&) = delete;

  MovingDcm<A, B, S> operator()(const I& t) const {
    const S s = (t - start_).value() / duration_;
    if (!detail::all(s >= S(0)) || !detail::all(s <= S(1))) {
      throw BadInput(place() + "the time " + detail::instant_text(t) + " is outside [" +
                     detail::instant_text(start_) + ", " + detail::instant_text(end_) + "]");
    }
    return {dcm(Quaternion<A, B, S>{detail::trusted, turn_.at(s)}), rate_};
  }

 private:
  Slerp(const I& t0, const Quaternion<A, B, S>& q0, const I& t1, const detail::Column<S>& theta)
      : start_(t0),
        end_(t1),
        duration_((t1 - t0).value()),
        turn_(q0.eigen(), theta),
        rate_(detail::trusted, theta / duration_) {
    if (!detail::all(duration_ > S(0)) || !detail::all(duration_ - duration_ == S(0))) {
      throw BadInput(place() + "the times " + detail::instant_text(t0) + " and " + detail::instant_text(t1) +
                     " do not increase");
    }
    if (!detail::all_finite(rate_.coordinates())) {
      throw BadInput(place() + "the times " + detail::instant_text(t0) + " and " + detail::instant_text(t1) +
                     " are " + detail::text(duration_) + " s apart; the rate overflows");
    }
  }
  static std::string place() {
    return "Slerp of " + frame_name<B>() + " relative to " + frame_name<A>() + ": ";
  }

  I start_, end_;
  S duration_;
  detail::ConstantTurn<S> turn_;
  AngularVelocity<A, B, In<B>, S> rate_;
};

template <class I, class A, class B, class S, class Last>
Slerp(const I&, const Quaternion<A, B, S>&, const I&, const Last&) -> Slerp<A, B, I>;

}  // namespace vectrix
