#pragma once

#include <Eigen/Core>
#include <complex>
#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>
#include <vectrix/dynamics/analysis/linear_system.hpp>
#include <vectrix/frames/export.hpp>

namespace vectrix {

/// What the inputs of a linear system can move.
struct Controllability {
  std::size_t controllable;  ///< dimension of the states that the inputs reach from zero
  std::size_t size;          ///< of the state
  /// Rows z: combinations z x of the coordinates that no input moves, such as a momentum of the whole craft.
  /// Each has the factor 1 for a coordinate that no other row has.
  Eigen::MatrixXd unmoved;
  std::vector<std::complex<double>> unmoved_eigenvalues;  ///< how they go on by themselves, 1/s
  std::vector<std::string> state_names;
};

/// The controllability of (A, B) by the staircase algorithm: orthogonal transformations, and a singular value
/// decomposition for each step (Paige 1981), after balancing and with A and the columns of B scaled to 1. A
/// singular value is zero if it is below `tolerance` times 1. Throws BadInput if a number is not finite.
VECTRIX_EXPORT Controllability controllability(const LinearSystem& system, double tolerance = 1e-10);

/// How many states are controllable; then each unmoved combination with its largest coordinates.
VECTRIX_EXPORT std::ostream& operator<<(std::ostream& out, const Controllability& controllability);

}  // namespace vectrix
