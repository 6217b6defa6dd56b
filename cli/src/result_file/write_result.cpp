#include <cstdint>
#include <string>
#include <vector>

#include "result_file/hdf5_file.hpp"
#include "result_file/result_file.hpp"
#include "result_file/schema.hpp"

namespace vectrix::cli {
namespace {

using Texts = std::vector<std::string>;
using Whole = std::vector<std::int64_t>;

// A number or a text of each.
template <class Of, class Value> auto column(const std::vector<Of>& all, const Value& value) {
  std::vector<std::decay_t<decltype(value(all.front()))>> values;
  for (const Of& each : all) values.push_back(value(each));
  return values;
}
// The numbers of each, one after the other.
template <class Of, class Value> std::vector<double> rows(const std::vector<Of>& all, const Value& value) {
  std::vector<double> numbers;
  for (const Of& each : all)
    for (const double number : value(each)) numbers.push_back(number);
  return numbers;
}
template <class Of, class Value> Texts text_rows(const std::vector<Of>& all, const Value& value) {
  Texts texts;
  for (const Of& each : all)
    for (const std::string& text : value(each)) texts.push_back(text);
  return texts;
}

Eigen::Vector4d scalar_first(const Eigen::Quaterniond& q) {
  return {q.w(), q.x(), q.y(), q.z()};
}
const Eigen::Vector3d& itself(const Eigen::Vector3d& v) {
  return v;
}
std::int64_t whole_number(std::size_t number) {
  return static_cast<std::int64_t>(number);
}

class ResultWriter {
 public:
  ResultWriter(const Result& result, const std::filesystem::path& file) : result_(result), file_(file) {}

  void write() {
    file_.add_words("/", {{"format", "vectrix result"},
                          {"version", result_.texts.version},
                          {"title", result_.texts.title},
                          {"body", result_.body},
                          {"reference", result_.reference}});
    file_.add_number("/", "form", result_form);
    add_attitude("/attitude", result_.attitude);
    add_samples();
    if (result_.orbit) add_orbit(*result_.orbit);
    add_frames();
    add_measures();
    add_verdicts();
    add_provenance();
    add_page();
    file_.close();
  }

 private:
  template <class Values>
  void add(const std::string& path, const Values& values, const Hdf5Words& words = {}) {
    const Hdf5Entry& entry = result_entry(path);
    if constexpr (std::is_same_v<Values, Whole>) {
      file_.add(path, values);
    } else {
      file_.add(path, values, entry.columns);
    }
    describe(path, words);
  }
  void describe(const std::string& path, const Hdf5Words& words) {
    const Hdf5Entry& entry = result_entry(path);
    file_.add_words(path, {{"meaning", std::string(entry.meaning)}});
    if (!entry.unit.empty()) file_.add_words(path, {{"unit", std::string(entry.unit)}});
    file_.add_words(path, words);
  }

  void add_attitude(const std::string& group, const Result::Attitude& attitude) {
    const Epoch& start = result_.texts.start;
    const Hdf5Words since{{"since_utc", exact_text(start, scale::utc)},
                          {"since_tt", exact_text(start, scale::tt)}};
    const auto seconds = [&](const Epoch& t) { return (t - start).value(); };
    add(group + "/tai",
        rows(attitude.times,
             [](const Epoch& t) {
               return std::vector<double>{t.tai().day, t.tai().fraction};
             }),
        {{"scale", "TAI"}});
    file_.add_number(group + "/tai", "tai_minus_utc_first", attitude.times.front().tai_minus_utc().value());
    file_.add_number(group + "/tai", "tai_minus_utc_last", attitude.times.back().tai_minus_utc().value());
    add(group + "/seconds", column(attitude.times, seconds), since);
    add(group + "/quaternion", rows(attitude.reference_from_body, scalar_first),
        {{"from", result_.body}, {"to", result_.reference}, {"scalar", "first"}});
    add(group + "/gaps",
        rows(gaps_of(attitude),
             [&](std::size_t i) {
               return std::vector<double>{seconds(attitude.times[i]), seconds(attitude.times[i + 1])};
             }),
        since);
    file_.add_number(group + "/gaps", "longest_step", attitude.longest_step);
  }

  // Without a step the samples are the instants.
  void add_samples() {
    const Result::Attitude& samples = result_.samples;
    if (samples.times == result_.attitude.times) {
      for (const char* name : {"/tai", "/seconds", "/quaternion", "/gaps"})
        file_.link("/samples" + std::string(name), "/attitude" + std::string(name));
    } else {
      add_attitude("/samples", samples);
    }
    if (!samples.rates.empty())
      add("/samples/rate", rows(samples.rates, itself),
          {{"of", result_.body}, {"relative_to", result_.reference}, {"in", result_.body}});
  }

  void add_orbit(const Result::Orbit& orbit) {
    add("/orbit/position",
        rows(orbit.motions, [](const SatelliteMotion& m) { return m.position.coordinates(); }),
        {{"of", "satellite"}, {"relative_to", "GCRF"}, {"in", "GCRF"}});
    add("/orbit/velocity",
        rows(orbit.motions, [](const SatelliteMotion& m) { return m.velocity.coordinates(); }),
        {{"of", "satellite"}, {"relative_to", "GCRF"}, {"observed_from", "GCRF"}, {"in", "GCRF"}});
    add("/orbit/geodetic", rows(orbit.ground_track, [](const Eigen::Vector2d& place) { return place; }));
    add("/orbit/visible_sun", orbit.visible_sun);
  }

  void add_frames() {
    add("/frames/names", column(result_.frames, [](const auto& frame) { return frame.name; }));
    add("/frames/quaternion",
        rows(result_.frames, [](const auto& frame) { return scalar_first(frame.body_from_frame); }),
        {{"to", result_.body}, {"scalar", "first"}});
  }

  void add_measures() {
    const auto& measures = result_.measures;
    add("/measures/names", text_rows(measures, [](const auto& measure) {
          return Texts{measure.name, measure.what, measure.axis, measure.target};
        }));
    add("/measures/axis", rows(measures, [](const auto& measure) { return measure.axis_in_body; }),
        {{"in", result_.body}});
    for (std::size_t k = 0; k < measures.size(); ++k) {
      const std::string group = "/measures/" + std::to_string(k + 1);
      add(group + "/angle", measures[k].degrees, {{"name", measures[k].name}, {"what", measures[k].what}});
      if (!measures[k].hidden.empty()) {
        add(group + "/hidden", Whole(measures[k].hidden.begin(), measures[k].hidden.end()),
            {{"name", measures[k].target}});
      }
      add(group + "/direction", rows(measures[k].directions, itself),
          {{"in", result_.reference}, {"name", measures[k].target}});
    }
  }

  void add_verdicts() {
    const auto& all = result_.verdicts;
    const auto add_column = [&](const char* name, const auto& value) {
      add("/verdicts/" + std::string(name), column(all, value));
    };
    add_column("measure", [](const auto& verdict) { return whole_number(verdict.measure + 1); });
    add_column("required", [](const auto& verdict) { return verdict.required; });
    add_column("percent", [](const auto& verdict) { return verdict.percent; });
    add_column("window", [](const auto& verdict) { return verdict.window; });
    add_column("when", [](const auto& verdict) {
      return std::string(when_words[static_cast<std::size_t>(verdict.when)]);
    });
    add_column("reached", [](const auto& verdict) { return verdict.reached; });
    add_column("margin", [](const auto& verdict) { return verdict.margin; });
    add_column("within", [](const auto& verdict) { return whole_number(verdict.within); });
    add_column("judged", [](const auto& verdict) { return whole_number(verdict.judged); });
    add_column("fulfilled", [](const auto& verdict) { return whole_number(verdict.fulfilled ? 1 : 0); });
    add("/verdicts/texts", text_rows(result_.texts.verdicts, [](const auto& verdict) {
          return Texts{verdict.what, verdict.required, verdict.reached, verdict.margin};
        }));
  }

  void add_provenance() {
    const auto& inputs = result_.texts.inputs;
    add("/choices", text_rows(result_.texts.choices, [](const auto& choice) {
          return Texts{choice.what, choice.value, choice.by};
        }));
    add("/inputs/paths", column(inputs, [](const auto& input) { return input.path; }));
    add("/inputs/bytes", column(inputs, [](const auto& input) { return whole_number(input.bytes); }));
    add("/inputs/sha256", column(inputs, [](const auto& input) { return input.sha256; }));
    add("/scenario/paths", column(result_.scenario, [](const auto& file) { return file.path; }));
    add("/scenario/texts", column(result_.scenario, [](const auto& file) { return file.text; }));
  }

  void add_page() {
    const auto& tables = result_.texts.tables;
    add("/page/facts", text_rows(result_.texts.facts, [](const auto& fact) {
          return Texts{fact.name, fact.value};
        }));
    add("/page/tables/titles", column(tables, [](const auto& table) { return table.title; }));
    for (std::size_t k = 0; k < tables.size(); ++k) {
      const std::string group = "/page/tables/" + std::to_string(k + 1);
      add(group + "/headings", tables[k].headings);
      file_.add(group + "/rows", text_rows(tables[k].rows, [](const Texts& row) { return row; }),
                tables[k].headings.size());
      describe(group + "/rows", {});
    }
  }

  const Result& result_;
  Hdf5Writer file_;
};

}  // namespace

void write_result(const Result& result, const std::filesystem::path& file) {
  ResultWriter(result, file).write();
}

}  // namespace vectrix::cli
