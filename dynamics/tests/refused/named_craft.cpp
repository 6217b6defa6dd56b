// Crafts with names at run time
#include <vectrix/dynamics.hpp>
#include <vectrix/dynamics/craft/named_spacecraft.hpp>

using namespace vectrix;

namespace craft_mount_turned_round {
// mistake: where the parent is on the body, instead of where the body is on its parent
// expect: P = (vectrix::)?ThisBody
// expect: B = (vectrix::)?ParentBody
auto panel(const Transform<ThisBody, ParentBody>& X_b_from_p) {
#ifdef REPAIRED
  return hinge(inverse(X_b_from_p), unit_y(in<ThisBody>));
#else
  return hinge(X_b_from_p, unit_y(in<ThisBody>));
#endif
}
}  // namespace craft_mount_turned_round

namespace craft_axis_of_the_parent {
// mistake: the axis of a slider in the axes of the parent
// expect: B = (vectrix::)?ThisBody
// expect: C = (vectrix::)?ParentBody
auto boom(const Transform<ParentBody, ThisBody>& X_p_from_b,
          const Vector<ParentBody, si::dimensionless>& axis_p) {
#ifdef REPAIRED
  return slider(X_p_from_b, inverse(X_p_from_b.rotation) * axis_p);
#else
  return slider(X_p_from_b, axis_p);
#endif
}
}  // namespace craft_axis_of_the_parent

namespace craft_length_as_axis {
// mistake: a length for a direction
// expect: D = (vectrix::)?ThisBody
// expect: V = (vectrix::)?si::length
auto antenna(const Transform<ParentBody, ThisBody>& X_p_from_b, const Vector<ThisBody, si::length>& r_b) {
#ifdef REPAIRED
  return gimbal(X_p_from_b, unit_x(in<ThisBody>), r_b / norm(r_b));
#else
  return gimbal(X_p_from_b, unit_x(in<ThisBody>), r_b);
#endif
}
}  // namespace craft_length_as_axis
