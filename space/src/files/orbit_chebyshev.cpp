#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <vectrix/frames/errors.hpp>

#include "orbit_source.hpp"

namespace vectrix::detail {
namespace {

constexpr double km = 1e3;

/// Polynomials over pieces of equal length, of the position (type 2) or also of the velocity (type 3):
///     r = sum_k a_k T_k(x),  x = (t - middle) / radius
class ChebyshevSource final : public OrbitSource {
 public:
  ChebyshevSource(const OrbitPart& part, int type);

  [[nodiscard]] PlainMotion at(const SecondsSince2000& time) const override;

 private:
  struct Values {
    double value, derivative;
  };
  [[nodiscard]] Values evaluate(const double* coefficients, double x) const;

  bool has_velocity_;
  double start_ = 0.0, length_ = 0.0;
  std::uint64_t first_piece_ = 0;
  std::size_t size_ = 0, terms_ = 0;  // of a record, of a polynomial
  std::vector<double> records_;
};

ChebyshevSource::ChebyshevSource(const OrbitPart& part, int type) : has_velocity_(type == 3) {
  constexpr std::uint64_t trailer = 4;
  const std::uint64_t all = part.array.size;
  if (all < trailer) part.fail(": a segment of " + text(all) + " numbers");
  const auto end = part.read_finite(all - trailer, trailer);
  start_ = end[0];
  length_ = end[1];
  if (!(length_ > 0.0)) part.fail(": the length of a piece is " + text(length_) + " s");
  size_ = part.count(end[2], "the size of a record", 1.0, static_cast<double>(all));
  const std::uint64_t pieces = part.count(end[3], "the number of records", 1.0, static_cast<double>(all));
  const std::size_t components = has_velocity_ ? 6 : 3;
  if (size_ < 2 + components || (size_ - 2) % components != 0)
    part.fail(": a record of " + text(size_) + " numbers");
  terms_ = (size_ - 2) / components;
  if (pieces > all / size_ || pieces * size_ + trailer != all)
    part.fail(": " + text(pieces) + " records of " + text(size_) + " numbers do not make a segment of " +
              text(all));
  const auto piece_of = [&](double time) {
    const double piece = std::floor((time - start_) / length_);
    return static_cast<std::uint64_t>(std::clamp(piece, 0.0, static_cast<double>(pieces - 1)));
  };
  first_piece_ = piece_of(part.first);
  const std::uint64_t count = piece_of(part.last) - first_piece_ + 1;
  records_ = part.read_finite(first_piece_ * size_, count * size_);
  constexpr double apart = 1e-6;  // of a piece
  for (std::uint64_t i = 0; i < count; ++i) {
    const double middle = records_[i * size_], radius = records_[i * size_ + 1];
    const double begin = start_ + static_cast<double>(first_piece_ + i) * length_;
    if (!(std::abs(middle - radius - begin) <= apart * length_ &&
          std::abs(2.0 * radius - length_) <= apart * length_))
      part.fail(", record " + text(first_piece_ + i + 1) + ": its piece is " + text(middle) + " +- " +
                text(radius) + " s; expected " + text(begin) + " to " + text(begin + length_));
  }
}

ChebyshevSource::Values ChebyshevSource::evaluate(const double* coefficients, double x) const {
  // Clenshaw's sums of T_k and of its derivative.
  double b1 = 0.0, b2 = 0.0, d1 = 0.0, d2 = 0.0;
  for (std::size_t k = terms_; k-- > 1;) {
    const double d = 2.0 * (b1 + x * d1) - d2;
    d2 = std::exchange(d1, d);
    const double b = coefficients[k] + 2.0 * x * b1 - b2;
    b2 = std::exchange(b1, b);
  }
  return {coefficients[0] + x * b1 - b2, b1 + x * d1 - d2};
}

PlainMotion ChebyshevSource::at(const SecondsSince2000& time) const {
  const auto last = static_cast<double>(records_.size() / size_ - 1);
  const double piece = std::floor(time.since(start_) / length_) - static_cast<double>(first_piece_);
  const double* const record = &records_[static_cast<std::size_t>(std::clamp(piece, 0.0, last)) * size_];
  const double radius = record[1], x = time.since(record[0]) / radius;
  PlainMotion motion;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Values r = evaluate(record + 2 + axis * terms_, x);
    motion.position(static_cast<Eigen::Index>(axis)) = km * r.value;
    motion.velocity(static_cast<Eigen::Index>(axis)) =
        km * (has_velocity_ ? evaluate(record + 2 + (axis + 3) * terms_, x).value : r.derivative / radius);
  }
  return motion;
}

}  // namespace

std::unique_ptr<const OrbitSource> chebyshev_source(const OrbitPart& part, int type) {
  return std::make_unique<ChebyshevSource>(part, type);
}

void OrbitPart::fail(const std::string& reason) const {
  throw BadInput(place + reason);
}

std::vector<double> OrbitPart::read_finite(std::uint64_t from, std::uint64_t count) const {
  auto numbers = read(from, count);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!std::isfinite(numbers[i]))
      fail(", number " + text(from + i + 1) + " of the segment: " + text(numbers[i]));
  }
  return numbers;
}

std::uint64_t OrbitPart::count(double number, const char* what, double least, double most) const {
  if (!(number >= least && number <= most) || number != std::floor(number))
    fail(": " + std::string{what} + " is " + text(number));
  return static_cast<std::uint64_t>(number);
}

}  // namespace vectrix::detail
