#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <sstream>
#include <vectrix/kinematics/named/dcm_doors.hpp>
#include <vectrix/kinematics/named/graph.hpp>

#include "testing/motions.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace values_test {
namespace {

/// Four frames, and values that relate them.
struct Values {
  NamedGraph graph;
  NamedFrame a = graph.add_frame("a", FrameMotion::moving);
  NamedFrame b = graph.add_frame("b", FrameMotion::moving);
  NamedFrame c = graph.add_frame("c", FrameMotion::moving);
  NamedFrame d = graph.add_frame("d", FrameMotion::moving);
  Eigen::Matrix3d R1 = *rotation_matrix(), R2 = *rotation_matrix();
  Eigen::Vector3d v1 = *triple(), v2 = *triple();

  NamedAngularVelocity w(NamedFrame of, NamedFrame relative_to, NamedFrame in,
                         const Eigen::Vector3d& v) const {
    return angular_velocity(Of(of), RelativeTo(relative_to), vector<si::angular_velocity>(In(in), v));
  }
  NamedAngularAcceleration alpha(NamedFrame of, NamedFrame relative_to, NamedFrame in,
                                 const Eigen::Vector3d& v) const {
    return angular_acceleration(Of(of), RelativeTo(relative_to), vector<si::angular_acceleration>(In(in), v));
  }
  NamedDisplacement r(NamedFrame of, NamedFrame relative_to, NamedFrame in, const Eigen::Vector3d& r) const {
    return displacement(Of(of), RelativeTo(relative_to), vector<si::length>(In(in), r));
  }
  NamedVelocity v(NamedFrame of, NamedFrame relative_to, NamedFrame observer, NamedFrame in,
                  const Eigen::Vector3d& v) const {
    return velocity(Of(of), RelativeTo(relative_to), ObservedFrom(observer), vector<si::velocity>(In(in), v));
  }
  NamedAcceleration a_of(NamedFrame of, NamedFrame relative_to, NamedFrame observer, NamedFrame in,
                         const Eigen::Vector3d& v) const {
    return acceleration(Of(of), RelativeTo(relative_to), ObservedFrom(observer),
                        vector<si::acceleration>(In(in), v));
  }
};

template <class Action> std::string refusal(const Action& action) {
  return message<BadInput>(action);
}

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
  RC_ASSERT(contains(refusal([&] { dcm(b, a, rough); }), R"(dcm(to<"b">, from<"a">): M^T M differs)"));
  RC_ASSERT(refusal([&] { nearest_dcm(b, a, Eigen::Matrix3d(-Eigen::Matrix3d::Identity())); }) ==
            R"(nearest_dcm(to<"b">, from<"a">): the determinant is -1; a rotation is right-handed)");
  const auto infinite = std::numeric_limits<double>::infinity() * si::radian;
  RC_ASSERT(refusal([&] { turned_z(b, a, infinite); }) ==
            R"(turned_z(to<"b">, from<"a">): the angle is inf)");
  RC_ASSERT(contains(refusal([&] { quaternion_scalar_first(b, a, 1.0, 1.0, 0.0, 0.0); }),
                     R"(quaternion_scalar_first(to<"b">, from<"a">): the norm differs)"));
  RC_ASSERT(quaternion_scalar_last(b, a, 1.0, 0.0, 0.0, 0.0).eigen().x() == 1.0);
  RC_ASSERT(refusal([&] { vector<si::length>(In(x.a), Eigen::Vector3d(0, NAN, 1)); }) ==
            R"(vector(in<"a">): the coordinates (0, nan, 1) are not finite)");
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
      R"(nearest_quaternion_scalar_first(to<"b">, from<"a">): the norm is 0; a zero quaternion turns nothing)");
  RC_ASSERT(
      refusal([&] { nearest_quaternion_scalar_last(b, a, 0.0, std::nan(""), 0.0, 1.0); }) ==
      R"(nearest_quaternion_scalar_last(to<"b">, from<"a">): the numbers, scalar first, (1, 0, nan, 0) are not finite)");
  RC_ASSERT(refusal([&] { nearest_quaternion_scalar_first(b, From(x.b), 1.0, 0.0, 0.0, 0.0); }) ==
            R"(to "b", from "b": a door takes two frames, and these are one)");
}

RC_GTEST_PROP(NamedDcm, TheDoorsTakeTwoFrames, ()) {
  const Values x;
  const std::string one = R"(to "a", from "a": a door takes two frames, and these are one)";
  RC_ASSERT(refusal([&] { dcm(To(x.a), From(x.a), x.R1); }) == one);
  RC_ASSERT(refusal([&] { nearest_dcm(To(x.a), From(x.a), x.R1); }) == one);
  RC_ASSERT(refusal([&] { trust_dcm(To(x.a), From(x.a), x.R1); }) == one);
  RC_ASSERT(refusal([&] { aligned(To(x.a), From(x.a)); }) == one);
  RC_ASSERT(refusal([&] { turned_z(To(x.a), From(x.a), 1.0 * si::radian); }) == one);
  RC_ASSERT(refusal([&] { quaternion_scalar_first(To(x.a), From(x.a), 1.0, 0.0, 0.0, 0.0); }) == one);
  const std::string still = R"(of "a" relative to "a": a frame does not move relative to itself)";
  RC_ASSERT(refusal([&] { x.w(x.a, x.a, x.c, x.v1); }) == still);
  RC_ASSERT(refusal([&] { x.alpha(x.a, x.a, x.c, x.v1); }) == still);
}

// A chain gives another quantity, as with types: w_ab += w_bc would be w_ac.
template <class Rate>
concept ChainsInPlace = requires(Rate& rate) {
  rate += rate;
};
static_assert(!ChainsInPlace<NamedAngularVelocity> && !ChainsInPlace<NamedVelocity>);
template <class X>
concept Adds = requires(const X& x) {
  x + x;
};
static_assert(Adds<NamedAngularVelocity> && Adds<NamedDisplacement> && Adds<NamedVelocity>);
static_assert(!Adds<NamedAngularAcceleration>);  // chain() has the rates
// An edge refers to its graph, so the graph must have a name.
template <class Graph>
concept GivesAnEdge = requires(Graph&& graph) {
  std::forward<Graph>(graph).template typed_edge<Dcm<Gcrf, Body>>();
};
static_assert(GivesAnEdge<const NamedGraph&> && !GivesAnEdge<NamedGraph>);

RC_GTEST_PROP(NamedRate, FollowsTheLawsOfAngularVelocity, ()) {
  const Values x;
  const auto w_ab_c = x.w(x.b, x.a, x.c, x.v1);
  const auto w_bd_c = x.w(x.d, x.b, x.c, x.v2);
  for (const auto& w_ad_c : {w_ab_c + w_bd_c, w_bd_c + w_ab_c}) {
    RC_ASSERT(w_ad_c.of() == x.d && w_ad_c.relative_to() == x.a && w_ad_c.in() == x.c);
    RC_ASSERT(w_ad_c.coordinates() == x.v1 + x.v2);
  }
  const auto w_ba_c = -w_ab_c;
  RC_ASSERT(w_ba_c.of() == x.a && w_ba_c.relative_to() == x.b && w_ba_c.coordinates() == -x.v1);
  const auto w_ab_d = dcm(To(x.d), From(x.c), x.R1) * w_ab_c;
  RC_ASSERT(w_ab_d.of() == x.b && w_ab_d.in() == x.d);
  RC_ASSERT(distance(w_ab_d.coordinates(), x.R1 * x.v1) <= rounding);
  const auto alpha_ad_c = chain(x.alpha(x.b, x.a, x.c, x.v2), x.alpha(x.d, x.b, x.c, x.v1), w_ab_c, w_bd_c);
  RC_ASSERT(alpha_ad_c.of() == x.d && alpha_ad_c.relative_to() == x.a && alpha_ad_c.in() == x.c);
  RC_ASSERT(distance(alpha_ad_c.coordinates(), x.v2 + x.v1 + x.v1.cross(x.v2)) <= rounding);
}

RC_GTEST_PROP(NamedRate, PairsThatDoNotChainAreRefused, ()) {
  const Values x;
  const auto w_ab_c = x.w(x.b, x.a, x.c, x.v1);
  RC_ASSERT(
      refusal([&] { w_ab_c + x.w(x.d, x.c, x.c, x.v2); }) ==
      R"(sum of w of "b" relative to "a" in "c" and w of "d" relative to "c" in "c": "b" and "c" are two frames)");
  RC_ASSERT(
      refusal([&] { w_ab_c + x.w(x.d, x.b, x.a, x.v2); }) ==
      R"(sum of w of "b" relative to "a" in "c" and w of "d" relative to "b" in "a": "c" and "a" are two frames)");
  RC_ASSERT(
      refusal([&] { dcm(To(x.d), From(x.a), x.R1) * w_ab_c; }) ==
      R"(product of R to "d" from "a" and w of "b" relative to "a" in "c": "a" and "c" are two frames)");
  const auto alpha_ab_c = x.alpha(x.b, x.a, x.c, x.v1), alpha_bd_c = x.alpha(x.d, x.b, x.c, x.v1);
  const auto w_bd_c = x.w(x.d, x.b, x.c, x.v2);
  const auto refused = [&](const auto& a1, const auto& a2, const auto& w1, const auto& w2) {
    return contains(refusal([&] { chain(a1, a2, w1, w2); }), "chain of alpha of ");
  };
  RC_ASSERT(refused(alpha_bd_c, alpha_ab_c, w_ab_c, w_bd_c));
  RC_ASSERT(refused(alpha_ab_c, alpha_bd_c, w_bd_c, w_ab_c));
  RC_ASSERT(refused(alpha_ab_c, alpha_bd_c, w_ab_c, x.w(x.d, x.b, x.a, x.v2)));
  RC_ASSERT(refused(alpha_ab_c, alpha_bd_c, x.w(x.b, x.a, x.a, x.v2), w_bd_c));
  RC_ASSERT(refused(alpha_ab_c, x.alpha(x.d, x.b, x.a, x.v1), w_ab_c, w_bd_c));
  RC_ASSERT(refused(alpha_ab_c, alpha_bd_c, x.w(x.b, x.d, x.c, x.v2), w_bd_c));
  RC_ASSERT(refused(alpha_ab_c, alpha_bd_c, w_ab_c, x.w(x.a, x.b, x.c, x.v2)));
}

RC_GTEST_PROP(NamedDisplacement, FollowsTheLawsOfDisplacement, ()) {
  const Values x;
  const auto r_ab_c = x.r(x.b, x.a, x.c, x.v1), r_bd_c = x.r(x.d, x.b, x.c, x.v2);
  const auto v_ab_c = x.v(x.b, x.a, x.d, x.c, x.v1), v_bd_c = x.v(x.d, x.b, x.d, x.c, x.v2);
  for (const auto& r_ad_c : {r_ab_c + r_bd_c, r_bd_c + r_ab_c}) {
    RC_ASSERT(r_ad_c.of() == x.d && r_ad_c.relative_to() == x.a && r_ad_c.in() == x.c);
    RC_ASSERT(r_ad_c.coordinates() == x.v1 + x.v2);
  }
  for (const auto& v_ad_c : {v_ab_c + v_bd_c, v_bd_c + v_ab_c}) {
    RC_ASSERT(v_ad_c.of() == x.d && v_ad_c.relative_to() == x.a && v_ad_c.in() == x.c);
    RC_ASSERT(v_ad_c.observed_from() == x.d && v_ad_c.coordinates() == x.v1 + x.v2);
  }
  RC_ASSERT((-r_ab_c).of() == x.a && (-r_ab_c).relative_to() == x.b && (-r_ab_c).coordinates() == -x.v1);
  RC_ASSERT((-v_ab_c).of() == x.a && (-v_ab_c).relative_to() == x.b && (-v_ab_c).coordinates() == -x.v1);
  RC_ASSERT((-v_ab_c).observed_from() == x.d);
  const NamedDcm R_d_from_c = dcm(To(x.d), From(x.c), x.R1);
  const auto v_ab_d = R_d_from_c * v_ab_c;
  RC_ASSERT(v_ab_d.in() == x.d && v_ab_d.observed_from() == x.d && v_ab_d.of() == x.b);
  RC_ASSERT(distance(v_ab_d.coordinates(), x.R1 * x.v1) <= rounding);
  RC_ASSERT(
      refusal([&] { v_ab_c + x.v(x.d, x.b, x.a, x.c, x.v2); }) ==
      R"(sum of v of "b" relative to "a" observed from "d" in "c" and v of "d" relative to "b" observed from "a" in "c": "d" and "a" are two frames)");
  RC_ASSERT(
      refusal([&] { r_ab_c + x.r(x.d, x.c, x.c, x.v2); }) ==
      R"(sum of r of "b" relative to "a" in "c" and r of "d" relative to "c" in "c": "b" and "c" are two frames)");
  RC_ASSERT(
      refusal([&] { R_d_from_c* x.v(x.b, x.a, x.c, x.a, x.v1); }) ==
      R"(product of R to "d" from "c" and v of "b" relative to "a" observed from "c" in "a": "c" and "a" are two frames)");
  const std::string one = R"(of "a" relative to "a": a door takes two points, and these are one)";
  RC_ASSERT(refusal([&] { x.r(x.a, x.a, x.c, x.v1); }) == one);
  RC_ASSERT(refusal([&] { x.v(x.a, x.a, x.d, x.c, x.v1); }) == one);
  RC_ASSERT(refusal([&] { x.a_of(x.a, x.a, x.d, x.c, x.v1); }) == one);
}

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
  RC_ASSERT(contains(refusal([&] { transform(b, a, rough); }), R"((to<"b">, from<"a">): M^T M differs)"));
  const NearestNamedTransform nearest = nearest_transform(b, a, rough);
  const auto expected = nearest_transform(to<Body>, from<Gcrf>, rough);
  RC_ASSERT(homogeneous_matrix(nearest.transform) == homogeneous_matrix(expected.transform));
  RC_ASSERT(nearest.distance == expected.distance);
  m(3, 0) = 1.0;
  RC_ASSERT(refusal([&] { transform(b, a, m); }) ==
            R"(transform(to<"b">, from<"a">): entry (4, 1) is 1 instead of 0)");
  RC_ASSERT(refusal([&] { trust_transform(b, From(x.b), m); }) ==
            R"(to "b", from "b": a door takes two frames, and these are one)");
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

TEST(NamedValues, PrintWithTheirFrames) {
  NamedGraph graph;
  const NamedFrame a = graph.add_frame("a", FrameMotion::moving);
  const NamedFrame b = graph.add_frame("b", FrameMotion::moving);
  Eigen::Matrix3d quarter_turn;  // about z
  quarter_turn << 0, 1, 0, -1, 0, 0, 0, 0, 1;
  const NamedDcm R_a_from_b = dcm(To(a), From(b), quarter_turn);
  const Eigen::Vector3d v(1, 0, -2);
  const auto w_ab_b = angular_velocity(Of(b), RelativeTo(a), vector<si::angular_velocity>(In(b), v));
  const auto alpha_ab_b =
      angular_acceleration(Of(b), RelativeTo(a), vector<si::angular_acceleration>(In(b), v));
  const auto printed = [](const auto& value) {
    std::ostringstream out;
    out << value;
    return out.str();
  };
  EXPECT_EQ(printed(vector<si::length>(In(a), v)), R"((1, 0, -2) m in "a")");
  EXPECT_EQ(printed(quaternion_scalar_first(To(a), From(b), 1.0, 0.0, 0.0, 0.0)),
            R"((1; 0, 0, 0) to "a" from "b")");
  EXPECT_EQ(printed(accelerating_dcm(R_a_from_b, w_ab_b, alpha_ab_b)),
            R"([0 1 0; -1 0 0; 0 0 1] to "a" from "b"; (1, 0, -2) rad/s of "b" relative to "a" in "b"; )"
            R"((1, 0, -2) rad/s^2 of "b" relative to "a" in "b")");
  const auto r_ab_a = displacement(Of(b), RelativeTo(a), vector<si::length>(In(a), v));
  const auto v_ab_a = velocity(Of(b), RelativeTo(a), ObservedFrom(a), vector<si::velocity>(In(a), v));
  const auto a_ab_a = acceleration(Of(b), RelativeTo(a), ObservedFrom(a), vector<si::acceleration>(In(a), v));
  EXPECT_EQ(printed(NamedTransform{R_a_from_b, r_ab_a}),
            R"([0 1 0; -1 0 0; 0 0 1] to "a" from "b"; (1, 0, -2) m of "b" relative to "a" in "a")");
  const std::string moving = printed(moving_dcm(R_a_from_b, w_ab_b)) +
                             R"(; (1, 0, -2) m of "b" relative to "a" in "a"; )"
                             R"((1, 0, -2) m/s of "b" relative to "a" observed from "a" in "a")";
  EXPECT_EQ(printed(NamedMovingTransform{moving_dcm(R_a_from_b, w_ab_b), r_ab_a, v_ab_a}), moving);
  const auto whole = accelerating_dcm(R_a_from_b, w_ab_b, alpha_ab_b);
  EXPECT_EQ(printed(NamedAcceleratingTransform{whole, r_ab_a, v_ab_a, a_ab_a}),
            printed(whole) + moving.substr(moving.find("; (1, 0, -2) m of")) +
                R"(; (1, 0, -2) m/s^2 of "b" relative to "a" observed from "a" in "a")");
  EXPECT_EQ(printed(moving_dcm(R_a_from_b, w_ab_b)),
            R"([0 1 0; -1 0 0; 0 0 1] to "a" from "b"; (1, 0, -2) rad/s of "b" relative to "a" in "b")");
}

// Typed and named values do not mix. A door does not take a name, because a name does not belong to a graph
// yet.
template <class Left, class Right>
concept Multiplies = requires(const Left& left, const Right& right) {
  left* right;
};
template <class Frame>
concept IsADoor = requires(Frame b, const Eigen::Matrix3d& m) {
  dcm(To(b), From(b), m);
};
static_assert(Multiplies<NamedDcm, NamedDcm> && Multiplies<Dcm<Body, Gcrf>, Dcm<Gcrf, Itrf>>);
static_assert(!Multiplies<NamedDcm, Dcm<Gcrf, Itrf>> && !Multiplies<Dcm<Body, Gcrf>, NamedDcm>);
static_assert(!Multiplies<NamedDcm, Vector<Gcrf, si::length>>);
static_assert(!Multiplies<NamedTransform, Displacement<Gcrf, Body, In<Gcrf>>>);
static_assert(IsADoor<NamedFrame> && !IsADoor<std::string_view>);

}  // namespace
}  // namespace values_test
