#include "typed_kernels.hpp"

// In a file of its own: where a file uses a law twice, the compiler may call the law instead of inlining it.
namespace typed {

void body_rate(const detail::StateLayout<A, B>& layout, const Scenario<A, B>& scenario,
               std::span<const double> y, std::span<double> ydot) {
  layout.derivative(scenario, 0.0, 0.0, y, ydot);
}

}  // namespace typed
