#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vectrix/frames/dcm_doors.hpp>
#include <vectrix/kinematics/attitude/axis_angle.hpp>
#include <vectrix/kinematics/attitude/exp.hpp>
#include <vectrix/kinematics/attitude/gibbs_vector.hpp>
#include <vectrix/kinematics/attitude/modified_rodrigues.hpp>

#include "testing/attitudes.hpp"

using namespace vectrix;
using namespace vectrix_test;

namespace rodrigues_test {
namespace {

using std::numbers::pi;
using Extended = Eigen::Matrix<long double, 3, 1>;

/// Relative: a sum, a quotient and a tangent of long double round once each, a norm rounds three times.
constexpr double few_ulps = 6 * epsilon;

ModifiedRodrigues<Gcrf, Body> sigma_of(const Eigen::Vector3d& numbers) {
  return modified_rodrigues(of<Body>, relative_to<Gcrf>, vector<si::dimensionless>(in<Gcrf>, numbers));
}
GibbsVector<Gcrf, Body> gibbs_of(const Eigen::Vector3d& numbers) {
  return gibbs_vector(of<Body>, relative_to<Gcrf>, vector<si::dimensionless>(in<Body>, numbers));
}
Quaternion<Gcrf, Body> turn(long double angle, const Eigen::Vector3d& axis) {
  const Extended v = std::sin(angle / 2) * axis.cast<long double>();
  return quaternion_scalar_first(to<Gcrf>, from<Body>, double(std::cos(angle / 2)), double(v.x()),
                                 double(v.y()), double(v.z()));
}
RotationVector<Gcrf, Body> theta_of(const Eigen::Vector3d& theta) {
  return rotation_vector(of<Body>, relative_to<Gcrf>, vector<si::angle>(in<Gcrf>, theta));
}
/// Angles from 1e-300 to almost a full turn.
std::vector<double> angles() {
  std::vector<double> list{0.5, 1, 2, 3, 3.14, pi - 1e-6, pi - 1e-10, pi, pi + 1e-6, 4, 5, 6, 6.28};
  for (double angle = 0.1; angle > 1e-300; angle /= 317) list.push_back(angle);
  return list;
}
const Eigen::Vector3d axes[] = {Eigen::Vector3d(2, -1, 2) / 3, Eigen::Vector3d::UnitZ(),
                                Eigen::Vector3d(-0.6, 0, 0.8)};

// sigma = n tan(phi/4), g = n tan(phi/2): from the numbers of q = (cos phi/2, n sin phi/2), in long double.
TEST(Rodrigues, AreTheTangentsToRounding) {
  for (const double angle : angles()) {
    for (const auto& axis : axes) {
      const auto q = turn(angle, axis);
      const Extended v = q.eigen().vec().cast<long double>();
      const auto w = static_cast<long double>(q.eigen().w());
      const Extended sigma = w < 0 ? Extended(-v / (1 - w)) : Extended(v / (1 + w));
      EXPECT_LE((modified_rodrigues(q).coordinates().cast<long double>() - sigma).norm(),
                few_ulps * sigma.norm());
      EXPECT_LE((quaternion(sigma_of(sigma.cast<double>())).eigen().vec().cast<long double>() -
                 (w < 0 ? Extended(-v) : v))
                    .norm(),
                few_ulps * v.norm());
      if (angle == pi) continue;
      const Extended g = v / w;
      EXPECT_LE((gibbs_vector(q).coordinates().cast<long double>() - g).norm(), few_ulps * g.norm());
      const long double factor = std::tan(static_cast<long double>(angle) / 4);
      if (angle < 3) {
        EXPECT_LE(
            (modified_rodrigues(q).coordinates().cast<long double>() - factor * axis.cast<long double>())
                .norm(),
            few_ulps * factor);
      }
    }
  }
}

RC_GTEST_PROP(ModifiedRodrigues, OfEveryRotationAreTheShorterAndComeBack, ()) {
  const auto R = trust_dcm(to<Gcrf>, from<Body>, *rotation_matrix());
  const auto sigma = modified_rodrigues(R);
  RC_ASSERT(sigma.coordinates().norm() <= 1 + few_ulps);
  RC_ASSERT(distance(dcm(sigma).matrix(), R.matrix()) <= rounding);
  RC_ASSERT(distance(modified_rodrigues(dcm(sigma)).coordinates(), sigma.coordinates()) <= rounding ||
            sigma.coordinates().norm() > 1 - rounding);
}

RC_GTEST_PROP(ModifiedRodrigues, AndTheirShadowAreTheSameRotation, ()) {
  const auto sigma = sigma_of(5 * *triple() + Eigen::Vector3d(1e-7, 0, 0));
  const auto shadow = sigma.shadow();
  RC_ASSERT(distance(dcm(sigma).matrix(), dcm(shadow).matrix()) <= rounding);
  const double product = sigma.coordinates().norm() * shadow.coordinates().norm();
  RC_ASSERT(std::abs(product - 1) <= few_ulps);
  RC_ASSERT(distance(shadow.shadow().coordinates(), sigma.coordinates()) <=
            few_ulps * sigma.coordinates().norm());
}

TEST(ModifiedRodrigues, SwitchOnlyWhenLongerThanOneAndSayIt) {
  const auto shorter = sigma_of({0.6, -0.3, 0.5});
  const auto kept = switch_to_shadow(shorter);
  EXPECT_FALSE(kept.switched);
  EXPECT_EQ(kept.parameters.coordinates(), shorter.coordinates());
  const auto changed = switch_to_shadow(sigma_of({1.5, -2, 0}));
  EXPECT_TRUE(changed.switched);
  EXPECT_LE(distance(changed.parameters.coordinates(), Eigen::Vector3d(-0.24, 0.32, 0)), epsilon);
  const auto half = switch_to_shadow(sigma_of({0, -1, 0}));  // equal length, so it is not switched
  EXPECT_FALSE(half.switched);
  EXPECT_EQ(half.parameters.coordinates().y(), -1);
}

TEST(ModifiedRodrigues, AtHalfATurnTheFirstNonZeroComponentIsPositive) {
  for (const double sign : {1.0, -1.0}) {
    const auto q = quaternion_scalar_first(to<Gcrf>, from<Body>, 0.0, 0.0, sign * 0.6, -sign * 0.8);
    EXPECT_LE(distance(modified_rodrigues(q).coordinates(), Eigen::Vector3d(0, 0.6, -0.8)), epsilon);
  }
}

// sigma_BA of Basilisk is v/(1 + w) of q_a_from_b: a quarter turn about z is tan(22.5 deg) along z. Its
// matrix, transposed, is dcm_BA = [0 1 0; -1 0 0; 0 0 1].
TEST(ModifiedRodrigues, OfAQuarterTurnHaveTheirPublishedNumbers) {
  const auto sigma = sigma_of({0, 0, std::tan(pi / 8)});
  Eigen::Matrix3d dcm_BA;
  dcm_BA << 0, 1, 0, -1, 0, 0, 0, 0, 1;
  EXPECT_LE(distance(inverse(dcm(sigma)).matrix(), dcm_BA), rounding);
  EXPECT_LE(
      distance(modified_rodrigues(inverse(turned_z(to<Body>, from<Gcrf>, pi / 2 * si::radian))).coordinates(),
               Eigen::Vector3d(0, 0, std::sqrt(2.0) - 1)),
      epsilon);
}

// R = (I + [g]x)(I - [g]x)^-1, Cayley's form.
RC_GTEST_PROP(GibbsVector, IsCayleysForm, ()) {
  const Eigen::Vector3d g = 3 * *triple();
  const Eigen::Matrix3d I = Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d cayley = (I + hat(g)) * (I - hat(g)).inverse();
  RC_ASSERT(distance(dcm(gibbs_of(g)).matrix(), cayley) <= 16 * rounding);
  RC_ASSERT(distance(gibbs_vector(quaternion(gibbs_of(g))).coordinates(), g) <= rounding * (1 + g.norm()));
}

TEST(GibbsVector, ComesBackToRoundingNearHalfATurn) {
  for (const double size : {1e3, 1e6, 1e9, 1e12, 1e14}) {
    const auto g = gibbs_of(size * axes[0]);
    EXPECT_LE((gibbs_vector(quaternion(g)).coordinates() - g.coordinates()).norm(), few_ulps * size);
    EXPECT_NEAR(g.distance_from_singularity().value() * size / 2, 1, 1 / size + few_ulps);
  }
}

TEST(GibbsVector, OfHalfATurnIsBadInputThatSaysHowNear) {
  const auto half = message<BadInput>([] { gibbs_vector(turn(pi, axes[1])); });
  EXPECT_TRUE(contains(half, "gibbs_vector(Gibbs vector of ")) << half;
  EXPECT_TRUE(contains(half, "Gcrf): 1.2246467991473532e-16 rad from the singularity, half a turn")) << half;
  EXPECT_NE(message<BadInput>([] { gibbs_vector(dcm(turn(pi, axes[0]))); }), "");
  EXPECT_EQ(message<BadInput>([] { gibbs_vector(turn(pi - 1e-14, axes[0])); }), "");
}

TEST(Rodrigues, TheirDoorsTakeFiniteNumbersAwayFromTheSingularity) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto huge = message<BadInput>([] { sigma_of({0, 1e20, 0}); });
  EXPECT_TRUE(contains(huge, "modified_rodrigues(modified Rodrigues parameters of ")) << huge;
  EXPECT_TRUE(contains(huge, "4e-20 rad from the singularity, a full turn")) << huge;
  const auto gibbs = message<BadInput>([] { gibbs_of({-1e300, 0, 0}); });
  EXPECT_TRUE(contains(gibbs, "2e-300 rad from the singularity, half a turn")) << gibbs;
  const auto none = message<BadInput>([] { static_cast<void>(sigma_of({1e-17, 0, 0}).shadow()); });
  EXPECT_TRUE(contains(none, "shadow(modified Rodrigues parameters of ")) << none;
  EXPECT_TRUE(contains(none, "4e-17 rad from the singularity, a full turn")) << none;
  EXPECT_NE(message<BadInput>([=] { sigma_of({0, nan, 0}); }), "");
  EXPECT_NE(message<BadInput>([=] { gibbs_of({0, nan, 0}); }), "");
}

// The vector is the same in both frames. Its negative is that of the inverse rotation, and its length depends
// only on the angle.
RC_GTEST_PROP(Rodrigues, AreVectorsAlongTheAxis, ()) {
  const Eigen::Vector3d theta = *triple() + Eigen::Vector3d(1e-3, 0, 0);
  const auto R = exp(theta_of(theta));
  const auto sigma = modified_rodrigues(R);
  const auto g = gibbs_vector(R);
  RC_ASSERT(distance(sigma.coordinates(), std::tan(theta.norm() / 4) * theta.normalized()) <= rounding);
  RC_ASSERT(distance(g.coordinates(), std::tan(theta.norm() / 2) * theta.normalized()) <= 4 * rounding);
  RC_ASSERT(distance((R * g.in_turned()).coordinates(), g.in_reference().coordinates()) <= rounding);
  const ModifiedRodrigues<Body, Gcrf> back = -sigma;
  const GibbsVector<Body, Gcrf> g_back = -g;
  RC_ASSERT(distance(dcm(back).matrix(), inverse(R).matrix()) <= rounding);
  RC_ASSERT(distance(dcm(g_back).matrix(), inverse(R).matrix()) <= rounding);
  const double away = sigma.distance_from_singularity().value() + theta.norm() - 2 * pi;
  const double g_away = g.distance_from_singularity().value() + theta.norm() - pi;
  RC_ASSERT(std::abs(away) <= rounding && std::abs(g_away) <= rounding);
}

TEST(Rodrigues, SayWhatTheyAre) {
  std::ostringstream out;
  out << sigma_of({0.5, 0, 0.25}) << "; " << gibbs_of({1, 2, 3});
  const std::string whose = " of " + frame_name<Body>() + " relative to " + frame_name<Gcrf>();
  EXPECT_EQ(out.str(),
            "(0.5, 0, 0.25), modified Rodrigues parameters" + whose + "; (1, 2, 3), Gibbs vector" + whose);
}

}  // namespace
}  // namespace rodrigues_test
