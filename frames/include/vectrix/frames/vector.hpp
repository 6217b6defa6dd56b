#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <string>
#include <vectrix/frames/errors.hpp>
#include <vectrix/frames/frame.hpp>
#include <vectrix/frames/operators.hpp>
#include <vectrix/frames/print.hpp>
#include <vectrix/frames/scalar/arc_tangent.hpp>
#include <vectrix/frames/trusted.hpp>
#include <vectrix/frames/units.hpp>

namespace vectrix {
namespace detail {

template <class S> using Column = Eigen::Matrix<S, 3, 1>;

/// Whether a size is right, or known at run time only.
template <int wanted, int size> inline constexpr bool may_be = size == wanted || size == Eigen::Dynamic;

/// Throws BadInput if the size, where it is known at run time only, is another; door() begins the message.
template <class M, class Door>
void require_size(const M& numbers, Eigen::Index rows, Eigen::Index columns, const Door& door) {
  if constexpr (M::SizeAtCompileTime == Eigen::Dynamic) {
    if (numbers.rows() != rows || numbers.cols() != columns) {
      throw BadInput(door() + "the matrix has " + text(numbers.rows()) + " x " + text(numbers.cols()) +
                     " entries, not " + text(rows) + " x " + text(columns));
    }
  }
}

/// Declared for ThreeNumbers: takes Eigen's matrices and vectors, and what is derived from them, as a
/// segment.
template <class Derived> void takes_matrix(const Eigen::MatrixBase<Derived>&);

/// A column or row of three numbers, or a matrix that may be one at run time; the doors call require_three().
template <class M>
concept ThreeNumbers = requires(const M& numbers) {
  takes_matrix(numbers);
}
&&((may_be<3, M::RowsAtCompileTime> && may_be<1, M::ColsAtCompileTime>) ||
   (may_be<1, M::RowsAtCompileTime> && may_be<3, M::ColsAtCompileTime>));

template <class M, class Door> void require_three(const M& numbers, const Door& door) {
  constexpr bool is_row = M::RowsAtCompileTime == 1;
  require_size(numbers, is_row ? 1 : 3, is_row ? 3 : 1, door);
}

/// The norm of finite numbers of any size: the squares do not overflow or underflow. Derivatives are NaN at
/// zero.
template <class Derived> auto scaled_norm(const Eigen::MatrixBase<Derived>& numbers) {
  using S = typename Derived::Scalar;
  if constexpr (Differentiated<S>) {
    // The scale is a constant, without derivatives. Multiplied by its inverse, not divided by it: the
    // derivative of a quotient divides by the square, which underflows.
    const auto plain = numbers.unaryExpr([](const S& x) { return without_derivatives(x); }).eval();
    const auto largest = plain.cwiseAbs().maxCoeff();
    return largest > 0 ? S(S(largest) * S((numbers * S(1 / largest)).norm())) : S(numbers.norm());
  } else {
    const S largest = numbers.cwiseAbs().maxCoeff();
    return select(largest > S(0), S(largest * (numbers / largest).norm()), largest);
  }
}

/// A function that returns a T. The result is built in place; a T passed by reference would be copied.
template <class Make, class T>
concept Makes = requires(const Make& make) {
  { make() } -> std::same_as<T>;
};

}  // namespace detail

/// r^a: the coordinates of a vector in the frame F, in the unit U.
/// Sums need one frame and one unit. A product of units follows units.hpp: w x r is a velocity, r x F a
/// torque. Made by `vector(in<F>, ...)`; there is no default.
template <Frame F, VectorUnit U, class S = double> class Vector {
 public:
  using frame = F;
  using unit = U;
  using scalar = S;

  Vector() = delete;  // vector(in<F>, x, y, z), or zero<U>(in<F>)
  template <class Derived>
  Vector(detail::Trusted, const Eigen::MatrixBase<Derived>& coordinates) : coordinates_(coordinates) {}
  template <detail::Makes<detail::Column<S>> Make>
  Vector(detail::Trusted, const Make& make) : coordinates_(make()) {}

  /// The bare numbers, in the coherent SI unit. Frame and unit are no longer checked.
  const detail::Column<S>& coordinates() const& { return coordinates_; }
  detail::Column<S> coordinates() && { return coordinates_; }

  Vector operator-() const { return {detail::trusted, -coordinates_}; }

  Quantity<U, S> x() const { return Quantity<U, S>::from_value(coordinates_.x()); }
  Quantity<U, S> y() const { return Quantity<U, S>::from_value(coordinates_.y()); }
  Quantity<U, S> z() const { return Quantity<U, S>::from_value(coordinates_.z()); }

 private:
  detail::Column<S> coordinates_;
};

template <class F, class U, class S> inline constexpr bool detail::is_framed<Vector<F, U, S>> = true;

namespace detail {

template <class S>
[[noreturn, gnu::cold, gnu::noinline]] void refuse_coordinates(const std::string& f,
                                                               const Column<S>& coordinates) {
  throw BadInput("vector(in<" + f + ">): the coordinates (" + text(coordinates.x()) + ", " +
                 text(coordinates.y()) + ", " + text(coordinates.z()) + ") are not finite");
}

template <Frame F, VectorUnit U, class S> Vector<F, U, S> checked_vector(const Column<S>& coordinates) {
  if (!all_finite(coordinates)) {
    refuse_coordinates<S>(frame_name<F>(), coordinates);
  }
  return {trusted, coordinates};
}

/// The type of the vector with these bare numbers; no type if there is none.
template <class F, class U, class Numbers> struct VectorOf {};
template <Frame F, VectorUnit U, ThreeNumbers Numbers>
struct VectorOf<F, U, Numbers> : std::type_identity<Vector<F, U, typename Numbers::Scalar>> {};

/// The tag of a quantity's unit, for messages; void of a bare number.
template <class X> struct UnitOf : std::type_identity<void> {};
template <class U, class S> struct UnitOf<Quantity<U, S>> : std::type_identity<U> {};
template <class... X> struct UnitOfFirst : std::type_identity<void> {};
template <class X, class... More> struct UnitOfFirst<X, More...> : UnitOf<X> {};

}  // namespace detail

/// The vector with coordinates x, y, z in F. Throws BadInput when one is not finite.
template <Frame F, class U, class S>
std::enable_if_t<!std::is_integral_v<S>, Vector<F, U, S>> vector(In<F>, const Quantity<U, S>& x,
                                                                 const Quantity<U, S>& y,
                                                                 const Quantity<U, S>& z) {
  return detail::checked_vector<F, U, S>({x.value(), y.value(), z.value()});
}

/// Claims that the three bare numbers are coordinates in F, in the coherent SI unit U:
/// vector<si::length>(in<F>, m), also of a part of a longer column or of a matrix: x.segment(3, 3). Throws
/// BadInput when one is not finite, or there are not three.
template <class U, class F, class Numbers>
typename detail::VectorOf<F, U, Numbers>::type vector(In<F>, const Numbers& coordinates) {
  detail::require_three(coordinates, [] { return "vector(in<" + frame_name<F>() + ">): "; });
  return detail::checked_vector<F, U, typename Numbers::Scalar>(coordinates);
}
template <class U = void, class InFrame, class... Given,
          class UnitGiven = typename detail::UnitOfFirst<Given...>::type>
auto vector(  // one SI vector unit for all: 1.0 * si::metre, or convert<U>(); <U>(in<F>, Eigen::Vector3d)
    const InFrame&, const Given&...) -> Refused = delete;

/// The zero vector of F in the unit U.
template <VectorUnit U, Frame F, class S = double> Vector<F, U, S> zero(In<F>) {
  return {detail::trusted, detail::Column<S>::Zero()};
}

/// The unit vectors along the axes of F.
template <Frame F, class S = double> Vector<F, si::dimensionless, S> unit_x(In<F>) {
  return {detail::trusted, detail::Column<S>(S(1), S(0), S(0))};
}
template <Frame F, class S = double> Vector<F, si::dimensionless, S> unit_y(In<F>) {
  return {detail::trusted, detail::Column<S>(S(0), S(1), S(0))};
}
template <Frame F, class S = double> Vector<F, si::dimensionless, S> unit_z(In<F>) {
  return {detail::trusted, detail::Column<S>(S(0), S(0), S(1))};
}

template <class F, class U, class V, class S>
struct detail::ReasonOf<Vector<F, U, S>, Vector<F, V, S>> : std::type_identity<reason::in_two_units> {};

template <class F, class U, class S> Vector<F, U, S> sum(const Vector<F, U, S>& r, const Vector<F, U, S>& s) {
  return {detail::trusted, r.coordinates() + s.coordinates()};
}
template <class F, class U, class S>
Vector<F, U, S> difference(const Vector<F, U, S>& r, const Vector<F, U, S>& s) {
  return {detail::trusted, r.coordinates() - s.coordinates()};
}

template <class F, class U, class S>
Vector<F, U, S> product(const std::type_identity_t<S>& k, const Vector<F, U, S>& r) {
  return {detail::trusted, k * r.coordinates()};
}
template <class F, class U, class S>
Vector<F, U, S> product(const Vector<F, U, S>& r, const std::type_identity_t<S>& k) {
  return {detail::trusted, r.coordinates() * k};
}
template <class F, class U, class S>
Vector<F, U, S> quotient(const Vector<F, U, S>& r, const std::type_identity_t<S>& k) {
  return {detail::trusted, r.coordinates() / k};
}

template <class F, class U, class V, class S>
Vector<F, unit_of_scaled_vector<unit_product<V, U>, U>, S> product(const Quantity<V, S>& k,
                                                                   const Vector<F, U, S>& r) {
  return {detail::trusted, k.value() * r.coordinates()};
}
template <class F, class U, class V, class S>
Vector<F, unit_of_scaled_vector<unit_product<U, V>, U>, S> product(const Vector<F, U, S>& r,
                                                                   const Quantity<V, S>& k) {
  return {detail::trusted, r.coordinates() * k.value()};
}
template <class F, class U, class V, class S>
Vector<F, unit_of_scaled_vector<unit_quotient<U, V>, U>, S> quotient(const Vector<F, U, S>& r,
                                                                     const Quantity<V, S>& k) {
  return {detail::trusted, r.coordinates() / k.value()};
}

// r . s
template <class F, class U, class V, class S>
Quantity<unit_product<U, V>, S> dot_product(const Vector<F, U, S>& r, const Vector<F, V, S>& s) {
  return Quantity<unit_product<U, V>, S>::from_value(r.coordinates().dot(s.coordinates()));
}
// r x s
template <class F, class U, class V, class S>
Vector<F, unit_of_vector_product<U, V>, S> cross_product(const Vector<F, U, S>& r, const Vector<F, V, S>& s) {
  return {detail::trusted, r.coordinates().cross(s.coordinates())};
}

/// |r|^2, in the exact square of the unit of r.
template <class F, class U, class S> Quantity<unit_product<U, U>, S> squared_norm(const Vector<F, U, S>& r) {
  return Quantity<unit_product<U, U>, S>::from_value(r.coordinates().squaredNorm());
}

/// |r|, in the unit of r. Correct also where r^2 overflows or underflows.
template <class F, class U, class S> Quantity<U, S> norm(const Vector<F, U, S>& r) {
  const S square = r.coordinates().squaredNorm();
  if constexpr (std::is_floating_point_v<S>) {
    using Limits = std::numeric_limits<S>;
    if (!(square > Limits::min() / Limits::epsilon() && square <= Limits::max())) [[unlikely]] {
      return Quantity<U, S>::from_value(detail::scaled_norm(r.coordinates()));
    }
  }
  using std::sqrt;
  return Quantity<U, S>::from_value(sqrt(square));
}

namespace detail {

/// direction() for the function with this name, which stands in the errors.
template <class F, class U, class S>
Vector<F, si::dimensionless, S> direction_for(const char* function, const Vector<F, U, S>& r) {
  const S largest = r.coordinates().cwiseAbs().maxCoeff();
  if (!all_finite(r.coordinates())) {
    throw BadInput(std::string{function} + "(vector in " + frame_name<F>() + "): the coordinates (" +
                   text(r.coordinates().x()) + ", " + text(r.coordinates().y()) + ", " +
                   text(r.coordinates().z()) + ") are not finite");
  }
  if (!all(largest > S(0))) {
    throw BadInput(std::string{function} + "(vector in " + frame_name<F>() + "): |r| is " + text(largest) +
                   "; a zero vector has no direction");
  }
  const Column<S> scaled = r.coordinates() / largest;
  return {trusted, scaled / scaled.norm()};
}

/// The angle between two unit vectors, by Kahan's formula.
template <class S> S angle_of_units(const Column<S>& u, const Column<S>& v) {
  return S(2) * arc_tangent<S>(scaled_norm(u - v), scaled_norm(u + v));
}

/// angle_between() of two vectors.
template <class F, class U, class V, class S>
Quantity<si::angle, S> angle_of(const Vector<F, U, S>& r, const Vector<F, V, S>& s) {
  return Quantity<si::angle, S>::from_value(angle_of_units<S>(
      direction_for("angle_between", r).coordinates(), direction_for("angle_between", s).coordinates()));
}

}  // namespace detail

/// r / |r|, safe from overflow and underflow. Throws BadInput for the zero vector, which has no direction,
/// and for one whose coordinates overflowed.
template <class F, class U, class S> Vector<F, si::dimensionless, S> direction(const Vector<F, U, S>& r) {
  return detail::direction_for("direction", r);
}

template <class F, class U, class S> std::ostream& print_framed(std::ostream& out, const Vector<F, U, S>& r) {
  return detail::print_column(out, r.coordinates(), detail::unit_symbol<U>) << " in " << frame_name<F>();
}

}  // namespace vectrix
