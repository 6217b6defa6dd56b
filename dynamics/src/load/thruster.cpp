#include <vectrix/dynamics/load/thruster.hpp>

namespace vectrix::detail {

std::vector<Quantity<si::time>> switches_of(const std::vector<FiringInterval>& intervals) {
  if (intervals.empty()) throw BadInput("thruster: no interval");
  std::vector<Quantity<si::time>> switches;
  for (const FiringInterval& interval : intervals) {
    for (const auto& time : {interval.start, interval.end}) {
      finite("thruster", "time of a switch", time);
      if (!switches.empty() && !(time > switches.back()))
        throw BadInput("thruster: the switch at " + text(time) + " follows that at " + text(switches.back()));
      switches.push_back(time);
    }
  }
  return switches;
}

}  // namespace vectrix::detail
