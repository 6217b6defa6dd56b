#include <vectrix/dynamics/force/gravity.hpp>

#include "rigid_bodies.hpp"

namespace vectrix::test::gravity_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

const auto mu_earth = Quantity<si::gravitational_parameter>::from_value(3.986004418e14);

template <class F> Vector<F, si::length> position(In<F>, const Vector3d& r) {
  return vector<si::length>(in<F>, r);
}

TEST(PointMassGravity, attracts_by_the_inverse_square) {
  const auto a = point_mass_gravity(mu_earth, position(in<Gcrf>, {3e6, 4e6, 12e6}));  // |r| is 13e6 m
  const Vector3d exact = -mu_earth.value() / 169e12 * Vector3d(3.0, 4.0, 12.0) / 13.0;
  static_assert(std::same_as<decltype(a), const Vector<Gcrf, si::acceleration>>);
  EXPECT_LT((a.coordinates() - exact).norm(), 1e-15 * exact.norm() * 10.0);
}

TEST(PointMassGravity, the_centre_is_refused) {
  expect_bad_input([] { point_mass_gravity(mu_earth, zero<si::length>(in<Gcrf>)); },
                   "point_mass_gravity(r in " + frame_name<Gcrf>() + "): mu is " +
                       detail::text(mu_earth.value()) +
                       " m^3/s^2 and |r| 0 m; mu must be positive, mu/|r|^3 finite");
}

TEST(PointMassGravity, an_attraction_that_pushes_is_refused) {
  expect_bad_input(
      [] {
        point_mass_gravity(-1.0 * mu_earth, position(in<Gcrf>, {7e6, 0.0, 0.0}));
      },
      "point_mass_gravity(r in " + frame_name<Gcrf>() + "): mu is " + detail::text(-mu_earth.value()) +
          " m^3/s^2 and |r| 7e+06 m; mu must be positive, mu/|r|^3 finite");
}

TEST(PointMassGravity, a_pull_that_overflows_is_refused) {
  expect_bad_input(
      [] {
        point_mass_gravity(mu_earth, position(in<Gcrf>, {1e-105, 0.0, 0.0}));
      },
      "point_mass_gravity(r in " + frame_name<Gcrf>() + "): mu is " + detail::text(mu_earth.value()) +
          " m^3/s^2 and |r| 1e-105 m; mu must be positive, mu/|r|^3 finite");
}

/// Eight masses at +-r: their moments of third order vanish, so that the error of the torque is of order
/// (size / distance)^2.
struct Dumbbells {
  std::array<double, 4> masses = {1.0, 2.5, 0.7, 4.0};
  std::array<Vector3d, 4> places = {Vector3d(1.0, 0.2, -0.3), Vector3d(-0.4, 0.9, 0.1),
                                    Vector3d(0.3, 0.5, 0.8), Vector3d(0.1, -0.3, 0.2)};

  Inertia<Body> inertia() const {
    Matrix3d J = Matrix3d::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector3d& r = places[i];
      J += 2.0 * masses[i] * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
    }
    return tensor(J(0, 0), J(1, 1), J(2, 2), J(0, 1), J(0, 2), J(1, 2));
  }

  /// Torque about the centre, which is at r, of Newton's attraction on every mass.
  Vector3d torque(double mu, const Vector3d& r) const {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i < 4; ++i) {
      for (const double side : {1.0, -1.0}) {
        const Vector3d place = side * places[i];
        const Vector3d from_earth = r + place;
        sum += place.cross(-mu * masses[i] / std::pow(from_earth.norm(), 3) * from_earth);
      }
    }
    return sum;
  }
};

TEST(GravityGradient, is_the_sum_over_the_masses_to_second_order_in_size) {
  const Dumbbells body;
  const double mu = 5.0;
  const auto mu_q = Quantity<si::gravitational_parameter>::from_value(mu);
  for (const Vector3d& towards :
       {Vector3d(1.0, 2.0, 3.0), Vector3d(-2.0, 0.1, 1.0), Vector3d(0.0, 1.0, -1.0)}) {
    const auto relative_error = [&](double distance) {
      const Vector3d r = distance * towards.normalized();
      const auto torque_b = gravity_gradient_torque(mu_q, body.inertia(), position(in<Body>, r));
      const Vector3d exact = body.torque(mu, r);
      return (torque_b.coordinates() - exact).norm() / exact.norm();
    };
    EXPECT_LT(relative_error(100.0), 1e-3);  // a few times (1/100)^2
    EXPECT_NEAR(relative_error(100.0) / relative_error(1000.0), 100.0, 1.0);
  }
}

TEST(GravityGradient, vanishes_along_a_principal_axis_and_does_not_tell_up_from_down) {
  const Inertia<Body> J_b = tensor(3.0, 4.0, 5.0);
  const auto along_y = gravity_gradient_torque(mu_earth, J_b, position(in<Body>, {0.0, 7e6, 0.0}));
  EXPECT_EQ(along_y.coordinates(), Vector3d::Zero());
  const auto up = gravity_gradient_torque(mu_earth, J_b, position(in<Body>, {1e6, 7e6, 2e6}));
  const auto down = gravity_gradient_torque(mu_earth, J_b, position(in<Body>, {-1e6, -7e6, -2e6}));
  EXPECT_EQ(up.coordinates(), down.coordinates());
  EXPECT_GT(up.coordinates().norm(), 0.0);
}

TEST(GravityGradient, the_centre_is_refused) {
  expect_bad_input(
      [] { gravity_gradient_torque(mu_earth, tensor(3.0, 4.0, 5.0), zero<si::length>(in<Body>)); },
      "gravity_gradient_torque(r in " + frame_name<Body>() + "): mu is " + detail::text(mu_earth.value()) +
          " m^3/s^2 and |r| 0 m; mu must be positive, mu/|r|^3 finite");
}

}  // namespace
}  // namespace vectrix::test::gravity_test
