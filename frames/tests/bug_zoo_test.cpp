// The bugs of docs/explanation/bug_zoo.md for frames without motion: each mistake in plain Eigen, and the law
// that finds it.
#include <gtest/gtest.h>

#include <vectrix/frames.hpp>

#include "testing/attitudes.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace bug_zoo_test {
namespace {

// The transpose is also finite, orthonormal and right-handed: only a direction known in both frames shows the
// mistake.
TEST(BugZoo, ATransposedMatrixPassesEveryCheckOfTheDoor) {
  const Eigen::Vector3d axis = Eigen::Vector3d(1, -2, 3).normalized();
  const Eigen::Matrix3d M_b_from_a = Eigen::AngleAxisd(-0.7, axis).toRotationMatrix();
  const Eigen::Vector3d star_a = Eigen::Vector3d(0.2, 0.5, -0.8).normalized();
  const Eigen::Vector3d star_b = M_b_from_a * star_a;
  const auto as_claimed = [&](const Eigen::Matrix3d& matrix) {
    const Dcm<Body, Gcrf> R_b_from_a = dcm(to<Body>, from<Gcrf>, matrix);
    EXPECT_LE(nearest_dcm(to<Body>, from<Gcrf>, matrix).distance, rounding);
    return (R_b_from_a * vector<si::dimensionless>(in<Gcrf>, star_a)).coordinates();
  };
  EXPECT_GT(distance(as_claimed(M_b_from_a.transpose()), star_b), visible);
  EXPECT_LE(distance(as_claimed(M_b_from_a), star_b), rounding);
}

}  // namespace
}  // namespace bug_zoo_test
