#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <utility>

#include "named_values.hpp"

namespace values_test {
namespace {

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
      refusal([&] { w_ab_c + x.w(x.b, x.a, x.c, x.v2); }) ==
      R"(sum of w of "b" relative to "a" in "c" and w of "b" relative to "a" in "c": one pair twice; a sum has ab and bd)");
  RC_ASSERT(
      refusal([&] { w_ab_c + x.w(x.d, x.b, x.a, x.v2); }) ==
      R"(sum of w of "b" relative to "a" in "c" and w of "d" relative to "b" in "a": "c" and "a" are two frames)");
  RC_ASSERT(
      refusal([&] { dcm(To(x.d), From(x.a), x.R1) * w_ab_c; }) ==
      R"(product of R to "d" from "a" and w of "b" relative to "a" in "c": "a" and "c" are two frames)");
  const auto alpha_ab_c = x.alpha(x.b, x.a, x.c, x.v1), alpha_bd_c = x.alpha(x.d, x.b, x.c, x.v1);
  const auto w_bd_c = x.w(x.d, x.b, x.c, x.v2);
  const auto refused = [&](const auto& a1, const auto& a2, const auto& w1, const auto& w2) {
    return contains(refusal([&] { chain(a1, a2, w1, w2); }), "chain(alpha of ");
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
  const std::string one = R"((of "a", relative to "a"): a door takes two points, and these are one)";
  RC_ASSERT(refusal([&] { x.r(x.a, x.a, x.c, x.v1); }) == "displacement" + one);
  RC_ASSERT(refusal([&] { x.v(x.a, x.a, x.d, x.c, x.v1); }) == "velocity" + one);
  RC_ASSERT(refusal([&] { x.a_of(x.a, x.a, x.d, x.c, x.v1); }) == "acceleration" + one);
}

}  // namespace
}  // namespace values_test
