#pragma once

#include <string>

#include <vectrix/frames/errors.hpp>

namespace vectrix::cli {

/// What the library says, without the names of types with which a message of it may begin.
std::string without_types(const std::string& text);

/// The result of the function. A BadInput that names types begins with `place` instead.
template <class Function> auto in_plain_words(const std::string& place, const Function& function) {
  try {
    return function();
  } catch (const BadInput& error) {
    const std::string text = error.what(), plain = without_types(text);
    if (plain == text) throw;
    throw BadInput(place + ": " + plain);
  }
}

}  // namespace vectrix::cli
