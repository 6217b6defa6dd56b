#include <vectrix/dynamics/load/prescribed.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vectrix/frames/errors.hpp>
#include <vectrix/frames/scalar/larger.hpp>

namespace vectrix::detail {
namespace {

/// Numbers of six digits, typed by hand, differ by less; a wrong factor, such as that of degrees, by more.
constexpr double derivatives_agree = 1e-5;
/// Where a run of usual tolerance ends, another may start.
constexpr double starts_agree = 1e-6, starts_agree_near_zero = 1e-9;
constexpr int samples = 5;

constexpr double epsilon = std::numeric_limits<double>::epsilon();

struct Slope {
  double value = 0.0, error = std::numeric_limits<double>::infinity();
};

/// Of a step and the next smaller one. No power of it is near a whole number: where a step is a period of the
/// function, it looks constant, and the next must not look so too.
constexpr double step_ratio = 1.7;

/// The derivative of a function by differences of ever smaller steps h, extrapolated to h = 0, and its error
/// (Ridders); of all steps that with the least error.
class FallingSteps {
 public:
  void add(double h, double before, double after, double rounding) {
    std::array<double, order> next{};
    next[0] = (after - before) / (2.0 * h);
    const std::size_t known = std::min(rows_, order - 1);
    double factor = 1.0;
    for (std::size_t k = 1; k <= known; ++k) {
      factor *= step_ratio * step_ratio;
      next[k] = next[k - 1] + (next[k - 1] - last_[k - 1]) / (factor - 1.0);
      const double error =
          larger(std::abs(next[k] - next[k - 1]), std::abs(next[k] - last_[k - 1])) + rounding / h;
      if (error < best_.error) best_ = {next[k], error};
    }
    last_ = next;
    ++rows_;
  }
  [[nodiscard]] const Slope& best() const { return best_; }

 private:
  static constexpr std::size_t order = 6;
  std::array<double, order> last_{};
  std::size_t rows_ = 0;
  Slope best_;
};

std::string at(const GivenAxis& axis, double t) {
  return axis.joint + " at " + text(t) + " s: ";
}
JointNumbers finite_motion(const GivenAxis& axis, double t) {
  const JointNumbers given = axis.motion(t);
  const char* names[]{"coordinate", "speed", "acceleration"};
  for (std::size_t i = 0; i < 3; ++i)
    if (!std::isfinite(given[i])) throw BadInput(at(axis, t) + "the " + names[i] + " is " + text(given[i]));
  return given;
}

/// The slope of number i at a time within (t - reach, t + reach), where the numbers are below `largest`,
/// which say from what step on it is worth to look.
Slope slope(const GivenAxis& axis, std::size_t i, double t, double reach, const JointNumbers& largest) {
  const double time_scale = largest[i] / largest[i + 1];
  FallingSteps steps;
  for (double h = (time_scale > 0.0 ? std::min(reach, time_scale) : reach) / step_ratio;
       h > 64.0 * epsilon * std::abs(t) && h > epsilon * reach; h /= step_ratio) {
    const double later = t + h, earlier = t - h;
    const double after = finite_motion(axis, later)[i], before = finite_motion(axis, earlier)[i];
    steps.add(0.5 * (later - earlier), before, after, epsilon * (largest[i] + std::abs(t) * largest[i + 1]));
    if (steps.best().error <= 1e-3 * derivatives_agree * largest[i + 1]) break;
  }
  return steps.best();
}

}  // namespace

void require_motion(const GivenAxis& axis, double start, double end, double q, double u) {
  const JointNumbers first = finite_motion(axis, start);
  JointNumbers largest{};
  const auto see = [&](const JointNumbers& given) {
    for (std::size_t i = 0; i < 3; ++i) largest[i] = larger(largest[i], std::abs(given[i]));
  };
  see(first);
  const auto time = [&](int sample) {
    return start + std::fmod(0.5 + sample * 0.6180339887498949, 1.0) * (end - start);
  };
  for (int sample = 0; sample < samples; ++sample) see(finite_motion(axis, time(sample)));

  const char* units[]{axis.coordinate, axis.speed, axis.acceleration};
  const char* names[]{"coordinate", "speed", "acceleration"};
  const auto number = [&](double x, std::size_t i) { return text(x) + " " + units[i]; };
  const std::size_t known = axis.coordinate ? 0 : 1;
  for (int sample = 0; sample < samples; ++sample)
    for (std::size_t i = known; i < 2; ++i) {
      const double t = time(sample), given = axis.motion(t)[i + 1];
      const auto [found, error] = slope(axis, i, t, std::min(t - start, end - t), largest);
      if (std::abs(found - given) > derivatives_agree * largest[i + 1] + 10.0 * error)
        throw BadInput(at(axis, t) + "the " + names[i + 1] + " is " + number(given, i + 1) + ", but the " +
                       names[i] + " changes by " + number(found, i + 1));
    }
  const double starts[]{q, u};
  for (std::size_t i = known; i < 2; ++i)
    if (!(std::abs(starts[i] - first[i]) <= starts_agree * largest[i] + starts_agree_near_zero))
      throw BadInput(at(axis, start) + "the " + names[i] + " is " + number(first[i], i) +
                     ", but the run starts with " + number(starts[i], i));
}

}  // namespace vectrix::detail
