#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vectrix/frames/export.hpp>

namespace vectrix {

/// The kinds of torque-free motion. In the long-axis mode h circles, in the body, around the axis of the
/// smallest moment of inertia; in the short-axis mode, around the axis of the largest. On the separatrix
/// between the two modes it goes once from one end of the intermediate axis to the other. `steady` is a spin
/// about a principal axis.
enum class Regime { at_rest, steady, long_axis, separatrix, short_axis };

namespace detail {

/// q_b^i, scalar first, and w_ib^b.
struct RotationNumbers {
  std::array<double, 4> q;
  std::array<double, 3> w;
};

struct FreeRotationSeries;

/// TorqueFree without frames in its type; this part is compiled in the library. Immutable.
class VECTRIX_EXPORT FreeRotation {
 public:
  FreeRotation(const Eigen::Matrix3d& J_b, const std::array<double, 4>& q_i_from_b,
               const Eigen::Vector3d& w_ib_b);

  [[nodiscard]] RotationNumbers at(long double seconds_since_epoch) const;
  [[nodiscard]] Regime regime() const;
  [[nodiscard]] double period() const;
  [[nodiscard]] double smallest_moment() const;

 private:
  std::shared_ptr<const FreeRotationSeries> series_;
};

}  // namespace detail
}  // namespace vectrix
