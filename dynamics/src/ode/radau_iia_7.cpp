#include <vectrix/dynamics/ode/radau_iia_7.hpp>

#include <cmath>
#include <utility>

namespace vectrix::ode {
namespace {

constexpr std::size_t stage_count = RadauIIA7::stages;

/// Legendre's polynomials of degrees 6 and 7.
std::pair<long double, long double> legendre(long double x) {
  long double before = 1.0L, value = x;
  for (int n = 1; n < static_cast<int>(stage_count); ++n)
    before = std::exchange(value, ((2 * n + 1) * x * value - n * before) / (n + 1));
  return {before, value};
}

long double difference(long double x) {
  const auto [six, seven] = legendre(x);
  return six - seven;
}

/// The zeros on (-1, 1), by bisection, and 1.
std::array<long double, stage_count> nodes() {
  constexpr int cells = 200;  // far more than zeros
  std::array<long double, stage_count> result{};
  std::size_t found = 0;
  for (int cell = 0; cell + 1 < cells; ++cell) {  // without the last cell, whose zero is 1
    long double low = -1.0L + 2.0L * cell / cells, high = -1.0L + 2.0L * (cell + 1) / cells;
    const bool rising = difference(low) < 0.0L;
    if (rising == (difference(high) < 0.0L)) continue;
    for (int i = 0; i < 80; ++i) {
      const long double middle = 0.5L * (low + high);
      ((difference(middle) < 0.0L) == rising ? low : high) = middle;
    }
    result.at(found++) = low;
  }
  result.at(found) = 1.0L;
  return result;
}

RadauIIA7 computed() {
  const auto x = nodes();
  std::array<long double, stage_count> c{}, weight{};
  for (std::size_t i = 0; i < stage_count; ++i) {
    c.at(i) = 0.5L * (1.0L + x.at(i));
    const long double six = legendre(x.at(i)).first;
    weight.at(i) = c.at(i) / (stage_count * stage_count * six * six);  // (1 + x) / (s P_6)^2 on [-1, 1]
  }
  const auto lagrange = [&](std::size_t j, long double t) {
    long double product = 1.0L;
    for (std::size_t m = 0; m < stage_count; ++m)
      if (m != j) product *= (t - c.at(m)) / (c.at(j) - c.at(m));
    return product;
  };
  RadauIIA7 result{};
  for (std::size_t i = 0; i < stage_count; ++i) {
    result.c.at(i) = static_cast<double>(c.at(i));
    for (std::size_t j = 0; j < stage_count; ++j) {
      long double integral =
          0.0L;  // of the Lagrange polynomial from 0 to c_i, by the method's own quadrature
      for (std::size_t m = 0; m < stage_count; ++m)
        integral += c.at(i) * weight.at(m) * lagrange(j, c.at(i) * c.at(m));
      result.a.at(i).at(j) = static_cast<double>(integral);
    }
  }
  return result;
}

}  // namespace

const RadauIIA7& RadauIIA7::table() {
  static const RadauIIA7 result = computed();
  return result;
}

}  // namespace vectrix::ode
