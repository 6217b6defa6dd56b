// mistake: a torque function that answers in inertial axes
// expect: Vector<Body, (vectrix::)?si::torque
// expect: CustomTorque
#include <vectrix/dynamics.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto solar_pressure(const Vector<Gcrf, si::torque>& torque_gcrf) {
  CustomTorque<Gcrf, Body> pressure;
#ifdef REPAIRED
  pressure.torque_b = [=](const State<Gcrf, Body>& state) -> Vector<Body, si::torque> {
    return inverse(state.R_i_from_b()) * torque_gcrf;
  };
#else
  pressure.torque_b = [=](const State<Gcrf, Body>&) -> Vector<Gcrf, si::torque> { return torque_gcrf; };
#endif
  return pressure;
}
