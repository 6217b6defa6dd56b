#pragma once

/// Exports a symbol from a shared library: for use, or to be thrown, across libraries. All other symbols are
/// hidden, in particular those of the solvers.
#define VECTRIX_EXPORT __attribute__((visibility("default")))
