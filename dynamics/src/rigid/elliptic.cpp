#include "elliptic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace vectrix::elliptic {
namespace {

constexpr long double infinity = std::numeric_limits<long double>::infinity();
// The series omits the sixth power of the deviations: 1e-21.
constexpr long double small_deviation = 3e-4L;
// Convergence is quadratic: the next step would change less than the last digit.
constexpr long double equal_means = 1e-10L;

}  // namespace

long double carlson_rf(long double x, long double y, long double z) {
  if ((x == 0.0L) + (y == 0.0L) + (z == 0.0L) > 1) return infinity;
  for (;;) {
    const long double mean = (x + y + z) / 3.0L;
    const long double dx = 1.0L - x / mean;
    const long double dy = 1.0L - y / mean;
    const long double dz = -(dx + dy);
    if (!(std::max({std::abs(dx), std::abs(dy), std::abs(dz)}) >= small_deviation)) {
      const long double e2 = dx * dy - dz * dz;
      const long double e3 = dx * dy * dz;
      return (1.0L - e2 / 10.0L + e3 / 14.0L + e2 * e2 / 24.0L - 3.0L * e2 * e3 / 44.0L) / std::sqrt(mean);
    }
    const long double rx = std::sqrt(x);
    const long double ry = std::sqrt(y);
    const long double rz = std::sqrt(z);
    const long double lambda = rx * ry + ry * rz + rz * rx;
    x = (x + lambda) / 4.0L;
    y = (y + lambda) / 4.0L;
    z = (z + lambda) / 4.0L;
  }
}

long double complete(long double complementary_modulus) {
  if (complementary_modulus == 0.0L) return infinity;
  long double a = 1.0L;
  long double b = complementary_modulus;
  while (std::abs(a - b) > equal_means * a) {
    const long double mean = (a + b) / 2.0L;
    b = std::sqrt(a * b);
    a = mean;
  }
  return std::numbers::pi_v<long double> / (a + b);
}

long double incomplete(long double sine, long double cosine, long double complementary_square) {
  const long double square = cosine * cosine;
  return sine * carlson_rf(square, square + complementary_square * sine * sine, 1.0L);
}

}  // namespace vectrix::elliptic
