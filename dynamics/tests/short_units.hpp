#pragma once

#include <vectrix/frames/units.hpp>

/// Units as a formula has them, for tests of many numbers.
namespace vectrix_test::short_units {

inline constexpr auto s = vectrix::si::second;
inline constexpr auto m = vectrix::si::metre;
inline constexpr auto rad = vectrix::si::radian;
inline constexpr auto N = vectrix::si::newton;
inline constexpr auto N_m = vectrix::si::newton_metre;
inline constexpr auto rad_s = vectrix::si::radian / vectrix::si::second;
inline constexpr auto m_s = vectrix::si::metre / vectrix::si::second;
inline constexpr auto kg_m2 = vectrix::si::kilogram_square_metre;

}  // namespace vectrix_test::short_units
