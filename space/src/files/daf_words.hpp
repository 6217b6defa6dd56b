#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace vectrix::detail {

inline constexpr std::uint64_t daf_word = 8, daf_record = 1024;  // bytes

enum class ByteOrder { little, big };

/// Unsigned integers of a file in its byte order.
std::uint32_t integer32(const char* bytes, ByteOrder order);
std::uint64_t integer64(const char* bytes, ByteOrder order);
double double64(const char* bytes, ByteOrder order);

/// The doubles of a file, from word 0 on.
class DafWords {
 public:
  DafWords() = default;
  DafWords(const DafWords&) = delete;
  DafWords& operator=(const DafWords&) = delete;
  virtual ~DafWords() = default;

  /// Whether all of them could be read.
  virtual bool read(std::uint64_t first, std::span<double> into) const = 0;
};

/// Those in memory, of a transfer form.
class KeptWords : public DafWords {
 public:
  explicit KeptWords(std::vector<double> words) : words_(std::move(words)) {}
  bool read(std::uint64_t first, std::span<double> into) const override;

 private:
  std::vector<double> words_;
};

/// Those of a binary file.
class FileWords : public DafWords {
 public:
  explicit FileWords(const std::filesystem::path& file) : in_(file, std::ios::binary) {}

  void set_order(ByteOrder order) { order_ = order; }
  [[nodiscard]] ByteOrder order() const { return order_; }
  bool read(std::uint64_t first, std::span<double> into) const override;
  bool read_bytes(std::uint64_t first, char* into, std::size_t size) const;

 private:
  mutable std::mutex mutex_;
  mutable std::ifstream in_;
  ByteOrder order_ = ByteOrder::little;
};

}  // namespace vectrix::detail
