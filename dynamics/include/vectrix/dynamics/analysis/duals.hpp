#pragma once

#include <memory>
#include <vectrix/dynamics/craft/craft_core.hpp>
#include <vectrix/frames/scalar/dual.hpp>

namespace vectrix {
namespace multibody {

extern template class Tree<Dual>;

}  // namespace multibody
namespace detail {

/// The craft whose motion is asked in duals: its own numbers are constants.
VECTRIX_EXPORT std::shared_ptr<const CraftCoreIn<Dual>> in_duals(const CraftCore& core);

}  // namespace detail
}  // namespace vectrix
