#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "named_values.hpp"

// Rotations and quaternions between named frames.
namespace values_test {
namespace {

RC_GTEST_PROP(NamedDcm, FollowsTheLawsOfDcm, ()) {
  const Values x;
  const NamedDcm R_c_from_b = dcm(To(x.c), From(x.b), x.R1);
  const NamedDcm R_b_from_a = dcm(To(x.b), From(x.a), x.R2);
  const NamedDcm R_c_from_a = R_c_from_b * R_b_from_a;
  RC_ASSERT(R_c_from_a.to() == x.c && R_c_from_a.from() == x.a);
  RC_ASSERT(distance(R_c_from_a.matrix(), x.R1 * x.R2) <= rounding);
  RC_ASSERT(inverse(R_c_from_b).to() == x.b && inverse(R_c_from_b).from() == x.c);
  RC_ASSERT(inverse(R_c_from_b).matrix() == x.R1.transpose());
  const auto r_a = vector<si::length>(In(x.a), x.v1);
  const NamedVector<si::length> r_b = R_b_from_a * r_a;
  RC_ASSERT(r_b.in() == x.b && distance(r_b.coordinates(), x.R2 * x.v1) <= rounding);
  RC_ASSERT(distance((r_b + r_b - -r_b).coordinates(), 3 * r_b.coordinates()) <= rounding);
  RC_ASSERT(distance(dcm(quaternion(R_c_from_b)).matrix(), x.R1) <= rounding);
}

RC_GTEST_PROP(NamedDcm, InnerFramesThatDifferAreRefused, ()) {
  const Values x;
  const NamedDcm R = dcm(To(x.c), From(x.b), x.R1);
  RC_ASSERT(refusal([&] { R* dcm(To(x.a), From(x.b), x.R2); }) ==
            R"(product of R to "c" from "b" and R to "a" from "b": "b" and "a" are two frames)");
  RC_ASSERT(refusal([&] { R* vector<si::length>(In(x.c), x.v1); }) ==
            R"(product of R to "c" from "b" and a vector in "c": "b" and "c" are two frames)");
  RC_ASSERT(refusal([&] { vector<si::length>(In(x.a), x.v1) + vector<si::length>(In(x.c), x.v1); }) ==
            R"(sum of two vectors: "a" and "c" are two frames)");
  RC_ASSERT(refusal([&] { vector<si::length>(In(x.a), x.v1) - vector<si::length>(In(x.c), x.v1); }) ==
            R"(difference of two vectors: "a" and "c" are two frames)");
  const Values other;
  RC_ASSERT(refusal([&] { R* dcm(To(other.b), From(other.a), x.R2); }) ==
            R"(product of R to "c" from "b" and R to "b" from "a": "b" and "b" are frames of two graphs)");
}

// The doors are those of Dcm, with the same errors.
RC_GTEST_PROP(NamedDcm, DoorsAreThoseOfDcm, ()) {
  const Values x;
  const auto angle = *coordinate() * si::radian;
  const auto b = To(x.b);
  const auto a = From(x.a);
  RC_ASSERT(turned_x(b, a, angle).matrix() == turned_x(to<Body>, from<Gcrf>, angle).matrix());
  RC_ASSERT(turned_y(b, a, angle).matrix() == turned_y(to<Body>, from<Gcrf>, angle).matrix());
  RC_ASSERT(turned_z(b, a, angle).matrix() == turned_z(to<Body>, from<Gcrf>, angle).matrix());
  RC_ASSERT(aligned(b, a).matrix() == Eigen::Matrix3d::Identity());
  const Eigen::Matrix3d rough = x.R1 + 1e-3 * x.R2;
  RC_ASSERT(trust_dcm(b, a, rough).matrix() == rough);
  const auto nearest = nearest_dcm(b, a, rough);
  const auto expected = nearest_dcm(to<Body>, from<Gcrf>, rough);
  RC_ASSERT(nearest.dcm.matrix() == expected.dcm.matrix() && nearest.distance == expected.distance);
  RC_ASSERT(nearest.dcm.to() == x.b && nearest.dcm.from() == x.a);
  RC_ASSERT(contains(refusal([&] { dcm(b, a, rough); }), R"(dcm(to "b", from "a"): M^T M differs)"));
  RC_ASSERT(refusal([&] { nearest_dcm(b, a, Eigen::Matrix3d(-Eigen::Matrix3d::Identity())); }) ==
            R"(nearest_dcm(to "b", from "a"): the determinant is -1; a rotation is right-handed)");
  const auto infinite = std::numeric_limits<double>::infinity() * si::radian;
  RC_ASSERT(refusal([&] { turned_z(b, a, infinite); }) == R"(turned_z(to "b", from "a"): the angle is inf)");
  RC_ASSERT(contains(refusal([&] { quaternion_scalar_first(b, a, 1.0, 1.0, 0.0, 0.0); }),
                     R"(quaternion_scalar_first(to "b", from "a"): the norm differs)"));
  RC_ASSERT(quaternion_scalar_last(b, a, 1.0, 0.0, 0.0, 0.0).eigen().x() == 1.0);
  RC_ASSERT(refusal([&] { vector<si::length>(In(x.a), Eigen::Vector3d(0, NAN, 1)); }) ==
            R"(vector(in "a"): the coordinates (0, nan, 1) are not finite)");
  Eigen::VectorXd column(6);
  column << x.v1, x.v2;
  const auto r_a = vector<si::length>(In(x.a), column.segment(3, 3));
  RC_ASSERT(r_a.coordinates() == x.v2);
  RC_ASSERT(r_a.x().value() == x.v2[0] && r_a.y().value() == x.v2[1] && r_a.z().value() == x.v2[2]);
  const auto w = x.w(x.b, x.a, x.c, x.v1);
  RC_ASSERT(w.x().value() == x.v1[0] && w.y().value() == x.v1[1] && w.z().value() == x.v1[2]);
  RC_ASSERT(refusal([&] { vector<si::length>(In(x.a), column); }) ==
            R"(vector(in "a"): the matrix has 6 x 1 entries, not 3 x 1)");
}

// What the checked door refuses, the projected one takes, and says how far it moved the numbers.
RC_GTEST_PROP(NamedQuaternion, TheProjectedDoorsAreThoseOfQuaternion, ()) {
  const Values x;
  const auto b = To(x.b);
  const auto a = From(x.a);
  const Eigen::Vector4d q = Eigen::Quaterniond(x.R1).coeffs() * (1.5 + *coordinate());
  RC_PRE(std::abs(q.norm() - 1.0) > 1e-3);
  RC_ASSERT(contains(refusal([&] { quaternion_scalar_first(b, a, q[3], q[0], q[1], q[2]); }),
                     "; nearest_quaternion_scalar_first() projects"));
  RC_ASSERT(contains(refusal([&] { quaternion_scalar_last(b, a, q[0], q[1], q[2], q[3]); }),
                     "; nearest_quaternion_scalar_last() projects"));
  const auto expected = nearest_quaternion_scalar_first(to<Body>, from<Gcrf>, q[3], q[0], q[1], q[2]);
  for (const NearestNamedQuaternion& nearest :
       {nearest_quaternion_scalar_first(b, a, q[3], q[0], q[1], q[2]),
        nearest_quaternion_scalar_last(b, a, q[0], q[1], q[2], q[3])}) {
    RC_ASSERT(nearest.quaternion.to() == x.b && nearest.quaternion.from() == x.a);
    RC_ASSERT(nearest.quaternion.eigen().coeffs() == expected.quaternion.eigen().coeffs());
    RC_ASSERT(nearest.distance == expected.distance && nearest.distance > 1e-4);
  }
  RC_ASSERT(
      refusal([&] { nearest_quaternion_scalar_first(b, a, 0.0, 0.0, 0.0, 0.0); }) ==
      R"(nearest_quaternion_scalar_first(to "b", from "a"): the norm is 0; a zero quaternion turns nothing)");
  RC_ASSERT(
      refusal([&] { nearest_quaternion_scalar_last(b, a, 0.0, std::nan(""), 0.0, 1.0); }) ==
      R"(nearest_quaternion_scalar_last(to "b", from "a"): the numbers, scalar first, (1, 0, nan, 0) are not finite)");
  RC_ASSERT(
      refusal([&] { nearest_quaternion_scalar_first(b, From(x.b), 1.0, 0.0, 0.0, 0.0); }) ==
      R"(nearest_quaternion_scalar_first(to "b", from "b"): a door takes two frames, and these are one)");
}

RC_GTEST_PROP(NamedQuaternion, TheDoorsOfEigenAreThoseOfQuaternion, ()) {
  const Values x;
  const auto b = To(x.b);
  const auto a = From(x.a);
  const Eigen::Quaterniond q(x.R1), far(1.0, 0.1, 0.0, 0.0);
  const NamedQuaternion q_b_from_a = quaternion(b, a, q);
  RC_ASSERT(q_b_from_a.to() == x.b && q_b_from_a.from() == x.a);
  RC_ASSERT(q_b_from_a.eigen().coeffs() == q.coeffs());
  RC_ASSERT(
      contains(refusal([&] { quaternion(b, a, far); }), R"(quaternion(to "b", from "a"): the norm differs)"));
  RC_ASSERT(contains(refusal([&] { quaternion(b, a, far); }), "; nearest_quaternion() projects"));
  const NearestNamedQuaternion nearest = nearest_quaternion(b, a, far);
  const auto expected = nearest_quaternion(to<Body>, from<Gcrf>, far);
  RC_ASSERT(nearest.quaternion.to() == x.b && nearest.quaternion.from() == x.a);
  RC_ASSERT(nearest.quaternion.eigen().coeffs() == expected.quaternion.eigen().coeffs());
  RC_ASSERT(nearest.distance == expected.distance && nearest.distance > 1e-4);
  RC_ASSERT(refusal([&] { nearest_quaternion(b, a, Eigen::Quaterniond(0.0, 0.0, 0.0, 0.0)); }) ==
            R"(nearest_quaternion(to "b", from "a"): the norm is 0; a zero quaternion turns nothing)");
}

RC_GTEST_PROP(NamedDcm, TheDoorsTakeTwoFrames, ()) {
  const Values x;
  const Eigen::Quaterniond none = Eigen::Quaterniond::Identity();
  const auto one = [](const std::string& door) {
    return door + R"((to "a", from "a"): a door takes two frames, and these are one)";
  };
  RC_ASSERT(refusal([&] { dcm(To(x.a), From(x.a), x.R1); }) == one("dcm"));
  RC_ASSERT(refusal([&] { nearest_dcm(To(x.a), From(x.a), x.R1); }) == one("nearest_dcm"));
  RC_ASSERT(refusal([&] { trust_dcm(To(x.a), From(x.a), x.R1); }) == one("trust_dcm"));
  RC_ASSERT(refusal([&] { aligned(To(x.a), From(x.a)); }) == one("aligned"));
  RC_ASSERT(refusal([&] { turned_z(To(x.a), From(x.a), 1.0 * si::radian); }) == one("turned_z"));
  RC_ASSERT(refusal([&] { quaternion_scalar_first(To(x.a), From(x.a), 1.0, 0.0, 0.0, 0.0); }) ==
            one("quaternion_scalar_first"));
  RC_ASSERT(refusal([&] { quaternion(To(x.a), From(x.a), none); }) == one("quaternion"));
  RC_ASSERT(refusal([&] { nearest_quaternion(To(x.a), From(x.a), none); }) == one("nearest_quaternion"));
  RC_ASSERT(refusal([&] { turned_x(To(x.a), From(x.a), 1.0 * si::radian); }) == one("turned_x"));
  RC_ASSERT(refusal([&] { turned_y(To(x.a), From(x.a), 1.0 * si::radian); }) == one("turned_y"));
  RC_ASSERT(refusal([&] { quaternion_scalar_last(To(x.a), From(x.a), 0.0, 0.0, 0.0, 1.0); }) ==
            one("quaternion_scalar_last"));
  RC_ASSERT(refusal([&] { nearest_quaternion_scalar_last(To(x.a), From(x.a), 0.0, 0.0, 0.0, 1.0); }) ==
            one("nearest_quaternion_scalar_last"));
  const auto still = [](const std::string& door) {
    return door + R"((of "a", relative to "a"): a frame does not move relative to itself)";
  };
  RC_ASSERT(refusal([&] { x.w(x.a, x.a, x.c, x.v1); }) == still("angular_velocity"));
  RC_ASSERT(refusal([&] { x.alpha(x.a, x.a, x.c, x.v1); }) == still("angular_acceleration"));
}

}  // namespace
}  // namespace values_test
