#include <arkode/arkode_arkstep.h>

#include "sundials.hpp"
#include "sundials_stepper.hpp"

namespace vectrix::ode {
namespace {

struct FreeArkode {
  void operator()(void* memory) const { ARKStepFree(&memory); }
};

/// Explicit Runge-Kutta through ARKStep. ERKStep of SUNDIALS 6.4 loses one order with Fehlberg 7(8): if the
/// last abscissa of a table is 1, it assumes that the last stage is the new state.
class ArkodeStepper final : public SundialsStepper {
 public:
  ArkodeStepper(const Problem& problem)
      : SundialsStepper(problem),
        state_(make_vector(problem.initial_state, context_)),
        tolerances_(make_vector(problem.absolute_tolerances, context_)),
        memory_(ARKStepCreate(call_rate, nullptr, 0.0, state_.get(), context_)) {
    if (!memory_) throw std::bad_alloc();
    const auto table =
        problem.method == Method::arkode_fehlberg_8 ? ARKODE_FEHLBERG_13_7_8 : ARKODE_DORMAND_PRINCE_7_4_5;
    require_success(ARKStepSetErrHandlerFn(memory_.get(), keep_message, &message_), "ARKStepSetErrHandlerFn");
    require_success(ARKStepSetUserData(memory_.get(), static_cast<SundialsStepper*>(this)),
                    "ARKStepSetUserData");
    require_success(ARKStepSetTableNum(memory_.get(), ARKODE_DIRK_NONE, table), "ARKStepSetTableNum");
    require_success(ARKStepSVtolerances(memory_.get(), problem.relative_tolerance, tolerances_.get()),
                    "ARKStepSVtolerances");
  }

  std::span<const double> state() const override { return span_of(state_.get()); }

  std::string flag_name(int flag) const override { return take_name(ARKStepGetReturnFlagName(flag)); }

  std::string worst_component() const override {
    return worst_of(memory_.get(), state_.get(), ARKStepGetEstLocalErrors, ARKStepGetErrWeights);
  }

 private:
  int reinitialize(std::span<const double> y, double longest) override {
    std::ranges::copy(y, span_of(state_.get()).begin());
    const int flag = ARKStepReInit(memory_.get(), call_rate, nullptr, 0.0, state_.get());
    return flag < 0 ? flag : ARKStepSetMaxStep(memory_.get(), longest);
  }

  int set_stop(double clock) override {
    stop_ = clock;
    return ARKStepSetStopTime(memory_.get(), clock);
  }

  int advance(double& clock, double& length) override {
    const int flag = ARKStepEvolve(memory_.get(), stop_, state_.get(), &clock, ARK_ONE_STEP);
    if (flag >= 0) ARKStepGetLastStep(memory_.get(), &length);
    return flag;
  }

  std::size_t failures_since_restart() const override {
    long failures = 0;
    ARKStepGetNumErrTestFails(memory_.get(), &failures);
    return static_cast<std::size_t>(failures);
  }

  sundials::Context context_;
  VectorPtr state_;
  VectorPtr tolerances_;
  std::unique_ptr<void, FreeArkode> memory_;
  double stop_ = 0.0;  ///< on the integrator's clock
};

}  // namespace

std::unique_ptr<Stepper> make_arkode_stepper(const Problem& problem) {
  return std::make_unique<ArkodeStepper>(problem);
}

}  // namespace vectrix::ode
