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

 private:
  NamedFrame to_, from_;
  Eigen::Quaterniond value_;
};

/// The checked doors. Throw BadInput when a number is not finite or | |q| - 1 | exceeds unit_norm_tolerance.
inline NamedQuaternion quaternion_scalar_first(To<NamedFrame> b, From<NamedFrame> a, double w, double x,
                                               double y, double z) {
  return detail::through_door(b.frame, a.frame, [&] {
    using namespace detail;
    return NamedQuaternion{trusted, b.frame, a.frame,
                           quaternion_scalar_first(to<FirstNamed>, from<SecondNamed>, w, x, y, z).eigen()};
  });
}
inline NamedQuaternion quaternion_scalar_last(To<NamedFrame> b, From<NamedFrame> a, double x, double y,
                                              double z, double w) {
  return detail::through_door(b.frame, a.frame, [&] {
    using namespace detail;
    return NamedQuaternion{trusted, b.frame, a.frame,
                           quaternion_scalar_last(to<FirstNamed>, from<SecondNamed>, x, y, z, w).eigen()};
  });
}

inline NamedQuaternion quaternion(const NamedDcm& R_b_from_a) {
  using namespace detail;
  const Dcm<FirstNamed, SecondNamed> R{trusted, R_b_from_a.matrix()};
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
