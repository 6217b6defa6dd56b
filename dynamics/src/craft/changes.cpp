#include <vectrix/dynamics/craft/changes.hpp>

namespace vectrix::detail {

void refuse_empty_function(const std::string& door) {
  throw BadInput(door + ": the function is empty");
}

double checked_period(double period) {
  if (!(period > 0.0 && std::isfinite(period)))
    throw BadInput("every: the period is " + text(period) + " s; it must be positive");
  return period;
}

double checked_latency(double latency) {
  if (!(latency >= 0.0 && std::isfinite(latency)))
    throw BadInput("every: the latency is " + text(latency) + " s; it must not be negative");
  return latency;
}

std::vector<double> checked_times(const std::vector<Quantity<si::time>>& times) {
  std::vector<double> checked;
  for (const auto& time : times) {
    const double t = time.value();
    if (!std::isfinite(t)) throw BadInput("at_times: a time is " + text(t) + " s");
    if (!checked.empty() && !(t > checked.back()))
      throw BadInput("at_times: " + text(t) + " s follows " + text(checked.back()) +
                     " s; times must increase");
    checked.push_back(t);
  }
  return checked;
}

}  // namespace vectrix::detail
