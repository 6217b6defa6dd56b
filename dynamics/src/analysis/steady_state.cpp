#include <vectrix/dynamics/analysis/steady_state.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vectrix/dynamics/analysis/errors_of_state.hpp>
#include <vectrix/dynamics/craft/eigen_numbers.hpp>
#include <vectrix/dynamics/multibody/converted.hpp>
#include <vectrix/frames/errors.hpp>

#include "newton.hpp"

namespace vectrix::detail {
namespace {

constexpr std::size_t w_at = 4, r_at = 7, v_at = 10;  // in the state

/// A craft that turns as one rigid body with the constant inertial angular velocity W:
///     w^h = (R_h^i)^T W,   v = W x r,   all speeds zero
/// in coordinates x from a guess: R_h^i = R0 R(g), the Gibbs vector g = theta/2, r = r0 + R0 rho.
class Steady {
 public:
  explicit Steady(const SteadyProblem& problem)
      : problem_(problem),
        errors_(problem.core),
        free_(problem.core.plain.motion == HubMotion::free),
        R0_(multibody::matrix_of_quaternion(problem.guess.data())),
        W_(R0_ * multibody::Column<double>{problem.guess[w_at], problem.guess[w_at + 1],
                                           problem.guess[w_at + 2]}) {}

  [[nodiscard]] const ErrorsOfState& errors() const { return errors_; }
  [[nodiscard]] std::size_t size() const { return errors_.coordinates().size(); }

  template <class S> std::vector<S> state(const std::vector<S>& x) const {
    const auto& guess = problem_.guess;
    const auto& layout = problem_.core.tree.layout();
    std::vector<S> y(guess.begin(), guess.end());
    for (std::size_t i = 0; i < layout.speeds; ++i) y[layout.speeds_begin() + i] = S(0.0);
    for (std::size_t i = 0; i < layout.modes; ++i) y[layout.modes_begin() + layout.modes + i] = S(0.0);
    std::vector<S> by_error(errors_.size(), S(0.0));
    for (std::size_t i = 0; i < size(); ++i) by_error[errors_.coordinates()[i].error] = x[i];
    for (const auto& number : errors_.numbers()) y[number.at] += by_error[number.error];
    for (const auto& turn : errors_.turns()) {
      const S* theta = &by_error[turn.error];
      std::array<S, 4> dq{};
      const std::array<S, 4> q{y[turn.q], y[turn.q + 1], y[turn.q + 2], y[turn.q + 3]};
      multibody::quaternion_rate(q.data(), theta, dq.data());
      for (std::size_t i = 0; i < 4; ++i) y[turn.q + i] += dq[i];
    }
    const multibody::Column<S> W = multibody::converted<S>(W_);
    const auto w = multibody::transposed_times(multibody::matrix_of_quaternion(y.data()), W);
    y[w_at] = w.x, y[w_at + 1] = w.y, y[w_at + 2] = w.z;
    if (free_) {
      const S* rho = &by_error[6];
      const auto dr = multibody::converted<S>(R0_) * multibody::Column<S>{rho[0], rho[1], rho[2]};
      y[r_at] += dr.x, y[r_at + 1] += dr.y, y[r_at + 2] += dr.z;
      const auto v = multibody::cross(W, multibody::Column<S>{y[r_at], y[r_at + 1], y[r_at + 2]});
      y[v_at] = v.x, y[v_at + 1] = v.y, y[v_at + 2] = v.z;
    }
    return y;
  }
  /// The accelerations that are left: of the hub's place R^T (r'' - W x v).
  std::vector<Dual> left(const std::vector<Dual>& x) const {
    const std::vector<Dual> y = state(x);
    std::vector<Dual> ydot(y.size());
    problem_.rates(y.data(), ydot.data());
    if (free_) {
      const auto W = multibody::converted<Dual>(W_);
      const auto in_orbit = multibody::cross(W, multibody::Column<Dual>{y[v_at], y[v_at + 1], y[v_at + 2]});
      const auto a = multibody::transposed_times(
          multibody::matrix_of_quaternion(y.data()),
          multibody::Column<Dual>{ydot[v_at], ydot[v_at + 1], ydot[v_at + 2]} - in_orbit);
      ydot[v_at] = a.x, ydot[v_at + 1] = a.y, ydot[v_at + 2] = a.z;
    }
    std::vector<Dual> list;
    for (const auto& coordinate : errors_.coordinates()) list.push_back(ydot[coordinate.speed]);
    return list;
  }
  /// After left(): whether the coordinate belongs to a locked joint.
  [[nodiscard]] bool locked(const ErrorsOfState::Coordinate& coordinate) const {
    const auto& layout = problem_.core.tree.layout();
    for (std::size_t i = 0; i < layout.speed_at.size(); ++i) {
      const std::size_t next =
          i + 1 < layout.speed_at.size() ? layout.speed_at[i + 1] : layout.rotors_begin();
      if (coordinate.speed >= layout.speed_at[i] && coordinate.speed < next)
        return problem_.work.held[i] != multibody::Hold::none;
    }
    return false;
  }
  /// Of each coordinate, by its unit.
  [[nodiscard]] double tolerance(const ErrorsOfState::Coordinate& coordinate) const {
    const std::string& name = errors_.names()[coordinate.error];
    if (name.ends_with("[rad]")) return problem_.tolerances.turning.value();
    return name.ends_with("[m]") ? problem_.tolerances.sliding.value() : problem_.tolerances.mode;
  }
  /// 1; of the hub's place little of its distance, so that an equilibrium which may be anywhere on an orbit
  /// is where the guess is.
  [[nodiscard]] double scale(const ErrorsOfState::Coordinate& coordinate) const {
    if (!free_ || coordinate.speed < v_at || coordinate.speed >= v_at + 3) return 1.0;
    return std::max(
        1.0, 1e-4 * std::hypot(problem_.guess[r_at], problem_.guess[r_at + 1], problem_.guess[r_at + 2]));
  }

 private:
  const SteadyProblem& problem_;
  ErrorsOfState errors_;
  bool free_;
  Square3 R0_;
  Column3 W_;
};

std::vector<Dual> duals_of(const Eigen::VectorXd& x, Eigen::Index along) {
  std::vector<Dual> list;
  for (Eigen::Index i = 0; i < x.size(); ++i) list.emplace_back(x[i], i == along ? 1.0 : 0.0);
  return list;
}
void require_tolerance(const char* of, double tolerance) {
  if (!(tolerance > 0.0 && std::isfinite(tolerance)))
    throw BadInput(std::string{"equilibrium: the tolerance of "} + of + " is " + text(tolerance) +
                   "; it must be positive" +
                   (tolerance == 0.0 ? ", and has no default: it is left out, or 0" : ""));
}

}  // namespace

std::vector<double> steady_state(const SteadyProblem& problem) {
  require_tolerance("what turns", problem.tolerances.turning.value());
  require_tolerance("what slides", problem.tolerances.sliding.value());
  require_tolerance("modes", problem.tolerances.mode);
  const Steady steady(problem);
  const auto& coordinates = steady.errors().coordinates();
  const auto n = static_cast<Eigen::Index>(steady.size());
  const auto left = [&](const Eigen::VectorXd& x) {
    Eigen::VectorXd F(n);
    const auto duals = steady.left(duals_of(x, -1));
    for (Eigen::Index i = 0; i < n; ++i) F[i] = duals[static_cast<std::size_t>(i)].value();
    return F;
  };
  const auto jacobian = [&](const Eigen::VectorXd& x) {
    Eigen::MatrixXd J(n, n);
    for (Eigen::Index j = 0; j < n; ++j) {
      const auto duals = steady.left(duals_of(x, j));
      for (Eigen::Index i = 0; i < n; ++i) J(i, j) = duals[static_cast<std::size_t>(i)].derivatives();
      if (steady.locked(coordinates[static_cast<std::size_t>(j)])) J.col(j).setZero();
    }
    return J;
  };
  Eigen::VectorXd scale(n), tolerance(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    scale[i] = steady.scale(coordinates[static_cast<std::size_t>(i)]);
    tolerance[i] = steady.tolerance(coordinates[static_cast<std::size_t>(i)]);
  }
  const auto name_of = [&](Eigen::Index i) -> const std::string& {
    return steady.errors().names()[coordinates[static_cast<std::size_t>(i)].error];
  };
  const Eigen::VectorXd guess = Eigen::VectorXd::Zero(n), at_guess = left(guess);
  for (Eigen::Index i = 0; i < n; ++i)
    if (!std::isfinite(at_guess[i]))
      throw BadInput("equilibrium of " + problem.core.plain.hub + ": at the guess the second derivative of " +
                     name_of(i) + " is " + text(at_guess[i]) + " per s^2");
  const NewtonResult found = newton({left, jacobian, guess, scale, tolerance});
  const Eigen::VectorXd F = left(found.x);
  Eigen::Index worst = 0;
  const double most = F.cwiseQuotient(tolerance).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(&worst);
  if (!(most <= 1.0)) {
    const std::string& name = name_of(worst);
    throw NoEquilibrium("equilibrium of " + problem.core.plain.hub + ": none found near the guess, " +
                            found.flag + " after " + text(found.iterations) +
                            " iterations; the second derivative of " + name + " is left, " + text(F[worst]) +
                            " per s^2",
                        name, F[worst], found.iterations);
  }
  std::vector<double> x(found.x.begin(), found.x.end());
  std::vector<double> y = steady.state(x);
  for (const auto& turn : steady.errors().turns()) {
    const double norm =
        std::hypot(std::hypot(y[turn.q], y[turn.q + 1]), std::hypot(y[turn.q + 2], y[turn.q + 3]));
    for (std::size_t i = 0; i < 4; ++i) y[turn.q + i] /= norm;
  }
  return y;
}

}  // namespace vectrix::detail
