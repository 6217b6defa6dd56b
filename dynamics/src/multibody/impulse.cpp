#include <algorithm>
#include <cstddef>
#include <vector>

#include <vectrix/dynamics/multibody/impulse.hpp>
#include <vectrix/dynamics/multibody/kinds.hpp>

namespace vectrix::multibody {

void stop(const Tree<double>& tree, const std::vector<InImpulse>& links, const std::vector<InImpulse>& rotors,
          double* y) {
  const TreeLayout& layout = tree.layout();
  const auto& numbers = tree.numbers();
  const auto modes_rate = layout.modes_begin() + layout.modes;
  const auto for_each_speed = [&](const auto& function) {
    for (std::size_t i = 4; i < 7; ++i) function(i);
    if (numbers.hub_motion == HubMotion::free)
      for (std::size_t i = 10; i < 13; ++i) function(i);
    for (std::size_t i = layout.speeds_begin(); i < layout.modes_begin(); ++i) function(i);
    for (std::size_t i = modes_rate; i < layout.size(); ++i) function(i);
  };
  std::vector<double> at_rest(y, y + layout.size()), change(layout.size());
  for_each_speed([&](std::size_t i) { at_rest[i] = 0.0; });

  Work<double> k = tree.work();
  tree.place(at_rest.data(), k);
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (links[i] == InImpulse::is_free) continue;
    k.held[i] = Hold::driven;
    if (links[i] == InImpulse::keeps_speed) continue;
    with_kind(numbers.links[i].joint.kind, [&](auto kind) {
      const std::size_t first = layout.speed_at[i];
      for (std::size_t n = first; n < first + std::size_t{kind.speeds}; ++n)
        k.given[n - layout.speeds_begin()] = -y[n];
    });
  }
  for (std::size_t i = 0; i < rotors.size(); ++i) {
    const Rotor<double>& rotor = numbers.rotors[i];
    k.held_rotors[i] = rotors[i] == InImpulse::is_free ? Hold::none : Hold::locked;
    if (rotors[i] != InImpulse::stops) continue;  // its body takes J_s O n
    const Column<double> momentum = rotor.axis * (rotor.inertia * y[layout.rotors_begin() + i]);
    tree.add_wrench(rotor.body, zero_column<double>(), tree.rotation(rotor.body, k) * momentum, k);
  }
  for (std::size_t i = 0; i < numbers.modes.size(); ++i) {  // the springs of the modes are efforts
    const double W = numbers.modes[i].frequency;
    k.modal[i] = W * (W * at_rest[layout.modes_begin() + i]);
  }
  tree.solve(at_rest.data(), change.data(), k);
  for_each_speed([&](std::size_t i) { y[i] += change[i]; });
  for (std::size_t i = 0; i < rotors.size(); ++i)
    if (rotors[i] == InImpulse::stops) y[layout.rotors_begin() + i] = 0.0;
}

std::vector<InImpulse> keeping(const std::vector<Hold>& held) {
  std::vector<InImpulse> in(held.size(), InImpulse::is_free);
  for (std::size_t i = 0; i < in.size(); ++i)
    if (held[i] != Hold::none) in[i] = InImpulse::keeps_speed;
  return in;
}

}  // namespace vectrix::multibody
