#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <type_traits>
#include <vectrix/frames/graph/frame_graph.hpp>

#include "testing/attitudes.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace dcm_chain_test {
namespace {

/// Five products of rotations, with vectors of length up to sqrt(3).
constexpr double of_five = 4 * rounding;

template <class B, class A> Dcm<B, A> any_dcm() {
  return trust_dcm(to<B>, from<A>, *rotation_matrix());
}

// R_a^f r^a, for every order of multiplication.
RC_GTEST_PROP(DcmChain, EveryOrderOfWritingGivesTheSameVector, ()) {
  const auto R1 = any_dcm<Body, Gcrf>();
  const auto R2 = any_dcm<Camera, Body>();
  const auto R3 = any_dcm<Wheel<1>, Camera>();
  const auto R4 = any_dcm<Wheel<2>, Wheel<1>>();
  const auto R5 = any_dcm<Wheel<3>, Wheel<2>>();
  const auto r = vector<si::length>(in<Gcrf>, *triple());
  const Eigen::Vector3d expected =
      R5.matrix() * R4.matrix() * R3.matrix() * R2.matrix() * R1.matrix() * r.coordinates();
  const auto agrees = [&](const Vector<Wheel<3>, si::length>& turned) {
    return distance(turned.coordinates(), expected) <= of_five;
  };
  RC_ASSERT(agrees(R5 * R4 * R3 * R2 * R1 * r));
  RC_ASSERT(agrees(R5 * (R4 * (R3 * (R2 * (R1 * r))))));
  RC_ASSERT(agrees((R5 * (R4 * (R3 * (R2 * R1)))) * r));
  RC_ASSERT(agrees((R5 * R4) * ((R3 * R2) * R1) * r));
  RC_ASSERT(agrees((R5 * R4 * R3) * (R2 * R1) * r));
  RC_ASSERT(agrees((R5 * R4) * R3 * (R2 * (R1 * r))));
  const auto named = R5 * R4 * R3;
  RC_ASSERT(agrees(named * R2 * R1 * r));
  RC_ASSERT(agrees(named * (R2 * R1) * r));
}

RC_GTEST_PROP(DcmChain, CarriesWhatIsBetweenPointsToo, ()) {
  const auto R_b_from_a = any_dcm<Body, Gcrf>();
  const auto R_c_from_b = any_dcm<Camera, Body>();
  const auto r_a = displacement(of<Wheel<1>>, relative_to<Wheel<2>>, vector<si::length>(in<Gcrf>, *triple()));
  const Displacement<Wheel<2>, Wheel<1>, In<Camera>> r_c = R_c_from_b * R_b_from_a * r_a;
  RC_ASSERT(distance(r_c.coordinates(), R_c_from_b.matrix() * R_b_from_a.matrix() * r_a.coordinates()) <=
            of_five);
}

// A chain stored under a name is the Dcm: it is multiplied once, and later changes of its factors have no
// effect.
RC_GTEST_PROP(DcmChain, WithANameItIsTheProduct, ()) {
  auto R_b_from_a = any_dcm<Body, Gcrf>();
  const auto R_c_from_b = any_dcm<Camera, Body>();
  const auto r_a = vector<si::length>(in<Gcrf>, *triple());
  const Eigen::Matrix3d product = R_c_from_b.matrix() * R_b_from_a.matrix();
  const auto chain = R_c_from_b * R_b_from_a;
  const Dcm<Camera, Gcrf> R_c_from_a = R_c_from_b * R_b_from_a;
  const Dcm<Camera, Gcrf> copied = chain;
  R_b_from_a = aligned(to<Body>, from<Gcrf>);
  RC_ASSERT(chain.matrix() == product);
  RC_ASSERT(R_c_from_a.matrix() == product);
  RC_ASSERT(copied.matrix() == product);
  RC_ASSERT((chain * r_a).coordinates() == product * r_a.coordinates());
  RC_ASSERT(inverse(chain).matrix() == product.transpose());
}

/// Ten products, with vectors of length up to sqrt(3).
constexpr double of_ten = 8 * rounding;

// Beyond its maximum length, a chain continues from the product of its first rotations, in whatever way it is
// written.
RC_GTEST_PROP(DcmChain, GoesOnPastItsGreatestLength, ()) {
  const auto P = any_dcm<Body, Gcrf>();
  const auto Q = any_dcm<Gcrf, Body>();
  const auto r = vector<si::length>(in<Gcrf>, *triple());
  Eigen::Vector3d expected = r.coordinates();
  for (int i = 0; i < 5; ++i) expected = Q.matrix() * (P.matrix() * expected).eval();
  const auto agrees = [&](const Vector<Gcrf, si::length>& turned) {
    return distance(turned.coordinates(), expected) <= of_ten;
  };
  RC_ASSERT(agrees(Q * P * Q * P * Q * P * Q * P * Q * P * r));
  RC_ASSERT(agrees(Q * (P * (Q * (P * (Q * (P * (Q * (P * (Q * P)))))))) * r));
  RC_ASSERT(agrees((Q * P * Q * P * Q * P) * (Q * P * Q * P) * r));
  const auto R = Q * P * Q * P * Q * P * Q * P * Q * P;
  static_assert(std::is_same_v<decltype(R), const DcmChain<Gcrf, Gcrf, 3>>);
  RC_ASSERT(agrees(R * r));
}

/// The rotations made in a function do not exist after it has returned their product.
auto product_of_locals(const Eigen::Matrix3d& first, const Eigen::Matrix3d& second) {
  const auto R_b_from_a = trust_dcm(to<Body>, from<Gcrf>, first);
  const auto R_c_from_b = trust_dcm(to<Camera>, from<Body>, second);
  return R_c_from_b * R_b_from_a;
}

RC_GTEST_PROP(DcmChain, OutlivesItsFactors, ()) {
  const Eigen::Matrix3d first = *rotation_matrix();
  const Eigen::Matrix3d second = *rotation_matrix();
  const auto R_d_from_c = any_dcm<Wheel<1>, Camera>();
  const auto r_a = vector<si::length>(in<Gcrf>, *triple());
  const Eigen::Vector3d expected = second * first * r_a.coordinates();
  RC_ASSERT(distance((product_of_locals(first, second) * r_a).coordinates(), expected) <= of_five);
  const auto kept = product_of_locals(first, second);
  RC_ASSERT(distance((kept * r_a).coordinates(), expected) <= of_five);
  RC_ASSERT(distance((R_d_from_c * product_of_locals(first, second) * r_a).coordinates(),
                     R_d_from_c.matrix() * expected) <= of_five);
  auto moved = product_of_locals(first, second);
  RC_ASSERT(distance((R_d_from_c * std::move(moved) * r_a).coordinates(), R_d_from_c.matrix() * expected) <=
            of_five);
}

Eigen::Matrix3d rotation_about_z(double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

TEST(DcmChain, StandsWhereADcmStands) {
  const auto R_b_from_a = trust_dcm(to<Body>, from<Gcrf>, rotation_about_z(0.3));
  const auto R_c_from_b = trust_dcm(to<Camera>, from<Body>, rotation_about_z(0.4));
  const auto about = rotation_about_z(0.7);
  const auto same = [&](const Dcm<Camera, Gcrf>& R) { return distance(R.matrix(), about) <= rounding; };
  EXPECT_TRUE(same(R_c_from_b * R_b_from_a));
  EXPECT_TRUE(same(true ? R_c_from_b * R_b_from_a : aligned(to<Camera>, from<Gcrf>)));
  const auto graph = frame_graph(static_edge(R_c_from_b * R_b_from_a));
  EXPECT_TRUE(same(graph.at(0.0 * si::second).rotation(to<Camera>, from<Gcrf>)));
  const auto moving = frame_graph(edge([&](const Quantity<si::time>&) { return R_c_from_b * R_b_from_a; }));
  EXPECT_TRUE(same(moving.at(0.0 * si::second).rotation(to<Camera>, from<Gcrf>)));
  const Transform X{R_c_from_b * R_b_from_a, coincident(of<Gcrf>, relative_to<Camera>, in<Camera>)};
  EXPECT_TRUE(same(X.rotation));
  Dcm<Gcrf, Gcrf> R_a_from_a = inverse(R_b_from_a) * R_b_from_a;
  R_a_from_a *= inverse(R_b_from_a) * R_b_from_a;
  EXPECT_LE(distance(R_a_from_a.matrix(), Eigen::Matrix3d::Identity()), rounding);
}

void replace(Dcm<Camera, Gcrf>& R_c_from_a) {
  R_c_from_a = trust_dcm(to<Camera>, from<Gcrf>, rotation_about_z(1.0));
}

TEST(DcmChain, TakesAnotherRotation) {
  const auto R_b_from_a = trust_dcm(to<Body>, from<Gcrf>, rotation_about_z(0.3));
  const auto R_c_from_b = trust_dcm(to<Camera>, from<Body>, rotation_about_z(0.4));
  const Eigen::Matrix3d other = rotation_about_z(1.0);
  const auto x = unit_x(in<Gcrf>);
  auto R_c_from_a = R_c_from_b * R_b_from_a;
  replace(R_c_from_a);
  EXPECT_EQ((R_c_from_a * x).coordinates(), other.col(0));
  const auto copy = [R_c_from_a] { return R_c_from_a; };
  EXPECT_LE(distance((copy() * x).coordinates(), other.col(0)), rounding);
  R_c_from_a = R_c_from_b * R_b_from_a;
  EXPECT_LE(distance((copy() * x).coordinates(), other.col(0)), rounding);
  EXPECT_LE(distance((R_c_from_a * x).coordinates(), rotation_about_z(0.7).col(0)), rounding);
  const auto copied_now = [R_c_from_a] { return R_c_from_a; };
  EXPECT_LE(distance((copied_now() * x).coordinates(), rotation_about_z(0.7).col(0)), rounding);
  EXPECT_LE(distance((inverse(R_b_from_a) * (inverse(R_c_from_b) * copied_now()) * x).coordinates(),
                     Eigen::Vector3d::UnitX()),
            rounding);
}

static_assert(!std::is_move_constructible_v<DcmChain<Camera, Gcrf, 2>>);

TEST(DcmChain, KeepsTheScalar) {
  using Column = Eigen::Matrix<long double, 3, 1>;
  const Eigen::Matrix<long double, 3, 3> turn{{0.6L, -0.8L, 0.0L}, {0.8L, 0.6L, 0.0L}, {0.0L, 0.0L, 1.0L}};
  const auto R = trust_dcm(to<Body>, from<Gcrf>, turn);
  const Vector<Body, si::dimensionless, long double> x = R * inverse(R) * unit_x<Body, long double>(in<Body>);
  EXPECT_LE((x.coordinates() - Column::UnitX()).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(),
            16 * std::numeric_limits<long double>::epsilon());
}

}  // namespace
}  // namespace dcm_chain_test
