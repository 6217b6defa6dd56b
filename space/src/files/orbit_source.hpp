#pragma once

#include <memory>
#include <string>

#include <vectrix/space/files/daf_file.hpp>
#include <vectrix/space/sky/geocentric.hpp>

#include "ephemeris_time.hpp"

namespace vectrix::detail {

/// The part of a segment of an ephemeris kernel that a span needs: position and velocity in its frame.
class OrbitSource {
 public:
  OrbitSource() = default;
  OrbitSource(const OrbitSource&) = delete;
  OrbitSource& operator=(const OrbitSource&) = delete;
  virtual ~OrbitSource() = default;

  /// In m and m/s, at a time within the span.
  [[nodiscard]] virtual PlainMotion at(const SecondsSince2000& time) const = 0;
};

/// What is read from first to last, in seconds of ephemeris time. `place` begins messages.
struct OrbitPart {
  std::string place;
  const DafFile& file;
  const DafFile::Array& array;
  double first, last;

  [[nodiscard]] std::vector<double> read(std::uint64_t from, std::uint64_t count) const {
    return file.read(array, from, count);
  }
  [[noreturn]] void fail(const std::string& reason) const;
  /// The numbers, all finite; `from` is that of the first in the segment.
  [[nodiscard]] std::vector<double> read_finite(std::uint64_t from, std::uint64_t count) const;
  /// A whole number from least to most among the numbers of the segment.
  [[nodiscard]] std::uint64_t count(double number, const char* what, double least, double most) const;
};

/// Throw BadInput with the place for counts that do not fit, numbers that are not finite and times that do
/// not increase.
std::unique_ptr<const OrbitSource> chebyshev_source(const OrbitPart& part, int type);  // types 2 and 3
std::unique_ptr<const OrbitSource> states_source(const OrbitPart& part, int type);     // 8, 9, 12 and 13
std::unique_ptr<const OrbitSource> element_sets_source(const OrbitPart& part);         // 10

}  // namespace vectrix::detail
