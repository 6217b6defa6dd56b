#include <vectrix/dynamics/mass/inertia.hpp>
#include <vectrix/dynamics/mass/parallel_axes.hpp>

namespace vectrix::detail {

template VECTRIX_EXPORT Square<double> inverse_or_nan(const Square<double>&, const double&);
template VECTRIX_EXPORT void require_moments(const char*, NameFunction, const Square<double>&, const double&);

std::string inertia_name(const std::string& b, const std::string& p, const std::string& c) {
  return "of<" + b + ">, about<" + p + ">, in<" + c + ">";
}
std::string inertia_name(const std::string& b) {
  return "in<" + b + ">";
}

void refuse_mass(const char* action, NameFunction body, const std::string& mass) {
  throw BadInput(std::string{action} + "(" + body() + "): the mass is " + mass + " kg");
}

}  // namespace vectrix::detail
