/// The integrators of the library compared with SUNDIALS and odeint, called directly, in the same run. Prints
/// sections of docs/evidence/performance.md.
#include "sections.hpp"

int main() {
  bench::print_long_runs();
  bench::print_segments();
  bench::print_stiff_craft();
}
