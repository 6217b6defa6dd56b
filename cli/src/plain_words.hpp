#pragma once

#include <string>

#include <vectrix/frames/errors.hpp>

namespace vectrix::cli {

/// What the library says, without the types that stand in brackets behind a name, "-99 (cli::Satellite)", or
/// at the end, "; asked for earth::Gcrf".
std::string without_types_of_names(const std::string& text);
/// What the library says, without the names of types with which a message of it may begin.
std::string without_types(const std::string& text);
/// What the library says, without its function with which a message may begin: "half_cone(): the confidence".
std::string without_function(const std::string& text);

/// The result of the function. A BadInput that names types begins with `place` instead.
template <class Function> auto in_plain_words(const std::string& place, const Function& function) {
  try {
    return function();
  } catch (const BadInput& error) {
    const std::string text = without_types_of_names(error.what()), plain = without_types(text);
    if (plain == error.what()) throw;
    if (plain == text) throw BadInput(text);
    throw BadInput(place + ": " + plain);
  }
}

}  // namespace vectrix::cli
