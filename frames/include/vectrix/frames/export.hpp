#pragma once

/// Marks what one shared library offers to another, or throws through it. Everything else in ours is hidden,
/// the solvers above all.
#define VECTRIX_EXPORT __attribute__((visibility("default")))
