#include <vectrix/dynamics/multibody/any_scalar.hpp>

namespace vectrix::multibody {

template class Tree<double>;
template VECTRIX_EXPORT int add_gimbal(TreeNumbers<double>&, int, const Square<double>&,
                                       const Column<double>&, const Column<double>&, const Column<double>&,
                                       const Mass<double>&);

}  // namespace vectrix::multibody
