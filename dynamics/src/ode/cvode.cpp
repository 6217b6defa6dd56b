#include <cvode/cvode.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include "sundials.hpp"
#include "sundials_stepper.hpp"

namespace vectrix::ode {
namespace {

struct FreeCvode {
  void operator()(void* memory) const { CVodeFree(&memory); }
};
struct FreeMatrix {
  void operator()(SUNMatrix matrix) const { SUNMatDestroy(matrix); }
};
struct FreeLinearSolver {
  void operator()(SUNLinearSolver solver) const { SUNLinSolFree(solver); }
};
struct FreeNonlinearSolver {
  void operator()(SUNNonlinearSolver solver) const { SUNNonlinSolFree(solver); }
};

/// Adams with fixed-point iteration, or BDF with Newton iteration and a dense difference-quotient Jacobian.
class CvodeStepper final : public SundialsStepper {
 public:
  CvodeStepper(const Problem& problem)
      : SundialsStepper(problem),
        state_(make_vector(problem.initial_state, context_)),
        scratch_(make_vector(problem.initial_state, context_)),
        tolerances_(make_vector(problem.absolute_tolerances, context_)),
        memory_(CVodeCreate(problem.method == Method::cvode_bdf ? CV_BDF : CV_ADAMS, context_)) {
    if (!memory_) throw std::bad_alloc();
    require_success(CVodeSetErrHandlerFn(memory_.get(), keep_message, &message_), "CVodeSetErrHandlerFn");
    require_success(CVodeInit(memory_.get(), call_rate, 0.0, state_.get()), "CVodeInit");
    require_success(CVodeSetUserData(memory_.get(), static_cast<SundialsStepper*>(this)), "CVodeSetUserData");
    require_success(CVodeSVtolerances(memory_.get(), problem.relative_tolerance, tolerances_.get()),
                    "CVodeSVtolerances");
    problem.method == Method::cvode_bdf ? attach_newton() : attach_fixed_point();
  }

  std::span<const double> state() const override { return span_of(state_.get()); }

  /// The slope of the integrator's own polynomial. It needs no evaluation, interpolates as well as f(t, y),
  /// and does not amplify the error of a stiff component, as f(t, y) would.
  void rate(std::span<double> ydot) override {
    require(CVodeGetDky(memory_.get(), clock_, 1, scratch_.get()));
    std::ranges::copy(span_of(scratch_.get()), ydot.begin());
  }

  std::string flag_name(int flag) const override { return take_name(CVodeGetReturnFlagName(flag)); }

  std::string worst_component() const override {
    return worst_of(memory_.get(), state_.get(), CVodeGetEstLocalErrors, CVodeGetErrWeights);
  }

 private:
  int reinitialize(std::span<const double> y, double longest) override {
    std::ranges::copy(y, span_of(state_.get()).begin());
    const int flag = CVodeReInit(memory_.get(), 0.0, state_.get());
    return flag < 0 ? flag : CVodeSetMaxStep(memory_.get(), longest);
  }

  int set_stop(double clock) override {
    stop_ = clock;
    return CVodeSetStopTime(memory_.get(), clock);
  }

  int advance(double& clock, double& length) override {
    const int flag = CVode(memory_.get(), stop_, state_.get(), &clock, CV_ONE_STEP);
    if (flag >= 0) CVodeGetLastStep(memory_.get(), &length);
    return flag;
  }

  std::size_t failures_since_restart() const override {
    long failures = 0;
    CVodeGetNumErrTestFails(memory_.get(), &failures);
    return static_cast<std::size_t>(failures);
  }

  void attach_fixed_point() {
    nonlinear_.reset(SUNNonlinSol_FixedPoint(state_.get(), 0, context_));
    require_success(CVodeSetNonlinearSolver(memory_.get(), nonlinear_.get()), "CVodeSetNonlinearSolver");
  }

  void attach_newton() {
    const auto size = N_VGetLength(state_.get());
    matrix_.reset(SUNDenseMatrix(size, size, context_));
    linear_.reset(SUNLinSol_Dense(state_.get(), matrix_.get(), context_));
    require_success(CVodeSetLinearSolver(memory_.get(), linear_.get(), matrix_.get()),
                    "CVodeSetLinearSolver");
  }

  sundials::Context context_;
  VectorPtr state_;
  VectorPtr scratch_;
  VectorPtr tolerances_;
  std::unique_ptr<_generic_SUNMatrix, FreeMatrix> matrix_;
  std::unique_ptr<_generic_SUNLinearSolver, FreeLinearSolver> linear_;
  std::unique_ptr<_generic_SUNNonlinearSolver, FreeNonlinearSolver> nonlinear_;
  std::unique_ptr<void, FreeCvode> memory_;
  double stop_ = 0.0;  ///< on the integrator's clock
};

}  // namespace

std::unique_ptr<Stepper> make_cvode_stepper(const Problem& problem) {
  return std::make_unique<CvodeStepper>(problem);
}

}  // namespace vectrix::ode
