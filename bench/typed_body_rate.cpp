#include "typed_kernels.hpp"

// Apart from the other kernels: a law that is used twice in one file may be called there instead of inlined.
namespace typed {

void body_rate(const detail::StateLayout<A, B>& layout, const Scenario<A, B>& scenario,
               std::span<const double> y, std::span<double> ydot) {
  layout.derivative(scenario, 0.0, 0.0, y, ydot);
}

}  // namespace typed
