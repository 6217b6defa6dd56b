#pragma once

#include <vectrix/kinematics/attitude/exp.hpp>
#include <vectrix/kinematics/attitude/log.hpp>
#include <vectrix/kinematics/rates/moving_dcm.hpp>

namespace vectrix {

/// The turn at constant rate from one attitude to another, by the shortest way (Shoemake 1985):
///     q_b^a(t) = q_b^a(t0) exp(s theta),  theta = log(q_b^a(t0)^-1 q_b^a(t1)),  s = (t - t0)/(t1 - t0)
/// w_ab^b = theta / (t1 - t0) throughout. The sign of a quaternion does not matter. Of the two ways between
/// attitudes exactly half a turn apart, the axis log() chooses.
/// Throws BadInput when t0 < t1 does not hold, or when asked outside [t0, t1].
template <Frame A, Frame B, class S = double> class Slerp {
 public:
  Slerp(const Quantity<si::time, S>& t0, const Quaternion<A, B, S>& q0_a_from_b,
        const Quantity<si::time, S>& t1, const Quaternion<A, B, S>& q1_a_from_b)
      : start_(t0.value()),
        duration_(t1.value() - t0.value()),
        q0_(q0_a_from_b),
        theta_(
            log(Quaternion<A, B, S>{detail::trusted, q0_a_from_b.eigen().conjugate() * q1_a_from_b.eigen()})
                .coordinates()) {
    if (!detail::all(duration_ > S(0)) || !detail::all(duration_ - duration_ == S(0))) {
      throw BadInput("Slerp of " + frame_name<B>() + " relative to " + frame_name<A>() + ": the times " +
                     detail::text(start_) + " s and " + detail::text(t1.value()) + " s do not increase");
    }
  }

  template <class FirstTo, class FirstFrom, class LastTo, class LastFrom>
  Slerp(  // from one rotation q0_a_from_b to another of the same two frames
      const Quantity<si::time, S>&, const Quaternion<FirstTo, FirstFrom, S>&, const Quantity<si::time, S>&,
      const Quaternion<LastTo, LastFrom, S>&) = delete;

  MovingDcm<A, B, S> operator()(const Quantity<si::time, S>& t) const {
    const S s = (t.value() - start_) / duration_;
    if (!detail::all(s >= S(0)) || !detail::all(s <= S(1))) {
      throw BadInput("Slerp of " + frame_name<B>() + " relative to " + frame_name<A>() + ": time " +
                     detail::text(t.value()) + " s is outside [" + detail::text(start_) + ", " +
                     detail::text(start_ + duration_) + "] s");
    }
    // b at t0 and b at t have one type: the increment is taken as raw numbers.
    const Quaternion<A, B, S> increment =
        exp_quaternion(RotationVector<A, B, S>{detail::trusted, s * theta_});
    return {dcm(Quaternion<A, B, S>{detail::trusted, q0_.eigen() * increment.eigen()}),
            vectrix::angular_velocity(of<B>, relative_to<A>,
                                      vector<si::angular_velocity>(in<B>, theta_ / duration_))};
  }

 private:
  S start_;
  S duration_;
  Quaternion<A, B, S> q0_;
  detail::Column<S> theta_;
};

template <class A, class B, class S, class Last>
Slerp(const Quantity<si::time, S>&, const Quaternion<A, B, S>&, const Quantity<si::time, S>&, const Last&)
    -> Slerp<A, B, S>;

}  // namespace vectrix
