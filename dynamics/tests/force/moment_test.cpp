#include <sstream>
#include <vectrix/dynamics/rigid/euler.hpp>

#include "forces.hpp"

// Torques and angular momenta about a point, against sums over forces and masses.
namespace vectrix::test::moment_test {
namespace {

using BodyTorque = Torque<Hinge, In<Body>>;
using BodyMomentum = AngularMomentum<Hinge, In<Body>>;

constexpr double rounding = 1e-13;  // some tens of operations on numbers of order 1

TEST(Moment, of_a_force_and_of_a_momentum_is_r_cross_it) {
  const auto r = from_to<Hinge, Thruster>({1.0, 2.0, 3.0});
  const BodyTorque M = moment(r, force({4.0, 5.0, 7.0}));
  const BodyMomentum H = moment(r, momentum({4.0, 5.0, 7.0}));
  EXPECT_EQ(M.coordinates(), Vector3d(-1.0, 5.0, -3.0));
  EXPECT_EQ(H.coordinates(), Vector3d(-1.0, 5.0, -3.0));
}

TEST(Moment, law1_about_one_point_they_add) {
  Draw draw(1);
  for (int i = 0; i < 100; ++i) {
    const auto arrows = random_arrows(draw);
    const Vector3d p = draw.triple();
    BodyTorque M = torque_about<Hinge>(zero<si::torque>(in<Body>));
    for (const auto& [r, F] : arrows) M = M + moment(from_to<Hinge, Thruster>(r - p), force(F));
    EXPECT_LT((M.coordinates() - moment_about(p, arrows)).norm(), rounding);
    const BodyTorque same = -M + 3.0 * M - M * 0.5;
    EXPECT_LT((same.coordinates() - 1.5 * M.coordinates()).norm(), rounding);
  }
}

TEST(Moment, law2_reexpression_keeps_the_point) {
  Draw draw(2);
  const Dcm<Camera, Body> R = trust_dcm(to<Camera>, from<Body>, draw.rotation());
  const Vector3d M = draw.triple();
  const Torque<Hinge, In<Camera>> M_camera = R * torque_about<Hinge>(newton_metres(M));
  EXPECT_EQ(M_camera.coordinates(), R.matrix() * M);
  const AngularMomentum<Hinge, In<Camera>> H_camera =
      R * angular_momentum_about<Hinge>(vector<si::angular_momentum>(in<Body>, M));
  EXPECT_EQ(H_camera.coordinates(), R.matrix() * M);
}

TEST(Moment, law3_shift_has_its_sign) {
  const auto M_p = torque_about<Thruster>(newton_metres(Vector3d(10.0, 20.0, 30.0)));
  const auto r_pq = from_to<Thruster, Hinge>({1.0, 2.0, 3.0});
  const BodyTorque M_q = shift(M_p, r_pq, force({4.0, 5.0, 7.0}));
  EXPECT_EQ(M_q.coordinates(), Vector3d(11.0, 15.0, 33.0));
}

TEST(Moment, law3_shift_gives_the_sum_about_the_new_point) {
  Draw draw(3);
  for (int i = 0; i < 100; ++i) {
    const auto arrows = random_arrows(draw);
    const Vector3d p = draw.triple(), q = draw.triple();
    const auto r_pq = from_to<Thruster, Hinge>(q - p);
    const auto M_p = torque_about<Thruster>(newton_metres(moment_about(p, arrows)));
    const auto H_p =
        angular_momentum_about<Thruster>(vector<si::angular_momentum>(in<Body>, moment_about(p, arrows)));
    const BodyTorque M_q = shift(M_p, r_pq, force(sum_of(arrows)));
    const BodyMomentum H_q = shift(H_p, r_pq, momentum(sum_of(arrows)));
    EXPECT_LT((M_q.coordinates() - moment_about(q, arrows)).norm(), rounding);
    EXPECT_LT((H_q.coordinates() - moment_about(q, arrows)).norm(), rounding);
  }
}

/// H_p = J_c w + m v_c x r_cp of a rigid body; checked against the velocities v_c + w x (r_k - c) of its
/// masses.
TEST(Moment, the_momentum_of_a_rigid_body_about_any_point) {
  Draw draw(4);
  for (int i = 0; i < 100; ++i) {
    std::vector<Vector3d> r;
    Vector3d c = Vector3d::Zero();
    for (int k = 0; k < 6; ++k) {
      r.push_back(draw.triple());
      c += r.back() / 6.0;
    }
    const Vector3d v = draw.triple(), w = draw.triple(), p = draw.triple();
    Matrix3d J = Matrix3d::Zero();
    std::vector<Arrow> momenta;
    for (const Vector3d& r_k : r) {
      const Vector3d d = r_k - c;
      J += 2.0 * (d.squaredNorm() * Matrix3d::Identity() - d * d.transpose());
      momenta.push_back({r_k, 2.0 * (v + w.cross(d))});
    }
    const auto H_c = angular_momentum_about<CentreOfMassOf<Body>>(trust_inertia(in<Body>, J) * rate_body(w));
    const BodyMomentum H_p = shift(H_c, from_to<CentreOfMassOf<Body>, Hinge>(p - c), momentum(12.0 * v));
    EXPECT_LT((H_p.coordinates() - moment_about(p, momenta)).norm(), 10 * rounding);
  }
}

TEST(Moment, a_torque_about_the_centre_of_mass_drives_euler) {
  Draw draw(5);
  const Inertia<Body> J_b = tensor(3.0, 4.0, 5.0, 0.1, 0.2, -0.3);
  const BodyRate w_b = rate_body(draw.triple());
  const auto M_b = newton_metres(draw.triple());
  EXPECT_EQ(euler(J_b, w_b, torque_about<CentreOfMassOf<Body>>(M_b)).coordinates(),
            euler(J_b, w_b, M_b).coordinates());
}

template <class T> std::string printed(const T& value) {
  std::ostringstream out;
  out << value;
  return out.str();
}

TEST(Print, a_moment_says_its_unit_point_and_frame) {
  const std::string body = " in " + frame_name<Body>(), about_hinge = " about " + frame_name<Hinge>();
  const auto M = torque_about<Hinge>(newton_metres(Vector3d(1.0, -2.0, 0.5)));
  EXPECT_EQ(printed(M), "(1, -2, 0.5) N m" + about_hinge + body);
  EXPECT_EQ(printed(angular_momentum_about<Hinge>(zero<si::angular_momentum>(in<Body>))),
            "(0, 0, 0) N m s" + about_hinge + body);
  EXPECT_EQ(norm(torque_about<Hinge>(newton_metres(Vector3d(3.0, 0.0, 4.0)))), 5.0 * si::newton_metre);
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
template <class... Given>
concept Drives = requires(const Given&... given) {
  euler(given...);
};
template <class R, class F>
concept HasMoment = requires(const R& r, const F& f) {
  moment(r, f);
};

template <class P, class C = Body> using TorqueAt = Torque<P, In<C>>;
using Arm = Displacement<Hinge, Thruster, In<Body>>;
using ToHinge = Displacement<Thruster, Hinge, In<Body>>;
using Force = Vector<Body, si::force>;
static_assert(Adds<BodyTorque, BodyTorque>);
static_assert(!Adds<BodyTorque, TorqueAt<Thruster>>);
static_assert(!Adds<BodyTorque, TorqueAt<Hinge, Camera>>);
static_assert(!Adds<BodyTorque, BodyMomentum>);
static_assert(!Adds<BodyTorque, Vector<Body, si::torque>>);
static_assert(!Multiplies<Dcm<Body, Camera>, BodyTorque>);
static_assert(Shifts<TorqueAt<Thruster>, ToHinge, Force>);
static_assert(!Shifts<TorqueAt<Hinge>, ToHinge, Force>);  // the displacement must start at the old point
static_assert(!Shifts<TorqueAt<Thruster, Camera>, ToHinge, Force>);
static_assert(!Shifts<TorqueAt<Thruster>, ToHinge, Vector<Camera, si::force>>);
static_assert(!Shifts<TorqueAt<Thruster>, ToHinge, Vector<Body, si::momentum>>);
static_assert(!Shifts<TorqueAt<Thruster>, ToHinge>);
static_assert(!Shifts<AngularMomentum<Thruster, In<Body>>, ToHinge, Force>);
static_assert(HasMoment<Arm, Force>);
static_assert(!HasMoment<Arm, Vector<Camera, si::force>>);
static_assert(!HasMoment<Arm, Vector<Body, si::torque>>);
static_assert(Drives<Inertia<Body>, BodyRate, TorqueAt<CentreOfMassOf<Body>>>);
static_assert(!Drives<Inertia<Body>, BodyRate, TorqueAt<Hinge>>);
static_assert(!Drives<Inertia<Body>, BodyRate, TorqueAt<CentreOfMassOf<Camera>>>);
static_assert(!Drives<Inertia<Body>, BodyRate, TorqueAt<CentreOfMassOf<Body>, Camera>>);
static_assert(!Drives<Inertia<Body>, BodyRate, AngularMomentum<CentreOfMassOf<Body>, In<Body>>>);
static_assert(!Drives<Inertia<Body, Hinge>, BodyRate, TorqueAt<Hinge>>);
static_assert(
    !Drives<Inertia<Body, CentreOfMassOf<Body>, In<Camera>>, BodyRate, TorqueAt<CentreOfMassOf<Body>>>);
static_assert(!std::is_default_constructible_v<BodyTorque>);
static_assert(!std::is_convertible_v<Vector<Body, si::torque>, BodyTorque>);

}  // namespace
}  // namespace vectrix::test::moment_test
