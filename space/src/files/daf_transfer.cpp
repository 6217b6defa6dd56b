#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

#include <vectrix/frames/errors.hpp>
#include <vectrix/space/files/daf_file.hpp>

#include "daf_words.hpp"
#include "text_file.hpp"

// The transfer form of a DAF file:
//     DAFETF NAIF DAF ENCODED TRANSFER FILE
//     'DAF/CK  '  '2'  '6'  'internal name'                 counts of doubles and integers, in base 16
//     BEGIN_ARRAY 1 539  'name'  '1183F90A5D0B^C' ...       the summary, then blocks: a count, the numbers
//     END_ARRAY 1 539  TOTAL_ARRAYS 1
// '8^-2' is 0.8 * 16^-2 with the digits and the exponent in base 16.
namespace vectrix {
namespace {

using detail::excerpt, detail::text;

/// Words, separated by blanks and line ends, or in quotation marks.
class TransferWords {
 public:
  TransferWords(const std::string& place, std::string_view rest) : place_(place), rest_(rest) {}

  std::string_view next(const char* expected) {
    skip_blanks();
    if (rest_.empty()) fail(std::string{"the file ends; "} + expected + " is expected");
    if (rest_.front() != '\'') return take(std::min(rest_.find_first_of(" \t\r\n"), rest_.size()));
    std::size_t end = rest_.find_first_of("'\n", 1);
    if (end == std::string_view::npos || rest_[end] == '\n')
      fail("the text '" + excerpt(rest_.substr(1, end - 1)) + "' has no end");
    const std::string_view quoted = take(end + 1);
    return quoted.substr(1, quoted.size() - 2);
  }
  std::string_view next_quoted(const char* expected) {
    skip_blanks();
    if (!rest_.starts_with('\'')) fail(std::string{expected} + " is expected");
    return next(expected);
  }
  std::uint64_t count(const char* expected, int base = 10) {
    const std::string_view word = next(expected);
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value, base);
    if (error != std::errc{} || end != word.data() + word.size())
      fail("'" + excerpt(word) + "' is not " + expected);
    return value;
  }
  std::int32_t integer() {
    const std::string_view word = next_quoted("an integer in base 16");
    std::int32_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value, 16);
    if (error != std::errc{} || end != word.data() + word.size())
      fail("'" + excerpt(word) + "' is not an integer of 32 bits in base 16");
    return value;
  }
  double number() {
    const std::string_view word = next_quoted("a number in base 16");
    const auto value = number_of(word);
    if (!value) fail("'" + excerpt(word) + "' is not a number in base 16");
    return *value;
  }
  void require(std::string_view word) {
    const std::string wanted{word};
    if (const auto found = next(wanted.c_str()); found != word)
      fail("'" + excerpt(found) + "' instead of " + wanted);
  }
  void require(std::uint64_t number, const char* what) {
    if (const auto found = count(what); found != number)
      fail(std::string{what} + " is " + text(found) + ", not " + text(number));
  }
  [[nodiscard]] std::size_t left() const { return rest_.size(); }
  [[nodiscard]] std::string_view rest() const { return rest_; }
  [[nodiscard]] std::uint64_t line() const { return line_; }
  [[noreturn]] void fail(const std::string& reason) const {
    throw BadInput(place_ + ", line " + text(line_) + ": " + reason);
  }

 private:
  static std::optional<double> number_of(std::string_view word) {
    const bool negative = word.starts_with('-');
    if (negative) word.remove_prefix(1);
    constexpr std::size_t most_digits = 16;
    std::uint64_t digits = 0;
    const char* const stop = word.data() + word.size();
    const auto [end, error] = std::from_chars(word.data(), stop, digits, 16);
    const auto size = static_cast<std::size_t>(end - word.data());
    if (error != std::errc{} || size > most_digits || end == stop || *end != '^') return std::nullopt;
    int exponent = 0;
    const auto [last, wrong] = std::from_chars(end + 1, stop, exponent, 16);
    constexpr int most = 1000;
    if (wrong != std::errc{} || last != stop || std::abs(exponent) > most) return std::nullopt;
    const double value = std::ldexp(static_cast<double>(digits), 4 * (exponent - static_cast<int>(size)));
    if (!std::isfinite(value)) return std::nullopt;
    return negative ? -value : value;
  }
  void skip_blanks() {
    std::size_t at = 0;
    for (; at < rest_.size(); ++at) {
      const char c = rest_[at];
      if (c == '\n') {
        ++line_;
      } else if (c != ' ' && c != '\t' && c != '\r') {
        break;
      }
    }
    rest_.remove_prefix(at);
  }
  std::string_view take(std::size_t size) {
    const std::string_view word = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return word;
  }

  const std::string& place_;
  std::string_view rest_;
  std::uint64_t line_ = 2;  // the first was the title
};

std::string trimmed_end(std::string_view text) {
  const auto last = text.find_last_not_of(' ');
  return std::string{last == std::string_view::npos ? std::string_view{} : text.substr(0, last + 1)};
}

std::string comments_of(TransferWords& words) {
  constexpr std::string_view begin = "~NAIF/SPC BEGIN COMMENTS~", end = "~NAIF/SPC END COMMENTS~";
  std::string_view rest = words.rest();
  const auto first = rest.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  rest.remove_prefix(first);
  if (!rest.starts_with(begin))
    words.fail("'" + excerpt(rest.substr(0, rest.find('\n'))) + "' after the last array");
  rest.remove_prefix(begin.size());
  const auto stop = rest.find(end);
  if (stop == std::string_view::npos) words.fail("the comments have no end");
  std::string_view comments = rest.substr(0, stop);
  comments.remove_prefix(std::min(comments.find('\n'), comments.size()));
  if (!comments.empty()) comments.remove_prefix(1);
  return trimmed_end(comments);
}

}  // namespace

void DafFile::read_transfer(const std::filesystem::path& file) {
  const auto bytes = detail::read_bytes(file);
  if (!bytes) fail(": cannot be read");
  std::string_view all = *bytes;
  const std::string_view title = detail::take_line(all);
  if (detail::trimmed(title) != "DAFETF NAIF DAF ENCODED TRANSFER FILE")
    fail(", line 1: '" + excerpt(title) + "' is not the title of a transfer file");
  TransferWords in(place_, all);
  const std::string_view id = in.next_quoted("the identification");
  if (!id.starts_with("DAF/") && id != "NAIF/DAF") in.fail("'" + excerpt(id) + "' does not begin with DAF/");
  if (id.starts_with("DAF/")) kind_ = trimmed_end(id.substr(4));
  constexpr std::uint64_t most_doubles = 124, most_integers = 250;
  const std::uint64_t nd = in.count("the count of doubles in a summary", 16),
                      ni = in.count("the count of integers in a summary", 16);
  if (nd > most_doubles || ni < 2 || ni > most_integers)
    in.fail("summaries of " + text(nd) + " doubles and " + text(ni) + " integers");
  internal_name_ = trimmed_end(in.next_quoted("the internal name"));

  std::vector<double> words;
  while (true) {
    const std::string_view word = in.next("BEGIN_ARRAY or TOTAL_ARRAYS");
    if (word == "TOTAL_ARRAYS") break;
    if (word != "BEGIN_ARRAY") in.fail("'" + excerpt(word) + "' instead of BEGIN_ARRAY or TOTAL_ARRAYS");
    in.require(arrays_.size() + 1, "the number of the array");
    const std::uint64_t size = in.count("the size of the array");
    constexpr std::size_t shortest = 6;  // characters of a number, '0^0' and a blank
    if (size == 0 || size > in.left() / shortest)
      in.fail("an array of " + text(size) + " numbers in the " + text(in.left()) +
              " characters that are left");
    Array array{trimmed_end(in.next_quoted("the name of the array")), {}, {}, words.size(), size};
    for (std::uint64_t i = 0; i < nd; ++i) array.doubles.push_back(in.number());
    for (std::uint64_t i = 0; i + 2 < ni; ++i) array.integers.push_back(in.integer());
    if (words.capacity() - words.size() < size)
      words.reserve(std::max(2 * words.capacity(), words.size() + size));
    for (std::uint64_t done = 0; done < size;) {
      const std::uint64_t block = in.count("the count of a block");
      if (block == 0 || block > size - done)
        in.fail("a block of " + text(block) + " numbers, of " + text(size - done) + " that are left");
      for (std::uint64_t i = 0; i < block; ++i) words.push_back(in.number());
      done += block;
    }
    in.require("END_ARRAY");
    in.require(arrays_.size() + 1, "the number of the array");
    in.require(size, "the size of the array");
    arrays_.push_back(std::move(array));
  }
  in.require(arrays_.size(), "the number of arrays");
  comments_ = comments_of(in);
  words_ = std::make_shared<detail::KeptWords>(std::move(words));
}

}  // namespace vectrix
