#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace vectrix::detail {

/// The components of a state, in their order.
inline constexpr std::array<const char*, 6> state_components{"X", "Y", "Z", "X_DOT", "Y_DOT", "Z_DOT"};

/// CX_X, CY_X, ..., CZ_DOT_Z_DOT: an entry of the covariance of a state, where the column is not behind the
/// row.
inline std::string covariance_keyword(std::size_t row, std::size_t column) {
  return "C" + std::string{state_components[row]} + "_" + std::string{state_components[column]};
}

inline bool is_covariance_keyword(std::string_view keyword) {
  for (std::size_t row = 0; row < state_components.size(); ++row) {
    for (std::size_t column = 0; column <= row; ++column) {
      if (keyword == covariance_keyword(row, column)) return true;
    }
  }
  return false;
}

}  // namespace vectrix::detail
