#include <vectrix/simbody/engine.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include "simbody_system.hpp"

namespace vectrix::detail {
namespace {

/// A wheel's angle, on which nothing depends, begins again at zero: else its rounding would be an error of
/// the step, and make the steps short.
constexpr double largest_wheel_angle = 1000.0;

}  // namespace

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
      apply(state, body_forces, mobility_forces);
      s_.give(state, body_forces, mobility_forces);
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
    for (std::size_t b = 0; b <= s_.links.size(); ++b)
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
      for (std::size_t b = 0; b <= s_.links.size(); ++b) attract(s_.mobilized(static_cast<int>(b)));
      for (const MobilizedBody& wheel : s_.wheels) attract(wheel);
    }
    const double* effort = acting.efforts.data();
    for (const Hung& hung : s_.links) {
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
  s.asked_locks = s.no_locks();
}

SimbodyEngine::~SimbodyEngine() = default;

void SimbodyEngine::System::lock(SimTK::State& s) const {
  const auto set = [&](const MobilizedBody& body, bool locked) {
    if (locked)
      body.lock(s, SimTK::Motion::Acceleration);
    else
      body.unlock(s);
  };
  for (std::size_t i = 0; i < links.size(); ++i)
    if (links[i].joint != SimbodyJoint::fixed) set(links[i].body, locks.links[i] != 0);
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
  struct Restored {
    System::Locks& locks;
    System::Locks of_integrator;
    ~Restored() { locks = std::move(of_integrator); }
  } restored{s.locks, s.locks};
  const auto realize = [&](System::Locks with) {
    s.locks = std::move(with);
    if (s.locks != s.asked_locks) s.lock(s.asked);
    s.asked_locks = s.locks;
    s.write(s.asked, y);
    s.asked.setTime((t - s.origin) / s.T);
    s.system.realize(s.asked, SimTK::Stage::Acceleration);
    s.require_no_trouble();
  };
  s.loads(t, y, s.acting);
  try {
    realize(s.found_locks());
  } catch (const Freed&) {
    realize(s.no_locks());
  }
  s.read_rates(s.asked, ydot);
}

std::vector<SimbodyEngine::Transmitted> SimbodyEngine::reactions() const {
  const System& s = *system_;
  SimTK::Vector_<SpatialVec> all;
  s.matter.calcMobilizerReactionForces(s.asked, all);
  std::vector<Transmitted> list;
  for (const Hung& hung : s.links) {
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

/// From the time origin + T elapsed on, with the locks that are set; without any if one is freed there.
void SimbodyEngine::System::integrate_from(double elapsed, const double* numbers) try {
  SimTK::State first = fresh;
  lock(first);
  write(first, numbers);
  // Where a turning hub is, nothing depends on; so its error is none.
  const double far = hub_has_place ? std::max(1.0, three(numbers + 7).norm()) : 1e12;
  for (int k = 3; k < 6; ++k) first.updUWeights()[hub.getFirstUIndex(first) + k] = 1.0 / far;
  first.setTime(elapsed);
  make_integrator(first);
  system.realize(integrator->getState(), SimTK::Stage::Acceleration);
  require_no_trouble();
} catch (const Freed&) {
  locks = no_locks();
  integrate_from(elapsed, numbers);
}

void SimbodyEngine::start(double t, const double* y, double stop, double longest) {
  System& s = *system_;
  s.loads(t, y, s.acting);
  s.locks = s.found_locks();
  s.origin = t;
  s.stop = stop;
  s.longest = longest;
  s.integrate_from(0.0, y);
}

double SimbodyEngine::step() {
  System& s = *system_;
  const double end = (s.stop - s.origin) / s.T, before = s.integrator->getTime();
  s.read(s.integrator->getState(), s.last.data());
  const auto advance = [&] {
    while (!(s.integrator->getTime() > before)) {
      s.integrator->stepTo(end, end);
      s.require_no_trouble();
    }
    s.turn_wheels_back();
    s.system.realize(s.integrator->getState(), SimTK::Stage::Acceleration);
    s.require_no_trouble();
  };
  try {
    advance();
  } catch (const Freed&) {
    s.locks = s.no_locks();
    s.integrate_from(before, s.last.data());
    advance();
  }
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
