#pragma once

#include <string>
#include <string_view>

namespace vectrix::cli {

/// The hash SHA-256 of FIPS 180-4, as 64 digits of base 16.
std::string sha256(std::string_view bytes);

}  // namespace vectrix::cli
