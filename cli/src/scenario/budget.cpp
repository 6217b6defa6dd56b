#include "scenario/budget.hpp"

#include <algorithm>
#include <cmath>

#include "angle_figures.hpp"
#include "figures.hpp"
#include "plain_words.hpp"

namespace vectrix::cli {
namespace {

enum class Index { absolute, mean, relative };

// The contributions to a measure, carried to the body, and its axis.
class Budget {
  struct Body : moving_frame {};

 public:
  Budget(const Requirement& required, const Scenario& scenario, const BodyFrames& frames)
      : required_(required),
        axis_(direction(
            vector<si::dimensionless>(in<Body>, frames.in_body(scenario.measures[required.measure].axis)))) {
    for (const Contribution& each : scenario.contributions) {
      if (std::find(each.measures.begin(), each.measures.end(), required.measure) == each.measures.end())
        continue;
      const Dcm R_body_from_frame =
          dcm(to<Body>, from<ErrorFrame>, frames.body_from(each.in, each.in_place).toRotationMatrix());
      contributions_.push_back(&each);
      errors_.push_back(R_body_from_frame * each.error);
    }
  }

  [[nodiscard]] bool is_empty() const { return errors_.empty(); }
  /// deg
  [[nodiscard]] double all_together(Index index) const { return figure(line_of_sight(sum(), index)); }
  [[nodiscard]] std::vector<BudgetFigure::Part> parts(Index index) const {
    std::vector<BudgetFigure::Part> all;
    const double square = std::pow(line_of_sight(sum(), index).rms().value(), 2);
    for (std::size_t i = 0; i < errors_.size(); ++i) {
      const LineOfSightError alone = line_of_sight(errors_[i], index);
      const double own = std::pow(alone.rms().value(), 2);
      all.push_back({contributions_[i]->name, contributions_[i]->in, contributions_[i]->kind, figure(alone),
                     square > 0.0 ? own / square : 0.0});
    }
    return all;
  }

 private:
  [[nodiscard]] PointingError<Body> sum() const {
    PointingError<Body> all = errors_.front();
    for (std::size_t i = 1; i < errors_.size(); ++i) all = all + errors_[i];
    return all;
  }
  [[nodiscard]] LineOfSightError line_of_sight(const PointingError<Body>& error, Index index) const {
    if (index == Index::absolute) return absolute_error(error, axis_);
    const auto window = *required_.window * si::second;
    return index == Index::mean ? mean_error(error, axis_, window) : relative_error(error, axis_, window);
  }
  [[nodiscard]] double figure(const LineOfSightError& error) const {
    try {
      return degrees * error.half_cone(0.01 * required_.percent).value();
    } catch (const BadInput& refused) {
      refuse(required_.place, "the budget of this requirement: " + without_function(refused.what()));
    }
  }

  const Requirement& required_;
  Vector<Body, si::dimensionless> axis_;
  std::vector<const Contribution*> contributions_{};
  std::vector<PointingError<Body>> errors_{};
};

std::string name_of(Index index, const Requirement& required) {
  std::string name = index == Index::absolute ? "absolute error (APE)"
                     : index == Index::mean   ? "mean error (MPE)"
                                              : "relative error (RPE)";
  if (index != Index::absolute) name += " in " + detail::text(*required.window) + " s";
  name += ", " + detail::text(required.percent) + " %";
  return name + words_of(required.when);
}

}  // namespace

std::vector<BudgetFigure> budget_figures(const Scenario& scenario, const Flight& flight,
                                         const std::vector<Measured>& measures) {
  std::vector<BudgetFigure> all;
  for (const Requirement& required : scenario.requirements) {
    const Budget budget(required, scenario, flight.flown.frames);
    if (budget.is_empty()) continue;
    const Measured& measure = measures[required.measure];
    const auto add = [&](Index index, const std::vector<double>& errors) {
      const double expected = budget.all_together(index),
                   found = AngleFigures(errors).quantile(required.percent);
      all.push_back({required.measure, name_of(index, required), expected, found,
                     found <= expected
                         ? "within the budget"
                         : "the data exceed the budget by " + decimals(found - expected) + " deg",
                     budget.parts(index)});
      if (index == Index::absolute && !required.by_budget && expected > required.degrees)
        all.back().remark += "; the budget exceeds what is required";
    };
    if (required.window) {
      const WindowErrors errors = errors_in_windows(required, scenario, flight, measure);
      add(Index::mean, errors.of_means);
      add(Index::relative, errors.from_means);
    } else {
      add(Index::absolute, errors_of(required, scenario, flight, measure));
    }
  }
  std::stable_sort(all.begin(), all.end(),
                   [](const auto& one, const auto& other) { return one.measure < other.measure; });
  return all;
}

double limit_by_budget(const Requirement& required, const Scenario& scenario, const BodyFrames& frames) {
  return Budget(required, scenario, frames).all_together(required.window ? Index::relative : Index::absolute);
}

}  // namespace vectrix::cli
