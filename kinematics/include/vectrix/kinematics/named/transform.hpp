#pragma once

#include <vectrix/kinematics/named/displacement.hpp>
#include <vectrix/kinematics/named/moving_dcm.hpp>

namespace vectrix {
namespace detail {

/// Throws BadInput unless x is of b relative to a, observed from a and expressed in a.
template <class X> void require_place(const char* type, const NamedDcm& R_a_from_b, const X& x) {
  const auto action = [&] {
    return std::string{type} + "{" + described(R_a_from_b) + ", " + described(x) + "}";
  };
  require_same(R_a_from_b.from(), x.of(), action);
  require_same(R_a_from_b.to(), x.relative_to(), action);
  if constexpr (requires { x.observed_from(); }) require_same(R_a_from_b.to(), x.observed_from(), action);
  require_same(R_a_from_b.to(), x.in(), action);
}

}  // namespace detail

/// X_a^b between two frames known at run time: R_a^b and r_ba^b, the position of a's origin relative to b's.
/// Its laws are those of Transform, checked at run time:
///     1.  r_bq^b = R_a^b r_aq^a + r_ba^b      X_b_from_a * r_aq_a
///     2.  X_a^c = X_b^c X_a^b                 X_c_from_b * X_b_from_a
///     3.  X_b^a = (X_a^b)^-1                  inverse(X_b_from_a)
/// NamedTransform{R_b_from_a, r_ba_b} throws BadInput when the frames of the two do not match.
class NamedTransform {
 public:
  NamedTransform(const NamedDcm& R_b_from_a, const NamedDisplacement& r_ba_b)
      : rotation_(R_b_from_a), translation_(r_ba_b) {
    detail::require_place("NamedTransform", R_b_from_a, r_ba_b);
  }
  template <class Derived>
  NamedTransform(detail::Trusted key, const NamedDcm& R_b_from_a, const Eigen::MatrixBase<Derived>& r_ba_b)
      : rotation_(R_b_from_a),
        translation_(key, R_b_from_a.from(), R_b_from_a.to(), {key, R_b_from_a.to(), r_ba_b}) {}

  const NamedDcm& rotation() const& { return rotation_; }
  NamedDcm rotation() && { return rotation_; }
  const NamedDisplacement& translation() const& { return translation_; }
  NamedDisplacement translation() && { return translation_; }

 private:
  NamedDcm rotation_;
  NamedDisplacement translation_;
};

/// Position and motion of b relative to a, observed from a, between frames known at run time: R_b^a and
/// w_ab^b, r_ab^a, and v_ab|a^a. As MovingTransform; throws BadInput when the frames do not match.
class NamedMovingTransform {
 public:
  NamedMovingTransform(const NamedMovingDcm& turning, const NamedDisplacement& r_ab_a,
                       const NamedVelocity& v_ab_a_a)
      : turning_(turning), translation_(r_ab_a), velocity_(v_ab_a_a) {
    detail::require_place("NamedMovingTransform", turning.rotation(), r_ab_a);
    detail::require_place("NamedMovingTransform", turning.rotation(), v_ab_a_a);
  }

  const NamedMovingDcm& turning() const& { return turning_; }
  NamedMovingDcm turning() && { return turning_; }
  const NamedDisplacement& translation() const& { return translation_; }
  NamedDisplacement translation() && { return translation_; }
  const NamedVelocity& velocity() const& { return velocity_; }
  NamedVelocity velocity() && { return velocity_; }

 private:
  NamedMovingDcm turning_;
  NamedDisplacement translation_;
  NamedVelocity velocity_;
};

/// The same with alpha_ab^b and the acceleration a_ab|a^a.
class NamedAcceleratingTransform {
 public:
  NamedAcceleratingTransform(const NamedAcceleratingDcm& turning, const NamedDisplacement& r_ab_a,
                             const NamedVelocity& v_ab_a_a, const NamedAcceleration& a_ab_a_a)
      : turning_(turning), translation_(r_ab_a), velocity_(v_ab_a_a), acceleration_(a_ab_a_a) {
    detail::require_place("NamedAcceleratingTransform", turning.rotation(), r_ab_a);
    detail::require_place("NamedAcceleratingTransform", turning.rotation(), v_ab_a_a);
    detail::require_place("NamedAcceleratingTransform", turning.rotation(), a_ab_a_a);
  }

  const NamedAcceleratingDcm& turning() const& { return turning_; }
  NamedAcceleratingDcm turning() && { return turning_; }
  const NamedDisplacement& translation() const& { return translation_; }
  NamedDisplacement translation() && { return translation_; }
  const NamedVelocity& velocity() const& { return velocity_; }
  NamedVelocity velocity() && { return velocity_; }
  const NamedAcceleration& acceleration() const& { return acceleration_; }
  NamedAcceleration acceleration() && { return acceleration_; }

 private:
  NamedAcceleratingDcm turning_;
  NamedDisplacement translation_;
  NamedVelocity velocity_;
  NamedAcceleration acceleration_;
};

template <> inline constexpr bool detail::is_framed<NamedTransform> = true;

// r_bq^b = R_a^b r_aq^a + r_ba^b
inline NamedDisplacement product(const NamedTransform& X_b_from_a, const NamedDisplacement& r_aq_a) {
  return X_b_from_a.translation() + X_b_from_a.rotation() * r_aq_a;
}
// X_a^c = X_b^c X_a^b
inline NamedTransform product(const NamedTransform& X_c_from_b, const NamedTransform& X_b_from_a) {
  return {X_c_from_b.rotation() * X_b_from_a.rotation(), X_c_from_b * X_b_from_a.translation()};
}
// r_ab^a = -R_b^a r_ba^b
inline NamedTransform inverse(const NamedTransform& X_b_from_a) {
  const NamedDcm R_a_from_b = inverse(X_b_from_a.rotation());
  return {R_a_from_b, R_a_from_b * -X_b_from_a.translation()};
}

inline std::ostream& print_framed(std::ostream& out, const NamedTransform& X_b_from_a) {
  return out << X_b_from_a.rotation() << "; " << X_b_from_a.translation();
}
inline std::ostream& print_framed(std::ostream& out, const NamedMovingTransform& value) {
  return out << value.turning() << "; " << value.translation() << "; " << value.velocity();
}
inline std::ostream& print_framed(std::ostream& out, const NamedAcceleratingTransform& value) {
  return out << value.turning() << "; " << value.translation() << "; " << value.velocity() << "; "
             << value.acceleration();
}

}  // namespace vectrix
