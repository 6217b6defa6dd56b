#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vectrix/dynamics/force/about.hpp>
#include <vectrix/frames/export.hpp>
#include <vectrix/frames/scalar/principal_values.hpp>
#include <vectrix/kinematics/rates/angular_acceleration.hpp>

namespace vectrix {

/// J_p^c, `J_p_c`, of type Inertia<B, P, In<C>>: the inertia tensor of the rigid body b about the point p,
/// expressed in c, kg m^2. `Inertia<B>`, `J_b`, is about the centre of mass, in the axes of the body.
///     J = [ Jxx Jxy Jxz; Jxy Jyy Jyz; Jxz Jyz Jzz ],  Jxx = int (y^2 + z^2) dm,  Jxy = - int x y dm
/// Its laws; see also parallel_axes.hpp and, for the sum of parts, join.hpp:
///     1.  J_p^d = R_c^d J_p^c (R_c^d)^T      R_d_from_c * J_p_c
///     2.  H_c = J_c w_ab, T = 1/2 w_ab . J_c w_ab, about the centre of mass c only
/// Made by inertia_from_tensor() or inertia_from_moments_and_products(), which differ in the sign of the
/// off-diagonal numbers, or inertia_from_principal_moments(). No default constructor. No principal moment is
/// negative, and J1 + J2 >= J3. One or all of them are zero for a rod and a point mass, which are parts of a
/// body; Euler's equation refuses these.
template <Frame B, Point P = CentreOfMassOf<B>, class ExpressedIn = In<B>, class S = double> class Inertia;

template <Frame B, Point P, Frame C, class S> class Inertia<B, P, In<C>, S> {
 public:
  Inertia() = delete;  // inertia_from_tensor(of<B>, about<P>, in<C>, ...)
  template <class Derived>
  Inertia(detail::Trusted, const Eigen::MatrixBase<Derived>& tensor) : tensor_(tensor) {}

  /// The entries of the tensor, kg m^2, without types.
  const detail::Square<S>& matrix() const& { return tensor_; }
  detail::Square<S> matrix() && { return tensor_; }

  template <class Operand = Inertia>
  auto operator-() const -> Refused = delete;  // an inertia has no negative

 private:
  detail::Square<S> tensor_;
};

namespace detail {

/// Relative tolerance for rounding: in J1 + J2 >= J3, where a flat plate has equality, and in J1 > 0, where a
/// thin rod has J1 = 0.
template <class S> S moment_tolerance() {
  return S(std::max(1e-12, 16.0 * static_cast<double>(Eigen::NumTraits<S>::epsilon())));
}

/// The inverse, or NaN if the smallest moment is zero within <rounding> (kg m^2) and the relative tolerance.
/// With moments of sum one: J1 J2 J3 / (J1 J2 + J2 J3 + J3 J1) is J1 if J1 is small, and between J1/3 and J1.
template <class S> Square<S> inverse_or_nan(const Square<S>& tensor, const S& rounding) {
  const S trace = tensor.trace();
  const Square<S> scaled = tensor / trace;
  const S products = (S(1) - scaled.squaredNorm()) / S(2);
  const S least = moment_tolerance<S>() / S(2) + rounding / trace;
  const S divisor =
      select(scaled.determinant() > least * products, trace, S(std::numeric_limits<double>::quiet_NaN()));
  return scaled.inverse() / divisor;
}
extern template Square<double> inverse_or_nan(const Square<double>&, const double&);

}  // namespace detail

/// Also holds the inverse tensor, for Euler's equation.
template <Frame B, class S> class Inertia<B, CentreOfMassOf<B>, In<B>, S> {
 public:
  Inertia() = delete;  // inertia_from_tensor(in<B>, ...) or inertia_from_moments_and_products(in<B>, ...)
  /// `rounding`: how far the tensor may be off, kg m^2.
  Inertia(detail::Trusted, const detail::Square<S>& tensor, const S& rounding = S(0))
      : tensor_(tensor), inverse_(detail::inverse_or_nan<S>(tensor, rounding)) {}

  /// The entries of the tensor, kg m^2, without types; and the inverse tensor, 1/(kg m^2). Throws BadInput if
  /// it has none, as that of a rod or a point mass, or if its numbers overflow.
  const detail::Square<S>& matrix() const& { return tensor_; }
  detail::Square<S> matrix() && { return tensor_; }
  const detail::Square<S>& inverse_matrix() const& {
    if (!has_inverse()) refuse_inverse();
    return inverse_;
  }
  detail::Square<S> inverse_matrix() && { return std::as_const(*this).inverse_matrix(); }
  bool has_inverse() const {
    const S& entry = inverse_(0, 0);
    return detail::all(entry - entry == S(0));
  }

  template <class Operand = Inertia>
  auto operator-() const -> Refused = delete;  // an inertia has no negative

 private:
  [[noreturn, gnu::cold, gnu::noinline]] void refuse_inverse() const;

  detail::Square<S> tensor_;
  detail::Square<S> inverse_;
};

template <class B, class P, class C, class S>
inline constexpr bool detail::is_framed<Inertia<B, P, C, S>> = true;

/// About the centre of mass of b, in the axes of b: `Inertia<B>` for another scalar.
template <Frame B, class S = double> using CentralInertia = Inertia<B, CentreOfMassOf<B>, In<B>, S>;

namespace detail {

template <class J, class S> struct WithScalar;
template <class B, class P, class C, class Old, class S>
struct WithScalar<Inertia<B, P, C, Old>, S> : std::type_identity<Inertia<B, P, C, S>> {};

template <class J, class S> J of_tensor(const Square<S>& tensor, const S& rounding) {
  if constexpr (std::constructible_from<J, Trusted, const Square<S>&, const S&>) {
    return J{trusted, tensor, rounding};
  } else {
    return J{trusted, tensor};
  }
}

// The operands of an inertia, for messages: of<B>, about<P>, in<C>, or in<B>.
VECTRIX_EXPORT std::string inertia_name(const std::string& b, const std::string& p, const std::string& c);
VECTRIX_EXPORT std::string inertia_name(const std::string& b);
template <class J> struct InertiaName;
template <class B, class P, class C, class S> struct InertiaName<Inertia<B, P, In<C>, S>> {
  static std::string text() { return inertia_name(frame_name<B>(), frame_name<P>(), frame_name<C>()); }
};
template <class B, class S> struct InertiaName<Inertia<B, CentreOfMassOf<B>, In<B>, S>> {
  static std::string text() { return inertia_name(frame_name<B>()); }
};

template <class S> std::string entry_is(Eigen::Index row, Eigen::Index column, const S& entry) {
  return "entry (" + text(row + 1) + ", " + text(column + 1) + ") of the tensor is " + text(entry) +
         " kg m^2";
}

/// Throws BadInput if no body has the tensor of the inertia with this name. `rounding`: how far it may be
/// off, kg m^2, besides the relative tolerance.
template <class S>
void require_moments(const char* door, NameFunction name, const Square<S>& tensor, const S& rounding) {
  const auto refuse = [&](const std::string& why) {
    throw BadInput(std::string{door} + "(" + name() + "): " + why);
  };
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = row; column < 3; ++column) {
      const S& entry = tensor(row, column);
      if (!(entry - entry == S(0))) refuse(entry_is(row, column, entry));
    }
  }
  const Column<S> moments = principal_values(tensor);
  const auto listed = [&] {
    return "(" + text(moments(0)) + ", " + text(moments(1)) + ", " + text(moments(2)) + ") kg m^2";
  };
  const S off = moment_tolerance<S>() * moments(2) + rounding;
  if (!(moments(0) >= -off && moments(2) >= S(0))) {
    refuse("not all principal moments " + listed() + " are positive or zero");
  }
  const S excess = moments(2) - moments(0) - moments(1);
  if (!(excess <= off)) {
    refuse("the largest principal moment of " + listed() + " exceeds the sum of the others by " +
           text(excess) + "; no body has this inertia");
  }
}
extern template void require_moments(const char*, NameFunction, const Square<double>&, const double&);

template <class J, class S>
J checked_inertia(const char* door, const Square<S>& tensor, const S& rounding = S(0)) {
  require_moments<S>(door, InertiaName<J>::text, tensor, rounding);
  return of_tensor<J>(tensor, rounding);
}
/// The check has branches, so each lane is checked alone.
template <class J, Batch S>
J checked_inertia(const char* door, const Square<S>& tensor, const S& rounding = S(0)) {
  for (std::size_t i = 0; i < S::size(); ++i) {
    using Lane = typename S::value_type;
    checked_inertia<typename WithScalar<J, Lane>::type>(door, lane(tensor, i), Lane(rounding[i]));
  }
  return of_tensor<J>(tensor, rounding);
}
/// Checked on values, not derivatives.
template <class J, Differentiated S>
J checked_inertia(const char* door, const Square<S>& tensor, const S& rounding = S(0)) {
  using Value = std::remove_cvref_t<decltype(tensor(0, 0).value())>;
  const Square<Value> values = tensor.unaryExpr([](const S& x) { return Value(x.value()); });
  checked_inertia<typename WithScalar<J, Value>::type>(door, values, Value(rounding.value()));
  return of_tensor<J>(tensor, rounding);
}

template <class J, class S> void require_symmetric(const char* door, const Square<S>& tensor) {
  for (Eigen::Index i = 0; i < 3; ++i)
    for (Eigen::Index j = 0; j < 3; ++j)
      if (const S entry = tensor(i, j); !all(entry - entry == S(0)))
        throw BadInput(std::string{door} + "(" + InertiaName<J>::text() + "): " + entry_is(i, j, entry));
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = i + 1; j < 3; ++j) {
      const S error = tensor(i, j) - tensor(j, i);
      const S tolerance = moment_tolerance<S>() * (tensor(i, i) + tensor(j, j));
      if (!all(error <= tolerance) || !all(-error <= tolerance)) {
        throw BadInput(std::string{door} + "(" + InertiaName<J>::text() + "): entries (" + text(i + 1) +
                       ", " + text(j + 1) + ") and (" + text(j + 1) + ", " + text(i + 1) +
                       ") of the tensor differ by " + text(error) + " kg m^2");
      }
    }
  }
}

/// An off-diagonal number of the axes i and j, i < j.
template <int i, int j, class S> struct OffDiagonal { S value; };

template <class S, class... Given>
concept OffDiagonals =
    sizeof...(Given) == 3 && one_of<OffDiagonal<1, 2, S>, Given...>&& one_of<
                                 OffDiagonal<1, 3, S>, Given...>&& one_of<OffDiagonal<2, 3, S>, Given...>;

template <class S, class... Given>
Square<S> symmetric(const S& xx, const S& yy, const S& zz, const S& sign, const Given&... given) {
  struct Named : Given... {};
  const Named all{given...};
  const S xy = sign * static_cast<const OffDiagonal<1, 2, S>&>(all).value;
  const S xz = sign * static_cast<const OffDiagonal<1, 3, S>&>(all).value;
  const S yz = sign * static_cast<const OffDiagonal<2, 3, S>&>(all).value;
  Square<S> matrix;
  matrix << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  return matrix;
}

}  // namespace detail

/// These name the off-diagonal numbers, so that any order can be given: tables list xy, xz, yz or xy, yz, zx.
template <class S> detail::OffDiagonal<1, 2, S> xy(const Quantity<si::moment_of_inertia, S>& J) {
  return {J.value()};
}
template <class S> detail::OffDiagonal<1, 3, S> xz(const Quantity<si::moment_of_inertia, S>& J) {
  return {J.value()};
}
template <class S> detail::OffDiagonal<1, 3, S> zx(const Quantity<si::moment_of_inertia, S>& J) {
  return xz(J);
}
template <class S> detail::OffDiagonal<2, 3, S> yz(const Quantity<si::moment_of_inertia, S>& J) {
  return {J.value()};
}

namespace detail {

template <class S> using InertiaNumber = Quantity<si::moment_of_inertia, S>;

template <Frame B, Point P, Frame C, class S, class... Named>
  requires OffDiagonals<S, Named...> Inertia<B, P, In<C>, S> from_tensor(Of<B>, About<P>, In<C>,
                                                                         const InertiaNumber<S>& Jxx,
                                                                         const InertiaNumber<S>& Jyy,
                                                                         const InertiaNumber<S>& Jzz,
                                                                         const Named&... entries) {
    return checked_inertia<Inertia<B, P, In<C>, S>>(
        "inertia_from_tensor", symmetric<S>(Jxx.value(), Jyy.value(), Jzz.value(), S(1), entries...));
  }
template <Frame B, Point P, Frame C, Matrix3x3 Matrix>
Inertia<B, P, In<C>, typename Matrix::Scalar> from_tensor(Of<B>, About<P>, In<C>, const Matrix& tensor) {
  using J = Inertia<B, P, In<C>, typename Matrix::Scalar>;
  require_size(tensor, 3, 3, [] { return "inertia_from_tensor(" + InertiaName<J>::text() + "): "; });
  require_symmetric<J, typename Matrix::Scalar>("inertia_from_tensor", tensor);
  return checked_inertia<J, typename Matrix::Scalar>("inertia_from_tensor", tensor);
}
template <Frame B, Point P, Frame C, class S, class... Named>
  requires OffDiagonals<S, Named...> Inertia<B, P, In<C>, S> from_moments_and_products(
      Of<B>, About<P>, In<C>, const InertiaNumber<S>& Jxx, const InertiaNumber<S>& Jyy,
      const InertiaNumber<S>& Jzz, const Named&... products) {
    return checked_inertia<Inertia<B, P, In<C>, S>>(
        "inertia_from_moments_and_products",
        symmetric<S>(Jxx.value(), Jyy.value(), Jzz.value(), S(-1), products...));
  }
template <Frame B, Point P, Frame C, class S>
Inertia<B, P, In<C>, S> from_principal_moments(Of<B>, About<P>, In<C>, const InertiaNumber<S>& Jx,
                                               const InertiaNumber<S>& Jy, const InertiaNumber<S>& Jz) {
  Square<S> tensor = Square<S>::Zero();
  tensor(0, 0) = Jx.value(), tensor(1, 1) = Jy.value(), tensor(2, 2) = Jz.value();
  return checked_inertia<Inertia<B, P, In<C>, S>>("inertia_from_principal_moments", tensor);
}
// in<B>: of b, about its centre of mass, in its own axes
template <Frame B, class... Given>
auto from_tensor(In<B>, const Given&... given)
    -> decltype(from_tensor(of<B>, about<CentreOfMassOf<B>>, in<B>, given...)) {
  return from_tensor(of<B>, about<CentreOfMassOf<B>>, in<B>, given...);
}
template <Frame B, class... Given>
auto from_moments_and_products(In<B>, const Given&... given)
    -> decltype(from_moments_and_products(of<B>, about<CentreOfMassOf<B>>, in<B>, given...)) {
  return from_moments_and_products(of<B>, about<CentreOfMassOf<B>>, in<B>, given...);
}
template <Frame B, class... Given>
auto from_principal_moments(In<B>, const Given&... given)
    -> decltype(from_principal_moments(of<B>, about<CentreOfMassOf<B>>, in<B>, given...)) {
  return from_principal_moments(of<B>, about<CentreOfMassOf<B>>, in<B>, given...);
}

template <class... Given> using FromTensor = decltype(from_tensor(std::declval<const Given&>()...));
template <class... Given>
using FromProducts = decltype(from_moments_and_products(std::declval<const Given&>()...));
template <class... Given>
using FromPrincipalMoments = decltype(from_principal_moments(std::declval<const Given&>()...));
template <template <class...> class ResultOf, class... Given>
concept GivesInertia = requires {
  typename ResultOf<Given...>;
};

}  // namespace detail

/// From the entries of the tensor, with Jxy = - int x y dm, the number that stands in the matrix:
///     inertia_from_tensor(in<B>, Jxx, Jyy, Jzz, xy(Jxy), xz(Jxz), yz(Jyz)), the last three in any order
///     inertia_from_tensor(in<B>, M), a bare matrix in kg m^2
/// or with of<B>, about<P>, in<C> for in<B>. Throws BadInput if an entry is not finite, the matrix is not
/// symmetric, a principal moment is negative, or one exceeds the sum of the other two.
template <class... Given> detail::FromTensor<Given...> inertia_from_tensor(const Given&... given) {
  return detail::from_tensor(given...);
}
template <class... Given>
  requires(!detail::GivesInertia<detail::FromTensor, Given...>)
auto inertia_from_tensor(  // in<B> or of<B>, about<P>, in<C>; Jxx, Jyy, Jzz, xy(Jxy), xz(Jxz), yz(Jyz)
    const Given&...) -> Refused = delete;

/// From moments and products of inertia, Pxy = + int x y dm: the off-diagonal entries of the tensor are their
/// negatives. Named and in any order, xy(Pxy), yz(Pyz), zx(Pzx). Throws BadInput as inertia_from_tensor()
/// does.
template <class... Given>
detail::FromProducts<Given...> inertia_from_moments_and_products(const Given&... given) {
  return detail::from_moments_and_products(given...);
}
template <class... Given>
  requires(!detail::GivesInertia<detail::FromProducts, Given...>)
auto inertia_from_moments_and_products(  // in<B>, ...; Jxx, Jyy, Jzz, xy(Pxy), xz(Pxz), yz(Pyz)
    const Given&...) -> Refused = delete;

/// From the moments about the axes, where these are principal axes: inertia_from_principal_moments(in<B>, Jx,
/// Jy, Jz). Throws BadInput as inertia_from_tensor() does.
template <class... Given>
detail::FromPrincipalMoments<Given...> inertia_from_principal_moments(const Given&... given) {
  return detail::from_principal_moments(given...);
}
template <class... Given>
  requires(!detail::GivesInertia<detail::FromPrincipalMoments, Given...>)
auto inertia_from_principal_moments(  // in<B> or of<B>, about<P>, in<C>; Jx, Jy, Jz in kg m^2
    const Given&...) -> Refused = delete;

/// The trusted door: checks nothing. For a symmetric positive tensor that no rigid body has, such as the
/// effective tensor of a body with rotors, which may violate J1 + J2 >= J3.
template <Frame B, Point P, Frame C, class Derived>
auto trust_inertia(Of<B>, About<P>, In<C>, const Eigen::MatrixBase<Derived>& tensor) {
  return Inertia<B, P, In<C>, typename Derived::Scalar>{detail::trusted, tensor};
}
template <Frame B, class Derived> auto trust_inertia(In<B>, const Eigen::MatrixBase<Derived>& tensor) {
  return CentralInertia<B, typename Derived::Scalar>{detail::trusted, tensor};
}

// J_p^d = R_c^d J_p^c (R_c^d)^T
template <class D, class C, class B, class P, class S>
Inertia<B, P, In<D>, S> product(const Dcm<D, C, S>& R_d_from_c, const Inertia<B, P, In<C>, S>& J_p_c) {
  return Inertia<B, P, In<D>, S>{detail::trusted,
                                 R_d_from_c.matrix() * J_p_c.matrix() * R_d_from_c.matrix().transpose()};
}

// H_c = J_c w_ab, the angular momentum about the centre of mass c, relative to a.
template <class B, class A, class C, class S>
Vector<C, si::angular_momentum, S> product(const Inertia<B, CentreOfMassOf<B>, In<C>, S>& J_c,
                                           const AngularVelocity<A, B, In<C>, S>& w_ab_c) {
  return {detail::trusted, J_c.matrix() * w_ab_c.coordinates()};
}
// J_c alpha_ab: the torque that changes the rate, without the gyroscopic torque.
template <class B, class A, class C, class S>
Vector<C, si::torque, S> product(const Inertia<B, CentreOfMassOf<B>, In<C>, S>& J_c,
                                 const AngularAcceleration<A, B, In<C>, S>& alpha_ab_c) {
  return {detail::trusted, J_c.matrix() * alpha_ab_c.coordinates()};
}

/// T = 1/2 w . J w, the rotational energy relative to a.
template <class B, class A, class C, class S>
Quantity<si::energy, S> kinetic_energy(const Inertia<B, CentreOfMassOf<B>, In<C>, S>& J_c,
                                       const AngularVelocity<A, B, In<C>, S>& w_ab_c) {
  return dot(w_ab_c.vector(), J_c * w_ab_c) / S(2);
}
template <class InertiaOf, class InertiaAbout, class InertiaIn, class RateRelativeTo, class RateOf,
          class RateIn, class S>
  requires(!(std::is_same_v<InertiaOf, RateOf> && std::is_same_v<InertiaIn, RateIn> &&
             std::is_same_v<InertiaAbout, CentreOfMassOf<InertiaOf>>))
auto kinetic_energy(  // kinetic_energy(J_c, w_ab_c): one body b, about its centre of mass, in one frame
    const Inertia<InertiaOf, InertiaAbout, In<InertiaIn>, S>&,
    const AngularVelocity<RateRelativeTo, RateOf, In<RateIn>, S>&) -> Refused = delete;

/// [...] kg m^2 in Body; [...] kg m^2 of Body about Hinge in Camera
template <class B, class P, class C, class S>
std::ostream& print_framed(std::ostream& out, const Inertia<B, P, In<C>, S>& J_p_c) {
  detail::print_square(out, J_p_c.matrix()) << " kg m^2";
  if constexpr (!std::is_same_v<Inertia<B, P, In<C>, S>, CentralInertia<B, S>>) {
    out << " of " << frame_name<B>() << " about " << frame_name<P>();
  }
  return out << " in " << frame_name<C>();
}

namespace detail {

template <class B, class S> std::string no_inverse(const CentralInertia<B, S>& J_b) {
  std::ostringstream said;
  said << "Euler's equation needs the inverse of the inertia ";
  print_framed(said, J_b);
  said << "; a principal moment is zero within rounding, or out of the range of numbers";
  return said.str();
}

}  // namespace detail

template <Frame B, class S> void Inertia<B, CentreOfMassOf<B>, In<B>, S>::refuse_inverse() const {
  throw BadInput(detail::no_inverse(*this));
}

}  // namespace vectrix
