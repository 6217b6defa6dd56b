#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <vectrix/dynamics/ode/solve.hpp>
#include <vectrix/dynamics/ode/stepper.hpp>

#include "record.hpp"
#include "roots.hpp"

namespace vectrix::ode {

/// One call of solve(): the loop over segments and steps, for all steppers.
class Run {
 public:
  Run(const Problem& problem, std::unique_ptr<Stepper> stepper);
  Solution operator()();

 private:
  void integrate();
  [[nodiscard]] std::vector<double> segment_ends() const;
  void change(std::span<const Event> ended_by);
  [[nodiscard]] std::vector<Event> integrate_segment();
  double step();
  [[nodiscard]] std::string what_limits_the_steps() const;
  [[nodiscard]] double time(double elapsed) const;
  void choose_stop(double elapsed);
  void keep_terms();
  [[nodiscard]] std::vector<Event> end_at_first_ending_event();
  [[nodiscard]] std::vector<Event> end_at(const Event& first, std::vector<Zero> zeros);
  void keep_until(double known);
  void fill_outputs();
  [[noreturn]] void fail(const Trouble& trouble);

  const Problem& problem_;
  std::unique_ptr<Stepper> stepper_;
  RootFinder roots_;
  std::shared_ptr<Record> record_;
  double segment_start_ = 0.0;
  double segment_end_ = 0.0;
  double stop_ = 0.0;               ///< where steps must end next, since the start of the segment
  double stop_time_ = 0.0;          ///< the same in the caller's time
  std::vector<double> look_again_;  ///< times at which steps end, to see zeros that were seen before
  std::size_t next_output_ = 0;
  bool kept_for_good_ = true;  ///< the interpolant of the last step
  std::size_t parts_ = 0;      ///< steps of the stepper in the last interval between nodes
  std::vector<double> state_;  ///< of the node being appended
  std::vector<double> slope_;
  std::vector<double> terms_;  ///< of the step's interpolant
};

}  // namespace vectrix::ode
