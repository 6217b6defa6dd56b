#include "daf_writer.hpp"

#include <bit>

#include "daf_words.hpp"

namespace vectrix::detail {
namespace {

class DafBytesWriter {
 public:
  void text(std::string_view text, std::size_t size, char padding) {
    bytes_ += text.substr(0, size);
    bytes_.append(size - std::min(size, text.size()), padding);
  }
  void integer(std::uint64_t value) { put(value, 4); }
  void number(double value) { put(std::bit_cast<std::uint64_t>(value), daf_word); }
  void end_record() { bytes_.resize((bytes_.size() + daf_record - 1) / daf_record * daf_record, '\0'); }
  void reserve(std::size_t size) { bytes_.reserve(size); }
  std::string take() && { return std::move(bytes_); }

 private:
  void put(std::uint64_t value, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i) bytes_ += static_cast<char>(value >> (8 * i) & 0xff);
  }

  std::string bytes_;
};

constexpr std::size_t comment_bytes = 1000;  // of a record

}  // namespace

std::string daf_bytes_of(const std::string& kind, const DafArrayToWrite& array, const std::string& comments) {
  constexpr std::uint64_t words = daf_record / daf_word;
  constexpr std::size_t internal_name = 60, until_check = 603;
  const std::size_t nd = array.doubles.size(), ni = array.integers.size() + 2;
  std::string area = comments.empty() ? "" : comments + '\4';
  for (char& c : area) c = c == '\n' ? '\0' : c;
  const std::uint64_t summaries = 2 + (area.size() + comment_bytes - 1) / comment_bytes;
  const std::uint64_t first = (summaries + 1) * words + 1, end = first + array.numbers.size();

  DafBytesWriter out;
  out.reserve((summaries + 2) * daf_record + array.numbers.size() * daf_word);
  out.text("DAF/" + kind, daf_word, ' ');
  out.integer(nd);
  out.integer(ni);
  out.text(array.name, internal_name, ' ');
  out.integer(summaries);
  out.integer(summaries);
  out.integer(end);
  out.text("LTL-IEEE", daf_word, ' ');
  out.text({}, until_check, '\0');
  out.text(daf_transfer_check, daf_transfer_check.size(), '\0');
  out.end_record();
  for (std::size_t at = 0; at < area.size(); at += comment_bytes) {
    out.text(std::string_view(area).substr(at), comment_bytes, '\0');
    out.end_record();
  }
  for (const double x : {0.0, 0.0, 1.0}) out.number(x);  // next, before, count
  for (const double x : array.doubles) out.number(x);
  for (const std::int32_t k : array.integers) out.integer(static_cast<std::uint32_t>(k));
  out.integer(first);
  out.integer(end - 1);
  out.end_record();
  out.text(array.name, (nd + (ni + 1) / 2) * daf_word, ' ');
  out.end_record();
  for (const double x : array.numbers) out.number(x);
  out.end_record();
  return std::move(out).take();
}

}  // namespace vectrix::detail
