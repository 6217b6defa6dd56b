#include <vectrix/dynamics/craft/attitude_state.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>
#include <vectrix/dynamics/craft/eigen_numbers.hpp>
#include <vectrix/frames/dcm_doors.hpp>
#include <vectrix/kinematics/attitude/quaternion.hpp>
#include <vectrix/kinematics/rates/rate.hpp>

namespace vectrix::detail {
namespace {

struct Inertial : inertial_frame {};
struct Hub : moving_frame {};

constexpr std::size_t of_quaternion = 4, of_dcm = 9, more = of_dcm - of_quaternion;

Eigen::Map<const Eigen::Matrix3d> matrix(std::span<const double> z) {
  return Eigen::Map<const Eigen::Matrix3d>(z.data());
}
double norm_of_quaternion(std::span<const double> y) {
  return Eigen::Map<const Eigen::Vector4d>(y.data()).norm();
}

void write_state(const Eigen::Quaterniond& q, std::span<const double> z, std::span<double> y) {
  y[0] = q.w(), y[1] = q.x(), y[2] = q.y(), y[3] = q.z();
  std::copy(z.begin() + of_dcm, z.end(), y.begin() + of_quaternion);
}

/// The numbers of a state, which each call overwrites. One step of the Newton-Schulz iteration, R (3 - R^T
/// R)/2, squares the distance of a matrix from a rotation. It never fails: an implicit method may try a
/// matrix that is none.
class StateNumbers {
 public:
  explicit StateNumbers(std::size_t size) : y_(size) {}

  std::span<double> of(std::span<const double> z) {
    const Eigen::Matrix3d R = matrix(z);
    write_state(unit_quaternion_of(Eigen::Matrix3d(1.5 * R - 0.5 * R * (R.transpose() * R))), z, y_);
    return y_;
  }

 private:
  std::vector<double> y_;
};

void write_rates(std::span<const double> z, std::span<const double> ydot, std::span<double> zdot) {
  const AngularVelocity<Inertial, Hub, In<Hub>> w_ih_h{trusted, Eigen::Vector3d(z[9], z[10], z[11])};
  Eigen::Map<Eigen::Matrix3d>(zdot.data()) =
      rate(trust_dcm(to<Inertial>, from<Hub>, Eigen::Matrix3d(matrix(z))), w_ih_h).matrix();
  std::copy(ydot.begin() + of_quaternion, ydot.end(), zdot.begin() + of_dcm);
}

ode::Problem with_dcm(ode::Problem problem) {
  const std::size_t size = problem.initial_state.size();

  const Eigen::Matrix3d R = eigen(multibody::matrix_of_quaternion(problem.initial_state.data()));
  auto& y = problem.initial_state;
  y.insert(y.begin(), more, 0.0);
  Eigen::Map<Eigen::Matrix3d>(y.data()) = R;
  auto& tolerances = problem.absolute_tolerances;
  tolerances.insert(tolerances.begin(), more, tolerances.front());
  auto& names = problem.component_names;
  names.erase(names.begin(), names.begin() + of_quaternion);
  for (std::size_t entry = of_dcm; entry-- > 0;)
    names.insert(names.begin(), "R(" + text(entry % 3 + 1) + ", " + text(entry / 3 + 1) + ")");

  problem.rhs = [rhs = std::move(problem.rhs), numbers = StateNumbers(size),
                 ydot = std::vector<double>(size)](double segment_start, double t, std::span<const double> z,
                                                   std::span<double> zdot) mutable {
    rhs(segment_start, t, numbers.of(z), ydot);
    write_rates(z, ydot, zdot);
  };
  if (problem.why_not_finite) {
    problem.why_not_finite = [why = std::move(problem.why_not_finite), numbers = StateNumbers(size)](
                                 double segment_start, double t, std::span<const double> z) mutable {
      return why(segment_start, t, numbers.of(z));
    };
  }
  for (ode::Root& root : problem.roots) {
    root.function = [function = std::move(root.function), numbers = StateNumbers(size)](
                        double t, std::span<const double> z) mutable { return function(t, numbers.of(z)); };
  }
  if (problem.at_segment_start) {
    problem.at_segment_start = [change = std::move(problem.at_segment_start), numbers = StateNumbers(size)](
                                   double t, std::span<double> z,
                                   std::span<const ode::Event> ended_by) mutable {
      const std::span<double> changed = numbers.of(z);
      change(t, changed, ended_by);
      std::copy(changed.begin() + of_quaternion, changed.end(), z.begin() + of_dcm);
    };
  }
  return problem;
}

}  // namespace

void read_state(AttitudeState attitude, std::span<const double> integrated, std::span<double> y) {
  if (attitude == AttitudeState::quaternion) {
    std::copy(integrated.begin(), integrated.end(), y.begin());
    return;
  }
  const auto R = nearest_dcm(to<Inertial>, from<Hub>, Eigen::Matrix3d(matrix(integrated))).dcm;
  write_state(quaternion(R).eigen(), integrated, y);
}

ode::Solution solve_in(AttitudeState attitude, ode::Problem problem) {
  if (attitude == AttitudeState::dcm) problem = with_dcm(std::move(problem));
  return ode::solve(problem);
}

double attitude_drift(AttitudeState attitude, std::span<const double> integrated,
                      std::span<const double> at_start) {
  if (attitude == AttitudeState::quaternion)
    return std::abs(norm_of_quaternion(integrated) / norm_of_quaternion(at_start) - 1.0);
  const Eigen::Matrix3d R = matrix(integrated);
  return (R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff<Eigen::PropagateNaN>();
}

}  // namespace vectrix::detail
