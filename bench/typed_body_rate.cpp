#include <vectrix/dynamics/rigid/euler.hpp>

#include "typed_kernels.hpp"

// In a file of its own: where a file uses a law twice, the compiler may call the law instead of inlining it.
namespace typed {

void body_rate(const AttitudeState& attitude, const Inertia<B>& J_b, std::span<const double> y,
               std::span<double> ydot) {
  const std::size_t attitude_size = attitude == AttitudeState::quaternion ? 4 : 9;
  const AngularVelocity<A, B, In<B>> w_ab_b{
      vectrix::detail::trusted, Eigen::Vector3d(Eigen::Map<const Eigen::Vector3d>(y.data() + attitude_size))};
  if (attitude == AttitudeState::quaternion) {
    const Eigen::Quaterniond rate =
        vectrix::rate(Quaternion<A, B>{vectrix::detail::trusted, Eigen::Quaterniond(y[0], y[1], y[2], y[3])},
                      w_ab_b)
            .eigen();
    ydot[0] = rate.w();
    ydot[1] = rate.x();
    ydot[2] = rate.y();
    ydot[3] = rate.z();
  } else {
    const Eigen::Matrix3d R = Eigen::Map<const Eigen::Matrix3d>(y.data());
    Eigen::Map<Eigen::Matrix3d>(ydot.data()) = vectrix::rate(trust_dcm(to<A>, from<B>, R), w_ab_b).matrix();
  }
  Eigen::Map<Eigen::Vector3d>(ydot.data() + attitude_size) =
      vectrix::euler(J_b, w_ab_b, zero<si::torque>(in<B>)).coordinates();
}

}  // namespace typed
