#include <vectrix/simbody/engine.hpp>

#include <Simbody.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <stdexcept>
#include <utility>

namespace vectrix::detail {
namespace {

using SimTK::Inertia;
using SimTK::Mat33;
using SimTK::MobilizedBody;
using SimTK::Quaternion;
using SimTK::Rotation;
using SimTK::SpatialVec;
using SimTK::SymMat33;
using SimTK::Transform;
using SimTK::UnitVec3;
using SimTK::Vec3;
using SimTK::Vec4;

constexpr double share_of_wheel = 0.05;
/// A wheel's angle, on which nothing depends, begins again at zero: else its rounding would be an error of
/// the step, and make the steps short.
constexpr double largest_wheel_angle = 1000.0;

Vec3 simbody(const std::array<double, 3>& v) {
  return {v[0], v[1], v[2]};
}
Vec3 three(const double* v) {
  return {v[0], v[1], v[2]};
}
Mat33 simbody(const std::array<double, 9>& m) {
  return {m[0], m[1], m[2], m[3], m[4], m[5], m[6], m[7], m[8]};
}
std::array<double, 3> plain(const Vec3& v) {
  return {v[0], v[1], v[2]};
}
void put(const Vec3& v, double* to) {
  for (int k = 0; k < 3; ++k) to[k] = v[k];
}
Rotation rotation(const Vec4& q) {
  return Rotation(Quaternion(q.normalize(), true));
}

/// Mass, centre and inertia about the centre of a body that lends mass to its wheels.
struct Carrier {
  double mass;
  Vec3 centre;
  Mat33 inertia;

  Mat33 lend(const Vec3& axis, double J) {
    const Mat33 along = axis * ~axis;
    const Mat33 disc = J * along + 0.5 * J * (Mat33(1.0) - along);
    inertia -= disc;
    return disc;
  }
  SimTK::Body::Rigid rigid() const {
    const Mat33 J = inertia + mass * (centre.normSqr() * Mat33(1.0) - centre * ~centre);
    return SimTK::Body::Rigid(SimTK::MassProperties(
        mass, centre, Inertia(SymMat33(J(0, 0), J(1, 0), J(1, 1), J(2, 0), J(2, 1), J(2, 2)))));
  }
};

constexpr int positions_of[]{1, 1, 2, 4, 7, 0};
constexpr int speeds_of[]{1, 1, 2, 3, 6, 0};

/// A body with the places of its numbers in a state of ours.
struct Hung {
  SimbodyJoint joint;
  MobilizedBody body;
  Rotation mount;
  int positions_at, speeds_at;

  bool turns_freely() const { return joint == SimbodyJoint::ball || joint == SimbodyJoint::free; }
  int speeds() const { return speeds_of[static_cast<int>(joint)]; }
};

Vec3 speeds(const MobilizedBody& body, const SimTK::State& s, int first) {
  return {body.getOneU(s, first), body.getOneU(s, first + 1), body.getOneU(s, first + 2)};
}
Vec3 accelerations(const MobilizedBody& body, const SimTK::State& s, int first) {
  return {body.getOneUDot(s, first), body.getOneUDot(s, first + 1), body.getOneUDot(s, first + 2)};
}
Rotation turned(const MobilizedBody& body, const SimTK::State& s) {
  return rotation(Vec4(body.getOneQ(s, 0), body.getOneQ(s, 1), body.getOneQ(s, 2), body.getOneQ(s, 3)));
}

}  // namespace

struct SimbodyEngine::System {
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter{system};
  SimTK::GeneralForceSubsystem forces{system};
  MobilizedBody::Free hub;
  std::vector<Hung> bodies;
  std::vector<MobilizedBody> wheels;
  bool hub_has_place;
  int wheels_at;

  SimbodyPair pair;
  double accuracy, T;
  Loads loads;
  SimbodyLoads acting;
  struct Locks {
    std::vector<char> joints, rotors;
    bool operator!=(const Locks& other) const { return joints != other.joints || rotors != other.rotors; }
  };
  Locks locks, asked_locks;  // those of the state that is realized, and of `asked`
  std::vector<double> y;
  double origin = 0.0, stop = 0.0, longest = 0.0;
  std::exception_ptr trouble;
  std::size_t evaluations = 0, failures_before = 0;

  SimTK::State fresh, asked;
  std::unique_ptr<SimTK::Integrator> integrator;

  MobilizedBody mobilized(int body) const {
    return body == 0 ? MobilizedBody(hub) : bodies[static_cast<std::size_t>(body) - 1].body;
  }
  void hang(const SimbodyCraft& craft);
  void write(SimTK::State& s, const double* numbers) const;
  void read(const SimTK::State& s, double* numbers) const;
  void read_rates(const SimTK::State& s, double* rates) const;
  Locks found_locks() const { return {acting.locked_joints, acting.locked_rotors}; }
  void lock(SimTK::State& s) const;
  void make_integrator(const SimTK::State& s);
  void turn_wheels_back();
  void require_no_trouble();
};

/// Gives Simbody what the loads find in its own state.
class SimbodyEngine::Acting : public SimTK::Force::Custom::Implementation {
 public:
  explicit Acting(System& system) : s_(system) {}

  // An exception is kept: Simbody would take it as a sign to try a shorter step.
  void calcForce(const SimTK::State& state, SimTK::Vector_<SpatialVec>& body_forces, SimTK::Vector_<Vec3>&,
                 SimTK::Vector& mobility_forces) const override {
    if (s_.trouble) return;
    ++s_.evaluations;
    try {
      s_.read(state, s_.y.data());
      s_.loads(s_.origin + s_.T * state.getTime(), s_.y.data(), s_.acting);
      if (s_.found_locks() != s_.locks)
        throw std::runtime_error("a load locks or frees a joint within a smooth segment");
      apply(state, body_forces, mobility_forces);
    } catch (...) {
      s_.trouble = std::current_exception();
    }
  }
  SimTK::Real calcPotentialEnergy(const SimTK::State&) const override { return 0.0; }

 private:
  void apply(const SimTK::State& state, SimTK::Vector_<SpatialVec>& body_forces,
             SimTK::Vector& mobility_forces) const {
    const double scale = s_.T * s_.T;
    const SimbodyLoads& acting = s_.acting;
    const Rotation& R_i_from_h = s_.hub.getBodyRotation(state);
    for (std::size_t b = 0; b <= s_.bodies.size(); ++b)
      s_.mobilized(static_cast<int>(b))
          .applyBodyForce(state,
                          SpatialVec(R_i_from_h * (scale * simbody(acting.torques[b])),
                                     R_i_from_h * (scale * simbody(acting.forces[b]))),
                          body_forces);
    if (s_.hub_has_place && acting.field_i != std::array<double, 3>{}) {
      const auto attract = [&](const MobilizedBody& body) {
        const Vec3 weight = scale * body.getBodyMass(state) * simbody(acting.field_i);
        body.applyForceToBodyPoint(state, body.getBodyMassCenterStation(state), weight, body_forces);
      };
      for (std::size_t b = 0; b <= s_.bodies.size(); ++b) attract(s_.mobilized(static_cast<int>(b)));
      for (const MobilizedBody& wheel : s_.wheels) attract(wheel);
    }
    const double* effort = acting.efforts.data();
    for (const Hung& hung : s_.bodies) {
      const auto push = [&](int first, const Vec3& efforts) {
        for (int k = 0; k < 3; ++k)
          hung.body.applyOneMobilityForce(state, first + k, scale * efforts[k], mobility_forces);
      };
      if (hung.turns_freely()) {
        push(0, turned(hung.body, state) * three(effort));
        if (hung.joint == SimbodyJoint::free) push(3, ~hung.mount * three(effort + 3));
      } else {
        for (int k = 0; k < hung.speeds(); ++k)
          hung.body.applyOneMobilityForce(state, k, scale * effort[k], mobility_forces);
      }
      effort += hung.speeds();
    }
    for (std::size_t i = 0; i < s_.wheels.size(); ++i)
      s_.wheels[i].applyOneMobilityForce(state, 0, scale * acting.motors[i], mobility_forces);
  }

  System& s_;
};

void SimbodyEngine::System::hang(const SimbodyCraft& craft) {
  std::vector<Carrier> carriers{{craft.mass, simbody(craft.centre_b), simbody(craft.inertia_c_b)}};
  for (const auto& b : craft.bodies)
    carriers.push_back({b.mass, simbody(b.centre_b), simbody(b.inertia_c_b)});
  std::vector<Carrier> discs;
  for (const auto& rotor : craft.rotors) {
    Carrier& carrier = carriers[static_cast<std::size_t>(rotor.body)];
    const double mass = share_of_wheel * carrier.mass;
    discs.push_back({mass, Vec3(0), carrier.lend(simbody(rotor.axis_b), rotor.inertia)});
    carrier.mass -= mass;
  }

  hub = MobilizedBody::Free(matter.Ground(), Transform(), carriers[0].rigid(), Transform());
  int at = hub_has_place ? 13 : 7;
  for (std::size_t i = 0; i < craft.bodies.size(); ++i) {
    const SimbodyBody& b = craft.bodies[i];
    MobilizedBody parent = mobilized(b.parent);
    const SimTK::Body::Rigid rigid = carriers[i + 1].rigid();
    const Rotation R0(simbody(b.R_p_from_b), true);
    const Vec3 p = simbody(b.r_pb_p);
    // A joint's own frame has an axis along the given one, in the body and, turned by R0, in the parent.
    const auto along = [&](const SimTK::CoordinateAxis& axis) {
      return Rotation(UnitVec3(simbody(b.axis_1_b)), axis);
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
      case SimbodyJoint::gimbal: {
        const Rotation F(UnitVec3(simbody(b.axis_1_b)), SimTK::XAxis, simbody(b.axis_2_b), SimTK::YAxis);
        body = MobilizedBody::Universal(parent, Transform(R0 * F, p), rigid, Transform(F));
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
    bodies.push_back({b.joint, body, R0, at, 0});
    at += positions_of[static_cast<int>(b.joint)];
  }
  for (Hung& hung : bodies) {
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
  y.resize(static_cast<std::size_t>(at) + wheels.size());
}

SimbodyEngine::SimbodyEngine(const SimbodyCraft& craft, SimbodyPair pair, double accuracy, double time_scale,
                             Loads loads)
    : system_(std::make_unique<System>()) {
  System& s = *system_;
  s.hub_has_place = craft.hub_has_place;
  s.pair = pair;
  s.accuracy = accuracy;
  s.T = time_scale;
  s.loads = std::move(loads);
  s.matter.setShowDefaultGeometry(false);
  s.hang(craft);
  SimTK::Force::Custom(s.forces, new Acting(s));
  s.fresh = s.system.realizeTopology();
  s.matter.setUseEulerAngles(s.fresh, false);
  s.system.realizeModel(s.fresh);
  s.asked = s.fresh;
  s.asked_locks = {std::vector<char>(s.bodies.size(), 0), std::vector<char>(s.wheels.size(), 0)};
}

SimbodyEngine::~SimbodyEngine() = default;

// Simbody has the speeds of Ball and Free in the parent's axes at zero; ours are in the body's, and of the
// origin in the parent's. Where a turning hub is, nothing depends on: it begins at rest at the origin.
void SimbodyEngine::System::write(SimTK::State& s, const double* numbers) const {
  const Vec4 q_h = Vec4(numbers[0], numbers[1], numbers[2], numbers[3]).normalize();
  const Vec3 w_i = rotation(q_h) * three(numbers + 4) * T;
  const Vec3 r = hub_has_place ? three(numbers + 7) : Vec3(0);
  const Vec3 v = hub_has_place ? three(numbers + 10) * T : Vec3(0);
  hub.setQ(s, SimTK::Vec7(q_h[0], q_h[1], q_h[2], q_h[3], r[0], r[1], r[2]));
  hub.setU(s, SimTK::Vec6(w_i[0], w_i[1], w_i[2], v[0], v[1], v[2]));
  for (const Hung& hung : bodies) {
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
}

void SimbodyEngine::System::read(const SimTK::State& s, double* numbers) const {
  for (int k = 0; k < 4; ++k) numbers[k] = hub.getOneQ(s, k);
  put(~turned(hub, s) * speeds(hub, s, 0) / T, numbers + 4);
  if (hub_has_place) {
    put(Vec3(hub.getOneQ(s, 4), hub.getOneQ(s, 5), hub.getOneQ(s, 6)), numbers + 7);
    put(speeds(hub, s, 3) / T, numbers + 10);
  }
  for (const Hung& hung : bodies) {
    double* q = numbers + hung.positions_at;
    double* u = numbers + hung.speeds_at;
    if (hung.turns_freely()) {
      for (int k = 0; k < 4; ++k) q[k] = hung.body.getOneQ(s, k);
      put(~turned(hung.body, s) * speeds(hung.body, s, 0) / T, u);
      if (hung.joint == SimbodyJoint::free) {
        const Vec3 moved(hung.body.getOneQ(s, 4), hung.body.getOneQ(s, 5), hung.body.getOneQ(s, 6));
        put(hung.mount * moved, q + 4);
        put(hung.mount * speeds(hung.body, s, 3) / T, u + 3);
      }
    } else {
      for (int k = 0; k < hung.speeds(); ++k) {
        q[k] = hung.body.getOneQ(s, k);
        u[k] = hung.body.getOneU(s, k) / T;
      }
    }
  }
  for (std::size_t i = 0; i < wheels.size(); ++i)
    numbers[static_cast<std::size_t>(wheels_at) + i] = wheels[i].getOneU(s, 0) / T;
}

// The axes of ours turn with the speed itself, which adds nothing to its derivative.
void SimbodyEngine::System::read_rates(const SimTK::State& s, double* rates) const {
  const double TT = T * T;
  for (int k = 0; k < 4; ++k) rates[k] = hub.getOneQDot(s, k) / T;
  put(~turned(hub, s) * accelerations(hub, s, 0) / TT, rates + 4);
  if (hub_has_place) {
    put(speeds(hub, s, 3) / T, rates + 7);
    put(accelerations(hub, s, 3) / TT, rates + 10);
  }
  for (const Hung& hung : bodies) {
    double* q = rates + hung.positions_at;
    double* u = rates + hung.speeds_at;
    if (hung.turns_freely()) {
      for (int k = 0; k < 4; ++k) q[k] = hung.body.getOneQDot(s, k) / T;
      put(~turned(hung.body, s) * accelerations(hung.body, s, 0) / TT, u);
      if (hung.joint == SimbodyJoint::free) {
        put(hung.mount * speeds(hung.body, s, 3) / T, q + 4);
        put(hung.mount * accelerations(hung.body, s, 3) / TT, u + 3);
      }
    } else {
      for (int k = 0; k < hung.speeds(); ++k) {
        q[k] = hung.body.getOneQDot(s, k) / T;
        u[k] = hung.body.getOneUDot(s, k) / TT;
      }
    }
  }
  for (std::size_t i = 0; i < wheels.size(); ++i)
    rates[static_cast<std::size_t>(wheels_at) + i] = wheels[i].getOneUDot(s, 0) / TT;
}

void SimbodyEngine::System::lock(SimTK::State& s) const {
  const auto set = [&](const MobilizedBody& body, bool locked) {
    if (locked)
      body.lock(s, SimTK::Motion::Acceleration);
    else
      body.unlock(s);
  };
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies[i].joint != SimbodyJoint::fixed) set(bodies[i].body, locks.joints[i] != 0);
  for (std::size_t i = 0; i < wheels.size(); ++i) set(wheels[i], locks.rotors[i] != 0);
}

void SimbodyEngine::System::turn_wheels_back() {
  bool turned_back = false;
  for (const MobilizedBody& wheel : wheels) {
    if (std::abs(wheel.getOneQ(integrator->getState(), 0)) < largest_wheel_angle) continue;
    wheel.setOneQ(integrator->updAdvancedState(), 0, 0.0);
    turned_back = true;
  }
  if (turned_back) integrator->reinitialize(SimTK::Stage::Position, false);
}

void SimbodyEngine::System::require_no_trouble() {
  if (trouble) std::rethrow_exception(std::exchange(trouble, nullptr));
}

void SimbodyEngine::rates(double t, const double* y, double* ydot) {
  System& s = *system_;
  s.loads(t, y, s.acting);
  s.locks = s.found_locks();
  if (s.locks != s.asked_locks) s.lock(s.asked);
  s.asked_locks = s.locks;
  s.write(s.asked, y);
  s.asked.setTime((t - s.origin) / s.T);
  s.system.realize(s.asked, SimTK::Stage::Acceleration);
  s.require_no_trouble();
  s.read_rates(s.asked, ydot);
}

std::vector<SimbodyEngine::Transmitted> SimbodyEngine::reactions() const {
  const System& s = *system_;
  SimTK::Vector_<SpatialVec> all;
  s.matter.calcMobilizerReactionForces(s.asked, all);
  std::vector<Transmitted> list;
  for (const Hung& hung : s.bodies) {
    const SpatialVec of = all[hung.body.getMobilizedBodyIndex()] / (s.T * s.T);
    list.push_back({plain(of[1]), plain(of[0])});
  }
  return list;
}

void SimbodyEngine::System::make_integrator(const SimTK::State& s) {
  if (integrator) failures_before += static_cast<std::size_t>(integrator->getNumErrorTestFailures());
  if (pair == SimbodyPair::merson)
    integrator = std::make_unique<SimTK::RungeKuttaMersonIntegrator>(system);
  else
    integrator = std::make_unique<SimTK::RungeKuttaFeldbergIntegrator>(system);
  integrator->setAccuracy(accuracy);
  integrator->setUseInfinityNorm(true);
  integrator->setProjectEveryStep(true);
  integrator->setReturnEveryInternalStep(true);
  if (std::isfinite(longest)) integrator->setMaximumStepSize(longest / T);
  integrator->initialize(s);
}

void SimbodyEngine::start(double t, const double* y, double stop, double longest) {
  System& s = *system_;
  SimTK::State first = s.fresh;
  s.loads(t, y, s.acting);
  s.locks = s.found_locks();
  s.lock(first);
  s.write(first, y);
  // Where a turning hub is, nothing depends on; so its error is none.
  const double far = s.hub_has_place ? std::max(1.0, three(y + 7).norm()) : 1e12;
  for (int k = 3; k < 6; ++k) first.updUWeights()[s.hub.getFirstUIndex(first) + k] = 1.0 / far;
  first.setTime(0.0);
  s.origin = t;
  s.stop = stop;
  s.longest = longest;
  s.make_integrator(first);
  s.system.realize(s.integrator->getState(), SimTK::Stage::Acceleration);
  s.require_no_trouble();
}

double SimbodyEngine::step() {
  System& s = *system_;
  const double end = (s.stop - s.origin) / s.T, before = s.integrator->getTime();
  while (!(s.integrator->getTime() > before)) {
    s.integrator->stepTo(end, end);
    s.require_no_trouble();
  }
  s.turn_wheels_back();
  s.system.realize(s.integrator->getState(), SimTK::Stage::Acceleration);
  s.require_no_trouble();
  const double now = s.integrator->getTime();
  if (now >= end) return s.stop;
  return std::min(s.origin + s.T * now, std::nextafter(s.stop, -std::numeric_limits<double>::infinity()));
}

void SimbodyEngine::state(double* y) const {
  system_->read(system_->integrator->getState(), y);
}
void SimbodyEngine::rate(double* ydot) const {
  system_->read_rates(system_->integrator->getState(), ydot);
}
std::size_t SimbodyEngine::evaluations() const {
  return system_->evaluations;
}
std::size_t SimbodyEngine::error_test_failures() const {
  const System& s = *system_;
  return s.failures_before +
         (s.integrator ? static_cast<std::size_t>(s.integrator->getNumErrorTestFailures()) : 0);
}

}  // namespace vectrix::detail
