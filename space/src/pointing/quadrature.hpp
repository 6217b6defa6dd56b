#pragma once

#include <algorithm>
#include <boost/math/quadrature/gauss.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cstdint>
#include <utility>
#include <vector>

namespace vectrix::detail {

/// The sum of rule(from, to) over the pieces into which the places within it cut the interval.
template <class Rule> double in_pieces(const Rule& rule, double from, double to, std::vector<double> places) {
  std::erase_if(places, [&](double place) { return !(place > from && place < to); });
  places.push_back(to);
  std::sort(places.begin(), places.end());
  double sum = 0.0, begin = from;
  for (const double end : places) {
    if (end > begin) sum += rule(begin, end);
    begin = end;
  }
  return sum;
}

/// By a rule of Gauss of 20 points in each piece.
template <class Function>
double integral(const Function& f, double from, double to, std::vector<double> places) {
  return in_pieces(
      [&](double a, double b) { return boost::math::quadrature::gauss<double, 20>::integrate(f, a, b); },
      from, to, std::move(places));
}

/// Of a function that is nowhere above 1: by rules of Gauss and Kronrod on halves of each piece, until the
/// two agree to 1e-10 of the interval.
template <class Function>
double adaptive_integral(const Function& f, double from, double to, std::vector<double> places) {
  constexpr unsigned halvings = 6;
  constexpr double tolerance = 1e-10, coarsest = 1e-3;
  return in_pieces(
      [&](double a, double b) {
        const double of_piece = std::min(tolerance * (to - from) / (b - a), coarsest);
        return boost::math::quadrature::gauss_kronrod<double, 15>::integrate(f, a, b, halvings, of_piece);
      },
      from, to, std::move(places));
}

/// The zero of a function that does not decrease, is not negative at `largest`, and is sought from a guess
/// on, to a relative 1e-12; 0 if the function is not negative there.
template <class Function> double zero_of(const Function& f, double largest, double guess) {
  double low = 0.0, high = std::min(guess, largest), f_low = f(low), f_high = f(high);
  if (f_low >= 0.0) return low;
  while (f_high < 0.0 && high < largest) {
    low = high;
    f_low = f_high;
    high = std::min(2.0 * high, largest);
    f_high = f(high);
  }
  if (f_high <= 0.0) return high;
  constexpr int bits = 40;
  std::uintmax_t steps = 200;
  const auto [below, above] = boost::math::tools::toms748_solve(
      f, low, high, f_low, f_high, boost::math::tools::eps_tolerance<double>(bits), steps);
  return 0.5 * (below + above);
}

}  // namespace vectrix::detail
