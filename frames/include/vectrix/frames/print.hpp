#pragma once

#include <ostream>
#include <string_view>
#include <vectrix/frames/errors.hpp>
#include <vectrix/frames/frame.hpp>
#include <vectrix/frames/units.hpp>

namespace vectrix {
namespace detail {

/// A unit as text.
template <Unit U> inline constexpr const char* unit_symbol = CoherentUnit<U> ? "SI units" : "other units";
template <> inline constexpr const char* unit_symbol<si::dimensionless> = "";
template <> inline constexpr const char* unit_symbol<si::angle> = "rad";
template <> inline constexpr const char* unit_symbol<si::length> = "m";
template <> inline constexpr const char* unit_symbol<si::velocity> = "m/s";
template <> inline constexpr const char* unit_symbol<si::acceleration> = "m/s^2";
template <> inline constexpr const char* unit_symbol<si::jerk> = "m/s^3";
template <> inline constexpr const char* unit_symbol<si::momentum> = "kg m/s";
template <> inline constexpr const char* unit_symbol<si::force> = "N";
template <> inline constexpr const char* unit_symbol<si::angular_velocity> = "rad/s";
template <> inline constexpr const char* unit_symbol<si::angular_acceleration> = "rad/s^2";
template <> inline constexpr const char* unit_symbol<si::angular_momentum> = "N m s";
template <> inline constexpr const char* unit_symbol<si::torque> = "N m";
template <> inline constexpr const char* unit_symbol<si::time> = "s";
template <> inline constexpr const char* unit_symbol<si::frequency> = "Hz";
template <> inline constexpr const char* unit_symbol<si::mass> = "kg";
template <> inline constexpr const char* unit_symbol<si::energy> = "J";
template <> inline constexpr const char* unit_symbol<si::power> = "W";
template <> inline constexpr const char* unit_symbol<si::moment_of_inertia> = "kg m^2";
template <> inline constexpr const char* unit_symbol<si::area> = "m^2";
template <> inline constexpr const char* unit_symbol<si::magnetic_flux_density> = "T";
template <> inline constexpr const char* unit_symbol<si::magnetic_dipole_moment> = "A m^2";
template <> inline constexpr const char* unit_symbol<si::gravitational_parameter> = "m^3/s^2";
template <> inline constexpr const char* unit_symbol<si::density> = "kg/m^3";
template <> inline constexpr const char* unit_symbol<si::kilometre_unit> = "km";
template <> inline constexpr const char* unit_symbol<si::millisecond_unit> = "ms";
template <> inline constexpr const char* unit_symbol<si::minute_unit> = "min";
template <> inline constexpr const char* unit_symbol<si::hour_unit> = "h";
template <> inline constexpr const char* unit_symbol<si::day_unit> = "d";
template <> inline constexpr const char* unit_symbol<si::degree_unit> = "deg";
template <> inline constexpr const char* unit_symbol<si::arcsecond_unit> = "arcsec";
template <> inline constexpr const char* unit_symbol<si::revolution_unit> = "rev";
template <> inline constexpr const char* unit_symbol<si::revolution_per_minute_unit> = "rpm";
template <> inline constexpr const char* unit_symbol<si::degree_per_second_unit> = "deg/s";
template <> inline constexpr const char* unit_symbol<si::nanotesla_unit> = "nT";

/// A number as the stream writes it; for a batch, the text of its lanes.
template <class S> decltype(auto) printable(const S& number) {
  if constexpr (Batch<S>) {
    return text(number);
  } else {
    return (number);
  }
}

/// (1, 2, 3) m
template <class Column> std::ostream& print_column(std::ostream& out, const Column& v, const char* unit) {
  return out << '(' << printable(v(0)) << ", " << printable(v(1)) << ", " << printable(v(2)) << ')'
             << (*unit ? " " : "") << unit;
}
/// [1 2 3; 4 5 6; 7 8 9]
template <class Square> std::ostream& print_square(std::ostream& out, const Square& m) {
  for (int row = 0; row < 3; ++row) {
    out << (row == 0 ? "[" : "; ") << printable(m(row, 0)) << ' ' << printable(m(row, 1)) << ' '
        << printable(m(row, 2));
  }
  return out << ']';
}
/// (1; 2, 3, 4), scalar first
template <class Quaternion> std::ostream& print_quaternion(std::ostream& out, const Quaternion& q) {
  return out << '(' << printable(q.w()) << "; " << printable(q.x()) << ", " << printable(q.y()) << ", "
             << printable(q.z()) << ')';
}
template <Frame B, Frame A> std::ostream& print_to_from(std::ostream& out) {
  return out << " to " << frame_name<B>() << " from " << frame_name<A>();
}
/// The square of a vector's unit: m^2, (m/s)^2
template <Unit U> std::ostream& print_squared(std::ostream& out) {
  const std::string_view unit = unit_symbol<U>;
  if (unit.empty()) return out;
  return unit.find_first_of(" /^") == unit.npos ? out << ' ' << unit << "^2" : out << " (" << unit << ")^2";
}
template <Point B, Point A> std::ostream& print_of_relative_to(std::ostream& out) {
  return out << " of " << frame_name<B>() << " relative to " << frame_name<A>();
}

}  // namespace detail

/// 7000 m
template <class U, class S> std::ostream& print_framed(std::ostream& out, const Quantity<U, S>& x) {
  return out << detail::printable(x.value()) << (*detail::unit_symbol<U> ? " " : "")
             << detail::unit_symbol<U>;
}

/// A value in the words of its door; the format of the stream applies to the numbers:
///     (1, 2, 3) m in Body        [1 0 0; 0 1 0; 0 0 1] to Body from Gcrf
///     (0, 0, 1) rad/s of Body relative to Gcrf in Body
/// Each type defines its text by print_framed().
template <class Framed>
auto operator<<(std::ostream& out, const Framed& value) -> decltype(print_framed(out, value)) {
  return print_framed(out, value);
}

}  // namespace vectrix
