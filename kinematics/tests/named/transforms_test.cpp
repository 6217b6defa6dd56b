#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "named_values.hpp"

namespace values_test {
namespace {

RC_GTEST_PROP(NamedTransform, FollowsTheLawsOfTransform, ()) {
  const Values x;
  const NamedTransform X_b_from_a{dcm(To(x.b), From(x.a), x.R1), x.r(x.a, x.b, x.b, x.v1)};
  const NamedTransform X_c_from_b{dcm(To(x.c), From(x.b), x.R2), x.r(x.b, x.c, x.c, x.v2)};
  const Transform<Body, Gcrf> X1{
      dcm(to<Body>, from<Gcrf>, x.R1),
      displacement(of<Gcrf>, relative_to<Body>, vector<si::length>(in<Body>, x.v1))};
  const Transform<Camera, Body> X2{
      dcm(to<Camera>, from<Body>, x.R2),
      displacement(of<Body>, relative_to<Camera>, vector<si::length>(in<Camera>, x.v2))};
  const auto same = [](const NamedTransform& X, NamedFrame b, NamedFrame a, const auto& typed) {
    RC_ASSERT(X.rotation().to() == b && X.rotation().from() == a);
    RC_ASSERT(X.translation().of() == a && X.translation().relative_to() == b && X.translation().in() == b);
    RC_ASSERT(distance(X.rotation().matrix(), typed.rotation.matrix()) <= rounding);
    RC_ASSERT(distance(X.translation().coordinates(), typed.translation.coordinates()) <= rounding);
  };
  same(X_c_from_b * X_b_from_a, x.c, x.a, X2 * X1);
  same(inverse(X_b_from_a), x.a, x.b, inverse(X1));
  const auto r_aq_a = x.r(x.d, x.a, x.a, x.v2);
  const NamedDisplacement r_bq_b = X_b_from_a * r_aq_a;
  RC_ASSERT(r_bq_b.of() == x.d && r_bq_b.relative_to() == x.b && r_bq_b.in() == x.b);
  RC_ASSERT(distance(r_bq_b.coordinates(), x.R1 * x.v2 + x.v1) <= rounding);
  RC_ASSERT(refusal([&] { X_b_from_a* X_c_from_b; }) ==
            R"(product of R to "b" from "a" and R to "c" from "b": "a" and "c" are two frames)");
  RC_ASSERT(
      contains(refusal([&] { X_b_from_a* x.r(x.d, x.c, x.a, x.v2); }), R"("a" and "c" are two frames)"));
}

RC_GTEST_PROP(NamedTransform, DoorsAreThoseOfTransform, ()) {
  const Values x;
  const auto b = To(x.b);
  const auto a = From(x.a);
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.topLeftCorner<3, 3>() = x.R1;
  m.topRightCorner<3, 1>() = x.v1;
  RC_ASSERT(homogeneous_matrix(transform(b, a, m)) == m);
  RC_ASSERT(homogeneous_matrix(trust_transform(b, a, 2 * m)).topRows(3) == 2 * m.topRows(3));
  const NamedTransform X = transform(b, a, m);
  RC_ASSERT(X.rotation().to() == x.b && X.rotation().from() == x.a);
  RC_ASSERT(X.translation().of() == x.a && X.translation().relative_to() == x.b);
  RC_ASSERT(X.translation().in() == x.b && X.translation().coordinates() == x.v1);
  Eigen::Matrix4d rough = m;
  rough.topLeftCorner<3, 3>() += 1e-3 * x.R2;
  RC_ASSERT(contains(refusal([&] { transform(b, a, rough); }), R"((to "b", from "a"): M^T M differs)"));
  const NearestNamedTransform nearest = nearest_transform(b, a, rough);
  const auto expected = nearest_transform(to<Body>, from<Gcrf>, rough);
  RC_ASSERT(homogeneous_matrix(nearest.transform) == homogeneous_matrix(expected.transform));
  RC_ASSERT(nearest.distance == expected.distance);
  m(3, 0) = 1.0;
  RC_ASSERT(refusal([&] { transform(b, a, m); }) ==
            R"(transform(to "b", from "a"): entry (4, 1) is 1 instead of 0)");
  for (const auto& [door, said] :
       {std::pair("transform", refusal([&] { transform(b, From(x.b), m); })),
        std::pair("nearest_transform", refusal([&] { nearest_transform(b, From(x.b), m); }))})
    RC_ASSERT(said ==
              std::string{door} + R"((to "b", from "b"): a door takes two frames, and these are one)");
  RC_ASSERT(refusal([&] { trust_transform(b, From(x.b), m); }) ==
            R"(trust_transform(to "b", from "b"): a door takes two frames, and these are one)");
}

RC_GTEST_PROP(NamedTransform, JoinsWhatBelongsTogether, ()) {
  const Values x;
  const NamedDcm R = dcm(To(x.a), From(x.b), x.R1);
  const auto moving = moving_dcm(R, x.w(x.b, x.a, x.b, x.v1));
  const auto whole = accelerating_dcm(R, x.w(x.b, x.a, x.b, x.v1), x.alpha(x.b, x.a, x.b, x.v2));
  const auto r = x.r(x.b, x.a, x.a, x.v1);
  const auto v = x.v(x.b, x.a, x.a, x.a, x.v1);
  const auto a = x.a_of(x.b, x.a, x.a, x.a, x.v1);
  RC_ASSERT((NamedAcceleratingTransform{whole, r, v, a}.acceleration().coordinates() == x.v1));
  RC_ASSERT((NamedMovingTransform{moving, r, v}.velocity().coordinates() == x.v1));
  RC_ASSERT(
      refusal([&] {
        NamedTransform{R, -r};
      }) ==
      R"(NamedTransform{R to "a" from "b", r of "a" relative to "b" in "a"}: "b" and "a" are two frames)");
  RC_ASSERT(
      refusal([&] {
        NamedTransform{R, x.r(x.b, x.a, x.b, x.v1)};
      }) ==
      R"(NamedTransform{R to "a" from "b", r of "b" relative to "a" in "b"}: "a" and "b" are two frames)");
  RC_ASSERT(
      refusal([&] {
        NamedMovingTransform{moving, r, x.v(x.b, x.a, x.b, x.a, x.v1)};
      }) ==
      R"(NamedMovingTransform{R to "a" from "b", v of "b" relative to "a" observed from "b" in "a"}: "a" and "b" are two frames)");
  RC_ASSERT(
      refusal([&] {
        NamedAcceleratingTransform{whole, r, v, x.a_of(x.b, x.c, x.a, x.a, x.v1)};
      }) ==
      R"(NamedAcceleratingTransform{R to "a" from "b", a of "b" relative to "c" observed from "a" in "a"}: "a" and "c" are two frames)");
  RC_ASSERT(contains(refusal([&] { NamedMovingTransform{moving, -r, v}; }), R"("b" and "a" are two frames)"));
  RC_ASSERT(contains(refusal([&] {
                       NamedAcceleratingTransform{whole, -r, v, a};
                     }),
                     R"("b" and "a" are two)"));
  RC_ASSERT(contains(refusal([&] {
                       NamedAcceleratingTransform{whole, r, -v, a};
                     }),
                     R"("b" and "a" are two)"));
}

RC_GTEST_PROP(NamedMovingDcm, JoinsWhatBelongsTogether, ()) {
  const Values x;
  const NamedDcm R = dcm(To(x.a), From(x.b), x.R1);
  const auto in_b = accelerating_dcm(R, x.w(x.b, x.a, x.b, x.v1), x.alpha(x.b, x.a, x.b, x.v2));
  RC_ASSERT(in_b.angular_velocity().coordinates() == x.v1 &&
            in_b.angular_acceleration().coordinates() == x.v2);
  const auto in_a = accelerating_dcm(R, x.w(x.b, x.a, x.a, x.v1), x.alpha(x.b, x.a, x.a, x.v2));
  RC_ASSERT(in_a.angular_velocity().in() == x.b && in_a.angular_acceleration().in() == x.b);
  RC_ASSERT(distance(in_a.angular_velocity().coordinates(), x.R1.transpose() * x.v1) <= rounding);
  RC_ASSERT(distance(in_a.angular_acceleration().coordinates(), x.R1.transpose() * x.v2) <= rounding);
  RC_ASSERT(refusal([&] { moving_dcm(R, x.w(x.a, x.b, x.b, x.v1)); }) ==
            R"(moving_dcm(R to "a" from "b", w of "a" relative to "b" in "b"): "a" and "b" are two frames)");
  RC_ASSERT(refusal([&] { moving_dcm(R, x.w(x.b, x.a, x.c, x.v1)); }) ==
            R"(moving_dcm(R to "a" from "b", w of "b" relative to "a" in "c"): "b" and "c" are two frames)");
  RC_ASSERT(
      contains(refusal([&] { accelerating_dcm(R, x.w(x.b, x.a, x.b, x.v1), x.alpha(x.c, x.a, x.b, x.v1)); }),
               R"(accelerating_dcm(R to "a" from "b", alpha of "c" relative to "a" in "b"): )"));
}

}  // namespace
}  // namespace values_test
