// mistake: a position relative to a point that is not the origin of the frame
// expect: Transform<Body, Gcrf
// expect: Displacement<Camera, Tip, (vectrix::)?In<Gcrf>
#include <vectrix/frames.hpp>

struct Gcrf : vectrix::inertial_frame {};
struct Body : vectrix::moving_frame {};
struct Camera : vectrix::moving_frame {};
struct Tip : vectrix::named_point {};

using namespace vectrix;

auto motion(const Transform<Body, Gcrf>& X_b_from_i, const Displacement<Camera, Tip, In<Gcrf>>& r_ct_i,
            const Displacement<Gcrf, Camera, In<Gcrf>>& r_ic_i) {
#ifdef REPAIRED
  return X_b_from_i * (r_ic_i + r_ct_i);
#else
  return static_cast<void>(r_ic_i), X_b_from_i * r_ct_i;
#endif
}
