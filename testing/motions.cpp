#include "testing/motions.hpp"

namespace vectrix_test {

using namespace vectrix;

MotionNumbers::MotionNumbers(const Eigen::Matrix<Dual2, 3, 3>& R_a_from_b)
    : R(R_a_from_b.unaryExpr([](const Dual2& x) { return value(x); })),
      Rdot(R_a_from_b.unaryExpr([](const Dual2& x) { return first(x); })),
      Rddot(R_a_from_b.unaryExpr([](const Dual2& x) { return second(x); })) {}

Eigen::Vector3d MotionNumbers::w_a() const {
  return vee(Rdot * R.transpose());
}
Eigen::Vector3d MotionNumbers::alpha_a() const {
  return vee(Rddot * R.transpose() + Rdot * Rdot.transpose());
}

Eigen::Matrix<Dual2, 3, 3> turning_matrix(double seed, const Dual2& t) {
  using std::sin;
  const auto angle = [](const Dual2& radians) { return Quantity<si::angle, Dual2>::from_value(radians); };
  const Dual2 k = constant(seed);
  const Dual2 a1 = k + t * k + t * t;
  const Dual2 a2 = k * k - t * t * k;
  const Dual2 a3 = sin(Dual2(t + k));
  return (turned_z(to<Gcrf>, from<Ground>, angle(a1)) * turned_x(to<Ground>, from<Itrf>, angle(a2)) *
          turned_y(to<Itrf>, from<Body>, angle(a3)))
      .matrix();
}

}  // namespace vectrix_test
