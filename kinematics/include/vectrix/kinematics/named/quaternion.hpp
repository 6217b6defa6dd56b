#pragma once

#include <vectrix/kinematics/attitude/quaternion.hpp>
#include <vectrix/kinematics/named/dcm_doors.hpp>

namespace vectrix {

/// q_a^b between two frames known at run time, for example from a line of an attitude file. The doors are
/// those of Quaternion, with the same checks and errors.
class NamedQuaternion {
 public:
  NamedQuaternion(detail::Trusted, NamedFrame to, NamedFrame from, const Eigen::Quaterniond& value)
      : to_(to), from_(from), value_(value) {}

  NamedFrame to() const { return to_; }
  NamedFrame from() const { return from_; }
  /// The bare quaternion; Eigen stores the scalar last and constructs with the scalar first.
  const Eigen::Quaterniond& eigen() const& { return value_; }
  Eigen::Quaterniond eigen() && { return value_; }
  std::array<double, 4> scalar_first() const { return {value_.w(), value_.x(), value_.y(), value_.z()}; }
  std::array<double, 4> scalar_last() const { return {value_.x(), value_.y(), value_.z(), value_.w()}; }

 private:
  NamedFrame to_, from_;
  Eigen::Quaterniond value_;
};

struct NearestNamedQuaternion {
  NamedQuaternion quaternion;
  /// | |q| - 1 | before the projection.
  double distance;
};

namespace detail {

template <class Typed>
NamedQuaternion named_quaternion(std::string_view door, NamedFrame b, NamedFrame a, const Typed& typed) {
  return through_door(door, b, a, [&] {
    return NamedQuaternion{trusted, b, a, typed(vectrix::to<Some<'b'>>, vectrix::from<Some<'a'>>).eigen()};
  });
}
template <class Typed>
NearestNamedQuaternion nearest_named_quaternion(std::string_view door, NamedFrame b, NamedFrame a,
                                                const Typed& typed) {
  double distance = 0.0;
  const NamedQuaternion nearest = named_quaternion(door, b, a, [&](auto to_b, auto from_a) {
    const auto found = typed(to_b, from_a);
    distance = found.distance;
    return found.quaternion;
  });
  return {nearest, distance};
}

}  // namespace detail

/// The checked doors. Throw BadInput when a number is not finite or | |q| - 1 | exceeds unit_norm_tolerance.
inline NamedQuaternion quaternion_scalar_first(To<NamedFrame> b, From<NamedFrame> a, double w, double x,
                                               double y, double z) {
  return detail::named_quaternion("quaternion_scalar_first", b.frame, a.frame, [&](auto to_b, auto from_a) {
    return quaternion_scalar_first(to_b, from_a, w, x, y, z);
  });
}
inline NamedQuaternion quaternion_scalar_last(To<NamedFrame> b, From<NamedFrame> a, double x, double y,
                                              double z, double w) {
  return detail::named_quaternion("quaternion_scalar_last", b.frame, a.frame, [&](auto to_b, auto from_a) {
    return quaternion_scalar_last(to_b, from_a, x, y, z, w);
  });
}

/// The same of Eigen's quaternion, whose members say where the scalar is.
inline NamedQuaternion quaternion(To<NamedFrame> b, From<NamedFrame> a, const Eigen::Quaterniond& q) {
  return detail::named_quaternion("quaternion", b.frame, a.frame,
                                  [&](auto to_b, auto from_a) { return quaternion(to_b, from_a, q); });
}

/// The projected doors: q / |q|, and | |q| - 1 |. Throw BadInput when q is zero or not finite.
inline NearestNamedQuaternion nearest_quaternion_scalar_first(To<NamedFrame> b, From<NamedFrame> a, double w,
                                                              double x, double y, double z) {
  return detail::nearest_named_quaternion(
      "nearest_quaternion_scalar_first", b.frame, a.frame,
      [&](auto to_b, auto from_a) { return nearest_quaternion_scalar_first(to_b, from_a, w, x, y, z); });
}
inline NearestNamedQuaternion nearest_quaternion_scalar_last(To<NamedFrame> b, From<NamedFrame> a, double x,
                                                             double y, double z, double w) {
  return detail::nearest_named_quaternion(
      "nearest_quaternion_scalar_last", b.frame, a.frame,
      [&](auto to_b, auto from_a) { return nearest_quaternion_scalar_last(to_b, from_a, x, y, z, w); });
}

inline NearestNamedQuaternion nearest_quaternion(To<NamedFrame> b, From<NamedFrame> a,
                                                 const Eigen::Quaterniond& q) {
  return detail::nearest_named_quaternion(
      "nearest_quaternion", b.frame, a.frame,
      [&](auto to_b, auto from_a) { return nearest_quaternion(to_b, from_a, q); });
}

inline NamedQuaternion quaternion(const NamedDcm& R_b_from_a) {
  using namespace detail;
  const Dcm<Some<'b'>, Some<'a'>> R{trusted, R_b_from_a.matrix()};
  return {trusted, R_b_from_a.to(), R_b_from_a.from(), quaternion(R).eigen()};
}
inline NamedDcm dcm(const NamedQuaternion& q_b_from_a) {
  return {detail::trusted, q_b_from_a.to(), q_b_from_a.from(), q_b_from_a.eigen().toRotationMatrix()};
}

inline std::ostream& print_framed(std::ostream& out, const NamedQuaternion& q_b_from_a) {
  return detail::print_quaternion(out, q_b_from_a.eigen())
         << detail::to_from(q_b_from_a.to(), q_b_from_a.from());
}

}  // namespace vectrix
