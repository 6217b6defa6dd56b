#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "result_file/hdf5_file.hpp"
#include "result_file/result_file.hpp"
#include "result_file/schema.hpp"
#include "selection.hpp"

namespace vectrix::cli {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

std::string row_text(std::size_t row) {
  return "row " + std::to_string(row + 1);
}

class ResultReader {
 public:
  explicit ResultReader(const std::filesystem::path& file) : file_(file) {
    if (file_.word("/", "format") != "vectrix result")
      file_.refuse("/", "has the format '" + file_.word("/", "format") + "', not 'vectrix result'");
    if (const double form = file_.number("/", "form"); form != result_form)
      file_.refuse("/", "has the form " + detail::text(form) + ", written by vectrix " +
                            file_.word("/", "version") + "; this program reads the form " +
                            std::to_string(result_form));
  }

  Result result() {
    Result::Attitude attitude = read_attitude("/attitude"), samples = read_attitude("/samples");
    if (file_.has("/samples/rate")) samples.rates = vectors("/samples/rate", samples.times.size());
    Report texts{.title = file_.word("/", "title"),
                 .start = attitude.times.front(),
                 .version = file_.word("/", "version")};
    const std::size_t instants = attitude.times.size();
    Result result{std::move(texts), file_.word("/", "body"), file_.word("/", "reference"),
                  std::move(attitude), std::move(samples)};
    if (inertial(result.reference) != result.reference)
      file_.refuse("/", "has the reference '" + result.reference + "', not EME2000 or GCRF");
    if (file_.has("/orbit")) result.orbit = read_orbit(instants);
    read_frames(result);
    read_measures(result, instants);
    read_verdicts(result);
    read_provenance(result);
    read_page(result.texts);
    return result;
  }

 private:
  void require_rows(const std::string& path, std::size_t rows, std::size_t wanted) const {
    if (rows != wanted)
      file_.refuse(path, "has " + std::to_string(rows) + " rows, not " + std::to_string(wanted));
  }
  // `rows` of them.
  [[nodiscard]] std::vector<double> numbers(const std::string& path, std::size_t rows) const {
    const std::size_t columns = result_entry(path).columns;
    auto all = file_.numbers(path, columns);
    require_rows(path, all.size() / columns, rows);
    return all;
  }
  [[nodiscard]] std::vector<std::size_t> counts(const std::string& path, std::size_t rows) const {
    const auto found = file_.whole_numbers(path);
    require_rows(path, found.size(), rows);
    std::vector<std::size_t> all;
    for (const std::int64_t count : found) {
      if (count < 0) file_.refuse(path, "holds " + std::to_string(count) + ", which counts nothing");
      all.push_back(static_cast<std::size_t>(count));
    }
    return all;
  }
  [[nodiscard]] std::vector<std::string> texts(const std::string& path, std::size_t rows) const {
    auto all = file_.texts(path, result_entry(path).columns);
    require_rows(path, all.size() / result_entry(path).columns, rows);
    return all;
  }
  [[nodiscard]] std::vector<std::string> texts(const std::string& path) const {
    return file_.texts(path, result_entry(path).columns);
  }

  [[nodiscard]] std::vector<Vector3d> vectors(const std::string& path, std::size_t rows) const {
    const auto all = numbers(path, rows);
    std::vector<Vector3d> vectors;
    for (std::size_t i = 0; i < rows; ++i) vectors.emplace_back(all[3 * i], all[3 * i + 1], all[3 * i + 2]);
    return vectors;
  }
  void require_unit(const std::string& path, std::size_t row, double norm) const {
    constexpr double tolerance = 1e-6;  // as of a report
    if (!(std::abs(norm - 1.0) <= tolerance))
      file_.refuse(path, "has in " + row_text(row) + " the norm " + detail::text(norm) + ", not 1");
  }
  [[nodiscard]] std::vector<Vector3d> unit_vectors(const std::string& path, std::size_t rows) const {
    auto all = vectors(path, rows);
    for (std::size_t i = 0; i < rows; ++i) require_unit(path, i, all[i].norm());
    return all;
  }
  [[nodiscard]] std::vector<Quaterniond> quaternions(const std::string& path, std::size_t rows) const {
    const auto q = numbers(path, rows);
    std::vector<Quaterniond> all;
    for (std::size_t i = 0; i < rows; ++i) {
      all.emplace_back(q[4 * i], q[4 * i + 1], q[4 * i + 2], q[4 * i + 3]);
      require_unit(path, i, all.back().norm());
    }
    return all;
  }

  template <class Time> auto dated(const std::string& path, const Time& time) const {
    try {
      return time();
    } catch (const BadInput& error) {
      file_.refuse(path, "holds a time that has no date: " + std::string(error.what()));
    }
  }
  [[nodiscard]] std::vector<Epoch> times(const std::string& path) const {
    const auto dates = file_.numbers(path, result_entry(path).columns);
    if (dates.size() < 4) file_.refuse(path, "has fewer than two rows");
    std::vector<Epoch> all;
    for (std::size_t i = 0; i < dates.size() / 2; ++i) {
      all.push_back(
          dated(path, [&] { return Epoch::from_julian_date(scale::tai, dates[2 * i], dates[2 * i + 1]); }));
      if (i > 0 && !(all[i - 1] < all[i]))
        file_.refuse(path, "has in " + row_text(i) + " a time that is not after the row before");
    }
    require_leap_seconds(path, "tai_minus_utc_first", all.front());
    require_leap_seconds(path, "tai_minus_utc_last", all.back());
    return all;
  }
  void require_leap_seconds(const std::string& path, const std::string& name, const Epoch& t) const {
    const double there = file_.number(path, name);
    const double here = dated(path, [&] { return t.tai_minus_utc().value(); });
    if (here != there)
      file_.refuse(path, "was written with " + detail::text(there) +
                             " s from UTC to TAI, where this program has " + detail::text(here) +
                             " s: with another table of leap seconds");
  }

  [[nodiscard]] Result::Attitude read_attitude(const std::string& group) const {
    auto epochs = times(group + "/tai");
    auto q = quaternions(group + "/quaternion", epochs.size());
    return {std::move(epochs), std::move(q), {}, file_.number(group + "/gaps", "longest_step")};
  }

  [[nodiscard]] Result::Orbit read_orbit(std::size_t instants) const {
    const auto r = vectors("/orbit/position", instants), v = vectors("/orbit/velocity", instants);
    Result::Orbit orbit{{}, numbers("/orbit/visible_sun", instants), {}};
    const auto places = numbers("/orbit/geodetic", instants);
    for (std::size_t i = 0; i < instants; ++i) {
      orbit.motions.push_back(point_motion(
          of<Satellite>, relative_to<earth::Gcrf>, observed_from<earth::Gcrf>,
          vector<si::length>(in<earth::Gcrf>, r[i]), vector<si::velocity>(in<earth::Gcrf>, v[i])));
      const Eigen::Vector2d& place = orbit.ground_track.emplace_back(places[2 * i], places[2 * i + 1]);
      if (std::abs(place.x()) > 90.0 || std::abs(place.y()) > 180.0)
        file_.refuse("/orbit/geodetic", "has in " + row_text(i) + " a place that is not on the Earth");
    }
    return orbit;
  }

  void read_frames(Result& result) const {
    const auto names = texts("/frames/names");
    const auto q = quaternions("/frames/quaternion", names.size());
    for (std::size_t i = 0; i < names.size(); ++i) result.frames.push_back({names[i], q[i]});
  }

  void read_measures(Result& result, std::size_t instants) const {
    const auto names = texts("/measures/names");
    const auto axes = unit_vectors("/measures/axis", names.size() / 4);
    for (std::size_t k = 0; k < axes.size(); ++k) {
      const std::string group = "/measures/" + std::to_string(k + 1);
      result.measures.push_back({names[4 * k], names[4 * k + 1], names[4 * k + 2], names[4 * k + 3], axes[k],
                                 numbers(group + "/angle", instants),
                                 unit_vectors(group + "/direction", instants)});
      if (!file_.has(group + "/hidden")) continue;
      for (const std::size_t each : counts(group + "/hidden", instants)) {
        if (each > 1) file_.refuse(group + "/hidden", "holds " + std::to_string(each) + ", neither 0 nor 1");
        result.measures.back().hidden.push_back(each == 1);
      }
    }
  }

  [[nodiscard]] When when_of(const std::string& path, const std::string& word) const {
    const auto at = std::find(when_words.begin(), when_words.end(), word);
    if (at == when_words.end()) file_.refuse(path, "holds '" + word + "'");
    return static_cast<When>(at - when_words.begin());
  }

  void read_verdicts(Result& result) const {
    const std::string group = "/verdicts/";
    const auto shown = texts(group + "texts");
    const std::size_t rows = shown.size() / 4;
    const auto measure = counts(group + "measure", rows), within_it = counts(group + "within", rows),
               judged = counts(group + "judged", rows), fulfilled = counts(group + "fulfilled", rows);
    const auto required = numbers(group + "required", rows), percent = numbers(group + "percent", rows),
               window = numbers(group + "window", rows), reached = numbers(group + "reached", rows),
               margin = numbers(group + "margin", rows);
    const auto when = texts(group + "when", rows);
    for (std::size_t i = 0; i < rows; ++i) {
      if (measure[i] == 0 || measure[i] > result.measures.size())
        file_.refuse(group + "measure", "names the measure " + std::to_string(measure[i]) + " of " +
                                            std::to_string(result.measures.size()));
      result.verdicts.push_back({measure[i] - 1, required[i], percent[i], window[i],
                                 when_of(group + "when", when[i]), reached[i], margin[i], within_it[i],
                                 judged[i], fulfilled[i] != 0});
      result.texts.verdicts.push_back(
          {shown[4 * i], shown[4 * i + 1], shown[4 * i + 2], shown[4 * i + 3], fulfilled[i] != 0});
    }
  }

  void read_provenance(Result& result) const {
    const auto choices = texts("/choices");
    for (std::size_t i = 0; i < choices.size(); i += 3)
      result.texts.choices.push_back({choices[i], choices[i + 1], choices[i + 2]});
    const auto paths = texts("/inputs/paths"), sums = texts("/inputs/sha256", paths.size());
    const auto bytes = counts("/inputs/bytes", paths.size());
    for (std::size_t i = 0; i < paths.size(); ++i)
      result.texts.inputs.push_back({paths[i], bytes[i], sums[i]});
    const auto files = texts("/scenario/paths"), contents = texts("/scenario/texts", files.size());
    for (std::size_t i = 0; i < files.size(); ++i) result.scenario.push_back({files[i], contents[i]});
  }

  void read_page(Report& page) const {
    const auto facts = texts("/page/facts");
    for (std::size_t i = 0; i < facts.size(); i += 2) page.facts.push_back({facts[i], facts[i + 1]});
    for (const std::string& title : texts("/page/tables/titles")) {
      const std::string group = "/page/tables/" + std::to_string(page.tables.size() + 1);
      Report::Table table{title, texts(group + "/headings"), {}};
      const std::size_t columns = table.headings.size();
      if (columns == 0) file_.refuse(group + "/headings", "has no rows");
      const auto cells = file_.texts(group + "/rows", columns);
      for (auto at = cells.begin(); at != cells.end(); at += static_cast<std::ptrdiff_t>(columns))
        table.rows.emplace_back(at, at + static_cast<std::ptrdiff_t>(columns));
      page.tables.push_back(std::move(table));
    }
  }

  Hdf5Reader file_;
};

}  // namespace

Result read_result(const std::filesystem::path& file) {
  return ResultReader(file).result();
}

}  // namespace vectrix::cli
