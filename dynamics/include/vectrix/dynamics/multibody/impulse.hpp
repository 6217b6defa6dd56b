#pragma once

#include <vector>
#include <vectrix/dynamics/multibody/tree.hpp>
#include <vectrix/frames/export.hpp>

namespace vectrix::multibody {

/// What the joint of a link, or a rotor, does in an impulse.
enum class InImpulse : char { is_free, keeps_speed, stops };

/// Changes the speeds of the state y by the impulses that stop these joints and rotors; no place changes. All
/// efforts are finite, so that what is free transmits no impulse along its freedoms. It is the law of the
/// accelerations of the craft at rest, with changes of speeds for accelerations:
///     (N, F) = [A H; H^T M] (dw, dv) of each body,   du = -u of a joint that stops,
///     J_s (dO + n.dw) = 0 of a free rotor,   deta' = -d_r.dw - d_t.dv of a mode
/// Momentum and angular momentum are kept; the energy lost is that of a craft with the changes as its speeds.
VECTRIX_EXPORT void stop(const Tree<double>& tree, const std::vector<InImpulse>& links,
                         const std::vector<InImpulse>& rotors, double* y);

/// What is locked or driven keeps its speed, and all else is free.
VECTRIX_EXPORT std::vector<InImpulse> keeping(const std::vector<Hold>& held);

}  // namespace vectrix::multibody
