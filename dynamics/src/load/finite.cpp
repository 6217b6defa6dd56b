#include <vectrix/dynamics/load/finite.hpp>

namespace vectrix::detail {

void refuse_value(const std::string& load, const char* what, const std::string& value, const char* rule) {
  throw BadInput(load + ": the " + what + " is " + value + rule);
}

}  // namespace vectrix::detail
