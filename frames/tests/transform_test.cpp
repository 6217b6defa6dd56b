#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vectrix/frames/transform.hpp>

#include "testing/attitudes.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace transform_test {
namespace {

struct Tip : named_point {};

Eigen::Matrix4d homogeneous(const Eigen::Matrix3d& R, const Eigen::Vector3d& r) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() = R;
  matrix.topRightCorner<3, 1>() = r;
  return matrix;
}
template <class B, class A> Transform<B, A> any_transform() {
  return trust_transform(to<B>, from<A>, homogeneous(*rotation_matrix(), *triple()));
}

// 1. r_bq^b = R_a^b r_aq^a + r_ba^b; the reference is homogeneous matrices.
RC_GTEST_PROP(Transform, Law1TakesPositionsFromAToPositionsFromB, ()) {
  const auto X = any_transform<Body, Gcrf>();
  const auto r_aq_a = displacement(of<Tip>, relative_to<Gcrf>, vector<si::length>(in<Gcrf>, *triple()));
  const Displacement<Body, Tip, In<Body>> r_bq_b = X * r_aq_a;
  const Eigen::Vector3d expected =
      (homogeneous_matrix(X) * r_aq_a.coordinates().homogeneous()).template head<3>();
  RC_ASSERT(distance(r_bq_b.coordinates(), expected) <= rounding);
}

// 2. X_a^c = X_b^c X_a^b, and not the reversed product.
RC_GTEST_PROP(Transform, Law2InnerFramesCancel, ()) {
  const auto X_cb = any_transform<Camera, Body>();
  const auto X_ba = any_transform<Body, Gcrf>();
  const Transform<Camera, Gcrf> X_ca = X_cb * X_ba;
  RC_ASSERT(distance(homogeneous_matrix(X_ca), homogeneous_matrix(X_cb) * homogeneous_matrix(X_ba)) <=
            rounding);
}

// 3. X_b^a = (X_a^b)^-1.
RC_GTEST_PROP(Transform, Law3TheInverseTakesBack, ()) {
  const auto X = any_transform<Body, Gcrf>();
  const Transform<Gcrf, Body> back = inverse(X);
  RC_ASSERT(distance(homogeneous_matrix(back) * homogeneous_matrix(X), Eigen::Matrix4d::Identity()) <=
            rounding);
}

TEST(Transform, TranslationIsThePlaceOfTheOriginOfA) {
  const Transform X{turned_z(to<Body>, from<Gcrf>, 0.5 * 3.14159265358979 * si::radian),
                    displacement(of<Gcrf>, relative_to<Body>,
                                 vector(in<Body>, 1.0 * si::metre, 2.0 * si::metre, 3.0 * si::metre))};
  const auto origin = X * coincident(of<Gcrf>, relative_to<Gcrf>, in<Gcrf>);
  EXPECT_EQ(origin.coordinates(), Eigen::Vector3d(1, 2, 3));
  // Body is Gcrf turned by +90 deg about z: the y axis of Gcrf is the x axis of Body.
  const auto ahead = X * displacement(of<Tip>, relative_to<Gcrf>,
                                      vector(in<Gcrf>, 0.0 * si::metre, 1.0 * si::metre, 0.0 * si::metre));
  EXPECT_LE(distance(ahead.coordinates(), Eigen::Vector3d(2, 2, 3)), 1e-14);
}

TEST(TransformDoors, RefuseWhatIsNoTransform) {
  const auto refusal = [](auto change) {
    Eigen::Matrix4d matrix = homogeneous(Eigen::Matrix3d::Identity(), {1.0, 2.0, 3.0});
    change(matrix);
    return message<BadInput>([&] { transform(to<Body>, from<Gcrf>, matrix); });
  };
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusal([](auto&) {}), "");
  EXPECT_EQ(refusal([](auto& m) { m(3, 1) = 0.25; }),
            "transform(to<vectrix_test::Body>, from<vectrix_test::Gcrf>): entry (4, 2) is 0.25 instead of 0");
  EXPECT_EQ(refusal([](auto& m) { m(3, 3) = 2.0; }),
            "transform(to<vectrix_test::Body>, from<vectrix_test::Gcrf>): entry (4, 4) is 2 instead of 1");
  EXPECT_TRUE(
      contains(refusal([=](auto& m) { m(1, 3) = infinity; }), "the translation (1, inf, 3) is not finite"));
  EXPECT_TRUE(contains(refusal([=](auto& m) { m(3, 0) = std::nan(""); }), "entry (4, 1) is nan"));
  EXPECT_TRUE(contains(refusal([](auto& m) { m(0, 0) = 1.1; }), "dcm(to<vectrix_test::Body>"));
  EXPECT_TRUE(contains(refusal([](auto& m) { m(0, 0) = -1.0; }), "right-handed"));
}

TEST(TransformDoors, TheProjectionLeavesTheTranslation) {
  const Eigen::Matrix3d R = Eigen::Quaterniond(0.4, -0.2, 0.5, 0.7).normalized().toRotationMatrix();
  const auto [X, moved] = nearest_transform(to<Body>, from<Gcrf>, homogeneous(1.001 * R, {1.0, 2.0, 3.0}));
  EXPECT_LE(distance(X.rotation.matrix(), R), rounding);
  EXPECT_NEAR(moved, 0.001 * std::sqrt(3.0), rounding);
  EXPECT_EQ(X.translation.coordinates(), Eigen::Vector3d(1, 2, 3));
  EXPECT_TRUE(
      contains(message<BadInput>([&] {
                 nearest_transform(to<Body>, from<Gcrf>, homogeneous(R, {1.0, std::nan(""), 3.0}));
               }),
               "nearest_transform(to<vectrix_test::Body>, from<vectrix_test::Gcrf>): the translation"));
}

template <class Left, class Right>
concept Multiplies = requires(const Left& left, const Right& right) {
  left* right;
};
static_assert(!Multiplies<Transform<Camera, Body>, Transform<Gcrf, Body>>);
static_assert(!Multiplies<Transform<Camera, Body>, Dcm<Body, Gcrf>>);
static_assert(!Multiplies<Transform<Camera, Body>, Vector<Body, si::length>>);
static_assert(!Multiplies<Transform<Camera, Body>, Displacement<Camera, Tip, In<Body>>>);
static_assert(!Multiplies<Transform<Camera, Body>, Displacement<Body, Tip, In<Camera>>>);

}  // namespace
}  // namespace transform_test
