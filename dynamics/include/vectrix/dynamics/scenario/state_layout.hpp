#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>
#include <vectrix/dynamics/craft/attitude_state.hpp>
#include <vectrix/dynamics/scenario/scenario.hpp>
#include <vectrix/frames/dcm_doors.hpp>
#include <vectrix/kinematics/rates/rate.hpp>

namespace vectrix {

namespace detail {

/// The only code that turns a state into an array without frames, for the integrator, and back:
///     [ attitude (4 or 9) | w_ib^b (3) | r^i (3) | v^i (3) ]
template <InertialFrame I, Frame B> class StateLayout {
  using Orbit = PointMotion<I, CentreOfMassOf<B>, I>;

 public:
  StateLayout(AttitudeState attitude, bool orbit) : attitude_(attitude), orbit_(orbit) {}

  std::size_t attitude_size() const { return attitude_ == AttitudeState::quaternion ? 4 : 9; }
  std::size_t size() const { return attitude_size() + (orbit_ ? 9 : 3); }

  /// Names of the numbers, for messages.
  std::vector<std::string> names() const {
    std::vector<std::string> names{"w_ib_b.x", "w_ib_b.y", "w_ib_b.z"};
    if (attitude_ == AttitudeState::quaternion) {
      names.insert(names.begin(), {"q_i_from_b.w", "q_i_from_b.x", "q_i_from_b.y", "q_i_from_b.z"});
    } else {
      for (std::size_t entry = 9; entry-- > 0;)
        names.insert(names.begin(), "R_i_from_b(" + text(entry % 3 + 1) + ", " + text(entry / 3 + 1) + ")");
    }
    if (orbit_) names.insert(names.end(), {"r_i.x", "r_i.y", "r_i.z", "v_i.x", "v_i.y", "v_i.z"});
    return names;
  }

  std::vector<double> pack(const State<I, B>& state) const {
    std::vector<double> y(size());
    if (attitude_ == AttitudeState::quaternion) {
      write_quaternion(state.q_i_from_b.eigen(), y);
    } else {
      write_matrix(state.R_i_from_b().matrix(), y);
    }
    write_column(state.w_ib_b.coordinates(), y, attitude_size());
    if (orbit_) {
      write_column(state.orbit->position.coordinates(), y, attitude_size() + 3);
      write_column(state.orbit->velocity.coordinates(), y, attitude_size() + 6);
    }
    return y;
  }

  /// The state; its attitude is projected onto the nearest rotation.
  State<I, B> unpack(double t, std::span<const double> y) const {
    return {Quantity<si::time>::from_value(t), unit_attitude(y), rate(y),
            orbit_ ? std::optional<Orbit>{orbit(y)} : std::nullopt};
  }

  AngularVelocity<I, B, In<B>> rate(std::span<const double> y) const {
    return AngularVelocity<I, B, In<B>>{trusted,
                                        Vector<B, si::angular_velocity>{trusted, column(y, attitude_size())}};
  }

  /// How far the raw attitude is from a rotation: | |q| - 1 |, or the largest entry of |R^T R - I|.
  double drift(std::span<const double> y) const {
    if (attitude_ == AttitudeState::quaternion) return std::abs(raw_quaternion(y).norm() - 1.0);
    const Square<double> R = raw_matrix(y);
    return (R.transpose() * R - Square<double>::Identity()).cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
  }

  /// ydot by the typed laws: kinematics of the chosen attitude, Euler's equation, point-mass gravity.
  void derivative(const Scenario<I, B>& scenario, double segment_start, double t, std::span<const double> y,
                  std::span<double> ydot) const {
    const AngularVelocity<I, B, In<B>> w_ib_b = rate(y);
    if (attitude_ == AttitudeState::quaternion) {
      write_quaternion(vectrix::rate(Quaternion<I, B>{trusted, raw_quaternion(y)}, w_ib_b).eigen(), ydot);
    } else {
      write_matrix(vectrix::rate(trust_dcm(to<I>, from<B>, raw_matrix(y)), w_ib_b).matrix(), ydot);
    }
    const Vector<B, si::torque> torque_b =
        scenario.torque_free()
            ? zero<si::torque>(in<B>)
            : torque(scenario, unpack(t, y), Quantity<si::time>::from_value(segment_start));
    write_column(euler(scenario.inertia, w_ib_b, torque_b).coordinates(), ydot, attitude_size());
    if (orbit_) {
      const Orbit now = orbit(y);
      write_column(now.velocity.coordinates(), ydot, attitude_size() + 3);
      write_column(point_mass_gravity(*scenario.mu, now.position.vector()).coordinates(), ydot,
                   attitude_size() + 6);
    }
  }

 private:
  static Eigen::Quaterniond raw_quaternion(std::span<const double> y) { return {y[0], y[1], y[2], y[3]}; }
  static Square<double> raw_matrix(std::span<const double> y) {
    return Eigen::Map<const Square<double>>(y.data());
  }
  static Column<double> column(std::span<const double> y, std::size_t at) {
    return Eigen::Map<const Column<double>>(y.data() + at);
  }
  static void write_quaternion(const Eigen::Quaterniond& q, std::span<double> y) {
    y[0] = q.w();
    y[1] = q.x();
    y[2] = q.y();
    y[3] = q.z();
  }
  static void write_matrix(const Square<double>& matrix, std::span<double> y) {
    Eigen::Map<Square<double>>(y.data()) = matrix;
  }
  static void write_column(const Column<double>& value, std::span<double> y, std::size_t at) {
    Eigen::Map<Column<double>>(y.data() + at) = value;
  }

  Quaternion<I, B> unit_attitude(std::span<const double> y) const {
    if (attitude_ == AttitudeState::quaternion) return {trusted, raw_quaternion(y).normalized()};
    return quaternion(nearest_dcm(to<I>, from<B>, raw_matrix(y)).dcm);
  }
  Orbit orbit(std::span<const double> y) const {
    return {decltype(Orbit::position){trusted, column(y, attitude_size() + 3)},
            decltype(Orbit::velocity){trusted, column(y, attitude_size() + 6)}};
  }

  AttitudeState attitude_;
  bool orbit_;
};

}  // namespace detail
}  // namespace vectrix
