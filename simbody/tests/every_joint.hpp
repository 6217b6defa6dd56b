#pragma once

#include <vectrix/simbody.hpp>

#include "craft/random_spacecraft.hpp"

/// A craft with every kind of joint, of random numbers, in random motion, with loads of every kind and a
/// sampled controller.
namespace vectrix_test::every_joint {

using namespace vectrix_test::spacecraft_test;
using spacecraft_test::Camera;
using spacecraft_test::Gcrf;  // not those of the library

/// `Transposed`: the boom's joint has its frame transposed, the mistake that a comparison must see.
inline auto make_craft(RandomCraft& random, bool transposed = false) {
  return spacecraft_test::make_craft(random, [&](RandomCraft& draws) {
    auto X_h_from_boom = place<Hub, Boom>(draws);
    if (transposed)
      X_h_from_boom.rotation =
          dcm(to<Hub>, from<Boom>, Eigen::Matrix3d(X_h_from_boom.rotation.matrix().transpose()));
    return X_h_from_boom;
  });
}
struct Craft : decltype(make_craft(std::declval<RandomCraft&>())) {
  explicit Craft(RandomCraft random, bool transposed = false)
      : decltype(make_craft(random))(make_craft(random, transposed)) {}
};

inline constexpr auto start_time = 3.0 * s;
inline CraftState<Craft> start_of(const Craft& craft, RandomCraft& random) {
  return state(craft, start_time, moving<Gcrf, Hub>(random, 10.0),
               starts(of<Boom>, random.normal() * rad, random.normal() * rad_s),
               spins(of<WheelOfHub>, random.normal() * rad_s),
               starts(of<Antenna>, random.normal() * rad, random.normal() * rad_s, random.normal() * rad,
                      random.normal() * rad_s),
               starts(of<Mass>, random.normal() * m, random.normal() * m_s),
               starts(moving<Boom, Gyro>(random).turning), starts(moving<Box, Probe>(random)),
               deflects(of<Blanket>, std::array{0.1, -0.2}, std::array{0.3, 0.05}),
               deflects(of<Tank>, 0.02, 0.04), spins(of<WheelOfBoom>, random.normal() * rad_s));
}

struct Command {
  Quantity<si::torque> torque;
};
inline const auto loads = [](const Now<Craft>& now, Forces<Craft>& forces, const Command& command) {
  const auto q = now.coordinate(of<Antenna>);
  forces.effort(of<Boom>, 5.0 * (0.3 - now.coordinate(of<Boom>).value()) * N_m);
  forces.effort(of<Antenna>, -2.0 * q[0].value() * N_m, -3.0 * q[1].value() * N_m);
  forces.effort(of<Mass>, -20.0 * now.coordinate(of<Mass>).value() * N);
  forces.effort(of<Gyro>, vector(in<Antenna>, 0.1 * N_m, 0.2 * N_m, -0.3 * N_m));
  forces.effort(of<Probe>, vector(in<Hub>, 0.1 * N_m, 0.2 * N_m, -0.3 * N_m));
  forces.torque(of<Hub>, vector(in<Boom>, 0.5 * N_m, 0.2 * N_m, -0.4 * N_m));
  forces.force(of<Camera>, vector(in<Probe>, 0.5 * N, 0.2 * N, 0.3 * N));
  forces.force(of<Gyro>, vector(in<Gcrf>, 0.1 * N, -0.7 * N, 0.3 * N));
  forces.field(vector(in<Gcrf>, 0.1 * (m_s / s), 0.2 * (m_s / s), -0.3 * (m_s / s)));
  forces.modal(of<Blanket>, {0.05, -0.1});
  forces.motor(of<WheelOfHub>, command.torque);
  forces.motor(of<WheelOfBoom>, 0.02 * std::cos(now.time().value()) * N_m);
};
inline const auto controller = every(0.5 * s, [](const Now<Craft>& now, const Command&) {
  return Command{-0.1 * now.speed(of<Boom>).value() * N_m};
});
inline auto flight_of(const Craft& craft) {
  return scenario(craft, loads, held(Command{0.0 * N_m}), controller);
}

inline CraftPropagation exact_until(const Quantity<si::time>& end) {
  return {.end = end,
          .relative_tolerance = 1e-13,
          .absolute_tolerances = {1e-13 * rad, 1e-13 * rad_s, 1e-13 * m, 1e-13 * m_s, 1e-13}};
}

}  // namespace vectrix_test::every_joint
