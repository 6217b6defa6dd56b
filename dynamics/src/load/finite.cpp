#include <sstream>
#include <vectrix/dynamics/load/finite.hpp>

namespace vectrix::detail {

std::string LoadName::text() const {
  return on == nullptr ? load : std::string{load} + " on " + on();
}

void refuse_value(const LoadName& load, const char* what, const std::string& value, const char* rule) {
  throw BadInput(load.text() + ": the " + what + " is " + value + rule);
}
void refuse_value(const LoadName& load, const char* what, double value, const char* unit, const char* rule) {
  std::ostringstream text;
  text << value << (*unit ? " " : "") << unit;
  refuse_value(load, what, text.str(), rule);
}

}  // namespace vectrix::detail
