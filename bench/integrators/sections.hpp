#pragma once

namespace bench {

/// Each prints a section of docs/evidence/performance.md.
void print_long_runs();
void print_segments();
void print_stiff_craft();

}  // namespace bench
