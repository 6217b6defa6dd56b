#include "plain_words.hpp"

#include <string_view>

namespace vectrix::cli {

std::string without_types_of_names(const std::string& given) {
  std::string text = given;
  const auto is_type = [](const std::string& name) {
    return name.find("::") != std::string::npos && name.find_first_of(" ,;'") == std::string::npos;
  };
  for (auto at = text.find(" ("); at != std::string::npos; at = text.find(" (", at)) {
    const auto end = text.find(')', at);
    if (end == std::string::npos) break;
    if (is_type(text.substr(at + 2, end - at - 2))) {
      text.erase(at, end + 1 - at);
    } else {
      ++at;
    }
  }
  constexpr std::string_view asked = "; asked for ";
  const auto last = text.rfind(asked);
  if (last != std::string::npos && is_type(text.substr(last + asked.size()))) text.resize(last);
  return text;
}

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

std::string without_function(const std::string& text) {
  constexpr std::string_view call = "(): ";
  const std::size_t end = text.find(call);
  return end == std::string::npos || text.find(' ') < end ? text : text.substr(end + call.size());
}

}  // namespace vectrix::cli
