#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vectrix/dynamics.hpp>
#include <vectrix/dynamics/multibody/any_scalar.hpp>
#include <vectrix/dynamics/multibody/converted.hpp>

/// The crafts that the integrators run. Each is ydot = f(y) on plain numbers, the same function for every
/// integrator, begins at `initial`, runs to `end`, and has rates() in any scalar S for its reference.
/// Besides, the parts of the scenario of the library with the same motion. q_i_from_hub, scalar first, then
/// w_ih_h, are the first numbers.
namespace bench {

using namespace vectrix;

template <std::size_t N> using Numbers = std::array<double, N>;

struct Inertial : inertial_frame {};
struct Hub : moving_frame {};
template <int> struct Panel : moving_frame {};

template <class B>
auto mass(double kilograms, const Eigen::Vector3d& centre, const Eigen::Vector3d& moments) {
  const auto kg_m2 = si::kilogram_square_metre;
  return mass_properties(
      kilograms * si::kilogram,
      displacement(of<CentreOfMassOf<B>>, relative_to<B>,
                   vector(in<B>, centre.x() * si::metre, centre.y() * si::metre, centre.z() * si::metre)),
      inertia_from_principal_moments(in<B>, moments.x() * kg_m2, moments.y() * kg_m2, moments.z() * kg_m2));
}

/// 2 q' = q (0, w)
template <class S> void turn(const S* y, S* ydot) {
  const S p = y[4], q = y[5], r = y[6];
  ydot[0] = S(0.5) * (-y[1] * p - y[2] * q - y[3] * r);
  ydot[1] = S(0.5) * (y[0] * p + y[2] * r - y[3] * q);
  ydot[2] = S(0.5) * (y[0] * q + y[3] * p - y[1] * r);
  ydot[3] = S(0.5) * (y[0] * r + y[1] * q - y[2] * p);
}

/// A torque about x of the hub, N m, that a controller changes.
struct Motor {
  const double* torque;
  template <class C, class S> void operator()(const Now<C, S>&, Forces<C, S>& forces) const {
    forces.torque(of<Hub>, *torque * si::newton_metre * unit_x(in<Hub>));
  }
};

/// P1: no torque, moments (1, 2, 3) kg m^2; about 4440 rad until the end.
struct FreeBody {
  static constexpr std::size_t size = 7;
  static constexpr double end = 1e5, rate_unit = 1.0, length_unit = 1.0, seconds = 1.0;
  static constexpr Numbers<size> initial{1.0, 0.0, 0.0, 0.0, 0.028, 0.024, 0.024};

  template <class S> void operator()(const S* y, S* ydot) const {
    turn(y, ydot);
    ydot[4] = -y[5] * y[6];
    ydot[5] = y[6] * y[4];
    ydot[6] = -y[4] * y[5] / S(3.0);
  }
  template <class S> auto rates() const { return *this; }
  static auto craft() {
    return spacecraft(body(mass<Hub>(1.0, {0.0, 0.0, 0.0}, {1.0, 2.0, 3.0}), turning_in<Inertial>));
  }
  static auto loads() { return std::tuple(); }
};
struct ControlledFreeBody : FreeBody {
  const double* torque;

  explicit ControlledFreeBody(const double* newton_metres) : torque(newton_metres) {}
  void operator()(const double* y, double* ydot) const {
    FreeBody::operator()(y, ydot);
    ydot[4] += *torque;
  }
};

/// A panel's moment of inertia about its hinge is 60 kg m^2.
template <int K> auto panel(double side) {
  using P = Panel<K>;
  const auto place = vector(in<Hub>, 0.1 * si::metre, 0.6 * side * si::metre, 0.0 * si::metre);
  return body(mass<P>(20.0, {0.0, 1.5 * side, 0.0}, {15.0, 1.5, 16.0}),
              hinge(Transform{turned_z(to<Hub>, from<P>, 0.1 * K * si::radian),
                              displacement(of<P>, relative_to<Hub>, place)},
                    unit_x(in<P>)));
}
inline auto hub_with_panels() {
  return spacecraft(body(mass<Hub>(400.0, {0.1, 0.05, -0.02}, {120.0, 100.0, 140.0}), free_in<Inertial>),
                    panel<1>(1.0), panel<2>(-1.0));
}
/// N m/rad, N m s/rad.
inline auto springs_and_dampers(double stiffness, double damping) {
  const auto craft = hub_with_panels();
  const auto k = stiffness * (si::newton_metre / si::radian);
  const auto c = damping * (si::newton_metre / (si::radian / si::second));
  const auto rest = 0.0 * si::radian;
  return std::tuple(spring(craft, of<Panel<1>>, k, rest), damper(craft, of<Panel<1>>, c),
                    spring(craft, of<Panel<2>>, k, rest), damper(craft, of<Panel<2>>, c));
}
template <class C, class... Loads> auto rates_of(const C& craft, const std::tuple<Loads...>& loads) {
  return detail::CraftRates<C, Loads...>(craft, loads);
}

/// P2: a hub and two panels on hinges with springs and dampers. The right-hand side is that of the typed
/// craft, and of its tree in another scalar.
template <class... More> class HubWithPanels {
 public:
  static constexpr std::size_t size = 17;
  static constexpr double rate_unit = 1.0, length_unit = 1.0, seconds = 1.0;
  static constexpr Numbers<size> initial{1.0, 0.0, 0.0, 0.0, 0.1, -0.2, 0.3};
  double end;

  HubWithPanels(double stiffness, double damping, double duration, const More&... more)
      : end(duration),
        stiffness_(stiffness),
        damping_(damping),
        rates_(with_loads(stiffness, damping, more...)) {}

  void operator()(const double* y, double* ydot) { rates_(0.0, y, ydot); }

  template <class S> auto rates() const {
    const multibody::Tree<S> tree(multibody::converted<S>(craft().core()->tree.numbers()));
    return [tree, work = tree.work(), k = S(stiffness_), c = S(damping_)](const S* y, S* ydot) mutable {
      tree.place(y, work);
      const auto& layout = tree.layout();
      for (std::size_t i = 0; i < layout.speeds; ++i)
        work.efforts[i] = -k * y[layout.hub + i] - c * y[layout.speeds_begin() + i];
      tree.solve(y, ydot, work);
    };
  }
  static auto craft() { return hub_with_panels(); }
  auto loads() const { return springs_and_dampers(stiffness_, damping_); }

 private:
  static auto with_loads(double stiffness, double damping, const More&... more) {
    return rates_of(hub_with_panels(),
                    std::tuple_cat(springs_and_dampers(stiffness, damping), std::tuple(more...)));
  }

  double stiffness_, damping_;
  decltype(with_loads(0.0, 0.0, std::declval<const More&>()...)) rates_;
};

/// P3: gravity gradient on an inclined eccentric orbit, moments (1, 2, 2.5), for 8 h. In units of the radius
/// of the perigee, 7000 km, and of the time in which the angle 1 rad is flown on a circle there: all numbers
/// are of the order of 1, so that one absolute tolerance serves them.
struct GravityGradient {
  static constexpr std::size_t size = 13;
  static constexpr double mu = 3.986004418e14, length_unit = 7e6;  // m^3/s^2, m
  static constexpr double rate_unit = 1.0780076e-3,
                          seconds = 1.0 / rate_unit;  // sqrt(mu/m^3), rad/s, rounded
  static constexpr double end = 28800.0 * rate_unit;
  static constexpr double gravity = mu / (length_unit * length_unit * length_unit * rate_unit * rate_unit);
  static constexpr Numbers<size> initial{1.0, 0.0, 0.0, 0.0, 2.0, 3.0, 1.5, 1.0, 0.0, 0.0, 0.0, 0.8, 0.65};

  template <class S> void operator()(const S* y, S* ydot) const {
    using std::sqrt;
    constexpr double Jx = 1.0, Jy = 2.0, Jz = 2.5;
    turn(y, ydot);
    const S x = y[7], yy = y[8], z = y[9];
    // r_b = r - s t + u x t, t = 2 u x r, q = (s, u)
    const S tx = 2.0 * (y[2] * z - y[3] * yy), ty = 2.0 * (y[3] * x - y[1] * z),
            tz = 2.0 * (y[1] * yy - y[2] * x);
    const S bx = x - y[0] * tx + (y[2] * tz - y[3] * ty), by = yy - y[0] * ty + (y[3] * tx - y[1] * tz),
            bz = z - y[0] * tz + (y[1] * ty - y[2] * tx);
    const S square = x * x + yy * yy + z * z, inverse_square = S(1.0) / square;
    const S pull = S(gravity) * inverse_square / sqrt(square), gradient = S(3.0) * pull * inverse_square;
    ydot[4] = S((Jz - Jy) / Jx) * (gradient * by * bz - y[5] * y[6]);
    ydot[5] = S((Jx - Jz) / Jy) * (gradient * bz * bx - y[6] * y[4]);
    ydot[6] = S((Jy - Jx) / Jz) * (gradient * bx * by - y[4] * y[5]);
    ydot[7] = y[10], ydot[8] = y[11], ydot[9] = y[12];
    ydot[10] = -pull * x, ydot[11] = -pull * yy, ydot[12] = -pull * z;
  }
  template <class S> auto rates() const { return *this; }
  static auto craft() {
    return spacecraft(body(mass<Hub>(300.0, {0.0, 0.0, 0.0}, {100.0, 200.0, 250.0}), free_in<Inertial>));
  }
  static auto loads() {
    return std::tuple(point_mass(craft(), Quantity<si::gravitational_parameter>::from_value(mu)));
  }
};

}  // namespace bench
