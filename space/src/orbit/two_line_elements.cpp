#include <vectrix/space/orbit/two_line_elements.hpp>

#include <erfa.h>

#include <cmath>
#include <optional>

#include "../files/text_file.hpp"
#include "element_line.hpp"
#include "mean_motion.hpp"

namespace vectrix {
namespace {

using detail::Columns, detail::ElementLine, detail::rev_per_hour;
constexpr double hours = detail::hours_of_a_day;

namespace line1 {
constexpr Columns classification{8, 8, "classification"}, designator{10, 17, "designator"},
    year{19, 20, "year"}, day{21, 32, "day of the year"},
    half_rate{34, 43, "half the derivative of the mean motion"},
    sixth_of_second_rate{45, 52, "a sixth of the second derivative of the mean motion"}, bstar{54, 61, "B*"},
    type{63, 63, "type of the elements"}, set_number{65, 68, "number of the set"};
}  // namespace line1
namespace line2 {
constexpr Columns catalogue{3, 7, "catalogue number"}, inclination{9, 16, "inclination"},
    node{18, 25, "ascending node"}, eccentricity{27, 33, "eccentricity"},
    perigee{35, 42, "argument of perigee"}, mean_anomaly{44, 51, "mean anomaly"},
    mean_motion{53, 63, "mean motion"}, revolution{64, 68, "revolution"};
}  // namespace line2

// The modified Julian day of January 1.
int new_year(int of_year) {
  double zero = 0.0, modified = 0.0;
  eraCal2jd(of_year, 1, 1, &zero, &modified);
  return static_cast<int>(modified);
}

Epoch epoch_of(const ElementLine& line) {
  constexpr int first_year = 57;  // of the first satellite
  const int two_digits = static_cast<int>(line.number(line1::year, 0.0, 99.0));
  const int of_year = two_digits + (two_digits < first_year ? 2000 : 1900);
  const int start = new_year(of_year), days = new_year(of_year + 1) - start;
  const double count = line.number(line1::day), whole = std::floor(count);
  if (!(whole >= 1.0 && whole <= days))
    line.fail(line1::day, "the year " + detail::text(of_year) + " has the days 1 to " + detail::text(days));
  const std::string_view written = line.text(line1::day);
  const auto point = written.find('.');
  const double fraction =
      point == std::string_view::npos ? 0.0 : detail::parse_number(written.substr(point)).value_or(0.0);
  try {
    return Epoch::from_utc_mjd(start + static_cast<int>(whole) - 1, fraction);
  } catch (const BadInput& error) {
    line.fail({line1::year.first, line1::day.last, "epoch"}, error.what());
  }
}

std::string_view title_of(std::string_view line) {
  return detail::trimmed(line.starts_with("0 ") ? line.substr(2) : line);
}

}  // namespace

TwoLineElements TwoLineElements::of(std::string_view title, const ElementLine& first,
                                    const ElementLine& second) {
  const int number = first.catalogue_number();
  if (second.catalogue_number() != number)
    second.fail(line2::catalogue, "line 1 is of " + std::string{first.text(line2::catalogue)});
  const char kind = first.text(line1::type)[0];
  if (kind != ' ' && kind != '0' && kind != '2' && kind != '3')
    first.fail(line1::type, "the elements are of another theory than SGP4 and SDP4");
  const char secrecy = first.text(line1::classification)[0];
  if (secrecy != ' ' && secrecy != 'U' && secrecy != 'C' && secrecy != 'S')
    first.fail(line1::classification, "not U, C or S");

  const auto degrees = [&](const Columns& columns, double most) {
    return convert<si::angle>(second.number(columns, 0.0, most) * si::degree);
  };
  const double revolutions = second.number(line2::mean_motion, 0.0, detail::fastest_mean_motion);
  if (revolutions == 0.0) second.fail(line2::mean_motion, "it must be positive");
  TwoLineElements set(
      title, {epoch_of(first), detail::mean_motion(revolutions), second.decimals(line2::eccentricity),
              degrees(line2::inclination, 180.0), degrees(line2::node, 360.0), degrees(line2::perigee, 360.0),
              MeanAnomaly(degrees(line2::mean_anomaly, 360.0)),
              first.with_exponent(line1::bstar, detail::largest_bstar) * bstar_unit});
  set.catalogue_number_ = number;
  set.classification_ = secrecy;
  set.designator_ = detail::trimmed(first.text(line1::designator));
  set.element_set_number_ = first.count(line1::set_number);
  set.revolution_number_ = second.count(line2::revolution);
  const double half_rate =
      first.number(line1::half_rate, -detail::largest_half_rate, detail::largest_half_rate);
  const auto rate = 2.0 * half_rate / (hours * hours) * (rev_per_hour / si::hour);
  set.mean_motion_rate_ = convert<si::angular_acceleration>(rate);
  const double sixth = first.with_exponent(line1::sixth_of_second_rate, detail::largest_sixth_of_second_rate);
  const auto second_rate = 6.0 * sixth / (hours * hours * hours) * (rev_per_hour / si::hour / si::hour);
  set.mean_motion_second_rate_ = convert<SecondRate::unit>(second_rate);
  return set;
}

TwoLineElements TwoLineElements::parse(std::string_view line1, std::string_view line2) {
  return parse({}, line1, line2);
}

TwoLineElements TwoLineElements::parse(std::string_view title, std::string_view line1,
                                       std::string_view line2) {
  const ElementLine first("two-line elements, line 1", line1, '1');
  const ElementLine second("two-line elements, line 2", line2, '2');
  return of(title_of(title), first, second);
}

std::vector<TwoLineElements> TwoLineElements::read(const std::filesystem::path& file) {
  const std::string name = "two-line elements " + file.string();
  const auto content = detail::read_lines(file);
  if (!content) throw BadInput(name + ": cannot be read");
  const auto place = [&](std::size_t line) { return name + ", line " + detail::text(line + 1); };

  std::vector<TwoLineElements> sets;
  std::string_view title;
  bool has_title = false;
  std::optional<ElementLine> first;
  for (std::size_t i = 0; i < content->lines.size(); ++i) {
    const std::string& line = content->lines[i];
    if (line.starts_with('#') || detail::trimmed(line).empty()) continue;
    if (first) {
      sets.push_back(of(title, *first, ElementLine(place(i), line, '2')));
      first.reset();
      title = {};
      has_title = false;
    } else if (has_title || line.starts_with("1 ")) {
      first.emplace(place(i), line, '1');
    } else if (line.starts_with("2 ")) {
      throw BadInput(place(i) + ": line 2 of a set without line 1 before it");
    } else {
      title = title_of(line);
      has_title = true;
    }
  }
  if (first || has_title) throw BadInput(place(content->lines.size() - 1) + ": the file ends within a set");
  if (sets.empty()) throw BadInput(name + ": there is no set of elements");
  return sets;
}

}  // namespace vectrix
