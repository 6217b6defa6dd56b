#pragma once

// The only header that knows Boost.Units: which unit a product or a quotient has, and what a unit is in
// another, is Boost's to say. A unit is a tag, `si::torque`; boost_unit and unit_tag go from one to the
// other. Boost counts the radian as a base dimension, so that torque and energy differ. One policy for the
// whole library: the radian is checked at the doors and counts as 1 in a product of vectors. The result is
// the named vector quantity of that dimension (unit_of_vector_product below).

#include <boost/units/base_unit.hpp>
#include <boost/units/conversion.hpp>
#include <boost/units/make_scaled_unit.hpp>
#include <boost/units/physical_dimensions/current.hpp>
#include <boost/units/physical_dimensions/length.hpp>
#include <boost/units/physical_dimensions/mass.hpp>
#include <boost/units/physical_dimensions/plane_angle.hpp>
#include <boost/units/physical_dimensions/temperature.hpp>
#include <boost/units/physical_dimensions/time.hpp>
#include <boost/units/systems/si/base.hpp>
#include <concepts>
#include <numbers>
#include <string>
#include <type_traits>

namespace vectrix {
namespace detail {

namespace bu = boost::units;

template <class U, class V> using Times = typename bu::multiply_typeof_helper<U, V>::type;
template <class U, class V> using Per = typename bu::divide_typeof_helper<U, V>::type;
template <class U, long base, long power>
using Scaled = typename bu::make_scaled_unit<U, bu::scale<base, bu::static_rational<power>>>::type;

struct UnitTag {};
/// base^power times a unit.
template <class U, long base, long power> struct Multiple;
/// A tag with a definition, which Boost is asked for when the unit is used.
template <class Definition> struct DefinedAs : UnitTag { using definition = Definition; };

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

template <class U>
concept Unit = std::derived_from<U, detail::UnitTag>;

namespace si {

/// The coherent SI unit m^metre kg^kilogram s^second rad^radian A^ampere K^kelvin.
template <int metre, int kilogram, int second, int radian = 0, int ampere = 0, int kelvin = 0>
struct unit : detail::UnitTag {
  using coherent = unit;
  using definition = unit;
};

struct dimensionless : unit<0, 0, 0> {};
struct angle : unit<0, 0, 0, 1> {};
struct time : unit<0, 0, 1> {};
struct frequency : unit<0, 0, -1> {};
struct mass : unit<0, 1, 0> {};
struct length : unit<1, 0, 0> {};
struct velocity : unit<1, 0, -1> {};
struct acceleration : unit<1, 0, -2> {};
struct jerk : unit<1, 0, -3> {};
struct momentum : unit<1, 1, -1> {};
struct force : unit<1, 1, -2> {};
struct energy : unit<2, 1, -2> {};
struct power : unit<2, 1, -3> {};
struct angular_velocity : unit<0, 0, -1, 1> {};
struct angular_acceleration : unit<0, 0, -2, 1> {};
struct moment_of_inertia : unit<2, 1, 0, -2> {};
struct angular_momentum : unit<2, 1, -1, -1> {};
struct torque : unit<2, 1, -2, -1> {};
struct area : unit<2, 0, 0> {};
struct magnetic_flux_density : unit<0, 1, -2, 0, -1> {};
/// Of a coil or a magnetorquer, A m^2: its torque in the field B is cross(m_b, B_b).
struct magnetic_dipole_moment : unit<2, 0, 0, 0, 1> {};
/// mu = G M of a central body, m^3/s^2.
struct gravitational_parameter : unit<3, 0, -2> {};
/// Of mass.
struct density : unit<-3, 1, 0> {};

/// A product or a quotient that is neither coherent nor has a name: per<degree_unit, hour_unit>.
template <Unit U, Unit V> struct times : detail::UnitTag {};
template <Unit U, Unit V> struct per : detail::UnitTag {};

// Not coherent with SI: convert<U>() takes them in, nothing else does.
struct kilometre_unit : detail::DefinedAs<detail::Multiple<length, 10, 3>> {};
struct millisecond_unit : detail::DefinedAs<detail::Multiple<time, 10, -3>> {};
struct minute_unit : detail::DefinedAs<detail::Multiple<time, 60, 1>> {};
struct hour_unit : detail::DefinedAs<detail::Multiple<time, 60, 2>> {};
/// 86400 s; a day of UTC may have 86401.
struct day_unit : detail::DefinedAs<detail::Multiple<time, 86400, 1>> {};
struct degree_unit : detail::UnitTag {};
struct arcsecond_unit : detail::DefinedAs<detail::Multiple<degree_unit, 60, -2>> {};
struct revolution_unit : detail::DefinedAs<detail::Multiple<degree_unit, 360, 1>> {};
struct revolution_per_minute_unit : detail::DefinedAs<per<revolution_unit, minute_unit>> {};
struct degree_per_second_unit : detail::DefinedAs<per<degree_unit, time>> {};
struct nanotesla_unit : detail::DefinedAs<detail::Multiple<magnetic_flux_density, 10, -9>> {};
/// Any other unit of Boost's.
template <class BoostUnit> struct derived : detail::UnitTag {};

}  // namespace si

namespace detail {

// From tags to Boost's units.

template <class Dimension, int power, class Others>
using WithDimension =
    std::conditional_t<power == 0, Others, bu::list<bu::dim<Dimension, bu::static_rational<power>>, Others>>;

template <class U> struct BoostUnit : BoostUnit<typename U::definition> {};
template <int m, int kg, int s, int rad, int A, int K> struct BoostUnit<si::unit<m, kg, s, rad, A, K>> {
  using Powers = WithDimension<
      bu::length_base_dimension, m,
      WithDimension<bu::mass_base_dimension, kg,
                    WithDimension<bu::time_base_dimension, s,
                                  WithDimension<bu::plane_angle_base_dimension, rad,
                                                WithDimension<bu::current_base_dimension, A,
                                                              WithDimension<bu::temperature_base_dimension, K,
                                                                            bu::dimensionless_type>>>>>>;
  using type = bu::unit<typename bu::make_dimension_list<Powers>::type, bu::si::system>;
};
template <class U> using BoostUnitOf = typename BoostUnit<U>::type;

template <class U, class V> struct BoostUnit<si::times<U, V>> {
  using type = Times<BoostUnitOf<U>, BoostUnitOf<V>>;
};
template <class U, class V> struct BoostUnit<si::per<U, V>> {
  using type = Per<BoostUnitOf<U>, BoostUnitOf<V>>;
};
template <class U> struct BoostUnit<si::derived<U>> { using type = U; };

template <class U, long base, long power> struct BoostUnit<Multiple<U, base, power>> {
  using type = Scaled<BoostUnitOf<U>, base, power>;
};
template <> struct BoostUnit<si::degree_unit> { using type = Degree::unit_type; };

// And back. A table is a class whose bases are its rows: the compiler finds the row of a key, and takes the
// key itself where there is none.

template <class Key, class Tag> struct Row {};
template <class Key, class Tag> Tag entry(const Row<Key, Tag>*);
template <class Key> Key entry(const void*);

template <class... Tags> struct CoherentTable : Row<typename Tags::coherent, Tags>... {};
using CoherentTags =
    CoherentTable<si::dimensionless, si::angle, si::time, si::frequency, si::mass, si::length, si::velocity,
                  si::acceleration, si::jerk, si::momentum, si::force, si::energy, si::power,
                  si::angular_velocity, si::angular_acceleration, si::moment_of_inertia, si::angular_momentum,
                  si::torque, si::area, si::magnetic_flux_density, si::magnetic_dipole_moment,
                  si::gravitational_parameter, si::density>;
template <class... Tags> struct ScaledTable : Row<BoostUnitOf<Tags>, Tags>... {};
using ScaledTags =
    ScaledTable<si::kilometre_unit, si::millisecond_unit, si::minute_unit, si::hour_unit, si::day_unit,
                si::degree_unit, si::arcsecond_unit, si::revolution_unit, si::revolution_per_minute_unit,
                si::degree_per_second_unit, si::nanotesla_unit>;

template <class Key, class Table> using EntryOf = decltype(entry<Key>(static_cast<const Table*>(nullptr)));

template <class Dimension, class Powers>
inline constexpr long power_in = power_in<Dimension, typename Powers::next>;
template <class Dimension, class Power, class Others>
inline constexpr long power_in<Dimension, bu::list<bu::dim<Dimension, Power>, Others>> = Power::Numerator;
template <class Dimension> inline constexpr long power_in<Dimension, bu::dimensionless_type> = 0;

template <class Powers>
using UnitOfPowers =
    si::unit<power_in<bu::length_base_dimension, Powers>, power_in<bu::mass_base_dimension, Powers>,
             power_in<bu::time_base_dimension, Powers>, power_in<bu::plane_angle_base_dimension, Powers>,
             power_in<bu::current_base_dimension, Powers>, power_in<bu::temperature_base_dimension, Powers>>;

/// The tag of one of Boost's units; Otherwise for one that is neither coherent nor in the table.
template <class Given, class Otherwise> constexpr auto tag_of() {
  using Powers = typename Given::dimension_type;
  using Coherent = bu::unit<Powers, bu::si::system>;
  if constexpr (bu::is_implicitly_convertible<Given, Coherent>::value) {
    using Tag = UnitOfPowers<Powers>;
    if constexpr (std::same_as<BoostUnitOf<Tag>, Coherent>) {
      return std::type_identity<EntryOf<Tag, CoherentTags>>{};
    } else {
      return std::type_identity<Otherwise>{};
    }
  } else if constexpr (Unit<EntryOf<Given, ScaledTags>>) {
    return std::type_identity<EntryOf<Given, ScaledTags>>{};
  } else {
    return std::type_identity<Otherwise>{};
  }
}
template <class Given, class Otherwise = si::derived<Given>>
using TagOf = typename decltype(tag_of<Given, Otherwise>())::type;

}  // namespace detail

/// Boost's unit of a tag, with the radian where Boost has it; and the tag of one of Boost's units.
template <Unit U> using boost_unit = detail::BoostUnitOf<U>;
template <class BoostUnit> using unit_tag = detail::TagOf<BoostUnit>;

/// Unit of a product, a quotient or a time derivative of scalars: exact, as in Boost.Units.
template <Unit U, Unit V>
using unit_product = detail::TagOf<detail::Times<boost_unit<U>, boost_unit<V>>, si::times<U, V>>;
template <Unit U, Unit V>
using unit_quotient = detail::TagOf<detail::Per<boost_unit<U>, boost_unit<V>>, si::per<U, V>>;

namespace detail {

template <class U>
concept CoherentUnit = Unit<U> && requires {
  typename U::coherent;
};

template <class Tag, class... Tags> inline constexpr bool one_of = (std::same_as<Tag, Tags> || ...);
template <class U>
inline constexpr bool names_a_vector =
    one_of<U, si::dimensionless, si::angle, si::length, si::velocity, si::acceleration, si::momentum,
           si::force, si::angular_velocity, si::angular_acceleration, si::angular_momentum, si::torque,
           si::magnetic_flux_density, si::magnetic_dipole_moment>;

// The radian counts as 1: try U, U/rad, U rad, U/rad^2 and take the first that is a named vector quantity.
template <class U> constexpr auto without_radian() {
  if constexpr (names_a_vector<U>) {
    return std::type_identity<U>{};
  } else if constexpr (names_a_vector<unit_quotient<U, si::angle>>) {
    return std::type_identity<unit_quotient<U, si::angle>>{};
  } else if constexpr (names_a_vector<unit_product<U, si::angle>>) {
    return std::type_identity<unit_product<U, si::angle>>{};
  } else if constexpr (names_a_vector<unit_quotient<unit_quotient<U, si::angle>, si::angle>>) {
    return std::type_identity<unit_quotient<unit_quotient<U, si::angle>, si::angle>>{};
  } else {
    return std::type_identity<U>{};
  }
}
template <class U> using VectorUnitTag = typename decltype(without_radian<U>())::type;

template <class U> inline constexpr bool is_vector_unit = false;
template <CoherentUnit U> inline constexpr bool is_vector_unit<U> = std::same_as<VectorUnitTag<U>, U>;

}  // namespace detail

/// Unit of a vector-valued product, the radian counting as 1:
///     w x r: velocity    r x F: torque    J w: angular momentum    w x H: torque    w x w: angular
///     acceleration
/// No vector is an energy: a vector of kg m^2/s^2 is a torque.
template <Unit U, Unit V> using unit_of_vector_product = detail::VectorUnitTag<unit_product<U, V>>;
template <Unit U, Unit V> using unit_of_vector_quotient = detail::VectorUnitTag<unit_quotient<U, V>>;

/// Unit of a vector times or over a scalar. A direction takes the scalar's unit as it is: joules along a
/// direction are no torque and hertz no angular velocity. Else as for the products above: H/t is a torque, w
/// t a rotation vector.
template <Unit Exact, Unit Scaled>
using unit_of_scaled_vector =
    std::conditional_t<std::same_as<Scaled, si::dimensionless>, Exact, detail::VectorUnitTag<Exact>>;

/// A unit that a vector may have: coherent with SI, and not another vector's up to the radian as the energy,
/// which is the torque's.
template <class U>
concept VectorUnit = detail::is_vector_unit<U>;

}  // namespace vectrix
