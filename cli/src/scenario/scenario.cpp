#include "scenario/scenario.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "attitude_kernel_record.hpp"
#include "figures.hpp"
#include "message_kind.hpp"
#include "plain_words.hpp"
#include "reference_frame.hpp"
#include "scales.hpp"
#include "scenario/contributions.hpp"
#include "scenario/fixed_frame.hpp"
#include "scenario/given.hpp"
#include "scenario/measures.hpp"
#include "scenario/table.hpp"
#include "stored_attitude.hpp"
#include "table_text.hpp"

namespace vectrix::cli {
namespace {

using Scalar = Convention::Scalar;
using Maps = Convention::Maps;

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : table_(read_scenario_table(file)) {
    if (const auto* const leap_seconds = table_.table("attitude")->find("leap_seconds")) {
      try {
        use_leap_seconds_of({.leap_seconds = leap_seconds->text()});
      } catch (const BadInput& error) {
        refuse(leap_seconds->place, error.what());
      }
      table_ = read_scenario_table(file);  // again: its times may be in UTC
    }
    scenario_.file = file.string();
    scenario_.title = table_.at("title").text();
  }

  Scenario read() {
    for (const auto& text : table_.files) add_input(text);
    scenario_.texts = scenario_.inputs;
    read_time();
    if (const auto* const earth = table_.table("earth")) {
      const auto& value = earth->at("orientation");
      add_input(value.text());
      scenario_.orientation = EarthOrientation::read(value.text());
      scenario_.orientation_place = value.place;
      choose("orientation of the Earth", value.text(), value.place);
    }
    read_attitude();
    for (const auto& input : files_of(scenario_.attitude)) add_input(input);
    if (const auto* const orbit = table_.table("orbit")) {
      read_orbit(*orbit);
      for (const auto& input : files_of(*scenario_.orbit)) add_input(input);
    }
    for (const ScenarioTable& each : table_.tables("frame")) {
      scenario_.frames.push_back(fixed_frame(each));
      const FixedFrame& frame = scenario_.frames.back();
      choose("frame " + frame.name, stated_frame(each), each.place);
    }
    read_measures(table_, scenario_);
    read_contributions(table_, scenario_);
    if (const auto* const output = table_.table("output")) {
      if (const auto* const report = output->find("report")) scenario_.report = named(*report, ".html");
      if (const auto* const csv = output->find("csv")) scenario_.csv = named(*csv, ".csv");
    }
    return std::move(scenario_);
  }

 private:
  void choose(const std::string& what, const std::string& value, const Place& by) {
    scenario_.choices.push_back({what, value, by.line_text()});
  }

  void add_input(const std::filesystem::path& file) {
    auto& all = scenario_.inputs;
    if (std::find(all.begin(), all.end(), file) == all.end()) all.push_back(file);
  }

  static std::filesystem::path named(const ScenarioValue& value, const std::string& ending) {
    const std::filesystem::path file = value.text();
    if (ending_of(file) != ending)
      refuse(value.place, "'" + value.path + "' is '" + file.string() + "'; the name must end in " + ending);
    return file;
  }

  void read_time() {
    const auto* const time = table_.table("time");
    if (!time) return;
    scenario_.time_place = time->place;
    const auto *start = time->find("start"), *end = time->find("end"), *step = time->find("step");
    if (start) scenario_.start = start->as<Epoch>();
    if (end) scenario_.end = end->as<Epoch>();
    if (start && end && !(*scenario_.start < *scenario_.end))
      refuse(end->place, "'time.end' is " + scenario_.end->utc() + " UTC, not after 'time.start', " +
                             scenario_.start->utc() + " UTC");
    if (step) {
      scenario_.step = positive(*step, "s");
      choose("instants",
             "each " + step->as<Amount>().text() +
                 ", the attitude turning at a constant rate between its samples",
             step->place);
    }
  }

  void read_attitude() {
    const ScenarioTable& from = *table_.table("attitude");
    const auto& file = from.at("file");
    scenario_.attitude.file = file.text();
    Selection& selection = scenario_.attitude.selection;
    selection.segment_word = "segment = NUMBER in [attitude]";
    if (!scenario_.step) {
      selection.from = scenario_.start;
      selection.until = scenario_.end;
    }
    if (const auto* const gap = from.find("gap")) {
      scenario_.gap = positive(*gap, "s");
      choose("gaps", "steps longer than " + gap->as<Amount>().text(), gap->place);
    }
    if (is_kernel(file.text())) {
      read_kernel_words(from);
      return;
    }
    refuse_keys(from, {"clock", "frames", "kernel_frame", "leap_seconds"},
                "is of a kernel of SPICE; " + file.text() + " is none");
    if (is_stored_result(file.text())) {
      const std::string is = file.text() + " is a stored result and says it itself";
      refuse_keys(from, {"segment"}, "is of a message; " + is);
      refuse_keys(from, {"time", "quaternion", "rates"}, "is of a table; " + is);
      return;
    }
    if (is_message(file.text())) {
      refuse_keys(from, {"time", "quaternion", "rates"},
                  "is of a table; " + file.text() + " is a message and says it itself");
      if (const auto* const segment = from.find("segment")) selection.segment = segment->as<std::size_t>();
      return;
    }
    refuse_keys(from, {"segment"}, "is of a message; " + file.text() + " is a table");
    want_keys(from, {"time", "quaternion"}, "a table");
    read_columns(from);
  }

  void read_kernel_words(const ScenarioTable& from) {
    const std::string is = scenario_.attitude.file.string() + " is a kernel of SPICE and says it itself";
    refuse_keys(from, {"segment"}, "is of a message; " + is);
    refuse_keys(from, {"time", "quaternion", "rates"}, "is of a table; " + is);
    want_keys(from, {"clock"}, "a kernel of SPICE");
    KernelWords words;
    words.frame_word = "kernel_frame = \"NAME\" in [attitude]";
    const auto take = [&](const char* key, const char* what, std::string& word) {
      const auto* const given = from.find(key);
      if (!given) return;
      word = given->text();
      choose(what, word, given->place);
    };
    take("clock", "clock of the attitude", words.clock);
    take("frames", "names of the frames of the attitude", words.frames);
    take("kernel_frame", "frame of the attitude", words.frame);
    if (const auto* const stated = from.find("kernel_frame")) words.frame_place = stated->place.text() + ": ";
    take("leap_seconds", "leap seconds", words.leap_seconds);
    scenario_.attitude.kernel = words;
  }

  void read_columns(const ScenarioTable& from) {
    TableColumns columns;
    read_time_column(*from.table("time"), scenario_.attitude.file, columns.time, columns.scale);
    const ScenarioTable& quaternion = *from.table("quaternion");
    columns.quaternion = columns_of(quaternion.at("columns"), scenario_.attitude.file);
    const auto& scalar = quaternion.at("scalar");
    const ScenarioTable& maps = *quaternion.table("maps");
    const auto &map_from = maps.at("from"), &map_to = maps.at("to");
    const auto reference_from = reference_name(map_from.text()), reference_to = reference_name(map_to.text());
    if (reference_from.has_value() == reference_to.has_value())
      refuse(maps.place,
             "'" + map_from.text() + "' and '" + map_to.text() +
                 (reference_from ? "' are both references; one of them must be the body"
                                 : std::string("' are both bodies; one of them must be a reference: ") +
                                       reference_names()));
    columns.reference = reference_from ? *reference_from : *reference_to;
    scenario_.body = reference_from ? map_to.text() : map_from.text();
    columns.stated = {scalar.text() == "first" ? Scalar::first : Scalar::last,
                      reference_from ? Maps::to_body : Maps::to_reference};
    choose("quaternions of the attitude",
           "v_" + map_to.text() + " = R(q) v_" + map_from.text() + ", the scalar is " + scalar.text(),
           maps.place);
    if (const auto* const rates = from.table("rates")) read_rates(*rates, columns);
    require_different(from, columns);
    scenario_.attitude.columns = columns;
  }

  // The columns that a value names.
  std::vector<std::string> columns_of(const ScenarioValue& value, const std::filesystem::path& file) {
    const auto& names = value.as<std::vector<std::string>>();
    for (const std::string& name : names) scenario_.columns.push_back({file, name, value.place});
    return names;
  }
  void read_time_column(const ScenarioTable& from, const std::filesystem::path& file, std::string& column,
                        TimeScale& scale) {
    column = from.at("column").text();
    scenario_.columns.push_back({file, column, from.at("column").place});
    scale = scales().at(small(from.at("scale").text()));
    choose("times of " + from.path.substr(0, from.path.find('.')),
           "column " + column + ", " + from.at("scale").text(), from.place);
  }

  void read_rates(const ScenarioTable& rates, TableColumns& columns) {
    columns.rates = columns_of(rates.at("columns"), scenario_.attitude.file);
    columns.rates_in_degrees = rates.at("unit").text() == "deg/s";
    const auto &of = rates.at("of"), &relative_to = rates.at("relative_to"), &in = rates.at("in");
    scenario_.rates =
        StatedRates{of.place, relative_to.place, in.place, of.text(), relative_to.text(), in.text()};
    if (reference_name(relative_to.text()) != columns.reference)
      refuse(relative_to.place, "the rates are relative to '" + relative_to.text() +
                                    "', the quaternions to " + columns.reference +
                                    "; both must be relative to one frame");
    if (const auto axes = reference_name(in.text())) {
      if (*axes != columns.reference)
        refuse(in.place, "the rates are in the axes of " + in.text() + "; it must be " + columns.reference +
                             " or a frame fixed in the body");
      columns.rate_axes = RateAxes::reference;
    }
    choose("rates of the file",
           "of " + of.text() + " relative to " + relative_to.text() + " in " + in.text() + ", " +
               rates.at("unit").text(),
           rates.place);
  }

  static void require_different(const ScenarioTable& from, const TableColumns& columns) {
    std::vector<std::string> all{columns.time};
    all.insert(all.end(), columns.quaternion.begin(), columns.quaternion.end());
    all.insert(all.end(), columns.rates.begin(), columns.rates.end());
    std::sort(all.begin(), all.end());
    if (const auto twice = std::adjacent_find(all.begin(), all.end()); twice != all.end())
      refuse(from.place, "the column '" + *twice + "' is named twice");
  }

  void read_orbit(const ScenarioTable& from) {
    const auto& file = one_of(from, {"tle", "omm", "oem", "spk", "table"});
    OrbitSource source;
    source.orientation = scenario_.orientation;
    source.interpolation.word = "interpolation = { method = \"hermite\", degree = 7 } in [orbit]";
    if (const auto* const given = from.table("interpolation")) {
      const auto& degree = given->at("degree");
      source.interpolation.value =
          Interpolation{given->at("method").text() == "hermite" ? "HERMITE" : "LAGRANGE",
                        static_cast<int>(std::min<std::size_t>(degree.as<std::size_t>(), 1000))};
      require_degree(degree.place.text() + ": ", *source.interpolation.value);
      choose("interpolation of the orbit", source.interpolation.value->name(), given->place);
    }
    const bool is_table = file.path == "orbit.table";
    if (!is_table)
      refuse_keys(from, {"time", "position", "velocity", "unit", "frame"},
                  "is of a table, '" + file.path + "' is given");
    const bool has_elements = file.path == "orbit.tle" || file.path == "orbit.omm";
    if (!has_elements) refuse_keys(from, {"satellite"}, "is of elements, '" + file.path + "' is given");
    source.satellite.word = "satellite = \"NUMBER\" in [orbit]";
    if (const auto* const given = from.find("satellite")) {
      source.satellite.value = given->text();
      choose("satellite of the orbit", given->text(), given->place);
    }
    if (has_elements || file.path == "orbit.spk") {
      refuse_keys(from, {"interpolation"}, "is of a table or an OEM, '" + file.path + "' is given");
      (file.path == "orbit.tle"   ? source.elements
       : file.path == "orbit.omm" ? source.mean_elements
                                  : source.kernel) = file.text();
    } else if (!is_table) {
      source.message = file.text();
    } else {
      want_keys(from, {"time", "position", "velocity", "unit", "frame", "interpolation"}, "a table");
      source.table = orbit_table(from, file.text());
    }
    scenario_.orbit = source;
  }

  OrbitFile orbit_table(const ScenarioTable& from, const std::string& file) {
    OrbitColumns columns;
    read_time_column(*from.table("time"), file, columns.time, columns.scale);
    columns.position = columns_of(from.at("position"), file);
    columns.velocity = columns_of(from.at("velocity"), file);
    columns.in_kilometres = from.at("unit").text() == "km";
    const auto& frame = from.at("frame");
    columns.reference = inertial(frame.text()).value_or(frame.text());
    if (columns.reference == "ITRF" && !scenario_.orientation)
      refuse(
          frame.place,
          "an orbit in ITRF needs the orientation of the Earth; missing: orientation = \"FILE\" in [earth]");
    choose("orbit", "in " + frame.text() + ", observed from it, " + from.at("unit").text(), frame.place);
    return {file, columns, {}};
  }

  ScenarioTable table_;
  Scenario scenario_;
};

}  // namespace

void require_columns(const Scenario& scenario) {
  std::map<std::filesystem::path, std::vector<std::string>> tables;
  for (const NamedColumn& column : scenario.columns) {
    const auto known = tables.find(column.file);
    const auto& names =
        known != tables.end()
            ? known->second
            : tables.emplace(column.file, CsvTable::read(column.file, {}).columns()).first->second;
    if (std::find(names.begin(), names.end(), column.name) == names.end())
      refuse(column.place,
             column.file.string() + " has no column '" + column.name + "'" + instead_of(column.name, names));
  }
}

Scenario read_scenario(const std::filesystem::path& file) {
  return Reader(file).read();
}

}  // namespace vectrix::cli
