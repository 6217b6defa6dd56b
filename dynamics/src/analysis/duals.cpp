#include <vectrix/dynamics/analysis/duals.hpp>

#include <vectrix/dynamics/multibody/any_scalar.hpp>
#include <vectrix/dynamics/multibody/converted.hpp>

namespace vectrix {

template class multibody::Tree<Dual>;

namespace detail {

std::shared_ptr<const CraftCoreIn<Dual>> in_duals(const CraftCore& core) {
  using multibody::converted;
  std::vector<MountNumbers<Dual>> mounts;
  for (const PlainMount& mount : core.mounts)
    mounts.push_back({converted<Dual>(mount.R_b_from_c), converted<Dual>(mount.r_bc_b)});
  return std::make_shared<CraftCoreIn<Dual>>(
      CraftCoreIn<Dual>{core.plain, multibody::Tree<Dual>(converted<Dual>(core.tree.numbers())),
                        core.component_names, std::move(mounts)});
}

}  // namespace detail
}  // namespace vectrix
