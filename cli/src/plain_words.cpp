#include "plain_words.hpp"

namespace vectrix::cli {

std::string without_types(const std::string& text) {
  const std::size_t first_reason = text.find(": "), scope = text.rfind("::"), bracket = text.find('<');
  // The last type, or a template: "Ephemeris<Sun>: the epoch".
  std::size_t type = std::string::npos;
  if (scope != std::string::npos) {
    type = scope;
  } else if (bracket < first_reason) {
    type = bracket;
  }
  if (type == std::string::npos) return text;
  const std::size_t reason = text.find(": ", type + 2);
  return reason == std::string::npos ? text : text.substr(reason + 2);
}

}  // namespace vectrix::cli
