#include "daf_words.hpp"

#include <algorithm>
#include <bit>
#include <cstring>

namespace vectrix::detail {
namespace {

constexpr ByteOrder native = std::endian::native == std::endian::little ? ByteOrder::little : ByteOrder::big;

template <class Integer> Integer integer(const char* bytes, ByteOrder order) {
  Integer value = 0;
  for (std::size_t i = 0; i < sizeof(Integer); ++i) {
    const std::size_t place = order == ByteOrder::little ? i : sizeof(Integer) - 1 - i;
    value |= static_cast<Integer>(static_cast<Integer>(static_cast<unsigned char>(bytes[i])) << (8 * place));
  }
  return value;
}

}  // namespace

std::uint32_t integer32(const char* bytes, ByteOrder order) {
  return integer<std::uint32_t>(bytes, order);
}
std::uint64_t integer64(const char* bytes, ByteOrder order) {
  return integer<std::uint64_t>(bytes, order);
}
double double64(const char* bytes, ByteOrder order) {
  return std::bit_cast<double>(integer64(bytes, order));
}

bool KeptWords::read(std::uint64_t first, std::span<double> into) const {
  if (first > words_.size() || into.size() > words_.size() - first) return false;
  std::copy_n(words_.begin() + static_cast<std::ptrdiff_t>(first), into.size(), into.begin());
  return true;
}

bool FileWords::read_bytes(std::uint64_t first, char* into, std::size_t size) const {
  const std::lock_guard lock(mutex_);
  in_.clear();
  in_.seekg(static_cast<std::streamoff>(first));
  in_.read(into, static_cast<std::streamsize>(size));
  return static_cast<bool>(in_);
}

bool FileWords::read(std::uint64_t first, std::span<double> into) const {
  char* const bytes = reinterpret_cast<char*>(into.data());
  if (!read_bytes(first * daf_word, bytes, into.size() * daf_word)) return false;
  if (order_ != native) {
    for (double& number : into) {
      const char* const at = reinterpret_cast<const char*>(&number);
      number = double64(at, order_);
    }
  }
  return true;
}

}  // namespace vectrix::detail
