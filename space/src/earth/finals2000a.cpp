#include "finals2000a.hpp"

#include <array>
#include <cmath>
#include <optional>

#include <vectrix/frames/errors.hpp>

#include "../files/text_file.hpp"

namespace vectrix::detail {
namespace {

struct Field {
  const char* name;
  std::size_t first, last;  // columns, from 1
};
constexpr Field mjd{"MJD", 8, 15};
constexpr std::array<Field, 5> values{
    {{"x", 19, 27}, {"y", 38, 46}, {"UT1-UTC", 59, 68}, {"dX", 98, 106}, {"dY", 117, 125}}};

// The length of the day varies by a few milliseconds. UT1-TAI changes by more only at a leap second that the
// table lacks.
constexpr Quantity<si::time> largest_change_in_a_day = 0.01 * si::second;

// The offsets from IAU 2006/2000A are some tenths of a milliarcsecond. Their largest in the series is 9.3 in
// 1982 and 1.7 since 1985. Those from IAU 1980, in the same columns of finals.all, grow by 3 in a year: -105
// in 2022.
constexpr int first_day_of_1985 = 46066;
double largest_offset(int day) {
  return day < first_day_of_1985 ? 15.0 : 3.0;
}

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : file_(file) {}

  [[noreturn]] void fail(const std::string& reason) const {
    throw BadInput("Earth orientation " + file_.string() + (line_ > 0 ? ", line " + text(line_) : "") + ": " +
                   reason);
  }
  [[noreturn]] void fail(const Field& field, const std::string& reason) const {
    fail(std::string{"columns "} + text(field.first) + "-" + text(field.last) + " (" + field.name +
         "): " + reason);
  }

  // The number in a field, or nothing if the field is blank.
  [[nodiscard]] std::optional<double> number(const std::string& line, const Field& field) const {
    const auto written =
        line.size() < field.first
            ? std::string_view{}
            : trimmed(std::string_view{line}.substr(field.first - 1, field.last - field.first + 1));
    if (written.empty()) return std::nullopt;
    const auto value = parse_number(written);
    if (!value || !std::isfinite(*value)) {
      fail(field,
           std::string{"'"}.append(written) + (value ? "' is not a finite number" : "' is not a number"));
    }
    return value;
  }

  void row(const std::string& line) {
    ++line_;
    if (line.starts_with('#')) return;
    const auto day = number(line, mjd);
    if (!day) fail(mjd, "the field is blank");
    if (*day != std::floor(*day) || std::abs(*day) > 1e6) fail(mjd, text(*day) + " is not a whole day");
    if (last_day_ && *day != *last_day_ + 1.0) {
      fail(mjd, std::string{"the day "} + text(*day) + " follows " + text(*last_day_) +
                    "; rows must be a day apart");
    }
    last_day_ = day;

    std::array<double, values.size()> found{};
    const Field* blank = nullptr;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto value = number(line, values[i]);
      if (!value && blank == nullptr) blank = &values[i];
      if (value) found[i] = *value;
    }
    if (blank != nullptr) {
      if (incomplete_line_ == 0) {
        incomplete_line_ = line_;
        incomplete_field_ = blank;
      }
    } else if (incomplete_line_ > 0) {
      line_ = incomplete_line_;
      fail(*incomplete_field_, "the field is blank, but a complete row follows");
    } else {
      add(static_cast<int>(*day), found);
    }
  }

  void add(int day, const std::array<double, values.size()>& found) {
    for (const std::size_t i : {3U, 4U}) {
      if (std::abs(found[i]) > largest_offset(day)) {
        fail(values[i], text(found[i]) +
                            " milliarcseconds is no offset of the pole from IAU 2006/2000A, at most " +
                            text(largest_offset(day)) +
                            "; finals.all has offsets from IAU 1980 in these columns, read finals2000A");
      }
    }
    const Epoch epoch = Epoch::from_utc_mjd(day);
    const auto arcseconds = [](double angle) { return convert<si::angle>(angle * si::arcsecond); };
    const auto ut1_minus_tai = found[2] * si::second - epoch.tai_minus_utc();
    if (!rows_.empty()) {
      const auto change = ut1_minus_tai - rows_.back().ut1_minus_tai;
      if (std::abs(change.value()) > largest_change_in_a_day.value()) {
        fail(values[2], std::string{"UT1-TAI changes by "} + text(change.value()) +
                            " s in a day; is there a leap second missing?");
      }
    }
    epochs_.push_back(epoch);
    rows_.push_back({arcseconds(found[0]), arcseconds(found[1]), ut1_minus_tai,
                     Quantity<si::dimensionless>{0.0}, arcseconds(1e-3 * found[3]),
                     arcseconds(1e-3 * found[4])});
  }

  std::pair<std::vector<Epoch>, std::vector<EarthOrientationParameters>> result() {
    if (rows_.size() >= 2) return {std::move(epochs_), std::move(rows_)};
    line_ = incomplete_line_;
    const std::string few = text(rows_.size()) + " complete rows; there must be two";
    if (incomplete_field_ != nullptr) fail(*incomplete_field_, "the field is blank after " + few);
    fail(few);
  }

 private:
  const std::filesystem::path& file_;
  std::size_t line_ = 0;
  std::optional<double> last_day_;
  std::size_t incomplete_line_ = 0;
  const Field* incomplete_field_ = nullptr;
  std::vector<Epoch> epochs_;
  std::vector<EarthOrientationParameters> rows_;
};

}  // namespace

std::pair<std::vector<Epoch>, std::vector<EarthOrientationParameters>> read_finals2000A(
    const std::filesystem::path& file) {
  Reader reader{file};
  const auto content = read_lines(file);
  if (!content) reader.fail("cannot be read");
  for (const std::string& line : content->lines) reader.row(line);
  if (!content->whole) reader.fail("the file stops within this line; it was truncated");
  return reader.result();
}

std::string shown(const Epoch& epoch) {
  try {
    return epoch.utc() + " UTC";
  } catch (const BadInput&) {
    return epoch.tt() + " TT";
  }
}

}  // namespace vectrix::detail
