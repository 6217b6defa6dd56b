#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vectrix/frames/export.hpp>

namespace vectrix {

/// How a body without torque moves. In the long-axis mode h goes around the axis of the smallest moment of
/// inertia, in the short-axis mode around that of the largest, and on the separatrix between them it goes
/// once from one end of the intermediate axis to the other. `steady` is a spin about a principal axis.
enum class Regime { at_rest, steady, long_axis, separatrix, short_axis };

namespace detail {

/// q_b^i, scalar first, and w_ib^b.
struct RotationNumbers {
  std::array<double, 4> q;
  std::array<double, 3> w;
};

struct FreeRotationSeries;

/// TorqueFree without its names: what has lost them is compiled. Immutable.
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
