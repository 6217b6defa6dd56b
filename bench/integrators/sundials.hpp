#pragma once

#include <arkode/arkode_arkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>
#include <stdexcept>
#include <sundials/sundials_context.hpp>

#include "attitude.hpp"
#include "engines.hpp"

/// A problem through SUNDIALS, called directly.
namespace bench {

template <auto release> struct Releases {
  template <class T> void operator()(T* held) const { release(held); }
};
inline void free_arkode(void* memory) {
  ARKStepFree(&memory);
}
inline void free_cvode(void* memory) {
  CVodeFree(&memory);
}
using Vector = std::unique_ptr<_generic_N_Vector, Releases<N_VDestroy>>;

inline constexpr long most_steps = 10'000'000;

/// The state, the function, and what it has cost.
template <class P> struct Called {
  P& problem;
  std::size_t evaluations = 0;
  sundials::Context context{};
  Vector y{N_VNew_Serial(P::size, context)};

  Called(P& given, const Numbers<P::size>& initial) : problem(given) { put(initial); }
  void put(const Numbers<P::size>& numbers) { std::ranges::copy(numbers, N_VGetArrayPointer(y.get())); }
  [[nodiscard]] Attitude at_end() const { return attitude(N_VGetArrayPointer(y.get())); }
  static int rates(realtype, N_Vector y, N_Vector ydot, void* self) {
    auto& called = *static_cast<Called*>(self);
    ++called.evaluations;
    called.problem(N_VGetArrayPointer(y), N_VGetArrayPointer(ydot));
    return 0;
  }
};

inline void require(int flag) {
  if (flag < 0) throw std::runtime_error("SUNDIALS fails");
}

/// ARKODE's Fehlberg 7(8), of ARKStep: ERKStep takes twice as many steps to the same error.
template <class P> class Arkode {
 public:
  Arkode(P& problem, double tolerance)
      : called_(problem, problem.initial),
        memory_(ARKStepCreate(Called<P>::rates, nullptr, 0.0, called_.y.get(), called_.context)) {
    void* memory = memory_.get();
    require(ARKStepSetErrFile(memory, nullptr));
    require(ARKStepSetTableNum(memory, ARKODE_DIRK_NONE, ARKODE_FEHLBERG_13_7_8));
    require(ARKStepSStolerances(memory, tolerance, tolerance));
    require(ARKStepSetUserData(memory, &called_));
    require(ARKStepSetMaxNumSteps(memory, most_steps));
  }
  /// From where it is.
  void run_to(double until) {
    require(ARKStepSetStopTime(memory_.get(), until));
    require(ARKStepEvolve(memory_.get(), until, called_.y.get(), &t_, ARK_NORMAL));
  }
  void restart() { require(ARKStepReInit(memory_.get(), Called<P>::rates, nullptr, t_, called_.y.get())); }
  [[nodiscard]] Result result() const { return {called_.at_end(), called_.evaluations}; }

 private:
  Called<P> called_;
  std::unique_ptr<void, Releases<free_arkode>> memory_;
  double t_ = 0.0;
};

/// CVODE, by Adams with fixed-point iteration, or by BDF with Newton's and a dense Jacobian from differences.
template <int formula, class P> class Cvode {
 public:
  Cvode(P& problem, double tolerance)
      : called_(problem, problem.initial), memory_(CVodeCreate(formula, called_.context)) {
    void* memory = memory_.get();
    require(CVodeSetErrFile(memory, nullptr));
    require(CVodeInit(memory, Called<P>::rates, 0.0, called_.y.get()));
    require(CVodeSStolerances(memory, tolerance, tolerance));
    require(CVodeSetUserData(memory, &called_));
    require(CVodeSetMaxNumSteps(memory, most_steps));
    if constexpr (formula == CV_ADAMS) {
      nonlinear_.reset(SUNNonlinSol_FixedPoint(called_.y.get(), 0, called_.context));
      require(CVodeSetNonlinearSolver(memory, nonlinear_.get()));
    } else {
      matrix_.reset(SUNDenseMatrix(P::size, P::size, called_.context));
      linear_.reset(SUNLinSol_Dense(called_.y.get(), matrix_.get(), called_.context));
      require(CVodeSetLinearSolver(memory, linear_.get(), matrix_.get()));
    }
  }
  void run_to(double until) {
    require(CVodeSetStopTime(memory_.get(), until));
    require(CVode(memory_.get(), until, called_.y.get(), &t_, CV_NORMAL));
  }
  void restart() { require(CVodeReInit(memory_.get(), t_, called_.y.get())); }
  [[nodiscard]] Result result() const { return {called_.at_end(), called_.evaluations}; }

 private:
  Called<P> called_;
  std::unique_ptr<_generic_SUNMatrix, Releases<SUNMatDestroy>> matrix_;
  std::unique_ptr<_generic_SUNLinearSolver, Releases<SUNLinSolFree>> linear_;
  std::unique_ptr<_generic_SUNNonlinearSolver, Releases<SUNNonlinSolFree>> nonlinear_;
  std::unique_ptr<void, Releases<free_cvode>> memory_;
  double t_ = 0.0;
};
template <class P> using Adams = Cvode<CV_ADAMS, P>;
template <class P> using Bdf = Cvode<CV_BDF, P>;

template <template <class> class Peer, class P> auto called_directly(const P& problem) {
  return [own = problem](double tolerance) mutable {
    Peer<P> peer(own, tolerance);
    peer.run_to(own.end);
    return peer.result();
  };
}

}  // namespace bench
