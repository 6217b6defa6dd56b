#include <vectrix/space/files/daf_file.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <string_view>
#include <system_error>

#include <vectrix/frames/errors.hpp>

#include "daf_words.hpp"
#include "daf_writer.hpp"
#include "text_file.hpp"

namespace vectrix {
namespace {

using detail::ByteOrder, detail::daf_record, detail::daf_word;

// The file record, in bytes.
constexpr std::size_t count_of_doubles = 8, count_of_integers = 12, internal_name_at = 16, first_summary = 76,
                      format_at = 88, name_size = 60;
constexpr std::uint64_t words_of_record = daf_record / daf_word, words_before_summaries = 3;

std::string_view without_padding(std::string_view text) {
  const auto last = text.find_last_not_of(std::string_view(" \0", 2));
  return last == std::string_view::npos ? std::string_view{} : text.substr(0, last + 1);
}

/// A whole number in [least, most] that is kept as a double.
std::optional<std::uint64_t> whole(double number, double least, double most) {
  if (!(number >= least && number <= most) || number != std::floor(number)) return std::nullopt;
  return static_cast<std::uint64_t>(number);
}

std::optional<ByteOrder> order_of(std::string_view format, const char* record) {
  if (format == "LTL-IEEE") return ByteOrder::little;
  if (format == "BIG-IEEE") return ByteOrder::big;
  if (!without_padding(format).empty()) return std::nullopt;
  // Files from before 2001 do not say it.
  for (const ByteOrder order : {ByteOrder::little, ByteOrder::big}) {
    if (detail::integer32(record + count_of_doubles, order) < 256) return order;
  }
  return std::nullopt;
}

}  // namespace

DafFile::DafFile(const std::filesystem::path& file) : place_("DAF file " + file.string()) {}

void DafFile::fail(const std::string& reason) const {
  throw BadInput(place_ + reason);
}

DafFile DafFile::open(const std::filesystem::path& file) {
  DafFile daf(file);
  std::ifstream in(file, std::ios::binary);
  std::array<char, 8> word{};
  if (!in.read(word.data(), word.size()))
    daf.fail(in.is_open() ? ": it has no file record" : ": cannot be read");
  const std::string_view id(word.data(), word.size());
  in.close();
  if (id.starts_with("DAFETF")) {
    daf.read_transfer(file);
  } else if (id == "NAIF/DAF" || id.starts_with("DAF/")) {
    daf.read_binary(file);
  } else {
    daf.fail(": it begins with '" + std::string{id} + "', not with DAF/, NAIF/DAF or DAFETF");
  }
  daf.require_disjoint_arrays();
  return daf;
}

void DafFile::read_binary(const std::filesystem::path& file) {
  std::error_code unknown;
  const std::uint64_t bytes = std::filesystem::file_size(file, unknown);
  if (unknown) fail(": it has no size");
  const std::uint64_t records = bytes / daf_record, words = bytes / daf_word;
  const auto in = std::make_shared<detail::FileWords>(file);
  std::array<char, daf_record> record{};
  const auto load = [&](std::uint64_t number) {
    if (number > records || !in->read_bytes((number - 1) * daf_record, record.data(), record.size()))
      fail(", record " + detail::text(number) + ": the file has " + detail::text(records) +
           " records; it was truncated");
  };
  load(1);
  const std::string_view text(record.data(), record.size());
  if (text.starts_with("DAF/")) kind_ = without_padding(text.substr(4, 4));
  internal_name_ = without_padding(text.substr(internal_name_at, name_size));
  if (const auto at = text.find("FTPSTR");
      at != std::string_view::npos &&
      text.substr(at, detail::daf_transfer_check.size()) != detail::daf_transfer_check)
    fail(", record 1: the file was damaged by a transfer as text");
  const std::string_view format = text.substr(format_at, 8);
  const auto order = order_of(format, record.data());
  if (!order) fail(", record 1: the numbers are '" + std::string{format} + "', not LTL-IEEE or BIG-IEEE");
  in->set_order(*order);
  words_ = in;

  const auto integer = [&](std::size_t at) { return detail::integer32(record.data() + at, *order); };
  const std::uint64_t nd = integer(count_of_doubles), ni = integer(count_of_integers);
  const std::uint64_t room = words_of_record - words_before_summaries;
  if (nd > room || ni < 2 || ni > 2 * room || nd + (ni + 1) / 2 > room)
    fail(", record 1: summaries of " + detail::text(nd) + " doubles and " + detail::text(ni) + " integers");
  const std::uint64_t summary_words = nd + (ni + 1) / 2, name_bytes = summary_words * daf_word;
  std::uint64_t next = integer(first_summary), before = 0;
  if (next < 2) fail(", record 1: the first record of summaries is " + detail::text(next));
  comment_records_ = next - 2;

  while (next != 0) {
    const std::string place = ", record " + detail::text(next);
    load(next);
    const auto number = [&](std::size_t word) {
      return detail::double64(record.data() + word * daf_word, *order);
    };
    const auto following = whole(number(0), 0.0, static_cast<double>(records));
    const auto count = whole(number(2), 0.0, static_cast<double>(room / summary_words));
    // A record names the one before it, so that the records make no loop.
    if (number(1) != static_cast<double>(before))
      fail(place + ": the record before it is " + detail::text(before) + ", and it says " +
           detail::text(number(1)));
    if (!following) fail(place + ": the next record is " + detail::text(number(0)));
    if (!count) fail(place + ": it has " + detail::text(number(2)) + " summaries");
    std::array<char, daf_record> summaries = record;
    if (*count > 0) load(next + 1);
    for (std::uint64_t i = 0; i < *count; ++i) {
      const char* at = summaries.data() + (words_before_summaries + i * summary_words) * daf_word;
      Array array{std::string{without_padding({record.data() + i * name_bytes, name_bytes})}, {}, {}, 0, 0};
      for (std::uint64_t k = 0; k < nd; ++k, at += daf_word)
        array.doubles.push_back(detail::double64(at, *order));
      for (std::uint64_t k = 0; k < ni; ++k, at += 4)
        array.integers.push_back(static_cast<std::int32_t>(detail::integer32(at, *order)));
      const std::int64_t last = array.integers[ni - 1], first = array.integers[ni - 2];
      array.integers.resize(ni - 2);
      if (first <= static_cast<std::int64_t>(words_of_record) || last < first ||
          static_cast<std::uint64_t>(last) > words)
        fail(place + ", summary " + detail::text(i + 1) + ": the array '" + array.name + "' has the words " +
             detail::text(first) + " to " + detail::text(last) + " of " + detail::text(words) +
             (static_cast<std::uint64_t>(last) > words && last >= first ? "; the file was truncated" : ""));
      array.first = static_cast<std::uint64_t>(first - 1);
      array.size = static_cast<std::uint64_t>(last - first + 1);
      arrays_.push_back(std::move(array));
    }
    before = next;
    next = *following;
  }
}

void DafFile::require_disjoint_arrays() const {
  std::vector<const Array*> sorted;
  sorted.reserve(arrays_.size());
  for (const Array& array : arrays_) sorted.push_back(&array);
  std::sort(sorted.begin(), sorted.end(), [](auto* a, auto* b) { return a->first < b->first; });
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    if (sorted[i]->first < sorted[i - 1]->first + sorted[i - 1]->size)
      fail(": the arrays '" + sorted[i - 1]->name + "' and '" + sorted[i]->name + "' share words");
  }
}

std::string DafFile::comments() const {
  if (comment_records_ == 0) return comments_;
  const auto& in = static_cast<const detail::FileWords&>(*words_);
  constexpr std::size_t used = 1000;
  std::string text;
  std::array<char, used> record{};
  for (std::uint64_t i = 0; i < comment_records_; ++i) {
    if (!in.read_bytes((i + 1) * daf_record, record.data(), record.size()))
      fail(", record " + detail::text(i + 2) + ": cannot be read");
    const std::string_view part(record.data(), record.size());
    const auto end = part.find('\4');
    text += part.substr(0, end);
    if (end != std::string_view::npos) {
      std::replace(text.begin(), text.end(), '\0', '\n');
      return text;
    }
  }
  if (std::all_of(text.begin(), text.end(), [](char c) { return c == ' ' || c == '\0'; })) return {};
  fail(": the comments have no end");
}

void DafFile::require_elements(const Array& array, std::uint64_t from, std::uint64_t count,
                               bool are_read) const {
  const bool are_there = from <= array.size && count <= array.size - from;
  if (are_there && are_read) return;
  fail(", array '" + array.name + "': the elements " + detail::text(from + 1) + " to " +
       detail::text(from + count) + (are_there ? " cannot be read" : " of " + detail::text(array.size)));
}

void DafFile::read(const Array& array, std::uint64_t from, std::span<double> into) const {
  require_elements(array, from, into.size(), true);
  require_elements(array, from, into.size(), words_->read(array.first + from, into));
}

std::vector<double> DafFile::read(const Array& array, std::uint64_t from, std::uint64_t count) const {
  require_elements(array, from, count, true);
  std::vector<double> numbers(count);
  read(array, from, numbers);
  return numbers;
}

}  // namespace vectrix
