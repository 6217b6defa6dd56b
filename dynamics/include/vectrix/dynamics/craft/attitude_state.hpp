#pragma once

#include <span>
#include <vectrix/dynamics/ode/solve.hpp>
#include <vectrix/frames/export.hpp>

namespace vectrix {

/// How the attitude is stored while it is integrated: four numbers of a quaternion, scalar first, or nine of
/// a DCM, by columns. Both follow their kinematic law. Neither is projected back during the run: the
/// trajectory reports how far they drifted.
enum class AttitudeState { quaternion, dcm };

namespace detail {

/// The numbers of a state from those that are integrated: q of the rotation nearest to the nine of R_h^i,
/// then the others. Those of a quaternion as they are.
VECTRIX_EXPORT void read_state(AttitudeState attitude, std::span<const double> integrated,
                               std::span<double> y);

/// Solves the problem of a craft, which is in the numbers of its state; with the nine of R_h^i in place of q:
///     d/dt R_h^i = R_h^i [w_ih^h]x
VECTRIX_EXPORT ode::Solution solve_in(AttitudeState attitude, ode::Problem problem);

/// How far the attitude is from a rotation: | |q|/|q_0| - 1 |, or the largest entry of |R^T R - I|.
VECTRIX_EXPORT double attitude_drift(AttitudeState attitude, std::span<const double> integrated,
                                     std::span<const double> at_start);

}  // namespace detail
}  // namespace vectrix
