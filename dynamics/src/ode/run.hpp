#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include <vectrix/dynamics/ode/solve.hpp>

#include "rate.hpp"
#include "record.hpp"
#include "roots.hpp"
#include "stepper.hpp"
#include "trouble.hpp"

namespace vectrix::ode {

/// One call of solve().
class Run {
 public:
  explicit Run(const Problem& problem);
  Solution operator()();

 private:
  void integrate();
  [[nodiscard]] std::vector<double> segment_ends() const;
  void integrate_segment();
  void restart(double elapsed, double stop, double longest);
  double step();
  [[nodiscard]] double time(double elapsed) const;
  void append(double elapsed, int rate_flag);
  void stop_at_first_stopping_event();
  void fill_outputs();
  [[noreturn]] void raise(int flag, double t) const;
  [[noreturn]] void fail(const Trouble& trouble);

  const Problem& problem_;
  Rate rate_;
  std::unique_ptr<Stepper> stepper_;
  RootFinder roots_;
  std::shared_ptr<Record> record_;
  double segment_start_ = 0.0;
  double segment_end_ = 0.0;
  std::vector<double> state_;  ///< of the node being appended
  std::vector<double> slope_;
};

}  // namespace vectrix::ode
