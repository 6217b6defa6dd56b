#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <vectrix/frames/export.hpp>

namespace vectrix {
namespace detail {

class DafWords;

}  // namespace detail

/// A double precision array file, the container of SPICE's binary kernels: arrays of doubles, each with a
/// name and a summary of a few doubles and integers. Read in either byte order, or from its transfer form, a
/// text with numbers in base 16. Opening reads the summaries only, an array is read in the part that is asked
/// for; of a transfer form all numbers are kept. Copies share the file, and threads may.
class VECTRIX_EXPORT DafFile {
 public:
  struct Array {
    std::string name;
    std::vector<double> doubles;
    std::vector<std::int32_t> integers;  ///< without the two addresses
    std::uint64_t first;                 ///< its first word in the file, from 0
    std::uint64_t size;                  ///< in words
  };

  /// Throws BadInput with the file, the record or line, and what is wrong there: another file, truncated,
  /// damaged by a transfer as text, counts and addresses outside the file, arrays that overlap.
  static DafFile open(const std::filesystem::path& file);

  /// What the file says it is: "CK", "SPK"; empty if it is old and does not say.
  [[nodiscard]] const std::string& kind() const { return kind_; }
  [[nodiscard]] const std::string& internal_name() const { return internal_name_; }
  [[nodiscard]] const std::vector<Array>& arrays() const { return arrays_; }
  /// The text of the comment area, with line ends. Throws BadInput if it has no end.
  [[nodiscard]] std::string comments() const;
  /// The file, "DAF file x.bc", which begins messages.
  [[nodiscard]] const std::string& place() const { return place_; }

  /// `count` doubles of an array, from its element `from` on. Throws BadInput if the array has not so many,
  /// or the file cannot be read.
  [[nodiscard]] std::vector<double> read(const Array& array, std::uint64_t from, std::uint64_t count) const;
  /// As many as the place has.
  void read(const Array& array, std::uint64_t from, std::span<double> into) const;

 private:
  explicit DafFile(const std::filesystem::path& file);

  void read_binary(const std::filesystem::path& file);
  void read_transfer(const std::filesystem::path& file);
  void require_disjoint_arrays() const;
  /// Throws BadInput if the array has not so many, or they could not be read.
  void require_elements(const Array& array, std::uint64_t from, std::uint64_t count, bool are_read) const;
  [[noreturn]] void fail(const std::string& reason) const;

  std::string place_, kind_, internal_name_, comments_;
  std::vector<Array> arrays_;
  std::uint64_t comment_records_ = 0;
  std::shared_ptr<const detail::DafWords> words_;
};

}  // namespace vectrix
