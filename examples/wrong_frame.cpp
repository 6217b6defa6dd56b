// The mistake of the README, and its correction.
//
//     r^b = R_i^b r^i          R_b_from_i * r_i
//
// A star tracker gives R_i_from_b, the matrix from the body to the inertial frame. A line of sight is known
// in the inertial frame and needed in the body frame. With plain matrices, R * r compiles, runs, and points
// the antenna in a wrong direction. Here the product does not compile until the matrix is inverted. Compile
// with -DMISTAKE to see the compiler's message.

#include <cstdio>
#include <vectrix/frames.hpp>

using namespace vectrix;

struct Gcrf : inertial_frame {};
struct Body : moving_frame {};

namespace {

Dcm<Gcrf, Body> star_tracker() {
  return turned_z(to<Gcrf>, from<Body>, convert<si::angle>(30.0 * si::degree));
}

Vector<Gcrf, si::length> target() {
  return vector(in<Gcrf>, 1000.0 * si::metre, 0.0 * si::metre, 0.0 * si::metre);
}

}  // namespace

int main() {
  Dcm<Gcrf, Body> R_i_from_b = star_tracker();  // takes body coordinates to inertial
  Vector<Gcrf, si::length> r_i = target();
#ifdef MISTAKE
  auto r_b = R_i_from_b * r_i;  // transposed: should be inverse(R_i_from_b) * r_i
#else
  Vector<Body, si::length> r_b = inverse(R_i_from_b) * r_i;
#endif

  const Eigen::Vector3d transposed = R_i_from_b.matrix() * r_i.coordinates();
  std::printf("typed:            r_b = (%8.3f, %8.3f, %8.3f) m\n", r_b.x().value(), r_b.y().value(),
              r_b.z().value());
  std::printf("bare, transposed: r_b = (%8.3f, %8.3f, %8.3f) m, off by %.1f m\n", transposed.x(),
              transposed.y(), transposed.z(), (transposed - r_b.coordinates()).norm());
}
