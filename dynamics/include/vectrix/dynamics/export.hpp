#pragma once

/// Marks what the shared library vectrix_dynamics offers; everything else in it is hidden, the solvers above
/// all.
#define VECTRIX_EXPORT __attribute__((visibility("default")))
