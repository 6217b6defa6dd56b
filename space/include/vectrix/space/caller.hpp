#pragma once

#include <string>

namespace vectrix::detail {

/// How a message begins: written only for an error, because the text allocates.
///     two_body(Satellite relative to Gcrf):        wgs84::position:
struct Caller {
  const char* action;
  std::string (*of)() = nullptr;

  std::string operator()() const {
    return of ? std::string{action} + "(" + of() + "): " : std::string{action} + ": ";
  }
};

}  // namespace vectrix::detail
