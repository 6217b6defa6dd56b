#include "subjects.hpp"

namespace vectrix::accuracy {
namespace {

// No turn; whole, half, quarter and third turns about axes, diagonals and edges of a cube; and the angles
// where the library changes formula: 1e-2 rad and 3 rad.
const std::vector<Eigen::Vector3d>& special_turns() {
  static const std::vector<Eigen::Vector3d> list = [] {
    std::vector<Eigen::Vector3d> all = {Eigen::Vector3d::Zero()};
    for (const double angle : {std::numbers::pi, std::numbers::pi / 2, 2 * std::numbers::pi / 3,
                               std::numbers::pi / 4, 1e-2, 3.0, 1.0}) {
      for (int x = -1; x <= 1; ++x) {
        for (int y = -1; y <= 1; ++y) {
          for (int z = -1; z <= 1; ++z) {
            const Eigen::Vector3d axis(x, y, z);
            if (x != 0 || y != 0 || z != 0) all.push_back(angle / axis.norm() * axis);
          }
        }
      }
    }
    return all;
  }();
  return list;
}

}  // namespace

const std::vector<Turns>& turns() {
  static const std::vector<Turns> kinds = {
      {"tiny, 1e-300 to 1e-8 rad", [](Draw& draw) { return draw.vector(1e-300, 1e-8); }, 0},
      {"small, 1e-8 to 1e-2 rad", [](Draw& draw) { return draw.vector(1e-8, 1e-2); }, 0},
      {"any, 1e-2 to 3.14 rad",
       [](Draw& draw) -> Eigen::Vector3d { return draw.uniform(1e-2, 3.14) * draw.direction(); }, 0},
      {"1e-12 to 1e-3 rad short of half a turn",
       [](Draw& draw) -> Eigen::Vector3d {
         return (std::numbers::pi - draw.logarithmic(1e-12, 1e-3)) * draw.direction();
       },
       0},
      {"half a turn, to rounding",
       [](Draw& draw) -> Eigen::Vector3d { return std::numbers::pi * draw.direction(); }, 0},
      {"special: no turn, 45, 90, 120, 180 degrees, the seams, about axes and diagonals",
       [](Draw& draw) { return special_turns()[draw.index]; }, special_turns().size()},
  };
  return kinds;
}

Eigen::Matrix3d rounded_dcm(const Eigen::Vector3d& theta) {
  return exponential(widened(theta)).cast<double>();
}

Eigen::Vector4d rounded_quaternion(const Eigen::Vector3d& theta) {
  const WideColumn wide = widened(theta);
  const Wide angle = wide.norm();
  Eigen::Matrix<Wide, 4, 1> q;
  q << (angle > 0 ? std::sin(angle / 2) / angle : Wide(0)) * wide, std::cos(angle / 2);
  return q.cast<double>();
}

}  // namespace vectrix::accuracy
