#pragma once

#include <GeographicLib/SphericalHarmonic.hpp>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <vector>

#include <vectrix/space/fields/gravity_field.hpp>

namespace bench {

/// C20 of the Earth, which the reader asks for.
inline constexpr double oblateness = -4.84e-4;

/// A file of normalized coefficients, the others as large as Kaula's rule has them, and GeographicLib's copy.
class RandomHarmonics {
 public:
  explicit RandomHarmonics(int degree)
      : degree_(degree),
        path_(std::filesystem::temp_directory_path() / ("vectrix_bench_" + std::to_string(degree) + ".gfc")) {
    const auto place = [&](int n, int m) {
      return static_cast<std::size_t>(m * (degree + 1) - m * (m - 1) / 2 + n - m);
    };
    C_.resize(place(degree, degree) + 1);
    S_.resize(C_.size() - place(degree, 0) - 1);  // without order 0
    std::mt19937_64 generator(11);
    std::normal_distribution<double> normal;
    std::ofstream file(path_);
    file.precision(17);
    file << "product_type gravity_field\nearth_gravity_constant 3.986004415e14\nradius 6378136.3\nmax_degree "
         << degree << "\nnorm fully_normalized\nend_of_head\n";
    for (int n = 0; n <= degree; ++n) {
      for (int m = 0; m <= n; ++m) {
        const double size = n < 2 ? 0.0 : 1e-5 / (n * n);
        const double random = size * normal(generator);
        double& C = C_[place(n, m)] = n == 0 ? 1.0 : n == 2 && m == 0 ? oblateness : random;
        double S = 0.0;
        if (m > 0) S = S_[place(n, m) - place(degree, 0) - 1] = size * normal(generator);
        file << "gfc " << n << ' ' << m << ' ' << C << ' ' << S << '\n';
      }
    }
  }
  RandomHarmonics(const RandomHarmonics&) = delete;
  RandomHarmonics& operator=(const RandomHarmonics&) = delete;
  ~RandomHarmonics() { std::filesystem::remove(path_); }

  [[nodiscard]] vectrix::GravityField ours() const { return vectrix::GravityField::read(path_, degree_); }
  /// Refers to this model.
  [[nodiscard]] GeographicLib::SphericalHarmonic theirs(unsigned normalization) const {
    return {C_, S_, degree_, 6378136.3, normalization};
  }

 private:
  int degree_;
  std::filesystem::path path_;
  std::vector<double> C_, S_;
};

}  // namespace bench
