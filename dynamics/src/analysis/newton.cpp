#include "newton.hpp"

#include <kinsol/kinsol.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <Eigen/QR>
#include <exception>

#include "../ode/sundials.hpp"

namespace vectrix::detail {
namespace {

constexpr double singular = 1e-12;    // a pivot below this part of the largest is rounding
constexpr double longest_step = 100;  // in x/size

/// What the callbacks of KINSOL see.
struct NewtonRun {
  const NewtonProblem* problem;
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> factors;
  std::exception_ptr thrown;

  template <class Call> int guarded(const Call& call) {
    try {
      call();
      return 0;
    } catch (...) {
      thrown = std::current_exception();
      return -1;
    }
  }
};

Eigen::Map<Eigen::VectorXd> map_of(N_Vector vector) {
  const auto span = ode::span_of(vector);
  return {span.data(), static_cast<Eigen::Index>(span.size())};
}
Eigen::Map<Eigen::MatrixXd> map_of(SUNMatrix matrix) {
  return {SUNDenseMatrix_Data(matrix), SUNDenseMatrix_Rows(matrix), SUNDenseMatrix_Columns(matrix)};
}

int function_of(N_Vector x, N_Vector F, void* run) {
  auto& newton = *static_cast<NewtonRun*>(run);
  return newton.guarded([&] { map_of(F) = newton.problem->function(map_of(x)); });
}
int jacobian_of(N_Vector x, N_Vector, SUNMatrix J, void* run, N_Vector, N_Vector) {
  auto& newton = *static_cast<NewtonRun*>(run);
  return newton.guarded([&] { map_of(J) = newton.problem->jacobian(map_of(x)); });
}

SUNLinearSolver_Type type_of(SUNLinearSolver) {
  return SUNLINEARSOLVER_DIRECT;
}
int factorise(SUNLinearSolver solver, SUNMatrix J) {
  auto& newton = *static_cast<NewtonRun*>(solver->content);
  const auto scale = newton.problem->tolerance.cwiseInverse();
  newton.factors.setThreshold(singular);
  newton.factors.compute(scale.asDiagonal() * map_of(J) * newton.problem->size.asDiagonal());
  return 0;
}
int shortest_step(SUNLinearSolver solver, SUNMatrix, N_Vector step, N_Vector right, realtype) {
  auto& newton = *static_cast<NewtonRun*>(solver->content);
  const Eigen::VectorXd scaled = map_of(right).cwiseQuotient(newton.problem->tolerance);
  map_of(step) = newton.factors.solve(scaled).cwiseProduct(newton.problem->size);
  return 0;
}
int free_solver(SUNLinearSolver solver) {
  solver->content = nullptr;
  SUNLinSolFreeEmpty(solver);
  return 0;
}

struct FreeKinsol {
  void operator()(void* memory) const { KINFree(&memory); }
};
struct FreeMatrix {
  void operator()(SUNMatrix matrix) const { SUNMatDestroy(matrix); }
};
struct FreeSolver {
  void operator()(SUNLinearSolver solver) const { SUNLinSolFree(solver); }
};
template <class T> T* allocated(T* memory) {
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

}  // namespace

NewtonResult newton(const NewtonProblem& problem) {
  const sundials::Context context;
  NewtonRun run{&problem, {}, nullptr};
  const auto vector = [&](const Eigen::VectorXd& v) {
    return ode::make_vector({v.data(), static_cast<std::size_t>(v.size())}, context);
  };
  const auto x = vector(problem.start), x_scale = vector(problem.size.cwiseInverse()),
             F_scale = vector(problem.tolerance.cwiseInverse());
  const std::unique_ptr<void, FreeKinsol> memory(allocated(KINCreate(context)));
  const auto n = static_cast<sunindextype>(problem.start.size());
  const std::unique_ptr<_generic_SUNMatrix, FreeMatrix> J(allocated(SUNDenseMatrix(n, n, context)));
  const std::unique_ptr<_generic_SUNLinearSolver, FreeSolver> solver(allocated(SUNLinSolNewEmpty(context)));
  solver->content = &run;
  solver->ops->gettype = type_of;
  solver->ops->setup = factorise;
  solver->ops->solve = shortest_step;
  solver->ops->free = free_solver;

  std::string message;
  KINSetErrHandlerFn(memory.get(), ode::keep_message, &message);
  KINSetUserData(memory.get(), &run);
  ode::require_success(KINInit(memory.get(), function_of, x.get()), "KINInit");
  ode::require_success(KINSetLinearSolver(memory.get(), solver.get(), J.get()), "KINSetLinearSolver");
  ode::require_success(KINSetJacFn(memory.get(), jacobian_of), "KINSetJacFn");
  ode::require_success(KINSetMaxSetupCalls(memory.get(), 1), "KINSetMaxSetupCalls");
  ode::require_success(KINSetFuncNormTol(memory.get(), 1.0), "KINSetFuncNormTol");
  ode::require_success(KINSetMaxNewtonStep(memory.get(), longest_step), "KINSetMaxNewtonStep");
  const int flag = KINSol(memory.get(), x.get(), KIN_LINESEARCH, x_scale.get(), F_scale.get());
  if (run.thrown) std::rethrow_exception(run.thrown);
  long iterations = 0;
  KINGetNumNonlinSolvIters(memory.get(), &iterations);
  return {map_of(x.get()), iterations, ode::take_name(KINGetReturnFlagName(flag))};
}

}  // namespace vectrix::detail
