#pragma once

#include <cstddef>
#include <vector>

namespace vectrix::detail {

/// The coefficients of a sum of solid harmonics of one radius a, up to a degree N:
///     sum_nm C_nm Re M_nm + S_nm Im M_nm,    M_nm = (a/r)^(n+1) p_nm(sin phi) cos^m phi e^(i m lambda)
/// where p_nm is the polynomial of the associated Legendre function, with the leading coefficient 1. Without
/// the factorials of the usual functions a derivative of a series has a simple rule.
class Harmonics {
 public:
  struct Pair {
    double C = 0.0, S = 0.0;
  };
  enum class Normalization { full, schmidt };

  explicit Harmonics(int degree)
      : degree_(degree), pairs_(static_cast<std::size_t>((degree + 1) * (degree + 2) / 2)) {}

  [[nodiscard]] int degree() const { return degree_; }
  [[nodiscard]] const Pair& at(int n, int m) const { return pairs_[place(n, m)]; }
  void add(int n, int m, const Pair& pair) {
    pairs_[place(n, m)].C += pair.C;
    pairs_[place(n, m)].S += pair.S;
  }

 private:
  static std::size_t place(int n, int m) { return static_cast<std::size_t>(n * (n + 1) / 2 + m); }

  int degree_;
  std::vector<Pair> pairs_;
};

/// From coefficients of normalized functions: sqrt((2 - delta_0m)(n-m)!/(n+m)!) of Schmidt, times sqrt(2n+1)
/// for full normalization.
Harmonics harmonics_of(const Harmonics& normalized, Harmonics::Normalization normalization);

/// a d/dx, a d/dy or a d/dz (axis 0, 1, 2): of degree N + 1. With c = 2n + 1
///     (d/dx + i d/dy) M_nm = -c M_n+1,m+1    (d/dx - i d/dy) M_nm = c M_n+1,m-1    d/dz M_nm = -c M_n+1,m
/// and M_n,-1 = -conj(M_n1) (Cunningham, On the computation of the spherical harmonic terms needed during the
/// numerical integration of the orbital motion of an artificial satellite, 1970).
Harmonics derivative(const Harmonics& harmonics, int axis);

}  // namespace vectrix::detail
