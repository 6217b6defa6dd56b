#pragma once

#include <string>
#include <vector>

#include "scenario/flight.hpp"

namespace vectrix::cli {

/// What a pointing error budget says of one requirement, beside what the data show. All in deg.
struct BudgetFigure {
  struct Part {
    std::string name, in, kind;
    double alone;
    double share;  // of the mean square of all together; those that are known add as vectors, or cancel
  };
  std::size_t measure;
  std::string what;  // "absolute error (APE), 99.7 % in sunlight"
  double budget, data;
  std::string remark;  // "within the budget", "the data exceed the budget by ..."
  std::vector<Part> parts;
};

/// Of each requirement of a measure with contributions: the absolute error, or the mean one of the windows
/// and the relative one at any time of them. Throws BadInput, with the place, for what is no small turn.
std::vector<BudgetFigure> budget_figures(const Scenario& scenario, const Flight& flight,
                                         const std::vector<Measured>& measures);

/// What the budget allows of a requirement, deg.
double limit_by_budget(const Requirement& required, const Scenario& scenario, const BodyFrames& frames);

}  // namespace vectrix::cli
