#include "principal_axes.hpp"

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <utility>

namespace vectrix {
namespace {

// Twice the digits of the inputs, so that differences of products of inputs keep all digits of a double.
using Quad = boost::multiprecision::number<boost::multiprecision::cpp_bin_float_quad::backend_type,
                                           boost::multiprecision::et_off>;
using QuadVector = std::array<Quad, 3>;
using QuadMatrix = std::array<QuadVector, 3>;  // columns of the matrix
// Convergence is quadratic: after this number of sweeps the off-diagonal entries are zero.
constexpr int sweeps = 12;

struct Eigen3 {
  QuadVector values;
  QuadMatrix vectors;
};

// Jacobi's method: rotates about axis k until the tensor is diagonal. A diagonal tensor is not changed.
Eigen3 eigenvalues(const Eigen::Matrix3d& tensor) {
  QuadMatrix a;
  QuadMatrix v;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      a[i][j] = tensor(static_cast<Eigen::Index>(std::max(i, j)), static_cast<Eigen::Index>(std::min(i, j)));
      v[i][j] = i == j ? 1 : 0;
    }
  }
  const auto turn = [&](std::size_t p, std::size_t q) {
    if (a[p][q] == 0) return;
    const std::size_t k = 3 - p - q;
    const Quad half_cotangent = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    const Quad root = sqrt(Quad(half_cotangent * half_cotangent + 1));
    const Quad t = half_cotangent < 0 ? Quad(1 / (half_cotangent - root)) : Quad(1 / (half_cotangent + root));
    const Quad c = 1 / sqrt(Quad(t * t + 1));
    const Quad s = t * c;
    const Quad shift = t * a[p][q];
    a[p][p] -= shift;
    a[q][q] += shift;
    a[p][q] = a[q][p] = 0;
    const Quad kp = a[k][p];
    a[k][p] = a[p][k] = c * kp - s * a[k][q];
    a[k][q] = a[q][k] = s * kp + c * a[k][q];
    for (std::size_t i = 0; i < 3; ++i) {
      const Quad first = v[p][i];
      v[p][i] = c * first - s * v[q][i];
      v[q][i] = s * first + c * v[q][i];
    }
  };
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    turn(0, 1);
    turn(0, 2);
    turn(1, 2);
  }
  return {{a[0][0], a[1][1], a[2][2]}, v};
}

// Sorts in increasing order and keeps the vectors right-handed: an exchange changes the sign of one.
void sort(Eigen3& e) {
  const auto order = [&](std::size_t i, std::size_t j) {
    if (e.values[i] <= e.values[j]) return;
    std::swap(e.values[i], e.values[j]);
    std::swap(e.vectors[i], e.vectors[j]);
    for (Quad& x : e.vectors[i]) x = -x;
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
}

PrincipalBody::Vector rounded(const QuadVector& x) {
  return {static_cast<long double>(x[0]), static_cast<long double>(x[1]), static_cast<long double>(x[2])};
}

}  // namespace

PrincipalBody principal_body(const Eigen::Matrix3d& J_b, const Eigen::Vector3d& w_b) {
  Eigen3 e = eigenvalues(J_b);
  sort(e);
  const QuadVector& J = e.values;
  QuadVector w;
  QuadVector each;  // h_i w_i of the angular momentum h = J w
  Quad square = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    w[i] = e.vectors[i][0] * w_b.x() + e.vectors[i][1] * w_b.y() + e.vectors[i][2] * w_b.z();
    each[i] = J[i] * w[i] * w[i];
    square += J[i] * each[i];
  }
  const Quad J21 = J[1] - J[0];
  const Quad J32 = J[2] - J[1];
  const Quad J31 = J[2] - J[0];
  // H^2 - 2 T J_i = sum over j of (J_j - J_i) h_j w_j
  const Quad from_second = J32 * each[2] - J21 * each[0];

  PrincipalBody body;
  for (std::size_t i = 0; i < 3; ++i) body.axes.col(static_cast<Eigen::Index>(i)) = rounded(e.vectors[i]);
  body.moments = rounded(J);
  body.J21 = static_cast<long double>(J21);
  body.J32 = static_cast<long double>(J32);
  body.J31 = static_cast<long double>(J31);
  body.rate = rounded(w);
  body.momentum = static_cast<long double>(Quad(sqrt(square)));
  body.distance = rounded({J21 * each[1] + J31 * each[2], from_second < 0 ? Quad(-from_second) : from_second,
                           J31 * each[0] + J32 * each[1]});
  body.nearer_first = from_second < 0;
  body.steady = J32 * w[1] * w[2] == 0 && J31 * w[2] * w[0] == 0 && J21 * w[0] * w[1] == 0;
  return body;
}

}  // namespace vectrix
