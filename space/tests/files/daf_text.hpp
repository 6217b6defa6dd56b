#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <vector>

namespace vectrix {

/// An array of a DAF file as a test writes it. The integers are without the two addresses.
struct DafTestArray {
  std::string name;
  std::vector<double> doubles;
  std::vector<std::int32_t> integers;
  std::vector<double> numbers;
};

/// The bytes of a DAF file in one byte order.
class DafBytes {
 public:
  explicit DafBytes(bool big) : big_(big) {}

  DafBytes& text(const std::string& text, std::size_t size, char padding = ' ') {
    bytes_ += text + std::string(size - text.size(), padding);
    return *this;
  }
  DafBytes& integer(std::uint32_t value) { return put(value, 4); }
  DafBytes& number(double value) { return put(std::bit_cast<std::uint64_t>(value), 8); }
  DafBytes& fill(std::size_t record) {
    bytes_.resize((bytes_.size() + record - 1) / record * record, '\0');
    return *this;
  }
  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  DafBytes& put(std::uint64_t value, int size) {
    for (int i = 0; i < size; ++i) bytes_ += static_cast<char>(value >> 8 * (big_ ? size - 1 - i : i));
    return *this;
  }
  bool big_;
  std::string bytes_;
};

/// A binary DAF file with one record of comments, if there are any, and `in_record` summaries in each record.
inline std::string daf_bytes(const std::string& kind, const std::vector<DafTestArray>& arrays,
                             bool big = false, std::size_t in_record = 25,
                             const std::string& comments = "A comment\n") {
  constexpr std::size_t record = 1024, words = 128;
  const std::size_t nd = arrays.front().doubles.size(), ni = arrays.front().integers.size() + 2,
                    summary = nd + (ni + 1) / 2;
  const std::size_t pairs = (arrays.size() + in_record - 1) / in_record, first = comments.empty() ? 2 : 3;
  const std::size_t data = first + 2 * pairs;  // record
  std::vector<std::size_t> begins{(data - 1) * words + 1};
  for (const auto& array : arrays) begins.push_back(begins.back() + array.numbers.size());
  const auto u = [](std::size_t n) { return static_cast<std::uint32_t>(n); };
  DafBytes out(big);
  out.text("DAF/" + kind, 8).integer(u(nd)).integer(u(ni)).text("a test", 60);
  out.integer(u(first)).integer(u(first + 2 * (pairs - 1))).integer(u(begins.back()));
  out.text(big ? "BIG-IEEE" : "LTL-IEEE", 8).text("", 603, '\0');
  out.text(std::string("FTPSTR:\r:\n:\r\n:\r\0:\x81:\x10\xce:ENDFTP", 28), 28).fill(record);
  std::string area = comments;
  for (char& c : area) c = c == '\n' ? '\0' : c;
  if (!area.empty()) out.text(area + '\4', record, '\0');
  for (std::size_t pair = 0; pair < pairs; ++pair) {
    const std::size_t from = pair * in_record, end = std::min(from + in_record, arrays.size());
    out.number(pair + 1 == pairs ? 0.0 : static_cast<double>(first + 2 * (pair + 1)));
    out.number(pair == 0 ? 0.0 : static_cast<double>(first + 2 * (pair - 1)));
    out.number(static_cast<double>(end - from));
    for (std::size_t i = from; i < end; ++i) {
      for (const double x : arrays[i].doubles) out.number(x);
      for (const std::int32_t k : arrays[i].integers) out.integer(static_cast<std::uint32_t>(k));
      out.integer(u(begins[i])).integer(u(begins[i + 1] - 1));
      if (ni % 2 == 1) out.integer(0);
    }
    out.fill(record);
    for (std::size_t i = from; i < end; ++i) out.text(arrays[i].name, summary * 8);
    out.fill(record);
  }
  for (const auto& array : arrays) {
    for (const double x : array.numbers) out.number(x);
  }
  return out.fill(record).bytes();
}

}  // namespace vectrix
