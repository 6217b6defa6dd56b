#pragma once

#include <Eigen/Core>
#include <array>
#include <random>
#include <vector>
#include <vectrix/kinematics.hpp>

#include "testing/attitudes.hpp"

/// The algebra as lists of numbers, for any scalar: the results of one scalar are compared with those of
/// another.
namespace vectrix_test {

using namespace vectrix;

/// Numbers that a float holds exactly: four quaternions, scalar first and not normalised, six vectors, and
/// times in [0, 1].
template <class S> struct Given {
  std::array<Eigen::Matrix<S, 4, 1>, 4> q;
  std::array<Eigen::Matrix<S, 3, 1>, 6> v;
  S t;
};

/// Over the samples, each of the four numbers of a quaternion is sometimes the largest; no rotation is near
/// half a turn.
inline Given<double> random_numbers(std::mt19937_64& random) {
  const auto number = [&](int low, int high) {
    return std::uniform_int_distribution<int>(low, high)(random) / 1024.0;
  };
  Given<double> given;
  for (auto& q : given.q) {
    q = {number(256, 1024), number(-1024, 1024), number(-1024, 1024), number(-1024, 1024)};
    q(std::uniform_int_distribution<int>(0, 3)(random)) += 1.5;
  }
  for (auto& v : given.v) v = {number(-1024, 1024), number(-1024, 1024), number(-1024, 1024)};
  given.t = number(0, 1024);
  return given;
}

/// Given<S> with f applied to each number.
template <class S, class From, class Function>
Given<S> converted(const Given<From>& from, const Function& f) {
  Given<S> given;
  for (std::size_t i = 0; i < from.q.size(); ++i) given.q[i] = from.q[i].unaryExpr(f);
  for (std::size_t i = 0; i < from.v.size(); ++i) given.v[i] = from.v[i].unaryExpr(f);
  given.t = f(from.t);
  return given;
}

/// Given<S> whose lanes are the entries of the list.
template <class S> Given<S> batch_of(const std::vector<Given<double>>& lanes) {
  Given<S> given;
  for (std::size_t i = 0; i < S::size(); ++i) {
    for (std::size_t k = 0; k < given.q.size(); ++k) {
      for (Eigen::Index n = 0; n < 4; ++n) given.q[k](n)[i] = lanes[i].q[k](n);
    }
    for (std::size_t k = 0; k < given.v.size(); ++k) {
      for (Eigen::Index n = 0; n < 3; ++n) given.v[k](n)[i] = lanes[i].v[k](n);
    }
    given.t[i] = lanes[i].t;
  }
  return given;
}

/// A list of numbers.
template <class S> struct Told {
  std::vector<S> numbers;

  template <class Derived> void add(const Eigen::MatrixBase<Derived>& matrix) {
    const auto plain = matrix.eval();
    for (Eigen::Index i = 0; i < plain.size(); ++i) numbers.push_back(plain.data()[i]);
  }
  void add(const S& number) { numbers.push_back(number); }
  template <class Value> void add(const Value& value) {
    if constexpr (requires { value.eigen(); }) {
      add(value.eigen().coeffs());
    } else if constexpr (requires { value.matrix(); }) {
      add(value.matrix());
    } else {
      add(value.coordinates());
    }
  }
};

template <class B, class A, class S> Quaternion<B, A, S> unit(const Eigen::Matrix<S, 4, 1>& q) {
  return nearest_quaternion_scalar_first(to<B>, from<A>, q(0), q(1), q(2), q(3)).quaternion;
}
template <class S> Quantity<si::angle, S> radians(const S& angle) {
  return Quantity<si::angle, S>::from_value(angle);
}
template <class S> Quantity<si::time, S> instant_of(const S& t) {
  return Quantity<si::time, S>::from_value(t);
}

/// The doors of vectors and rotations, and their products.
template <class S> std::vector<S> rotations(const Given<S>& given) {
  Told<S> told;
  const auto turn = turned_x(to<Ground>, from<Itrf>, radians(given.v[0].x())) *
                    turned_y(to<Itrf>, from<Camera>, radians(given.v[0].y())) *
                    turned_z(to<Camera>, from<Wheel<1>>, radians(S(given.v[0].z() * S(5))));
  told.add(turn);
  told.add(dcm(to<Body>, from<Gcrf>, turn.matrix()));
  told.add(dcm_from_axes(to<Body>, direction(vector<si::dimensionless>(in<Gcrf>, turn.matrix().row(0))),
                         vector<si::dimensionless>(in<Gcrf>, turn.matrix().row(1)),
                         vector<si::dimensionless>(in<Gcrf>, turn.matrix().row(2))));
  const auto length = [](const S& metres) { return Quantity<si::length, S>::from_value(metres); };
  const auto r = vector(in<Wheel<1>>, length(given.v[1].x()), length(given.v[1].y()), length(given.v[1].z()));
  const auto s = vector<si::length>(in<Wheel<1>>, given.v[2]);
  told.add(turn * r);
  told.add(inverse(turn) * (turn * (r - s)));
  told.add(rotate(inverse(turn), r + S(2) * s));
  told.add(cross(r, s));
  told.add(dot(r, s).value());
  told.add(norm(r - s).value());
  told.add(direction(vector<si::length>(in<Body>, Eigen::Matrix<S, 3, 1>(given.q[0].template head<3>()))));
  const Transform<Body, Camera, S> X{
      dcm(to<Body>, from<Camera>, turn.matrix()),
      displacement(of<Camera>, relative_to<Body>, vector<si::length>(in<Body>, given.v[3]))};
  const auto homogeneous = homogeneous_matrix(X);
  told.add(homogeneous_matrix(inverse(transform(to<Body>, from<Camera>, homogeneous))));
  return told.numbers;
}

/// The rotation nearest to a distorted one.
template <class S> std::vector<S> projections(const Given<S>& given) {
  Told<S> told;
  const auto R = unit<Body, Gcrf>(given.q[0]).eigen().toRotationMatrix();
  const auto nearest = nearest_dcm(to<Body>, from<Gcrf>, detail::Square<S>(R + R.cwiseProduct(R) / S(16)));
  told.add(nearest.dcm);
  told.add(nearest.distance);
  return told.numbers;
}

/// Quaternions: doors, conversions and products.
template <class S> std::vector<S> quaternions(const Given<S>& given) {
  Told<S> told;
  const auto q_ba = unit<Body, Gcrf>(given.q[0]);
  const auto q_cb = unit<Camera, Body>(given.q[1]);
  told.add(q_cb * q_ba);
  told.add(q_ba * vector<si::length>(in<Gcrf>, given.v[0]));
  told.add(dcm(q_cb * q_ba));
  told.add(quaternion(dcm(q_ba)));
  told.add(quaternion(dcm(unit<Body, Gcrf>(given.q[2]))));
  told.add(dcm(quaternion(dcm(q_cb * q_ba))));
  const auto [w, x, y, z] = q_ba.scalar_first();
  told.add(quaternion_scalar_first(to<Body>, from<Gcrf>, w, x, y, z));
  told.add(quaternion_scalar_last(to<Body>, from<Gcrf>, x, y, z, w));
  told.add(inverse(nearest_quaternion_scalar_last(to<Body>, from<Gcrf>, w, z, y, x).quaternion));
  return told.numbers;
}

/// exp and log of rotations from zero to almost half a turn, and the rotation at constant rate.
template <class S> std::vector<S> turns(const Given<S>& given) {
  Told<S> told;
  const auto turn = [&](const Eigen::Matrix<S, 3, 1>& theta) {
    return rotation_vector(of<Body>, relative_to<Gcrf>, vector<si::angle>(in<Gcrf>, theta));
  };
  // Of random size, so that in one batch some lanes use the series and some do not.
  const S size = given.t * given.t * given.t * given.t;
  for (const auto& theta : {turn(given.v[0]), turn(Eigen::Matrix<S, 3, 1>(given.v[1] * size)),
                            turn(Eigen::Matrix<S, 3, 1>(given.v[2] * (size / S(1 << 20))))}) {
    told.add(exp(theta));
    told.add(exp_quaternion(theta));
    told.add(log(exp(theta)));
    told.add(log(exp_quaternion(theta)));
  }
  const auto q0 = unit<Gcrf, Body>(given.q[0]);
  const auto q1 = q0 * unit<Body, Gcrf>(given.q[1]) * inverse(unit<Body, Gcrf>(given.q[2]));
  told.add(log(q1));
  const Slerp slerp(instant_of(S(-1)), q0, instant_of(S(3)), unit<Gcrf, Body>(given.q[1]));
  const auto here = slerp(instant_of(given.t));
  told.add(here.rotation);
  told.add(here.angular_velocity);
  return told.numbers;
}

template <class A, class B, class S>
AngularVelocity<A, B, In<B>, S> rate_of(const Eigen::Matrix<S, 3, 1>& w) {
  return angular_velocity(of<B>, relative_to<A>, vector<si::angular_velocity>(in<B>, w));
}
template <class A, class B, class S>
AngularAcceleration<A, B, In<B>, S> acceleration_of(const Eigen::Matrix<S, 3, 1>& alpha) {
  return angular_acceleration(of<B>, relative_to<A>, vector<si::angular_acceleration>(in<B>, alpha));
}

/// The rate laws of DCM and quaternion in both forms, their inverse, and the chains.
template <class S> std::vector<S> rates(const Given<S>& given) {
  Told<S> told;
  const auto q = unit<Gcrf, Body>(given.q[0]);
  const auto R = dcm(q);
  const auto w = rate_of<Gcrf, Body>(given.v[0]);
  told.add(rate(R, w));
  told.add(rate(R, R * w));
  told.add(rate(q, w));
  told.add(rate(q, R * w));
  const auto alpha = acceleration_of<Gcrf, Body>(given.v[2]);
  told.add(second_rate(R, w, alpha));
  told.add(second_rate(q, R * w, R * alpha));
  told.add(angular_acceleration_from(R, rate(R, w), second_rate(R, w, alpha), in<Gcrf>));
  told.add(angular_acceleration_from(q, rate(q, w), second_rate(q, w, alpha), in<Body>));
  told.add(angular_velocity_from(R, rate(R, w), in<Body>));
  told.add(angular_velocity_from(R, dcm_rate(R, rate(R, w).matrix()), in<Gcrf>));
  told.add(rate(R, w) * vector<si::length>(in<Body>, given.v[1]));
  const auto ab = accelerating_dcm(R, w, acceleration_of<Gcrf, Body>(given.v[2]));
  const auto bd = accelerating_dcm(dcm(unit<Body, Camera>(given.q[1])), rate_of<Body, Camera>(given.v[3]),
                                   acceleration_of<Body, Camera>(given.v[4]));
  const auto ad = ab * inverse(inverse(bd));
  told.add(ad.rotation);
  told.add(ad.angular_velocity);
  told.add(ad.angular_acceleration);
  return told.numbers;
}

/// An edge whose function moves b and turns it at an increasing rate: X_b^a(t) from numbers k.
template <class A, class B, class S>
AcceleratingTransform<A, B, S> travel(const Given<S>& given, std::size_t k, const Quantity<si::time, S>& t) {
  const S angle = given.v[k].x() + t.value() * given.v[k].y();
  const auto R =
      dcm(unit<A, Ground>(given.q[k])) * turned_z(to<Ground>, from<B>, radians(S(angle * t.value())));
  return {
      accelerating_dcm(R, rate_of<A, B>(given.v[k]), acceleration_of<A, B>(given.v[k + 1])),
      displacement(of<B>, relative_to<A>,
                   vector<si::length>(in<A>, Eigen::Matrix<S, 3, 1>(given.v[k + 2] * t.value()))),
      velocity(of<B>, relative_to<A>, observed_from<A>, vector<si::velocity>(in<A>, given.v[k + 2])),
      acceleration(of<B>, relative_to<A>, observed_from<A>, vector<si::acceleration>(in<A>, given.v[k + 1]))};
}

/// A graph of function edges in both directions and one fixed edge; all its queries.
template <class S> std::vector<S> graph_answers(const Given<S>& given) {
  Told<S> told;
  using Time = Quantity<si::time, S>;
  const auto trusted = [&](const Time& t) {
    const auto X = travel<Body, Itrf>(given, 3, t);
    return Transform{trust_dcm(to<Body>, from<Itrf>, [&] { return X.turning.rotation.matrix(); }),
                     X.translation};
  };
  const auto graph =
      frame_graph(edge([&](const Time& t) { return travel<Gcrf, Body>(given, 0, t); }),
                  edge([&](const Time& t) { return travel<Camera, Body>(given, 1, t); }),
                  rigid_edge(transform_of(travel<Camera, Wheel<1>>(given, 2, instant_of(S(0))))),
                  edge(trusted), static_edge(dcm(unit<Itrf, Wheel<2>>(given.q[3]))));
  const auto now = graph.at(instant_of(given.t));
  told.add(now.rotation(to<Wheel<2>>, from<Wheel<1>>));
  told.add(now.rotation(to<Gcrf>, from<Gcrf>));
  told.add(now.angular_velocity(of<Wheel<1>>, relative_to<Gcrf>, in<Gcrf>));
  told.add(now.angular_velocity(of<Wheel<1>>, relative_to<Gcrf>, in<Body>));
  told.add(now.angular_acceleration(of<Gcrf>, relative_to<Camera>, in<Wheel<1>>));
  told.add(homogeneous_matrix(now.transform(to<Itrf>, from<Wheel<1>>)));
  told.add(now.position(of<Wheel<1>>, relative_to<Itrf>, in<Gcrf>));
  told.add(now.velocity(of<Wheel<1>>, relative_to<Gcrf>, observed_from<Body>, in<Camera>));
  told.add(now.acceleration(of<Gcrf>, relative_to<Wheel<1>>, observed_from<Gcrf>, in<Body>));
  return told.numbers;
}

}  // namespace vectrix_test
