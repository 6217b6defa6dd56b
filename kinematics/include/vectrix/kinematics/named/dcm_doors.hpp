#pragma once

#include <vectrix/frames/dcm_doors.hpp>
#include <vectrix/kinematics/named/dcm.hpp>

namespace vectrix {
namespace detail {

inline void require_two(std::string_view door, NamedFrame b, NamedFrame a) {
  if (b == a) {
    throw BadInput(std::string{door} + "(to " + in_quotes(b) + ", from " + in_quotes(a) +
                   "): a door takes two frames, and these are one");
  }
}
/// make(), which uses the typed door to Some<'b'> from Some<'a'>.
template <class Make> auto through_door(std::string_view door, NamedFrame b, NamedFrame a, const Make& make) {
  require_two(door, b, a);
  Lent lent;
  lent.give('b', b);
  lent.give('a', a);
  return lent.call(make);
}

template <class Typed> NamedDcm named(std::string_view door, NamedFrame b, NamedFrame a, const Typed& typed) {
  return through_door(door, b, a, [&] {
    return NamedDcm{trusted, b, a, typed(vectrix::to<Some<'b'>>, vectrix::from<Some<'a'>>).matrix()};
  });
}

template <class Derived>
concept Matrix3x3d = Matrix3x3<Derived> && std::same_as<typename Derived::Scalar, double>;

}  // namespace detail

// The doors of frames/dcm_doors.hpp for frames known at run time, with the same checks and errors.

/// Checked: throws BadInput unless `matrix` is finite, orthonormal to 1e-9 and right-handed.
template <detail::Matrix3x3d Matrix>
NamedDcm dcm(To<NamedFrame> b, From<NamedFrame> a, const Matrix& matrix) {
  return detail::named("dcm", b.frame, a.frame,
                       [&](auto to_b, auto from_a) { return dcm(to_b, from_a, matrix); });
}

struct NearestNamedDcm {
  NamedDcm dcm;
  /// Frobenius norm of the change.
  double distance;
};

/// Projected: the nearest rotation, and its distance.
template <detail::Matrix3x3d Matrix>
NearestNamedDcm nearest_dcm(To<NamedFrame> b, From<NamedFrame> a, const Matrix& matrix) {
  double distance = 0.0;
  const NamedDcm nearest = detail::named("nearest_dcm", b.frame, a.frame, [&](auto to_b, auto from_a) {
    const auto found = nearest_dcm(to_b, from_a, matrix);
    distance = found.distance;
    return found.dcm;
  });
  return {nearest, distance};
}

/// Trusted: does not check the matrix.
template <detail::Matrix3x3d Matrix>
NamedDcm trust_dcm(To<NamedFrame> b, From<NamedFrame> a, const Matrix& matrix) {
  detail::require_two("trust_dcm", b.frame, a.frame);
  detail::require_size(matrix, 3, 3, [&] {
    return "trust_dcm(to " + detail::in_quotes(b.frame) + ", from " + detail::in_quotes(a.frame) + "): ";
  });
  return {detail::trusted, b.frame, a.frame, matrix};
}

/// Claims that the axes of a and b are parallel.
inline NamedDcm aligned(To<NamedFrame> b, From<NamedFrame> a) {
  detail::require_two("aligned", b.frame, a.frame);
  return {detail::trusted, b.frame, a.frame, detail::Square<double>::Identity()};
}

/// R_b_from_a, where turning a by `angle` about its x axis (y, z) gives b. Any finite angle is valid.
inline NamedDcm turned_x(To<NamedFrame> b, From<NamedFrame> a, const Quantity<si::angle>& angle) {
  return detail::named("turned_x", b.frame, a.frame,
                       [&](auto to_b, auto from_a) { return turned_x(to_b, from_a, angle); });
}
inline NamedDcm turned_y(To<NamedFrame> b, From<NamedFrame> a, const Quantity<si::angle>& angle) {
  return detail::named("turned_y", b.frame, a.frame,
                       [&](auto to_b, auto from_a) { return turned_y(to_b, from_a, angle); });
}
inline NamedDcm turned_z(To<NamedFrame> b, From<NamedFrame> a, const Quantity<si::angle>& angle) {
  return detail::named("turned_z", b.frame, a.frame,
                       [&](auto to_b, auto from_a) { return turned_z(to_b, from_a, angle); });
}

}  // namespace vectrix
