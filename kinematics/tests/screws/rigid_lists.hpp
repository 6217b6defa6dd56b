#pragma once

#include <gtest/gtest.h>

#include "testing/any_scalar.hpp"

/// Screws, Jacobians and rates as a list of numbers, for any scalar.
namespace vectrix_test {

/// Roundings of the list, on numbers of order 10.
inline constexpr double few_thousand = 4e3;
inline constexpr int instances = 100;

/// A screw and its derivatives, of random size: in one batch some lanes use the series, and some turn by more
/// than 3 rad.
template <class S> std::vector<S> rigid_motions(const Given<S>& given) {
  Told<S> told;
  const S size = given.t * given.t * given.t * given.t;
  const detail::Column<S> theta = given.v[0] * (S(2.8) * size);
  const detail::Column<S> rho = given.v[1] * S(3);
  const auto theta_ab = rotation_vector(of<Body>, relative_to<Gcrf>, vector<si::angle>(in<Gcrf>, theta));
  const auto xi_ab = screw(of<Body>, relative_to<Gcrf>, vector<si::angle>(in<Gcrf>, theta),
                           vector<si::length>(in<Gcrf>, rho));
  const auto X = exp(xi_ab);
  told.add(homogeneous_matrix(X));
  const auto short_one =
      screw(of<Body>, relative_to<Gcrf>, vector<si::angle>(in<Body>, detail::Column<S>(theta / S(2))),
            vector<si::length>(in<Body>, rho));
  told.add(log(exp(short_one)));
  told.add(left_jacobian(theta_ab));
  told.add(inverse_right_jacobian(theta_ab));
  told.add(left_jacobian(xi_ab));
  told.add(inverse_right_jacobian(xi_ab));
  told.add(ad(xi_ab));

  const auto theta_dot = parameter_rate(theta_ab, given.v[2]);
  const auto w_b = angular_velocity_from(theta_ab, theta_dot, in<Body>);
  const auto alpha_a =
      angular_acceleration_from(theta_ab, theta_dot, second_parameter_rate(theta_ab, given.v[3]), in<Gcrf>);
  told.add(w_b);
  told.add(alpha_a);
  told.add(rate(theta_ab, w_b).coordinates());
  told.add(second_rate(theta_ab, w_b, inverse(X.rotation) * alpha_a).coordinates());

  const auto xi_dot =
      screw_rate(of<Body>, relative_to<Gcrf>, vector<si::angular_velocity>(in<Gcrf>, given.v[2]),
                 vector<si::velocity>(in<Gcrf>, given.v[4]));
  const auto V_b = twist_from(xi_ab, xi_dot, in<Body>);
  told.add(V_b);
  told.add(rate(xi_ab, X * V_b));
  const auto t = instant_of(given.t);
  told.add(homogeneous_matrix(moved(X, V_b, t)));
  told.add(homogeneous_matrix(moved(X, X * V_b, t)));
  const auto axis = screw_axis(held(V_b, instant_of(S(given.t + S(1)))));
  told.add(screw_along(of<Body>, relative_to<Gcrf>, axis));

  const auto Vdot_b = twist_rate(V_b, acceleration_of<Gcrf, Body>(given.v[3]),
                                 vector<si::acceleration>(in<Body>, given.v[5]));
  told.add((X * Vdot_b).coordinates());
  told.add(particle_acceleration(X * V_b, X * Vdot_b));
  return told.numbers;
}

template <class Found, class Reference>
void expect_all_near(const std::vector<Found>& found, const std::vector<Reference>& reference,
                     double tolerance) {
  ASSERT_EQ(found.size(), reference.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_LE(std::abs(static_cast<double>(found[i] - static_cast<Found>(reference[i]))),
              tolerance * std::max(1.0, std::abs(static_cast<double>(reference[i]))))
        << "number " << i;
  }
}

/// No rotation is slow: its axis would be far away, and its position would have fewer digits.
inline Given<double> numbers_of(std::mt19937_64& random) {
  auto given = random_numbers(random);
  given.v[2] += Eigen::Vector3d(1.5, -1.5, 1.5);
  return given;
}

}  // namespace vectrix_test
