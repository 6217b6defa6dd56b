#include "torque_free.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace bench {

Attitudes reference(int steps_per_second) {
  using Real = long double;
  using State = Eigen::Matrix<Real, 7, 1>;  // w x y z of q_i_from_b, then w_ib_b
  const Eigen::Matrix<Real, 3, 1> J = moments.cast<Real>();
  const auto rate = [&](const State& y) -> State {
    const Real p = y(4), q = y(5), r = y(6);
    State d;
    d << (-y(1) * p - y(2) * q - y(3) * r) / 2, (y(0) * p + y(2) * r - y(3) * q) / 2,
        (y(0) * q + y(3) * p - y(1) * r) / 2, (y(0) * r + y(1) * q - y(2) * p) / 2,
        (J.y() - J.z()) * q * r / J.x(), (J.z() - J.x()) * r * p / J.y(), (J.x() - J.y()) * p * q / J.z();
    return d;
  };
  State y;
  y << 1, 0, 0, 0, start_rate.cast<Real>();
  const Real h = Real(1) / steps_per_second;
  Attitudes attitudes;
  double t = 0.0;
  for (const double sample : sample_times) {
    for (; t < sample; t += 1.0) {
      for (int i = 0; i < steps_per_second; ++i) {
        const State k1 = rate(y);
        const State k2 = rate(y + h / 2 * k1);
        const State k3 = rate(y + h / 2 * k2);
        const State k4 = rate(y + h * k3);
        y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      }
    }
    const Eigen::Matrix<Real, 4, 1> q = y.head<4>().normalized();
    attitudes.push_back(Eigen::Quaternion<Real>(q(0), q(1), q(2), q(3)).toRotationMatrix().cast<double>());
  }
  return attitudes;
}

double difference(const Attitudes& left, const Attitudes& right) {
  double largest = 0.0;
  for (std::size_t i = 0; i < right.size(); ++i) {
    // |L - R| (Frobenius) is 2 sqrt(2) sin(angle / 2).
    const double chord = std::min(1.0, (left.at(i) - right[i]).norm() / std::sqrt(8.0));
    largest = std::max(largest, 2.0 * std::asin(chord));
  }
  return largest;
}

}  // namespace bench
