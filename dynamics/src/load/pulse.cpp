#include <vectrix/dynamics/load/pulse.hpp>

namespace vectrix::detail {

void require_pulse(const Quantity<si::time>& start, const Quantity<si::time>& end) {
  finite("pulse", "start", start);
  finite("pulse", "end", end);
  if (!(end > start)) throw BadInput("pulse: it starts at " + text(start) + " and ends at " + text(end));
}

}  // namespace vectrix::detail
