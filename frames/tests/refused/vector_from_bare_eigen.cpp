// mistake: three bare numbers that nobody has claimed to be coordinates of a frame
// expect: Vector<Body, (vectrix::)?si::length
#include <vectrix/frames.hpp>

struct Body : vectrix::moving_frame {};

using namespace vectrix;

Vector<Body, si::length> position(const Eigen::Vector3d& numbers) {
#ifdef REPAIRED
  return vector<si::length>(in<Body>, numbers);
#else
  return numbers;
#endif
}
