#pragma once

#include <vectrix/frames/dcm.hpp>
#include <vectrix/kinematics/named/some.hpp>

namespace vectrix {

/// R_a^b between two frames known at run time. Its laws are those of Dcm, checked at run time:
///     1.  R_a^c = R_b^c R_a^b                 R_c_from_b * R_b_from_a
///     2.  R_b^a = (R_a^b)^T                   inverse(R_b_from_a)
/// A product whose inner frames differ throws BadInput that names both. Made by the doors in
/// named/dcm_doors.hpp and by the queries of a NamedGraph; there is no default. Must not outlive the graph.
class NamedDcm {
 public:
  template <class Derived>
  NamedDcm(detail::Trusted, NamedFrame to, NamedFrame from, const Eigen::MatrixBase<Derived>& matrix)
      : to_(to), from_(from), matrix_(matrix) {}
  template <detail::Makes<detail::Square<double>> Make>
  NamedDcm(detail::Trusted, NamedFrame to, NamedFrame from, const Make& make)
      : to_(to), from_(from), matrix_(make()) {}

  NamedFrame to() const { return to_; }
  NamedFrame from() const { return from_; }
  const detail::Square<double>& matrix() const& { return matrix_; }
  detail::Square<double> matrix() && { return matrix_; }

 private:
  NamedFrame to_, from_;
  detail::Square<double> matrix_;
};

template <> inline constexpr bool detail::is_framed<NamedDcm> = true;

namespace detail {

inline std::string to_from(NamedFrame b, NamedFrame a) {
  return " to " + in_quotes(b) + " from " + in_quotes(a);
}
inline std::string described(const NamedDcm& R_b_from_a) {
  return "R" + to_from(R_b_from_a.to(), R_b_from_a.from());
}

/// Throws BadInput unless both are the same frame. action() describes the operation and its operands.
template <class Action> void require_same(NamedFrame one, NamedFrame other, const Action& action) {
  if (one == other) [[likely]]
    return;
  throw BadInput(action() + ": " + are_two(one, other));
}

}  // namespace detail

inline NamedDcm product(const NamedDcm& R_c_from_b, const NamedDcm& R_b_from_a) {
  detail::require_same(R_c_from_b.from(), R_b_from_a.to(), [&] {
    return "product of " + detail::described(R_c_from_b) + " and " + detail::described(R_b_from_a);
  });
  return {detail::trusted, R_c_from_b.to(), R_b_from_a.from(), R_c_from_b.matrix() * R_b_from_a.matrix()};
}

inline NamedDcm inverse(const NamedDcm& R_b_from_a) {
  return {detail::trusted, R_b_from_a.from(), R_b_from_a.to(), R_b_from_a.matrix().transpose()};
}

inline std::ostream& print_framed(std::ostream& out, const NamedDcm& R_b_from_a) {
  return detail::print_square(out, R_b_from_a.matrix())
         << detail::to_from(R_b_from_a.to(), R_b_from_a.from());
}

}  // namespace vectrix
