#pragma once

// The only header that knows Boost.Units. A unit is a tag, `si::torque`; a quantity is a number with a unit,
// `Quantity<si::torque> t = 2.0 * si::newton_metre`. Boost counts the radian as a base dimension, so that
// torque and energy differ. One policy for the whole library: the radian is checked at the doors and counts
// as 1 in a product of vectors. The result is the named vector quantity of that dimension (unit_of_vector
// below).

#include <boost/units/base_unit.hpp>
#include <boost/units/base_units/angle/radian.hpp>
#include <boost/units/conversion.hpp>
#include <boost/units/make_scaled_unit.hpp>
#include <boost/units/physical_dimensions.hpp>
#include <boost/units/quantity.hpp>
#include <boost/units/systems/si.hpp>
#include <concepts>
#include <numbers>
#include <string>
#include <type_traits>
#include <vectrix/frames/operators.hpp>

namespace vectrix {
namespace detail {

namespace bu = boost::units;

template <class U, class V> using Times = typename bu::multiply_typeof_helper<U, V>::type;
template <class U, class V> using Per = typename bu::divide_typeof_helper<U, V>::type;

using Radian = bu::si::plane_angle;

template <class BoostUnit> struct UnitTag { using boost_unit = BoostUnit; };

// Boost's own degree is off by 6.6e-14 of itself: it writes pi with twelve digits. The number orders the base
// units of one system.
struct Degree : bu::base_unit<Degree, bu::plane_angle_dimension, 3600> {
  static std::string name() { return "degree"; }
  static std::string symbol() { return "deg"; }
};

}  // namespace detail
}  // namespace vectrix

BOOST_UNITS_DEFINE_CONVERSION_FACTOR(vectrix::detail::Degree, boost::units::angle::radian_base_unit, double,
                                     std::numbers::pi / 180);
BOOST_UNITS_DEFAULT_CONVERSION(vectrix::detail::Degree, boost::units::angle::radian_base_unit);

namespace vectrix {

namespace si {

// Tags. `boost_unit` is the coherent SI unit, with the radian where Boost.Units has it.
struct dimensionless : detail::UnitTag<detail::bu::si::dimensionless> {};
struct angle : detail::UnitTag<detail::bu::si::plane_angle> {};
struct time : detail::UnitTag<detail::bu::si::time> {};
struct frequency : detail::UnitTag<detail::bu::si::frequency> {};
struct mass : detail::UnitTag<detail::bu::si::mass> {};
struct length : detail::UnitTag<detail::bu::si::length> {};
struct velocity : detail::UnitTag<detail::bu::si::velocity> {};
struct acceleration : detail::UnitTag<detail::bu::si::acceleration> {};
struct momentum : detail::UnitTag<detail::bu::si::momentum> {};
struct force : detail::UnitTag<detail::bu::si::force> {};
struct energy : detail::UnitTag<detail::bu::si::energy> {};
struct power : detail::UnitTag<detail::bu::si::power> {};
struct angular_velocity : detail::UnitTag<detail::bu::si::angular_velocity> {};
struct angular_acceleration : detail::UnitTag<detail::bu::si::angular_acceleration> {};
struct moment_of_inertia : detail::UnitTag<detail::bu::si::moment_of_inertia> {};
struct angular_momentum : detail::UnitTag<detail::bu::si::angular_momentum> {};
struct torque : detail::UnitTag<detail::bu::si::torque> {};
struct area : detail::UnitTag<detail::bu::si::area> {};
/// mu = G M of a central body, m^3/s^2.
struct gravitational_parameter
    : detail::UnitTag<detail::Times<detail::bu::si::acceleration, detail::bu::si::area>> {};
/// Any unit without a name of its own.
template <class BoostUnit> struct derived : detail::UnitTag<BoostUnit> {};

}  // namespace si

template <class U>
concept Unit = requires {
  typename U::boost_unit;
};

/// A number of S in the unit U.
template <Unit U, class S = double> using Quantity = boost::units::quantity<typename U::boost_unit, S>;

/// A number of S in a unit that is given as Boost.Units writes it: what `2.0 * si::metre` is.
template <class BoostUnit, class S> using AnyQuantity = boost::units::quantity<BoostUnit, S>;

namespace detail {

template <class BoostUnit, class... Tags> struct FirstTag : std::type_identity<si::derived<BoostUnit>> {};
template <class BoostUnit, class Tag, class... Tags>
struct FirstTag<BoostUnit, Tag, Tags...>
    : std::conditional_t<std::same_as<BoostUnit, typename Tag::boost_unit>, std::type_identity<Tag>,
                         FirstTag<BoostUnit, Tags...>> {};

template <class BoostUnit>
using TagOf =
    typename FirstTag<BoostUnit, si::dimensionless, si::angle, si::time, si::frequency, si::mass, si::length,
                      si::velocity, si::acceleration, si::momentum, si::force, si::energy, si::power,
                      si::angular_velocity, si::angular_acceleration, si::moment_of_inertia,
                      si::angular_momentum, si::torque, si::area, si::gravitational_parameter>::type;

// The named vector quantities; `void` when BoostUnit is none of them.
template <class BoostUnit, class... Tags> struct FirstVectorTag : std::type_identity<void> {};
template <class BoostUnit, class Tag, class... Tags>
struct FirstVectorTag<BoostUnit, Tag, Tags...>
    : std::conditional_t<std::same_as<BoostUnit, typename Tag::boost_unit>, std::type_identity<Tag>,
                         FirstVectorTag<BoostUnit, Tags...>> {};

template <class BoostUnit>
using VectorTag = typename FirstVectorTag<BoostUnit, si::dimensionless, si::angle, si::length, si::velocity,
                                          si::acceleration, si::momentum, si::force, si::angular_velocity,
                                          si::angular_acceleration, si::angular_momentum, si::torque>::type;

// The radian counts as 1: try U, U/rad, U rad, U/rad^2 and take the first that is a named vector quantity.
template <class U, class... Candidates> struct WithoutRadian : std::type_identity<TagOf<U>> {};
template <class U, class Candidate, class... Candidates>
struct WithoutRadian<U, Candidate, Candidates...>
    : std::conditional_t<!std::is_void_v<VectorTag<Candidate>>, std::type_identity<VectorTag<Candidate>>,
                         WithoutRadian<U, Candidates...>> {};

template <class BoostUnit>
inline constexpr bool is_coherent = std::same_as<typename BoostUnit::system_type, bu::si::system>;

template <class U>
using VectorUnitTag =
    typename WithoutRadian<U, U, Per<U, Radian>, Times<U, Radian>, Per<Per<U, Radian>, Radian>>::type;

}  // namespace detail

/// Unit of a product, a quotient or a time derivative of scalars: exact, as in Boost.Units.
template <Unit U, Unit V>
using unit_product = detail::TagOf<detail::Times<typename U::boost_unit, typename V::boost_unit>>;
template <Unit U, Unit V>
using unit_quotient = detail::TagOf<detail::Per<typename U::boost_unit, typename V::boost_unit>>;

/// Unit of a vector-valued product, the radian counting as 1:
///     w x r: velocity    r x F: torque    J w: angular momentum    w x H: torque    w x w: angular
///     acceleration
/// No vector is an energy: a vector of kg m^2/s^2 is a torque.
template <Unit U, Unit V>
using unit_of_vector_product =
    detail::VectorUnitTag<detail::Times<typename U::boost_unit, typename V::boost_unit>>;
template <Unit U, Unit V>
using unit_of_vector_quotient =
    detail::VectorUnitTag<detail::Per<typename U::boost_unit, typename V::boost_unit>>;

/// Unit of a vector times or over a scalar. A direction takes the scalar's unit as it is: joules along a
/// direction are no torque and hertz no angular velocity. Else as for the products above: H/t is a torque, w
/// t a rotation vector.
template <Unit Exact, Unit Scaled>
using unit_of_scaled_vector = std::conditional_t<std::same_as<Scaled, si::dimensionless>, Exact,
                                                 detail::VectorUnitTag<typename Exact::boost_unit>>;

/// A unit that a vector may have: coherent with SI, and not another vector's up to the radian as the energy
/// is.
template <class U>
concept VectorUnit = Unit<U> && detail::is_coherent<typename U::boost_unit> &&
    std::same_as<detail::VectorUnitTag<typename U::boost_unit>, U>;

/// The tag of a Boost.Units unit.
template <class BoostUnit> using unit_tag = detail::TagOf<BoostUnit>;

namespace si {

inline constexpr angle::boost_unit radian{};
inline constexpr time::boost_unit second{};
inline constexpr mass::boost_unit kilogram{};
inline constexpr length::boost_unit metre{};
inline constexpr force::boost_unit newton{};
inline constexpr energy::boost_unit joule{};
inline constexpr power::boost_unit watt{};
inline constexpr torque::boost_unit newton_metre{};
inline constexpr angular_momentum::boost_unit newton_metre_second{};
inline constexpr moment_of_inertia::boost_unit kilogram_square_metre{};

// Not coherent with SI: convert<U>() takes them in, nothing else does.
using kilometre_unit =
    boost::units::make_scaled_unit<length::boost_unit,
                                   boost::units::scale<10, boost::units::static_rational<3>>>::type;
using millisecond_unit =
    boost::units::make_scaled_unit<time::boost_unit,
                                   boost::units::scale<10, boost::units::static_rational<-3>>>::type;
using minute_unit =
    boost::units::make_scaled_unit<time::boost_unit,
                                   boost::units::scale<60, boost::units::static_rational<1>>>::type;
using hour_unit =
    boost::units::make_scaled_unit<time::boost_unit,
                                   boost::units::scale<60, boost::units::static_rational<2>>>::type;
using degree_unit = detail::Degree::unit_type;
using arcsecond_unit =
    boost::units::make_scaled_unit<degree_unit,
                                   boost::units::scale<60, boost::units::static_rational<-2>>>::type;
using revolution_unit =
    boost::units::make_scaled_unit<degree_unit,
                                   boost::units::scale<360, boost::units::static_rational<1>>>::type;
using revolution_per_minute_unit = detail::Per<revolution_unit, minute_unit>;
using degree_per_second_unit = detail::Per<degree_unit, time::boost_unit>;

inline constexpr kilometre_unit kilometre{};
inline constexpr millisecond_unit millisecond{};
inline constexpr minute_unit minute{};
inline constexpr hour_unit hour{};
inline constexpr degree_unit degree{};
inline constexpr arcsecond_unit arcsecond{};
inline constexpr revolution_per_minute_unit revolution_per_minute{};
inline constexpr degree_per_second_unit degree_per_second{};

}  // namespace si

/// The quantity in the coherent SI unit: convert<si::length>(7000.0 * si::kilometre) is 7e6 m.
template <Unit U, class BoostUnit, class S>
std::enable_if_t<!std::is_integral_v<S>, Quantity<U, S>> convert(const AnyQuantity<BoostUnit, S>& quantity) {
  return Quantity<U, S>(quantity);
}
template <Unit U, class BoostUnit, class S>
  requires std::is_integral_v<S>
auto convert(  // a whole number would be cut: convert<si::angle>(30.0 * si::degree)
    const AnyQuantity<BoostUnit, S>&) -> Refused = delete;

}  // namespace vectrix
