#include <sstream>
#include <vectrix/dynamics/force/wrench.hpp>
#include <vectrix/kinematics/screws/twist.hpp>

#include "forces.hpp"

// Wrenches about a point, against sums over forces.
namespace vectrix::test::wrench_test {
namespace {

using BodyWrench = Wrench<Hinge, In<Body>>;

constexpr double rounding = 1e-13;  // some tens of operations on numbers of order 1

TEST(Wrench, law1_about_one_point_they_add) {
  Draw draw(6);
  for (int i = 0; i < 100; ++i) {
    const auto arrows = random_arrows(draw);
    const Vector3d p = draw.triple();
    BodyWrench W = wrench(zero<si::force>(in<Body>), torque_about<Hinge>(zero<si::torque>(in<Body>)));
    for (const auto& [r, F] : arrows)
      W = W + shift(force_through<Thruster>(force(F)), from_to<Thruster, Hinge>(p - r));
    EXPECT_LT((W.force().coordinates() - sum_of(arrows)).norm(), rounding);
    EXPECT_LT((W.torque().coordinates() - moment_about(p, arrows)).norm(), rounding);
    const BodyWrench same = -W + 3.0 * W - W * 0.5;
    EXPECT_LT((same.force().coordinates() - 1.5 * W.force().coordinates()).norm(), rounding);
    EXPECT_LT((same.torque().coordinates() - 1.5 * W.torque().coordinates()).norm(), rounding);
  }
}

/// A wrench re-expressed and then shifted equals one shifted and then re-expressed.
TEST(Wrench, law2_reexpression_and_shift_commute) {
  Draw draw(7);
  for (int i = 0; i < 100; ++i) {
    const auto R = trust_dcm(to<Camera>, from<Body>, draw.rotation());
    const auto W_p = wrench(force(draw.triple()), torque_about<Thruster>(newton_metres(draw.triple())));
    const auto r_pq = from_to<Thruster, Hinge>(draw.triple());
    const Wrench<Hinge, In<Camera>> shifted_first = R * shift(W_p, r_pq);
    const Wrench<Hinge, In<Camera>> turned_first = shift(R * W_p, R * r_pq);
    EXPECT_EQ(shifted_first.force().coordinates(), R.matrix() * W_p.force().coordinates());
    EXPECT_LT((shifted_first.torque().coordinates() - turned_first.torque().coordinates()).norm(), rounding);
  }
}

TEST(Wrench, law3_shift_keeps_the_force_and_there_and_back_is_the_same) {
  const auto W_p =
      wrench(force({4.0, 5.0, 7.0}), torque_about<Thruster>(newton_metres(Vector3d(10.0, 20.0, 30.0))));
  const auto r_pq = from_to<Thruster, Hinge>({1.0, 2.0, 3.0});
  const BodyWrench W_q = shift(W_p, r_pq);
  EXPECT_EQ(W_q.force().coordinates(), Vector3d(4.0, 5.0, 7.0));
  EXPECT_EQ(W_q.torque().coordinates(), Vector3d(11.0, 15.0, 33.0));
  const Wrench<Thruster, In<Body>> back = shift(W_q, -r_pq);
  EXPECT_EQ(back.torque().coordinates(), Vector3d(10.0, 20.0, 30.0));
}

/// F . v + M . w, the power of a wrench on a rigid body, is the same at all points of the body.
TEST(Wrench, its_power_does_not_depend_on_the_point) {
  Draw draw(8);
  for (int i = 0; i < 100; ++i) {
    const auto W_p = wrench(force(draw.triple()), torque_about<Thruster>(newton_metres(draw.triple())));
    const auto V_p =
        twist(at<Thruster>, rate_body(draw.triple()), vector<si::velocity>(in<Body>, draw.triple()));
    const auto r_pq = from_to<Thruster, Hinge>(draw.triple());
    const auto power = [](const auto& W, const auto& V) {
      return dot(W.force(), V.velocity()).value() + dot(W.torque().vector(), V.angular_velocity()).value();
    };
    EXPECT_NEAR(power(shift(W_p, r_pq), shift(V_p, r_pq)), power(W_p, V_p), 10 * rounding);
  }
}

TEST(Wrench, says_its_force_and_its_torque) {
  const auto F = force({4.0, 5.0, 6.0});
  const auto M = torque_about<Hinge>(newton_metres({1.0, -2.0, 0.5}));
  std::ostringstream said, parts;
  said << wrench(F, M);
  parts << F << "; " << M;
  EXPECT_EQ(said.str(), parts.str());
}

template <class Left, class Right>
concept Adds = requires(const Left& left, const Right& right) {
  left + right;
};
template <class Left, class Right>
concept Multiplies = requires(const Left& left, const Right& right) {
  left* right;
};
template <class... Given>
concept Shifts = requires(const Given&... given) {
  shift(given...);
};

using ToHinge = Displacement<Thruster, Hinge, In<Body>>;
static_assert(!Adds<BodyWrench, Wrench<Thruster, In<Body>>>);
static_assert(!Adds<BodyWrench, Wrench<Hinge, In<Camera>>>);
static_assert(!Multiplies<Dcm<Body, Camera>, BodyWrench>);
static_assert(Shifts<Wrench<Thruster, In<Body>>, ToHinge>);
static_assert(!Shifts<BodyWrench, ToHinge>);
static_assert(!Shifts<Wrench<Thruster, In<Camera>>, ToHinge>);
static_assert(sizeof(BodyWrench) == 2 * sizeof(Vector3d));

}  // namespace
}  // namespace vectrix::test::wrench_test
