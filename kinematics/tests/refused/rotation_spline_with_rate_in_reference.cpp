// mistake: the rate at an end is expressed in Gcrf, that of the spline in the body
// expect: AngularVelocity<Gcrf, Body, vectrix::In<Gcrf>|AngularVelocity<Gcrf, Body, In<Gcrf>
// expect: natural_ends, or w_ab_b at the first and the last
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto motion(const std::vector<AttitudeSample<Gcrf, Body>>& samples,
            const AngularVelocity<Gcrf, Body, In<Gcrf>>& w_ib_i) {
#ifdef REPAIRED
  const auto in_body = [&](const AttitudeSample<Gcrf, Body>& sample) {
    return inverse(sample.q_a_from_b) * w_ib_i;
  };
  return RotationSpline(samples, 10.0 * si::second, in_body(samples.front()), in_body(samples.back()));
#else
  return RotationSpline(samples, 10.0 * si::second, w_ib_i, w_ib_i);
#endif
}
