// mistake: the quotient of two vectors
// expect: Left = (vectrix::)?Vector<Body
// expect: Right = (vectrix::)?Vector<Body
// expect: a vector over a number
#include <vectrix/frames.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

double ratio(const Vector<Body, si::length>& r_body, const Vector<Body, si::length>& s_body) {
#ifdef REPAIRED
  return norm(r_body) / norm(s_body);
#else
  return r_body / s_body;
#endif
}
