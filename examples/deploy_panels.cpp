// Two wings of two panels each unfold: springs drive their four hinges, dampers slow them, and each hinge
// latches when it is straight. The wings are released one after the other, and the hub is thrown about.
//
//     hinge: M = -k (q - q_0) - c q',   q_0 beyond the latch, so that the spring still pushes there
//     latch: an impulse stops the hinge at q = 0; no place changes, but all speeds may
//     H of the whole is constant in the inertial frame, also through a latch
//     energy: T + sum k (q - q_0)^2/2 = E_0 - sum int c q'^2 dt - sum of J_q q'^2/2 at the latches
//
// J_q is the inertia that a hinge sees: an effort on it over the acceleration that it gives the hinge, while
// the rest of the craft is as free as it then is. Angles and rates to a table: deploy_panels <data>
// <table.csv>.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iostream>
#include <numbers>
#include <string>
#include <tuple>
#include <vectrix/dynamics.hpp>

namespace {

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Hub : moving_frame {};
template <int wing> struct Inner : moving_frame {};
template <int wing> struct Outer : moving_frame {};

constexpr auto m = si::metre;
constexpr auto s = si::second;
constexpr auto rad = si::radian;
constexpr auto rad_s = si::radian / si::second;
constexpr auto kg_m2 = si::kilogram_square_metre;
constexpr auto N_m = si::newton_metre;
constexpr double degrees = 180.0 / std::numbers::pi;

/// Wing 1 is along y of the hub when it is straight, wing 2 along -y. A panel has 12 kg and is 1.6 m long.
template <int wing> constexpr double side = wing == 1 ? 1.0 : -1.0;
template <Frame B> auto panel_mass(double to_side) {
  return mass_properties(
      12.0 * si::kilogram,
      displacement(of<CentreOfMassOf<B>>, relative_to<B>, vector(in<B>, 0.0 * m, to_side * 0.8 * m, 0.0 * m)),
      inertia_from_principal_moments(in<B>, 2.6 * kg_m2, 1.0 * kg_m2, 3.5 * kg_m2));
}
template <Frame P, Frame B> auto hinge_at(double y) {
  const auto r_pb_p = vector(in<P>, 0.0 * m, y * m, 0.0 * m);
  return hinge(Transform{aligned(to<P>, from<B>), displacement(of<B>, relative_to<P>, r_pb_p)},
               unit_x(in<B>));
}
template <int wing> auto inner() {
  return body(panel_mass<Inner<wing>>(side<wing>), hinge_at<Hub, Inner<wing>>(side<wing> * 0.7));
}
template <int wing> auto outer() {
  return body(panel_mass<Outer<wing>>(side<wing>), hinge_at<Inner<wing>, Outer<wing>>(side<wing> * 1.6));
}
auto make_sat() {
  return spacecraft(
      body(mass_properties(250.0 * si::kilogram,
                           coincident(of<CentreOfMassOf<Hub>>, relative_to<Hub>, in<Hub>),
                           inertia_from_principal_moments(in<Hub>, 60.0 * kg_m2, 55.0 * kg_m2, 70.0 * kg_m2)),
           turning_in<Gcrf>),
      inner<1>(), outer<1>(), inner<2>(), outer<2>());
}
struct Sat : decltype(make_sat()) {
  Sat() : decltype(make_sat())(make_sat()) {}
};

/// Stowed, the inner panel stands along z on the side of the hub, and the outer one is folded back on it.
template <class B> constexpr double stowed = 0.0;
template <int wing> constexpr double stowed<Inner<wing>> = side<wing> * 0.5 * std::numbers::pi;
template <int wing> constexpr double stowed<Outer<wing>> = -side<wing>* std::numbers::pi;
/// The springs of the inner hinges are stronger than those of the outer ones.
template <class B> constexpr double k = 0.6;
template <int wing> constexpr double k<Outer<wing>> = 0.25;
template <class B> constexpr double c = 0.8;
template <int wing> constexpr double c<Outer<wing>> = 0.3;
template <class B> constexpr double q_0 = -0.2 * stowed<B>;

template <class B> double angle(const CraftState<Sat>& state) {
  return state.coordinate(of<B>).value();
}
template <class B> double rate(const CraftState<Sat>& state) {
  return state.speed(of<B>).value();
}
template <class B> auto released_at(double time) {
  return at_times({time * s}, becomes(Locked<B>{false}));
}
/// What is on one hinge: locked until it is released, and again from where it is straight on.
template <class B> auto hinge_parts(const Sat& sat, const std::string& name) {
  const auto straight = [](const Now<Sat>& now) { return now.coordinate(of<B>); };
  return std::tuple{spring(sat, of<B>, k<B> * N_m / rad, q_0<B> * rad),
                    damper(sat, of<B>, c<B> * (N_m / rad_s)), lockable(sat, of<B>, Locked<B>{true}),
                    when(name, straight, stowed<B> > 0.0 ? ode::Direction::falling : ode::Direction::rising,
                         becomes(Locked<B>{true}))};
}
auto deployment(const Sat& sat) {
  return std::apply(
      [&](const auto&... parts) {
        return scenario(sat, parts..., released_at<Inner<1>>(2.0), released_at<Outer<1>>(2.0),
                        released_at<Inner<2>>(8.0), released_at<Outer<2>>(8.0));
      },
      std::tuple_cat(hinge_parts<Inner<1>>(sat, "inner 1"), hinge_parts<Outer<1>>(sat, "outer 1"),
                     hinge_parts<Inner<2>>(sat, "inner 2"), hinge_parts<Outer<2>>(sat, "outer 2")));
}

/// The function for each of the four hinges; the sum.
template <class Function> double sum_over_hinges(const Function& f) {
  return f(of<Inner<1>>) + f(of<Outer<1>>) + f(of<Inner<2>>) + f(of<Outer<2>>);
}
double kinetic(const Sat& sat, const CraftState<Sat>& state) {
  return motion(sat, state).energy().value();
}
double energy(const Sat& sat, const CraftState<Sat>& state) {
  return kinetic(sat, state) + sum_over_hinges([&]<class B>(Of<B>) {
           const double beyond = angle<B>(state) - q_0<B>;
           return 0.5 * k<B> * beyond * beyond;
         });
}

template <class Flight> struct Inertia {
  const Sat& sat;
  const Flight& flight;
  /// J_q of the hinge of b before a time, other hinges locked as they then are.
  template <class B> double of_hinge(Of<B>, const CraftState<Sat>& before) const {
    const auto rate_under = [&](double effort) {
      return motion(sat, before,
                    [&](const Now<Sat>&, Forces<Sat>& forces) {
                      sum_over_hinges([&]<class Other>(Of<Other>) {
                        if (!std::is_same_v<B, Other> &&
                            flight.template held<Locked<Other>>(before.time()).locked)
                          forces.lock(of<Other>);
                        return 0.0;
                      });
                      forces.effort(of<B>, effort * N_m);
                    })
          .rates()[Sat::shape::template speed_at<B>];
    };
    return 1.0 / (rate_under(1.0) - rate_under(0.0));
  }
};

void run(const std::string& path) {
  const Sat sat;
  const auto start =
      state(sat, 0.0 * s,
            moving_dcm(aligned(to<Gcrf>, from<Hub>),
                       angular_velocity(of<Hub>, relative_to<Gcrf>,
                                        vector(in<Hub>, 0.002 * rad_s, 0.01 * rad_s, 0.02 * rad_s))),
            starts(of<Inner<1>>, stowed<Inner<1>> * rad, 0.0 * rad_s),
            starts(of<Outer<1>>, stowed<Outer<1>> * rad, 0.0 * rad_s),
            starts(of<Inner<2>>, stowed<Inner<2>> * rad, 0.0 * rad_s),
            starts(of<Outer<2>>, stowed<Outer<2>> * rad, 0.0 * rad_s));
  constexpr double end = 60.0;
  const auto flight = propagate(deployment(sat), start,
                                {.end = end * s,
                                 .relative_tolerance = 1e-12,
                                 .absolute_tolerances = {.angle = 1e-13 * rad,
                                                         .rate = 1e-13 * rad_s,
                                                         .length = 1e-12 * m,
                                                         .velocity = 1e-12 * (m / s),
                                                         .mode = 1e-12}});

  std::ofstream table(path);
  table << "t_s,inner1_deg,outer1_deg,inner2_deg,outer2_deg,wx_deg_s,wy_deg_s,wz_deg_s\n";
  std::printf("   t [s]   inner 1   outer 1   inner 2   outer 2 [deg]   hub about x, y, z [deg/s]\n");
  for (int i = 0; i <= 600; ++i) {
    const double t = end * i / 600.0;
    const auto now = flight.at(t * s);
    const Eigen::Vector3d w = degrees * now.turning().angular_velocity.coordinates();
    const std::array angles{degrees * angle<Inner<1>>(now), degrees * angle<Outer<1>>(now),
                            degrees * angle<Inner<2>>(now), degrees * angle<Outer<2>>(now)};
    table << t;
    for (const double q : angles) table << ',' << q;
    table << ',' << w.x() << ',' << w.y() << ',' << w.z() << '\n';
    if (i % 60 != 0) continue;
    std::printf("%8.0f", t);
    for (const double q : angles) std::printf(" %9.2f", std::round(100.0 * q) / 100.0 + 0.0);
    std::printf(" %14.3f %8.3f %8.3f\n", w.x(), w.y(), w.z());
  }

  std::printf("\n latches   t [s]   at [deg/s]   impulse [N m s]   lost [J]   J_q q'^2/2 [J]\n");
  double by_latches = 0.0;
  for (const auto& event : flight.events()) {
    const auto& before = event.state;
    const double lost = kinetic(sat, before) - kinetic(sat, flight.at(before.time()));
    by_latches += lost;
    sum_over_hinges([&]<class B>(Of<B> hinge) {
      // Of the four, the one that moved and moves no longer.
      if (rate<B>(before) == 0.0 || rate<B>(flight.at(before.time())) != 0.0) return 0.0;
      const double J_q = Inertia<decltype(flight)>{sat, flight}.of_hinge(hinge, before), u = rate<B>(before);
      std::printf("%8s %7.3f %12.3f %17.4f %10.6f %16.6f\n", event.name.c_str(), before.time().value(),
                  degrees * u, -J_q * u, lost, 0.5 * J_q * u * u);
      return 0.0;
    });
  }
  // Simpson between instants that no latch lies between; what dampers take.
  double by_dampers = 0.0, largest_change = 0.0;
  std::vector<double> ends{2.0, 8.0};
  for (const auto& event : flight.events()) ends.push_back(event.state.time().value());
  ends.push_back(end);
  std::sort(ends.begin(), ends.end());
  const Eigen::Vector3d H_0 = motion(sat, start).angular_momentum().coordinates();
  double from = 0.0;
  for (const double to : ends) {
    constexpr int parts = 400;
    for (int i = 0; i <= parts; ++i) {
      const double t = i == parts ? std::nextafter(to, from) : from + (to - from) * i / parts;
      const auto now = flight.at(t * s);
      const double weight = (i == 0 || i == parts ? 1.0 : i % 2 == 1 ? 4.0 : 2.0) * (to - from) / parts / 3.0;
      by_dampers +=
          weight * sum_over_hinges([&]<class B>(Of<B>) { return c<B> * std::pow(rate<B>(now), 2); });
      const Eigen::Vector3d H = motion(sat, now).angular_momentum().coordinates();
      largest_change = std::max(largest_change, (H - H_0).norm());
    }
    from = to;
  }
  const double before = energy(sat, start), after = energy(sat, flight.at(end * s));
  std::printf("\nenergy: %.6f J at the start, %.6f J at the end, dampers took %.6f J, latches %.6f J\n",
              before, after, by_dampers, by_latches);
  std::printf("not accounted for: %s 1e-8 J\n",
              std::abs(before - after - by_dampers - by_latches) < 1e-8 ? "less than" : "more than");
  std::printf("angular momentum %.6f N m s, changed by %s 1e-11 of it\n", H_0.norm(),
              largest_change < 1e-11 * H_0.norm() ? "less than" : "more than");
}

}  // namespace

int main(int count, char** arguments) try {
  run(count > 2 ? arguments[2] : "/dev/null");
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 1;
}
