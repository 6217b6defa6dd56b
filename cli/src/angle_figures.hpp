#pragma once

#include <cstddef>
#include <vector>

namespace vectrix::cli {

/// What a requirement asks of angles, and what they are.
struct Judgement {
  double found;        // deg, the least that so many percent do not exceed
  double margin;       // deg
  std::size_t within;  // how many are at most what is required
  bool fulfilled;
};

/// The figures of angles, in degrees, and the places at which they are. There is at least one angle.
class AngleFigures {
 public:
  /// rad
  explicit AngleFigures(std::vector<double> angles);

  [[nodiscard]] std::size_t size() const { return angles_.size(); }
  [[nodiscard]] double quantile(double percent) const { return value(place_of(percent)); }
  [[nodiscard]] std::size_t place_of(double percent) const;
  [[nodiscard]] std::size_t place_of_least() const { return order_.front(); }
  [[nodiscard]] std::size_t place_of_largest() const { return order_.back(); }
  [[nodiscard]] double value(std::size_t place) const;
  [[nodiscard]] double rms() const;

  /// Whether so many percent are at most `required`, in deg.
  [[nodiscard]] Judgement judge(double required, double percent) const;

 private:
  std::vector<double> angles_;
  std::vector<std::size_t> order_;
};

}  // namespace vectrix::cli
