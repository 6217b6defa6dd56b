#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vectrix/dynamics/craft/joint_counts.hpp>
#include <vectrix/dynamics/ode/inlined.hpp>
#include <vectrix/simbody/propagate.hpp>

namespace vectrix::detail {
namespace {

/// Simbody's integrator as a stepper of the loop of ode::solve().
class SimbodyStepper final : public ode::Stepper {
 public:
  SimbodyStepper(const PlainSpacecraft& craft, const ode::Problem& problem, const SimbodyPropagation& how,
                 const LoadsFound& loads)
      : craft_(craft),
        problem_(problem),
        tree_(simbody_craft(craft)),
        found_(loads),
        engine_(tree_, how.pair, how.accuracy, how.time_scale.value(),
                [this](double elapsed, const double* y, SimbodyLoads& at) { load(elapsed, y, at); }),
        state_(problem.initial_state.size()) {}

  void enter_segment(double start, double end) override {
    start_ = start;
    end_ = end;
  }
  void evaluate(double elapsed, std::span<const double> y, std::span<double> ydot) override {
    guarded(elapsed, [&] { engine_.rates(elapsed, y.data(), ydot.data()); });
  }
  void restart(double elapsed, std::span<const double> y, double stop, double longest) override {
    reached_ = elapsed;
    guarded(elapsed, [&] { engine_.start(elapsed, y.data(), stop, longest); });
  }
  double step() override {
    guarded(reached_, [&] { reached_ = engine_.step(); });
    return reached_;
  }
  [[nodiscard]] std::span<const double> state() const override {
    engine_.state(state_.data());
    return state_;
  }
  void rate(std::span<double> ydot) override { engine_.rate(ydot.data()); }
  [[nodiscard]] std::size_t degree() const override { return 0; }
  void terms(std::span<double>) override {}
  [[nodiscard]] std::size_t evaluations() const override { return engine_.evaluations(); }
  [[nodiscard]] std::size_t error_test_failures() const override { return engine_.error_test_failures(); }

 private:
  [[nodiscard]] double time(double elapsed) const { return std::clamp(start_ + elapsed, start_, end_); }

  void load(double elapsed, const double* y, SimbodyLoads& at) {
    const double t = time(elapsed);
    bool finite = true;
    try {
      const multibody::Work<double>& found = found_(t, y);
      finite = not_finite_load(craft_, found).empty();
      copy_loads(found, at);
    } catch (...) {
      throw ode::Trouble{ode::flag::rhs_failed, t, "a load threw", std::current_exception()};
    }
    if (!finite)
      throw ode::Trouble{ode::flag::rhs_failed, t,
                         "a load is not finite at t = " + text(t) +
                             ode::detail::why_not_finite(problem_, start_, t, std::span(y, state_.size())),
                         nullptr};
  }
  /// An exception of Simbody itself: no step is short enough.
  template <class Action> void guarded(double elapsed, const Action& action) const {
    try {
      action();
    } catch (const ode::Trouble&) {
      throw;
    } catch (const std::exception&) {
      throw ode::Trouble{ode::flag::step_too_short, time(elapsed), "Simbody", std::current_exception()};
    }
  }

  const PlainSpacecraft& craft_;
  const ode::Problem& problem_;
  SimbodyCraft tree_;
  const LoadsFound& found_;
  SimbodyEngine engine_;
  mutable std::vector<double> state_;
  double start_ = 0.0, end_ = 0.0, reached_ = 0.0;
};

/// Simbody integrates unit quaternions. Those of a state may have any norm.
void make_units(const PlainSpacecraft& craft, std::vector<double>& y) {
  const auto make_unit = [&](std::size_t at) {
    Eigen::Map<Eigen::Vector4d> q(&y[at]);
    q /= q.stableNorm();
  };
  make_unit(0);
  std::size_t at = craft.motion == HubMotion::free ? 13 : 7;
  for (const PlainBody& body : craft.bodies) {
    if (body.joint == JointKind::ball || body.joint == JointKind::free) make_unit(at);
    at += counts_of(body.joint).positions;
  }
}

}  // namespace

ode::Solution solve_with_simbody(const PlainSpacecraft& craft, ode::Problem problem,
                                 const SimbodyPropagation& how, const LoadsFound& loads) {
  const auto require = [&](bool condition, const char* what, double number) {
    if (!condition) throw BadInput(problem.caller + ": " + what + ", got " + text(number));
  };
  require(how.accuracy != 0.0,
          "the accuracy must be between 0 and 1; it is left out, or 0, and has no default", how.accuracy);
  require(how.accuracy > 0.0 && how.accuracy < 1.0, "the accuracy must be between 0 and 1", how.accuracy);
  const double scale = how.time_scale.value();
  require(std::isfinite(scale) && scale > 0.0, "the time scale must be finite and greater than 0 s", scale);
  problem.relative_tolerance = how.accuracy;
  problem.absolute_tolerances.assign(problem.initial_state.size(), how.accuracy);
  make_units(craft, problem.initial_state);
  return ode::detail::solve_with(problem, [&]() -> std::unique_ptr<ode::Stepper> {
    try {
      return std::make_unique<SimbodyStepper>(craft, problem, how, loads);
    } catch (const BadInput&) {
      throw;
    } catch (const std::exception& error) {
      throw BadInput(problem.caller + ": Simbody refuses the craft: " + error.what());
    }
  });
}

}  // namespace vectrix::detail
