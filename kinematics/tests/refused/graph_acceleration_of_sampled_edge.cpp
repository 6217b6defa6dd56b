// mistake: the acceleration across samples joined by slerp: its rate jumps from one to the next
// expect: AccelerationOn<(vectrix::)?Link<Gcrf, Body
#include <vectrix/kinematics.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};

using namespace vectrix;

auto acceleration(const std::vector<AttitudeSample<Gcrf, Body>>& samples, const Quantity<si::time>& t) {
#ifdef REPAIRED
  const auto graph = frame_graph(edge(RotationSpline<Gcrf, Body>(samples, 10.0 * si::second, natural_ends)));
#else
  const auto graph = frame_graph(sampled_edge(samples, 10.0 * si::second));
#endif
  return graph.at(t).angular_acceleration(of<Body>, relative_to<Gcrf>, in<Body>);
}
