#pragma once

namespace vectrix::detail {

/// Pass-key of the library's own algebra: a result of checked operands is not checked again.
struct Trusted {
  explicit Trusted() = default;
};
inline constexpr Trusted trusted{};

}  // namespace vectrix::detail
