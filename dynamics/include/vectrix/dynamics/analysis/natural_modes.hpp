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

/// A motion x(t) = Re(shape exp(eigenvalue t)) of a linear system without inputs.
struct NaturalMode {
  std::complex<double> eigenvalue;           ///< 1/s; of a pair the one with a positive imaginary part
  Quantity<si::angular_velocity> frequency;  ///< |eigenvalue|: without damping it oscillates so fast
  double damping_ratio;    ///< -Re(eigenvalue)/|eigenvalue|; 1 or -1 if it does not oscillate
  Eigen::VectorXcd shape;  ///< the largest number is 1
  /// |l_i shape_i| / sum of all, with the left eigenvector l: the part of each coordinate, in any units.
  Eigen::VectorXd participation;

  bool oscillates() const { return eigenvalue.imag() > 0.0; }
};

/// The modes of a linear system by frequency, and how many of its eigenvalues are zero: those of a free body,
/// which drifts. They may have fewer eigenvectors than their number.
struct NaturalModes {
  std::vector<NaturalMode> list;
  std::size_t zeros;
  std::vector<std::string> state_names;
};

/// The natural modes of x' = A x. Zero eigenvalues are counted by singular values, as the dimension of the
/// chain of null spaces of A, and taken out by orthogonal transformations before the others are found
/// (Golub and Wilkinson 1976): an eigenvalue that is twice zero would else come out near the root of the
/// rounding. A singular value is zero if it is up to `rounding` times the largest, after balancing; of an A
/// whose numbers have fewer digits this must be more. Throws BadInput if a number of A is not finite.
VECTRIX_EXPORT NaturalModes natural_modes(const LinearSystem& system, double rounding = 1e-14);

/// One line for each mode: frequency, damping ratio, and the coordinates with more than a tenth of it.
VECTRIX_EXPORT std::ostream& operator<<(std::ostream& out, const NaturalModes& modes);

}  // namespace vectrix
