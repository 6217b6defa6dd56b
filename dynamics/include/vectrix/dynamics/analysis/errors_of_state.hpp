#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <string>
#include <vector>
#include <vectrix/dynamics/analysis/duals.hpp>

namespace vectrix::detail {

/// How a motion differs from a reference motion, in as many numbers as the craft has freedoms, in the order
/// of the state:
///     R_h^i = R0_h^i exp([theta]x)          three numbers in place of the four of each quaternion
///     rho = R0^T (r - r0), nu = R0^T (v - v0)  place and velocity of the hub, in the axes of the reference
/// and the differences of all other numbers. For small errors, with the rate w0 of the reference,
///     theta' = dw - w0 x theta,   rho' = nu - w0 x rho,   nu' = R0^T d(r'') - w0 x nu
/// so that a reference that turns steadily with all that acts on it has constant derivatives.
class VECTRIX_EXPORT ErrorsOfState {
 public:
  explicit ErrorsOfState(const CraftCore& core);

  [[nodiscard]] std::size_t size() const { return names_.size(); }
  /// "attitude error x of Hub [rad]"
  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

  /// A coordinate: its place in the errors, and that of its speed in the state.
  struct Coordinate {
    std::size_t error, speed;
  };
  [[nodiscard]] const std::vector<Coordinate>& coordinates() const { return coordinates_; }
  /// Where each quaternion begins in the state, and the errors that replace it; that of the hub is the first.
  struct Turn {
    std::size_t q, w, error;
  };
  [[nodiscard]] const std::vector<Turn>& turns() const { return turns_; }
  /// A number of the state that is neither of a quaternion nor of the hub's place and velocity.
  struct Number {
    std::size_t at, error;
  };
  [[nodiscard]] const std::vector<Number>& numbers() const { return numbers_; }

  /// The state that is off the reference by the errors times e, or with no derivative if they are zero.
  void depart(std::span<const double> reference, const Eigen::VectorXd& errors, std::span<Dual> y) const;
  /// The derivatives of the errors' rates along these errors; ydot is the derivative of y by the time.
  [[nodiscard]] Eigen::VectorXd rates(std::span<const double> reference, const Eigen::VectorXd& errors,
                                      std::span<const Dual> y, std::span<const Dual> ydot) const;

 private:
  bool free_;
  std::vector<Turn> turns_;
  std::vector<Coordinate> coordinates_;
  std::vector<Number> numbers_;
  std::vector<std::string> names_;
};

/// Throws BadInput with the names of a derivative that is not finite.
VECTRIX_EXPORT void require_derivatives(const CraftCore& core, const Eigen::MatrixXd& derivatives,
                                        const std::vector<std::string>& rows,
                                        const std::vector<std::string>& columns);

}  // namespace vectrix::detail
