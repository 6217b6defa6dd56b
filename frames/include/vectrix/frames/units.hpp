#pragma once

#include <vectrix/frames/quantity.hpp>

namespace vectrix {

namespace si {

inline constexpr UnitConstant<angle> radian;
inline constexpr UnitConstant<time> second;
inline constexpr UnitConstant<mass> kilogram;
inline constexpr UnitConstant<length> metre;
inline constexpr UnitConstant<force> newton;
inline constexpr UnitConstant<energy> joule;
inline constexpr UnitConstant<power> watt;
inline constexpr UnitConstant<torque> newton_metre;
inline constexpr UnitConstant<angular_momentum> newton_metre_second;
inline constexpr UnitConstant<moment_of_inertia> kilogram_square_metre;
inline constexpr UnitConstant<magnetic_flux_density> tesla;
inline constexpr UnitConstant<magnetic_dipole_moment> ampere_square_metre;

inline constexpr UnitConstant<kilometre_unit> kilometre;
inline constexpr UnitConstant<millisecond_unit> millisecond;
inline constexpr UnitConstant<minute_unit> minute;
inline constexpr UnitConstant<hour_unit> hour;
inline constexpr UnitConstant<day_unit> day;
inline constexpr UnitConstant<degree_unit> degree;
inline constexpr UnitConstant<arcsecond_unit> arcsecond;
inline constexpr UnitConstant<revolution_unit> revolution;
inline constexpr UnitConstant<revolution_per_minute_unit> revolution_per_minute;
inline constexpr UnitConstant<degree_per_second_unit> degree_per_second;
inline constexpr UnitConstant<nanotesla_unit> nanotesla;

}  // namespace si

namespace detail {

template <class U, class V, class S> using Converted = std::enable_if_t<converts<U, V, S>, Quantity<U, S>>;

}  // namespace detail

/// The quantity in another unit of its dimension: convert<si::length>(7000.0 * si::kilometre) is 7e6 m.
template <Unit U, class V, class S> constexpr detail::Converted<U, V, S> convert(const Quantity<V, S>& x) {
  return {detail::trusted, x.in(UnitConstant<U>{})};
}
template <Unit To, class From, class S>
  requires(!detail::converts<To, From, S>)
auto convert(  // one dimension; a whole number would be cut: convert<si::angle>(30.0 * si::degree)
    const Quantity<From, S>&) -> Refused = delete;

}  // namespace vectrix
