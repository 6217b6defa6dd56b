#pragma once

#include <vector>
#include <vectrix/dynamics/mass/parallel_axes.hpp>

#include "draw.hpp"

/// Bodies of point masses, whose inertias are sums, and short forms of the doors. Shared by the tests of
/// inertias.
namespace vectrix::test {

struct Bus : moving_frame {};
struct Satellite : moving_frame {};
template <int I> struct Panel : moving_frame {};

/// A body of point masses, in some frame: the reference for the tests.
struct Masses {
  std::vector<double> m;
  std::vector<Vector3d> r;

  double total() const {
    double sum = 0.0;
    for (const double m_k : m) sum += m_k;
    return sum;
  }
  Vector3d centre() const {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t k = 0; k < m.size(); ++k) sum += m[k] * r[k];
    return sum / total();
  }
  /// The sum of m (|r|^2 I - r r^T), r from the point p.
  Matrix3d inertia_about(const Vector3d& p) const {
    Matrix3d J = Matrix3d::Zero();
    for (std::size_t k = 0; k < m.size(); ++k) {
      const Vector3d d = r[k] - p;
      J += m[k] * (d.dot(d) * Matrix3d::Identity() - d * d.transpose());
    }
    return J;
  }
  /// The same masses in other axes and from another origin: r^a = R r^b + r_ab^a.
  Masses placed(const Matrix3d& R, const Vector3d& origin) const {
    Masses other{m, {}};
    for (const Vector3d& r_k : r) other.r.emplace_back(R * r_k + origin);
    return other;
  }
  void add(const Masses& other) {
    m.insert(m.end(), other.m.begin(), other.m.end());
    r.insert(r.end(), other.r.begin(), other.r.end());
  }
};

inline Masses random_masses(Draw& draw) {
  const Vector3d somewhere = draw.triple();
  Masses body;
  for (int k = 0; k < 6; ++k) {
    body.m.push_back(1.5 + draw.number());
    body.r.emplace_back(somewhere + draw.triple());
  }
  return body;
}

/// J of the body B about P in C, through the checked door.
template <class B, class P, class C> Inertia<B, P, In<C>> inertia(const Matrix3d& J) {
  const auto unit = si::kilogram_square_metre;
  return inertia_from_tensor(of<B>, about<P>, in<C>, J(0, 0) * unit, J(1, 1) * unit, J(2, 2) * unit,
                             xy(J(0, 1) * unit), xz(J(0, 2) * unit), yz(J(1, 2) * unit));
}
inline Quantity<si::mass> kilograms(double m) {
  return m * si::kilogram;
}

}  // namespace vectrix::test
