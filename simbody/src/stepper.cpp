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
    try {
      copy_loads(found_(t, y), at);
    } catch (...) {
      throw ode::Trouble{ode::flag::rhs_failed, t, "a load threw", std::current_exception()};
    }
    require_finite(t, at);
  }
  void require_finite(double t, const SimbodyLoads& at) const {
    const auto require = [&](std::span<const double> numbers, const char* what, const std::string& of) {
      for (const double number : numbers)
        if (!std::isfinite(number))
          throw ode::Trouble{ode::flag::rhs_failed, t,
                             what + of + " is " + text(number) + " at t = " + text(t), nullptr};
    };
    for (std::size_t b = 0; b < at.forces.size(); ++b) {
      const std::string& name = b == 0 ? craft_.hub : tree_.links[b - 1].name;
      require(at.forces[b], "the force on ", name);
      require(at.torques[b], "the torque on ", name);
    }
    std::span<const double> efforts = at.efforts, given = at.given;
    for (const PlainBody& body : craft_.bodies) {
      const std::size_t count = counts_of(body.joint).speeds;
      require(efforts.first(count), "the effort of ", body.name);
      require(given.first(count), "the given acceleration of ", body.name);
      efforts = efforts.subspan(count);
      given = given.subspan(count);
    }
    for (std::size_t i = 0; i < at.motors.size(); ++i) {
      require(std::span(at.motors).subspan(i, 1), "the motor torque of ", craft_.rotors[i].name);
      require(std::span(at.given_spins).subspan(i, 1), "the given acceleration of ", craft_.rotors[i].name);
    }
    for (std::size_t i = 0; i < at.modal.size(); ++i)
      require(std::span(at.modal).subspan(i, 1), "the force on ", craft_.modes[i].name);
    require(at.field_i, "the field on ", craft_.hub);
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
