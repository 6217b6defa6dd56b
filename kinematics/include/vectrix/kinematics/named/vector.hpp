#pragma once

#include <vectrix/kinematics/named/dcm.hpp>

namespace vectrix {

/// r^a: coordinates in a frame known at run time, in the unit U. The frames are checked at run time, the unit
/// at compile time. Made by `vector(In(a), ...)`; there is no default.
template <VectorUnit U> class NamedVector {
 public:
  template <class Derived>
  NamedVector(detail::Trusted, NamedFrame in, const Eigen::MatrixBase<Derived>& coordinates)
      : in_(in), coordinates_(coordinates) {}

  NamedFrame in() const { return in_; }
  const detail::Column<double>& coordinates() const& { return coordinates_; }
  detail::Column<double> coordinates() && { return coordinates_; }

  NamedVector operator-() const { return {detail::trusted, in_, -coordinates_}; }

  Quantity<U> x() const { return Quantity<U>::from_value(coordinates_.x()); }
  Quantity<U> y() const { return Quantity<U>::from_value(coordinates_.y()); }
  Quantity<U> z() const { return Quantity<U>::from_value(coordinates_.z()); }

 private:
  NamedFrame in_;
  detail::Column<double> coordinates_;
};

template <class U> inline constexpr bool detail::is_framed<NamedVector<U>> = true;

/// Claims that the three bare numbers are coordinates in a, in the coherent SI unit U:
/// vector<si::length>(In(a), m), also of a part of a longer column or of a matrix: x.segment(3, 3). Throws
/// BadInput when one is not finite, or there are not three.
template <VectorUnit U, detail::ThreeNumbers Numbers>
  requires(std::same_as<typename Numbers::Scalar, double>)
NamedVector<U> vector(In<NamedFrame> a, const Numbers& coordinates) {
  const auto door = [&] { return "vector(in " + detail::in_quotes(a.frame) + "): "; };
  detail::require_three(coordinates, door);
  const detail::Column<double> r = coordinates;
  if (!r.allFinite()) {
    throw BadInput(door() + "the coordinates (" + detail::text(r.x()) + ", " + detail::text(r.y()) + ", " +
                   detail::text(r.z()) + ") are not finite");
  }
  return {detail::trusted, a.frame, r};
}
template <VectorUnit U>
NamedVector<U> vector(In<NamedFrame> a, const Quantity<U>& x, const Quantity<U>& y, const Quantity<U>& z) {
  return vector<U>(a, detail::Column<double>(x.value(), y.value(), z.value()));
}

// r^b = R_a^b r^a
template <class U> NamedVector<U> product(const NamedDcm& R_b_from_a, const NamedVector<U>& r_a) {
  detail::require_same(R_b_from_a.from(), r_a.in(), [&] {
    return "product of " + detail::described(R_b_from_a) + " and a vector in " + detail::in_quotes(r_a.in());
  });
  return {detail::trusted, R_b_from_a.to(), R_b_from_a.matrix() * r_a.coordinates()};
}

template <class U> NamedVector<U> sum(const NamedVector<U>& r, const NamedVector<U>& s) {
  detail::require_same(r.in(), s.in(), [] { return std::string{"sum of two vectors"}; });
  return {detail::trusted, r.in(), r.coordinates() + s.coordinates()};
}
template <class U> NamedVector<U> difference(const NamedVector<U>& r, const NamedVector<U>& s) {
  detail::require_same(r.in(), s.in(), [] { return std::string{"difference of two vectors"}; });
  return {detail::trusted, r.in(), r.coordinates() - s.coordinates()};
}

template <class U> std::ostream& print_framed(std::ostream& out, const NamedVector<U>& r_a) {
  return detail::print_column(out, r_a.coordinates(), detail::unit_symbol<U>)
         << " in " << detail::in_quotes(r_a.in());
}

}  // namespace vectrix
