// mistake: a torque function that answers in inertial axes
// expect: TorqueFunction
// expect: from State<I, B> to Vector<B, si::torque>
// expect: Vector<Eci, (vectrix::)?si::torque
#include <vectrix/dynamics.hpp>

struct Eci : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto solar_pressure(const Vector<Eci, si::torque>& torque_eci) {
  CustomTorque<Eci, Body> pressure;
#ifdef REPAIRED
  pressure.torque_b = [=](const State<Eci, Body>& state) -> Vector<Body, si::torque> {
    return inverse(state.R_i_from_b()) * torque_eci;
  };
#else
  pressure.torque_b = [=](const State<Eci, Body>&) -> Vector<Eci, si::torque> { return torque_eci; };
#endif
  return pressure;
}
