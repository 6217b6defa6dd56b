// Torque-free rotation about the intermediate axis: the flips, and the exact solution beside the integrated
// one.
//
//     J dw/dt = -w x (J w),   d/dt q_b^i = 1/2 q_b^i (0, w_ib^b)
//
// With J1 < J2 < J3 and the spin about axis 2 disturbed, H^2 < 2 T J2 or H^2 > 2 T J2 decides which axis the
// body tumbles around. The exact rate is Jacobi's (Landau and Lifshitz, Mechanics, section 37); here for H^2
// > 2 T J2:
//
//     w1 = a1 cn(u),  w2 = a2 sn(u),  w3 = a3 dn(u),   u = rho t + u0
//     a1^2 = (2 T J3 - H^2) / (J1 (J3 - J1)),  a2^2 = (2 T J3 - H^2) / (J2 (J3 - J2)),  a3^2 = (H^2 - 2 T J1)
//     / (J3 (J3 - J1)) rho^2 = (J3 - J2) (H^2 - 2 T J1) / (J1 J2 J3),   k^2 = (J2 - J1) (2 T J3 - H^2) / ((J3
//     - J2) (H^2 - 2 T J1))
//
// The body flips, w2 = 0, each 2 K(k) / rho seconds.

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <cstdio>
#include <exception>
#include <iostream>
#include <vectrix/dynamics.hpp>

namespace {

using namespace vectrix;

struct Inertial : inertial_frame {};
struct Body : moving_frame {};

constexpr auto kg_m2 = si::kilogram_square_metre;
const Eigen::Vector3d J(1.0, 2.0, 3.0);

// Jacobi's solution through the state in which w1 = 0, w2 > 0 and w3 > 0 at t = 0: u0 = K(k).
class Exact {
 public:
  explicit Exact(const Eigen::Vector3d& w) {
    const double twice_energy = w.dot(J.cwiseProduct(w));
    const double momentum_squared = J.cwiseProduct(w).squaredNorm();
    const double near3 = twice_energy * J.z() - momentum_squared;
    const double near1 = momentum_squared - twice_energy * J.x();
    amplitude_ << std::sqrt(near3 / (J.x() * (J.z() - J.x()))), std::sqrt(near3 / (J.y() * (J.z() - J.y()))),
        std::sqrt(near1 / (J.z() * (J.z() - J.x())));
    rho_ = std::sqrt((J.z() - J.y()) * near1 / (J.x() * J.y() * J.z()));
    k_ = std::sqrt((J.y() - J.x()) * near3 / ((J.z() - J.y()) * near1));
    quarter_ = boost::math::ellint_1(k_);
  }

  Eigen::Vector3d rate(double t) const {
    double cn = 0.0;
    const double sn =
        boost::math::jacobi_elliptic(k_, rho_ * t + quarter_, &cn, static_cast<double*>(nullptr));
    const double dn =
        std::sqrt(1.0 - k_ * k_ * sn * sn);  // Boost's own loses its digits where cn passes zero
    return {amplitude_.x() * cn, amplitude_.y() * sn, amplitude_.z() * dn};
  }
  double flip_interval() const { return 2.0 * quarter_ / rho_; }
  double first_flip() const { return quarter_ / rho_; }

 private:
  Eigen::Vector3d amplitude_;
  double rho_;
  double k_;
  double quarter_;
};

void run() {
  const Eigen::Vector3d w0(0.0, 1.0, 1e-2);
  const Scenario<Inertial, Body> scenario{
      .inertia = inertia_from_tensor(in<Body>, J.x() * kg_m2, J.y() * kg_m2, J.z() * kg_m2, 0.0 * kg_m2,
                                     0.0 * kg_m2, 0.0 * kg_m2),
      .initial = {.time = 0.0 * si::second,
                  .q_i_from_b = quaternion_scalar_first(to<Inertial>, from<Body>, 1.0, 0.0, 0.0, 0.0),
                  .w_ib_b = angular_velocity(of<Body>, relative_to<Inertial>,
                                             vector<si::angular_velocity>(in<Body>, w0))}};
  const Exact exact(w0);

  Propagation<Inertial, Body> how{.end = 120.0 * si::second};
  how.tolerances.relative = 1e-14;
  how.tolerances.attitude = 1e-14;
  how.roots = {{.name = "flip", .function = [](const State<Inertial, Body>& state) {
                  return state.w_ib_b.vector().y().value();
                }}};
  const auto trajectory = propagate(scenario, how);

  std::printf(
      "Torque-free tumble, J = (1, 2, 3) kg m^2, spin of 1 rad/s about axis 2, disturbed by 1e-2 rad/s\n\n");
  std::printf("%8s %11s %11s %11s %14s\n", "t [s]", "w1 [rad/s]", "w2 [rad/s]", "w3 [rad/s]",
              "body y to i y");
  for (int t = 0; t <= 120; t += 6) {
    const auto state = trajectory.at(static_cast<double>(t) * si::second);
    const Eigen::Vector3d w = state.w_ib_b.coordinates();
    const double cosine = dot(state.R_i_from_b() * unit_y(in<Body>), unit_y(in<Inertial>)).value();
    std::printf("%8d %11.6f %11.6f %11.6f %10.2f deg\n", t, w.x(), w.y(), w.z(),
                std::acos(cosine) * 180.0 / M_PI);
  }

  std::printf("\n%6s %20s %20s %12s\n", "flip", "found at [s]", "exact [s]", "difference");
  const auto events = trajectory.events();
  for (std::size_t i = 0; i < events.size(); ++i) {
    const double found = events[i].state.time.value();
    const double expected = exact.first_flip() + static_cast<double>(i) * exact.flip_interval();
    std::printf("%6zu %20.10f %20.10f %12s\n", i + 1, found, expected,
                std::abs(found - expected) < 1e-9 ? "< 1e-9 s" : "LARGE");
  }

  double worst = 0.0;
  for (std::size_t i = 0; i < trajectory.node_count(); ++i) {
    const auto state = trajectory.node(i);
    worst = std::max(worst, (state.w_ib_b.coordinates() - exact.rate(state.time.value())).norm());
  }
  const Conservation kept = conservation(scenario, trajectory);
  const auto below = [](double value, double bound) { return value < bound ? "below" : "ABOVE"; };
  std::printf("\nRate against the exact solution, all steps: %s 1e-9 rad/s\n", below(worst, 1e-9));
  std::printf("Energy and angular momentum kept to: %s 1e-12\n",
              below(std::max(*kept.rotational_energy, *kept.angular_momentum), 1e-12));
}

}  // namespace

int main() try { run(); } catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
