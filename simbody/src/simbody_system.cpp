#include "simbody_system.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace vectrix::detail {
namespace {

constexpr double share_of_wheel = 0.05;

/// Mass, centre and inertia about the centre of a body that lends mass to its wheels.
struct Carrier {
  std::string name;
  double mass;
  Vec3 centre;
  Mat33 inertia;
  bool lends = false;

  Mat33 lend(const Vec3& axis, double J) {
    const Mat33 along = axis * ~axis;
    const Mat33 disc = J * along + 0.5 * J * (Mat33(1.0) - along);
    inertia -= disc;
    lends = true;
    return disc;
  }
  SimTK::Body::Rigid rigid() const {
    if (mass == 0.0) return SimTK::Body::Rigid(SimTK::MassProperties(0.0, Vec3(0), Inertia(0.0)));
    const Mat33 J = inertia + mass * (centre.normSqr() * Mat33(1.0) - centre * ~centre);
    try {
      return SimTK::Body::Rigid(SimTK::MassProperties(
          mass, centre, Inertia(SymMat33(J(0, 0), J(1, 0), J(1, 1), J(2, 0), J(2, 1), J(2, 2)))));
    } catch (const std::exception& error) {
      throw std::invalid_argument(name + (lends ? " less the discs of its rotors: " : ": ") + error.what());
    }
  }
};

}  // namespace

void SimbodyEngine::System::hang(const SimbodyCraft& craft) {
  std::vector<Carrier> carriers{
      {craft.name_of_hub, craft.mass, simbody(craft.centre_b), simbody(craft.inertia_c_b)}};
  for (const auto& b : craft.links)
    carriers.push_back({b.name, b.mass, simbody(b.centre_b), simbody(b.inertia_c_b)});
  std::vector<Carrier> discs;
  for (const auto& rotor : craft.rotors) {
    Carrier& carrier = carriers[static_cast<std::size_t>(rotor.body)];
    const double mass = share_of_wheel * carrier.mass;
    discs.push_back(
        {"the rotor of " + carrier.name, mass, Vec3(0), carrier.lend(simbody(rotor.axis_b), rotor.inertia)});
    carrier.mass -= mass;
  }

  hub = MobilizedBody::Free(matter.Ground(), Transform(), carriers[0].rigid(), Transform());
  int at = hub_has_place ? 13 : 7;
  for (std::size_t i = 0; i < craft.links.size(); ++i) {
    const SimbodyLink& b = craft.links[i];
    MobilizedBody parent = mobilized(b.parent);
    const SimTK::Body::Rigid rigid = carriers[i + 1].rigid();
    const Rotation R0(simbody(b.R_p_from_b), true);
    const Vec3 p = simbody(b.r_pb_p);
    // A joint's own frame has an axis along the given one, in the body and, turned by R0, in the parent.
    const auto along = [&](const SimTK::CoordinateAxis& axis) {
      return Rotation(UnitVec3(simbody(b.axis_b)), axis);
    };
    MobilizedBody body;
    switch (b.joint) {
      case SimbodyJoint::hinge: {
        const Rotation Z = along(SimTK::ZAxis);
        body = MobilizedBody::Pin(parent, Transform(R0 * Z, p), rigid, Transform(Z));
        break;
      }
      case SimbodyJoint::slider: {
        const Rotation X = along(SimTK::XAxis);
        body = MobilizedBody::Slider(parent, Transform(R0 * X, p), rigid, Transform(X));
        break;
      }
      case SimbodyJoint::ball:
        body = MobilizedBody::Ball(parent, Transform(R0, p), rigid, Transform());
        break;
      case SimbodyJoint::free:
        body = MobilizedBody::Free(parent, Transform(R0, p), rigid, Transform());
        break;
      case SimbodyJoint::fixed:
        body = MobilizedBody::Weld(parent, Transform(R0, p), rigid, Transform());
        break;
    }
    links.push_back({b.joint, body, R0, at, 0});
    at += positions_of[static_cast<int>(b.joint)];
  }
  for (Hung& hung : links) {
    hung.speeds_at = at;
    at += hung.speeds();
  }
  wheels_at = at;
  for (std::size_t i = 0; i < craft.rotors.size(); ++i) {
    MobilizedBody carrier = mobilized(craft.rotors[i].body);
    const Rotation Z(UnitVec3(simbody(craft.rotors[i].axis_b)), SimTK::ZAxis);
    const Vec3 centre = carriers[static_cast<std::size_t>(craft.rotors[i].body)].centre;
    wheels.push_back(MobilizedBody::Pin(carrier, Transform(Z, centre), discs[i].rigid(), Transform(Z)));
  }
  modes_at = at + static_cast<int>(wheels.size());
  const SimTK::Body::Rigid unit(SimTK::MassProperties(1.0, Vec3(0), Inertia(1.0)));
  for (const SimbodyMode& mode : craft.modes) {
    modes.push_back({MobilizedBody::Slider(matter.Ground(), Transform(), unit, Transform()), mode.body,
                     simbody(mode.rotation_b), simbody(mode.translation_b), mode.frequency,
                     mode.damping_ratio});
    if (std::find(flexible.begin(), flexible.end(), mode.body) == flexible.end())
      flexible.push_back(mode.body);
  }
  y.resize(static_cast<std::size_t>(modes_at) + 2 * modes.size());
  last = y;
}

// Simbody has the speeds of Ball and Free in the parent's axes at zero; ours are in the body's, and of the
// origin in the parent's. Where a turning hub is, nothing depends on: it begins at rest at the origin.
void SimbodyEngine::System::write(SimTK::State& s, const double* numbers) const {
  const Vec4 q_h = Vec4(numbers[0], numbers[1], numbers[2], numbers[3]).normalize();
  const Vec3 w_i = rotation(q_h) * three(numbers + 4) * T;
  const Vec3 r = hub_has_place ? three(numbers + 7) : Vec3(0);
  const Vec3 v = hub_has_place ? three(numbers + 10) * T : Vec3(0);
  hub.setQ(s, SimTK::Vec7(q_h[0], q_h[1], q_h[2], q_h[3], r[0], r[1], r[2]));
  hub.setU(s, SimTK::Vec6(w_i[0], w_i[1], w_i[2], v[0], v[1], v[2]));
  for (const Hung& hung : links) {
    const double* q = numbers + hung.positions_at;
    const double* u = numbers + hung.speeds_at;
    const auto set_speeds = [&](int first, const Vec3& speed) {
      for (int k = 0; k < 3; ++k) hung.body.setOneU(s, first + k, speed[k] * T);
    };
    if (hung.turns_freely()) {
      const Vec4 unit = Vec4(q[0], q[1], q[2], q[3]).normalize();
      for (int k = 0; k < 4; ++k) hung.body.setOneQ(s, k, unit[k]);
      set_speeds(0, rotation(unit) * three(u));
      if (hung.joint == SimbodyJoint::free) {
        const Vec3 moved = ~hung.mount * three(q + 4);
        for (int k = 0; k < 3; ++k) hung.body.setOneQ(s, 4 + k, moved[k]);
        set_speeds(3, ~hung.mount * three(u + 3));
      }
    } else {
      for (int k = 0; k < hung.speeds(); ++k) {
        hung.body.setOneQ(s, k, q[k]);
        hung.body.setOneU(s, k, u[k] * T);
      }
    }
  }
  for (std::size_t i = 0; i < wheels.size(); ++i)
    wheels[i].setOneU(s, 0, numbers[static_cast<std::size_t>(wheels_at) + i] * T);
  const double* eta = numbers + modes_at;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    modes[i].slider.setOneQ(s, 0, eta[i]);
    modes[i].slider.setOneU(s, 0, eta[modes.size() + i] * T);
  }
}

// Numbers of a body, q(body, k) and u(body, k), as those of a state of ours. Of rates too: our axes turn with
// the speed itself, which adds nothing to its derivative.
template <class Q, class U>
void SimbodyEngine::System::put_numbers(const SimTK::State& s, const Q& q, const U& u, double* to) const {
  const auto three_of = [](const auto& numbers, const MobilizedBody& body, int first) {
    return Vec3(numbers(body, first), numbers(body, first + 1), numbers(body, first + 2));
  };
  const auto put_turn = [&](const MobilizedBody& body, double* positions, double* speeds) {
    for (int k = 0; k < 4; ++k) positions[k] = q(body, k);
    put(~turned(body, s) * three_of(u, body, 0), speeds);
  };
  const auto put_place = [&](const MobilizedBody& body, const Rotation& mount, double* place,
                             double* velocity) {
    put(mount * three_of(q, body, 4), place);
    put(mount * three_of(u, body, 3), velocity);
  };
  put_turn(hub, to, to + 4);
  if (hub_has_place) put_place(hub, Rotation(), to + 7, to + 10);
  for (const Hung& hung : links) {
    double* positions = to + hung.positions_at;
    double* speeds = to + hung.speeds_at;
    if (hung.turns_freely()) {
      put_turn(hung.body, positions, speeds);
      if (hung.joint == SimbodyJoint::free) put_place(hung.body, hung.mount, positions + 4, speeds + 3);
    } else {
      for (int k = 0; k < hung.speeds(); ++k) {
        positions[k] = q(hung.body, k);
        speeds[k] = u(hung.body, k);
      }
    }
  }
  for (std::size_t i = 0; i < wheels.size(); ++i)
    to[static_cast<std::size_t>(wheels_at) + i] = u(wheels[i], 0);
  double* eta = to + modes_at;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    eta[i] = q(modes[i].slider, 0);
    eta[modes.size() + i] = u(modes[i].slider, 0);
  }
}

void SimbodyEngine::System::read(const SimTK::State& s, double* numbers) const {
  put_numbers(
      s, [&](const MobilizedBody& body, int k) { return body.getOneQ(s, k); },
      [&](const MobilizedBody& body, int k) { return body.getOneU(s, k) / T; }, numbers);
}

void SimbodyEngine::System::read_rates(const SimTK::State& s, double* rates) const {
  put_numbers(
      s, [&](const MobilizedBody& body, int k) { return body.getOneQDot(s, k) / T; },
      [&](const MobilizedBody& body, int k) { return body.getOneUDot(s, k) / (T * T); }, rates);
}

}  // namespace vectrix::detail
