#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "draw.hpp"
#include "wide.hpp"

namespace vectrix::accuracy {

/// The bound of a row, ulp, and the reason for it.
struct Bound {
  double ulps;
  std::string reason;
};
/// The bound of `count` roundings of half an ulp each, all in the same direction.
inline Bound roundings(int count, const std::string& which) {
  return {0.5 * count, std::to_string(count) + " roundings: " + which};
}

/// The error of one sample, and a number that identifies the sample.
struct Found {
  Wide ulps;
  std::string place;
  double value;
};

/// |computed - exact| in ulp of the scale.
template <class Computed, class Exact>
Found compare(const Computed& computed, const Exact& exact, Wide scale, const char* place, double value) {
  const auto difference = (computed.template cast<Wide>() - exact).eval();
  const Wide largest = difference.cwiseAbs().template maxCoeff<Eigen::PropagateNaN>();
  const Wide norm = largest > 0 ? largest * (difference / largest).norm() : largest;
  return {norm == 0 ? norm : norm / scale * ulps_in_one, place, value};
}

struct Row {
  std::string section, function, domain, scale;
  std::size_t samples;
  double largest, rms;
  std::string worst;
  Bound promise;

  bool passed() const { return largest <= promise.ulps; }
};

struct Section {
  std::string title, text;
};

/// Measures the rows one after the other.
class Table {
 public:
  explicit Table(std::size_t samples) : samples_(samples) {}

  /// Describes the rows that follow.
  void section(const std::string& title, const std::string& text) { sections_.push_back({title, text}); }

  /// Calls `sample(draw)` as often as the table requires, or `count` times.
  template <class Sample>
  void row(const std::string& function, const std::string& domain, const std::string& scale,
           const Bound& promise, const Sample& sample, std::size_t count = 0) {
    Draw draw;
    Found worst{-1, "", 0};
    Wide squares = 0;
    std::size_t at = 0;
    const std::size_t n = count == 0 ? samples_ : count;
    for (draw.index = 0; draw.index < n; ++draw.index) {
      const Found found = sample(draw);
      squares += found.ulps * found.ulps;
      if (!(found.ulps <= worst.ulps)) {
        worst = found;
        at = draw.index;
        if (std::isnan(worst.ulps)) break;
      }
    }
    add({sections_.back().title, function, domain, scale, n, static_cast<double>(worst.ulps),
         static_cast<double>(std::sqrt(squares / static_cast<Wide>(n))), where(worst, at), promise});
  }

  const std::vector<Row>& rows() const { return rows_; }
  std::string markdown() const;

 private:
  static std::string where(const Found& worst, std::size_t sample);
  void add(const Row& row) { rows_.push_back(row); }

  std::size_t samples_;
  std::vector<Section> sections_;
  std::vector<Row> rows_;
};

// Each function adds its sections.
void frame_rows(Table& table);
void rotation_rows(Table& table);
void quaternion_rows(Table& table);
void parameter_rows(Table& table);
void parameter_rate_rows(Table& table);
void euler_rows(Table& table);
void euler_rate_rows(Table& table);
void jacobian_rows(Table& table);
void screw_rows(Table& table);
void law_rows(Table& table);
void step_rows(Table& table);
void sampled_rows(Table& table);
void fit_rows(Table& table);
void free_rotation_rows(Table& table);

}  // namespace vectrix::accuracy
