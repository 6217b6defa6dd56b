#pragma once

#include <vectrix/frames/graph/level.hpp>
#include <vectrix/kinematics/named/rate.hpp>

namespace vectrix {

/// The rotation and the rate of b relative to a at one instant, R_b^a and w_ab^b: MovingDcm for frames known
/// at run time. Made by moving_dcm().
class NamedMovingDcm {
 public:
  NamedMovingDcm(detail::Trusted, const NamedDcm& R_a_from_b, const NamedAngularVelocity& w_ab_b)
      : rotation_(R_a_from_b), rate_(w_ab_b) {}

  const NamedDcm& rotation() const& { return rotation_; }
  NamedDcm rotation() && { return rotation_; }
  const NamedAngularVelocity& angular_velocity() const& { return rate_; }
  NamedAngularVelocity angular_velocity() && { return rate_; }

 private:
  NamedDcm rotation_;
  NamedAngularVelocity rate_;
};

/// The rotation, rate and acceleration: R_b^a, w_ab^b and alpha_ab^b. Made by accelerating_dcm().
class NamedAcceleratingDcm {
 public:
  NamedAcceleratingDcm(detail::Trusted, const NamedMovingDcm& moving,
                       const NamedAngularAcceleration& alpha_ab_b)
      : moving_(moving), acceleration_(alpha_ab_b) {}

  const NamedDcm& rotation() const& { return moving_.rotation(); }
  NamedDcm rotation() && { return moving_.rotation(); }
  const NamedAngularVelocity& angular_velocity() const& { return moving_.angular_velocity(); }
  NamedAngularVelocity angular_velocity() && { return moving_.angular_velocity(); }
  const NamedAngularAcceleration& angular_acceleration() const& { return acceleration_; }
  NamedAngularAcceleration angular_acceleration() && { return acceleration_; }

 private:
  NamedMovingDcm moving_;
  NamedAngularAcceleration acceleration_;
};

namespace detail {

template <class U>
void require_motion(const NamedDcm& R_a_from_b, const NamedRelativeVector<U>& rate, const char* door) {
  const auto action = [&] {
    return std::string{door} + "(" + described(R_a_from_b) + ", " + described(rate) + ")";
  };
  require_same(R_a_from_b.to(), rate.relative_to(), action);
  require_same(R_a_from_b.from(), rate.of(), action);
  if (rate.in() != rate.relative_to()) require_same(R_a_from_b.from(), rate.in(), action);
}

}  // namespace detail

/// Joins a rotation and its rate; the rate may be expressed in b or in a. Throws BadInput when the frames of
/// the two do not match.
inline NamedMovingDcm moving_dcm(const NamedDcm& R_a_from_b, const NamedAngularVelocity& w_ab) {
  detail::require_motion(R_a_from_b, w_ab, "moving_dcm");
  if (w_ab.in() == R_a_from_b.from()) return {detail::trusted, R_a_from_b, w_ab};
  return {detail::trusted, R_a_from_b, inverse(R_a_from_b) * w_ab};
}

/// Joins a rotation, its rate and its acceleration, each of the last two expressed in b or in a.
inline NamedAcceleratingDcm accelerating_dcm(const NamedDcm& R_a_from_b, const NamedAngularVelocity& w_ab,
                                             const NamedAngularAcceleration& alpha_ab) {
  detail::require_motion(R_a_from_b, alpha_ab, "accelerating_dcm");
  const NamedMovingDcm moving = moving_dcm(R_a_from_b, w_ab);
  if (alpha_ab.in() == R_a_from_b.from()) return {detail::trusted, moving, alpha_ab};
  return {detail::trusted, moving, inverse(R_a_from_b) * alpha_ab};
}

inline std::ostream& print_framed(std::ostream& out, const NamedMovingDcm& value) {
  return out << value.rotation() << "; " << value.angular_velocity();
}
inline std::ostream& print_framed(std::ostream& out, const NamedAcceleratingDcm& value) {
  return out << value.rotation() << "; " << value.angular_velocity() << "; " << value.angular_acceleration();
}

}  // namespace vectrix
