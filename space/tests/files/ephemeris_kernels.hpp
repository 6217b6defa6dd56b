#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <vectrix/space.hpp>

#include "files/daf_text.hpp"
#include "temporary_file.hpp"

// The ephemeris kernels that the tests write: one of every type, of the same motion.
namespace vectrix::ephemeris_kernel_test {

using earth::Gcrf;

struct Ship : moving_frame {};
struct Other : moving_frame {};

inline constexpr double km = 1e3;

// A cubic in time, from 2000 on, in km: each type of degree 3 has it exactly.
inline Eigen::Vector3d cubic(double t, int derivative) {
  const double x = t / 1000.0, k = 1.0 / 1000.0;
  if (derivative == 0)
    return {7000.0 + 100.0 * x - 3.0 * x * x + x * x * x, -500.0 + 200.0 * x, 4.0 * x * x * x};
  return {k * (100.0 - 6.0 * x + 3.0 * x * x), k * 200.0, k * 12.0 * x * x};
}
// As Chebyshev polynomials over middle +- radius: x^2 = (1 + T2)/2, x^3 = (3 T1 + T3)/4.
inline std::vector<double> chebyshev(double middle, double radius, int derivative, int axis) {
  const auto f = [&](double x) { return cubic(middle + radius * x, derivative)(axis); };
  const double a0 = f(0.0), odd = (f(1.0) - f(-1.0)) / 2.0, even = (f(1.0) + f(-1.0)) / 2.0 - a0;
  const double half = (f(0.5) - f(-0.5)) / 2.0, a3 = (odd - 2.0 * half) / 0.75, a1 = odd - a3;
  return {a0 + even / 2.0, a1 + 0.75 * a3, even / 2.0, a3 / 4.0};
}
inline DafTestArray segment(int type, std::vector<double> numbers, double first, double last,
                            int target = -77, int center = 399, int frame = 1) {
  return {"S" + std::to_string(type), {first, last}, {target, center, frame, type}, std::move(numbers)};
}
inline DafTestArray of_type(int type, int target = -77, int center = 399, int frame = 1, double sign = 1.0) {
  std::vector<double> numbers;
  const double first = 100.0, step = 50.0;
  const auto add_state = [&](double t) {
    for (const int derivative : {0, 1}) {
      for (const double x : cubic(t, derivative)) numbers.push_back(sign * x);
    }
  };
  if (type == 2 || type == 3) {
    const int count = 20;
    for (int i = 0; i < count; ++i) {
      const double radius = step / 2.0, middle = first + i * step + radius;
      numbers.insert(numbers.end(), {middle, radius});
      for (int derivative = 0; derivative < type - 1; ++derivative) {
        for (int axis = 0; axis < 3; ++axis) {
          for (const double a : chebyshev(middle, radius, derivative, axis)) numbers.push_back(sign * a);
        }
      }
    }
    numbers.insert(numbers.end(), {first, step, type == 2 ? 14.0 : 26.0, 1.0 * count});
    return segment(type, numbers, first, first + count * step, target, center, frame);
  }
  const bool is_even = type == 8 || type == 12;
  std::vector<double> times;
  for (int i = 0; i <= 250; ++i) times.push_back(first + i * step + (is_even ? 0.0 : 10.0 * std::sin(i)));
  times.front() = first;
  for (const double t : times) add_state(t);
  if (is_even) {
    numbers.insert(numbers.end(), {first, step});
  } else {
    numbers.insert(numbers.end(), times.begin(), times.end());
    numbers.insert(numbers.end(), {times[99], times[199]});
  }
  const double window = type == 8 ? 3.0 : type == 9 ? 4.0 : type == 12 ? 1.0 : 2.0;
  numbers.insert(numbers.end(), {window, 1.0 * static_cast<double>(times.size())});
  return segment(type, numbers, first, times.back(), target, center, frame);
}
// At these seconds of ephemeris time.
inline Epoch at_seconds(double et) {
  return Epoch::from_julian_date(scale::tdb, 2451545.0, et / 86400.0);
}
inline EphemerisKernel written(const std::vector<DafTestArray>& arrays, bool big = false) {
  const TemporaryFile file(daf_bytes("SPK", arrays, big));
  return EphemerisKernel::open(file.path());
}
// ERFA's TDB and SPICE's ephemeris time differ by 2e-5 s near 2000, here of 0.3 km/s.
inline constexpr double of_time = 0.02, of_time_in_velocity = 1e-4;

}  // namespace vectrix::ephemeris_kernel_test
