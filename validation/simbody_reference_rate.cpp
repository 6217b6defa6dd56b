#include "simbody_reference_rate.hpp"

#include <Simbody.h>

namespace vectrix::validation {

struct SimbodyRate::System {
  SimTK::MultibodySystem system;
  SimTK::SimbodyMatterSubsystem matter{system};
  SimTK::State state;
};

SimbodyRate::SimbodyRate() : system_(std::make_unique<System>()) {
  auto& [system, matter, state] = *system_;
  matter.setShowDefaultGeometry(false);
  const SimTK::Body::Rigid rigid(
      SimTK::MassProperties(1.0, SimTK::Vec3(0), SimTK::Inertia(SimTK::Vec3(1.0, 2.0, 3.0))));
  const SimTK::MobilizedBody::Ball ball(matter.Ground(), rigid);
  state = system.realizeTopology();
  matter.setUseEulerAngles(state, false);
  system.realizeModel(state);
}

SimbodyRate::~SimbodyRate() = default;

void SimbodyRate::evaluate(const std::array<double, 4>& q, const std::array<double, 3>& w) {
  SimTK::State& state = system_->state;
  SimTK::Vector& positions = state.updQ();
  for (int i = 0; i < 4; ++i) positions[i] = q[static_cast<std::size_t>(i)];
  SimTK::Vector& rates = state.updU();
  for (int i = 0; i < 3; ++i) rates[i] = w[static_cast<std::size_t>(i)];
  system_->system.realize(state, SimTK::Stage::Acceleration);
}

}  // namespace vectrix::validation
