#include "radau.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Eigenvalues>
#include <vectrix/frames/errors.hpp>
#include <vectrix/frames/scalar/larger.hpp>

namespace vectrix::ode {
namespace {

constexpr int stages = RadauStepper::stages;
constexpr int pairs = RadauStepper::pairs;
constexpr int most_iterations = 15;
constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double error_exponent = 1.0 / (stages + 1);

using Square = Eigen::Matrix<double, stages, stages>;
using Complex = std::complex<double>;

/// A^-1 of the method, and its eigenvectors: the real one, and one of each complex pair.
struct Decomposition {
  Square inverse;
  double real;
  Eigen::Matrix<double, stages, 1> right_real;
  Eigen::Matrix<double, 1, stages> left_real;
  Eigen::Matrix<Complex, pairs, 1> complex;
  Eigen::Matrix<Complex, stages, pairs> right;
  Eigen::Matrix<Complex, pairs, stages> left;

  Decomposition() {
    Square a;
    for (int i = 0; i < stages; ++i)
      for (int j = 0; j < stages; ++j)
        a(i, j) = RadauIIA7::table().a[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
    inverse = a.inverse();
    const Eigen::EigenSolver<Square> solver(inverse);
    const Eigen::Matrix<Complex, stages, stages> vectors = solver.eigenvectors(), rows = vectors.inverse();
    int pair = 0;
    for (int k = 0; k < stages; ++k) {
      const Complex lambda = solver.eigenvalues()(k);
      if (lambda.imag() == 0.0) {
        real = lambda.real();
        right_real = vectors.col(k).real();  // of unit length, therefore real
        left_real = rows.row(k).real();
      } else if (lambda.imag() > 0.0) {
        complex(pair) = lambda;
        right.col(pair) = vectors.col(k);
        left.row(pair) = rows.row(k);
        ++pair;
      }
    }
  }
};

const Decomposition& method() {
  static const Decomposition result;
  return result;
}

double abscissa(int stage) {
  return RadauIIA7::table().c[static_cast<std::size_t>(stage)];
}

/// The largest value on [0, 1] of the polynomial of degree 8 that is 0 at 0 and at all c_i and has the slope
/// 1 at 0: what a wrong slope at the start does to the collocation polynomial.
double largest_correction() {
  constexpr int places = 10'000;
  double largest = 0.0;
  for (int i = 1; i < places; ++i) {
    const double theta = static_cast<double>(i) / places;
    double product = theta;
    for (int stage = 0; stage < stages; ++stage) product *= 1.0 - theta / abscissa(stage);
    largest = std::max(largest, std::abs(product));
  }
  return largest;
}

}  // namespace

RadauStepper::RadauStepper(const Problem& problem)
    : problem_(problem), rates_{std::cref(problem.rhs), &problem} {
  const auto size = static_cast<Eigen::Index>(problem.initial_state.size());
  absolute_ = Vector::Map(problem.absolute_tolerances.data(), size);
  y_ = rate_ = trial_ = trial_rate_ = new_y_ = unit_ = error_ = Vector::Zero(size);
  z_ = f_ = residual_ = change_ = terms_ = last_terms_ = ByStage::Zero(size, stages);
  complex_residual_ = complex_change_ = Eigen::VectorXcd::Zero(size);
  jacobian_ = Eigen::MatrixXd::Zero(size, size);
}

void RadauStepper::enter_segment(double start, double end) {
  rates_.start = start;
  rates_.end = end;
}

void RadauStepper::evaluate(double elapsed, std::span<const double> y, std::span<double> ydot) {
  rates_(elapsed, y, ydot);
  rates_.require_none();
}

bool RadauStepper::evaluate_trial(double elapsed) {
  rates_(elapsed, span_of(std::as_const(trial_)), span_of(trial_rate_));
  return !rates_.trouble;
}

void RadauStepper::restart(double elapsed, std::span<const double> y, double stop, double longest) {
  origin_ = elapsed;
  stop_ = stop;
  longest_ = longest;
  elapsed_ = {};
  step_ = 0.0;
  std::ranges::copy(y, y_.data());
  evaluate(elapsed, y, span_of(rate_));
  jacobian_fresh_ = jacobian_good_ = false;
}

void RadauStepper::rate(std::span<double> ydot) {
  std::ranges::copy(span_of(std::as_const(rate_)), ydot.begin());
}

void RadauStepper::find_unit(const Vector& sizes) {
  unit_ = absolute_ + problem_.relative_tolerance * sizes.cwiseAbs();
}

/// Short enough for any problem: a hundredth of the time in which the rate changes the state. It grows
/// eightfold a step.
double RadauStepper::first_step(double longest) {
  constexpr double cautious = 0.01;
  find_unit(y_);
  const double speed = rate_.cwiseAbs().cwiseQuotient(unit_).maxCoeff();
  const double size = y_.cwiseAbs().cwiseQuotient(unit_).maxCoeff();
  return speed > 0.0 ? std::min(longest, cautious * std::max(size, 1.0) / speed) : cautious * longest;
}

double RadauStepper::step() {
  const double end = stop_ - origin_;
  if (!(next_step_ > 0.0)) next_step_ = first_step(std::min(elapsed_.remaining(end), longest_));
  bool rejected = false;
  while (true) {
    const auto [h, last, too_short] = elapsed_.next(std::min(next_step_, longest_), end);
    if (too_short) throw_failed(h);
    rates_.trouble.reset();
    overflowed_ = false;
    if (!jacobian_good_ && !jacobian_fresh_ && !find_jacobian(h)) {
      next_step_ = 0.5 * h;
      continue;
    }
    if (factorised_ != h) factorise(h);
    guess(h);
    converged_ = iterate(h);
    if (!converged_) {
      jacobian_good_ = false;
      if (jacobian_fresh_) next_step_ = 0.5 * h;
      continue;
    }
    find_terms();
    const double error = error_of(h, rejected || step_ == 0.0);
    if (!std::isfinite(error)) {
      overflowed_ = true;
      next_step_ = 0.5 * h;
      rejected = true;
      ++rejections_;
      continue;
    }
    // A step whose iteration took long is lengthened less.
    const double safety =
        0.9 * (2.0 * most_iterations + 1.0) / (2.0 * most_iterations + static_cast<double>(iterations_));
    const double factor = std::clamp(safety * std::pow(error, -error_exponent), 0.1, 8.0);
    if (error > 1.0) {
      next_step_ = h * std::min(factor, 0.9);
      rejected = true;
      ++rejections_;
      continue;
    }
    jacobian_good_ = slowest_ratio_ < 1e-3;
    const double proposed = h * (rejected ? std::min(factor, 1.0) : factor);
    const bool keep = jacobian_good_ && proposed >= h && proposed <= 1.2 * h;  // the systems stay factorised
    next_step_ = last && !rejected ? std::max(next_step_, proposed) : keep ? h : proposed;
    accept(h, last);
    return time();
  }
}

/// By differences of the size of the state, or of its change |h f| in a step; that of a first step, which may
/// be carried over a breakpoint and far too long, says nothing. False if a rate there is not finite.
bool RadauStepper::find_jacobian(double h) {
  trial_ = y_;
  const double trusted = step_ > 0.0 ? h : first_step(h);
  for (Eigen::Index c = 0; c < y_.size(); ++c) {
    const double size =
        std::max({std::abs(y_(c)), std::abs(trusted * rate_(c)), absolute_(c) / std::sqrt(epsilon)});
    trial_(c) = y_(c) + std::sqrt(epsilon) * size;
    const double change = trial_(c) - y_(c);
    if (!evaluate_trial(time())) return false;
    jacobian_.col(c) = (trial_rate_ - rate_) / change;
    trial_(c) = y_(c);
  }
  jacobian_fresh_ = true;
  factorised_ = 0.0;
  return true;
}

void RadauStepper::factorise(double h) {
  const auto size = y_.size();
  real_.compute(method().real * Eigen::MatrixXd::Identity(size, size) - h * jacobian_);
  for (int k = 0; k < pairs; ++k) {
    complex_[static_cast<std::size_t>(k)].compute(
        method().complex(k) * Eigen::MatrixXcd::Identity(size, size) - (h * jacobian_).cast<Complex>());
  }
  factorised_ = h;
}

/// The polynomial of the last step, continued.
void RadauStepper::guess(double h) {
  z_.setZero();
  if (step_ == 0.0) return;
  for (Eigen::Index c = 0; c < y_.size(); ++c) {
    double now = 0.0;
    for (int p = stages; p-- > 0;) now += last_terms_(c, p);
    for (int i = 0; i < stages; ++i) {
      const double theta = 1.0 + abscissa(i) * h / step_;
      double later = 0.0;
      for (int p = stages; p-- > 0;) later = theta * (later + last_terms_(c, p));
      z_(c, i) = later - now;
    }
  }
}

/// Newton's iteration for Z; false if it is slow. A rate that is not finite ends it: a shorter step may avoid
/// it.
bool RadauStepper::iterate(double h) {
  find_unit(y_);
  const double rounded = 10.0 * epsilon * y_.cwiseAbs().cwiseQuotient(unit_).maxCoeff();
  const double small = std::max(rounded, std::min(0.01, std::sqrt(problem_.relative_tolerance)));
  contraction_ = std::pow(std::max(contraction_, epsilon), 0.8);
  slowest_ratio_ = 0.0;
  double before = 0.0;
  for (iterations_ = 1; iterations_ <= most_iterations; ++iterations_) {
    for (int i = 0; i < stages; ++i) {
      trial_ = y_ + z_.col(i);
      if (!evaluate_trial(time() + abscissa(i) * h)) return false;
      f_.col(i) = trial_rate_;
    }
    residual_ = h * f_;
    residual_.noalias() -= z_ * method().inverse.transpose();
    trial_.noalias() = residual_ * method().left_real.transpose();
    error_ = real_.solve(trial_);
    change_.noalias() = error_ * method().right_real.transpose();
    for (int k = 0; k < pairs; ++k) {
      complex_residual_.noalias() = residual_ * method().left.row(k).transpose();
      complex_change_ = complex_[static_cast<std::size_t>(k)].solve(complex_residual_);
      for (int i = 0; i < stages; ++i)
        change_.col(i) += 2.0 * (complex_change_ * method().right(i, k)).real();
    }
    double size = 0.0;
    for (int i = 0; i < stages; ++i)
      size = vectrix::detail::larger(size, change_.col(i).cwiseAbs().cwiseQuotient(unit_).maxCoeff());
    if (!std::isfinite(size) || !change_.allFinite()) return false;
    z_ += change_;
    if (iterations_ > 1) {
      const double ratio = size / before;
      slowest_ratio_ = std::max(slowest_ratio_, ratio);
      if (ratio >= 0.99) return size <= small;
      contraction_ = ratio / (1.0 - ratio);
      const double left = contraction_ * size * std::pow(ratio, most_iterations - 1 - iterations_);
      if (left > small) return false;
    }
    if (contraction_ * size <= small || size == 0.0) return true;
    before = size;
  }
  return false;
}

/// The polynomial through 0 and all Z_i: divided differences, which are small, expanded in powers of theta.
void RadauStepper::find_terms() {
  for (Eigen::Index c = 0; c < y_.size(); ++c) {
    std::array<double, stages + 1> x{}, newton{};
    for (std::size_t i = 0; i < stages; ++i) {
      x[i + 1] = abscissa(static_cast<int>(i));
      newton[i + 1] = z_(c, static_cast<Eigen::Index>(i));
    }
    for (std::size_t k = 1; k <= stages; ++k)
      for (std::size_t i = stages; i >= k; --i) newton[i] = (newton[i] - newton[i - 1]) / (x[i] - x[i - k]);
    std::array<double, stages + 1> powers{};
    for (std::size_t k = stages + 1; k-- > 0;) {  // powers = powers (theta - x_k) + newton_k
      for (std::size_t p = stages; p > 0; --p) powers[p] = powers[p - 1] - x[k] * powers[p];
      powers[0] = newton[k] - x[k] * powers[0];
    }
    for (std::size_t p = 1; p <= stages; ++p) terms_(c, static_cast<Eigen::Index>(p) - 1) = powers[p];
  }
}

/// The largest error of a component, in units of its tolerance. A large one may come from a stiff component
/// that the first estimate overrates; `careful` estimates it once more.
double RadauStepper::error_of(double h, bool careful) {
  new_y_ = y_ + z_.col(stages - 1);
  trial_ = y_.cwiseAbs().cwiseMax(new_y_.cwiseAbs());
  find_unit(trial_);
  const auto largest = [&](const Vector& rate) {
    trial_ = h * rate - terms_.col(0);
    error_ = real_.solve(trial_);
    Eigen::Index worst = 0;
    const double size = error_.cwiseAbs().cwiseQuotient(unit_).maxCoeff(&worst);
    worst_ = static_cast<std::size_t>(worst);
    return error_.allFinite() && new_y_.allFinite() ? size : std::numeric_limits<double>::quiet_NaN();
  };
  double size = largest(rate_);
  if (size > 1.0 && careful) {
    trial_ = y_ + error_;
    if (!evaluate_trial(time())) return std::numeric_limits<double>::quiet_NaN();
    size = largest(trial_rate_);
  }
  return vectrix::detail::larger(size, dense_error(h));
}

/// The error of the polynomial between the nodes. The estimate at the node is blind to that of a stiff
/// component. Here its slope at the start is compared with the one at the end of the last step, which the
/// collocation makes equal to the rate, but without its errors.
double RadauStepper::dense_error(double h) {
  if (step_ == 0.0) return 0.0;
  static const double correction = largest_correction();
  double largest = 0.0;
  for (Eigen::Index c = 0; c < y_.size(); ++c) {
    double slope = 0.0;
    for (int p = 0; p < stages; ++p) slope += (p + 1) * last_terms_(c, p);
    const double error = correction * std::abs(h / step_ * slope - terms_(c, 0)) / unit_(c);
    if (!(error > largest)) continue;
    largest = error;
    if (error > 1.0) worst_ = static_cast<std::size_t>(c);
  }
  return largest;
}

void RadauStepper::accept(double h, bool last) {
  y_ = new_y_;
  last_terms_ = terms_;
  step_ = h;
  if (last) {
    origin_ = stop_;
    elapsed_ = {};
  } else {
    elapsed_.add(h);
  }
  jacobian_fresh_ = false;
  evaluate(time(), span_of(std::as_const(y_)), span_of(rate_));
}

void RadauStepper::terms(std::span<double> terms) {
  std::copy(last_terms_.data(), last_terms_.data() + last_terms_.size(), terms.begin());
}

void RadauStepper::throw_failed(double h) const {
  rates_.require_none();
  const double t = rates_.time(time());
  if (overflowed_)
    throw Trouble{flag::rhs_failed, t, "a step from t = " + vectrix::detail::text(t) + " overflows", nullptr};
  const std::string why =
      converged_ ? "the error of " + detail::component_name(problem_, worst_) + " is still too large"
                 : "Newton's iteration still does not converge";
  throw Trouble{flag::step_too_short, t, "the step fell below " + vectrix::detail::text(h) + ", and " + why,
                nullptr};
}

std::unique_ptr<Stepper> make_radau_stepper(const Problem& problem) {
  return std::make_unique<RadauStepper>(problem);
}

}  // namespace vectrix::ode
