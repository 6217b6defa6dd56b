#include "scenario/scenario.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "figures.hpp"
#include "plain_words.hpp"
#include "scales.hpp"
#include "scenario/fixed_frame.hpp"
#include "scenario/table.hpp"
#include "table_text.hpp"

namespace vectrix::cli {
namespace {

using Scalar = Convention::Scalar;
using Maps = Convention::Maps;

const std::map<std::string, SkyCorrection> corrections{
    {"geometric", geometric}, {"light_time", light_time}, {"apparent", apparent}};
const std::map<std::string, Target> targets{{"sun", Target::sun},
                                            {"moon", Target::moon},
                                            {"earth", Target::earth},
                                            {"velocity relative to gcrf", Target::velocity},
                                            {"velocity relative to itrf", Target::velocity_in_itrf}};

std::string line_of(const Place& place) {
  return place.file + ':' + std::to_string(place.line);
}

// The one of these keys that is given.
const ScenarioValue& one_of(const ScenarioTable& table, const std::vector<std::string_view>& keys) {
  const ScenarioValue* given = nullptr;
  for (const std::string_view key : keys) {
    const auto* const found = table.find(key);
    if (!found) continue;
    if (given)
      refuse(found->place, "'" + found->path + "' and '" + given->path + "' are both given; one is needed");
    given = found;
  }
  if (!given) refuse(table.place, "'" + table.path + "' needs one of: " + listed(keys));
  return *given;
}

// None of these keys, for `why`.
void refuse_keys(const ScenarioTable& table, const std::vector<std::string_view>& keys,
                 const std::string& why) {
  for (const std::string_view key : keys)
    if (const auto* const found = table.find(key)) refuse(found->place, "'" + found->path + "' " + why);
}
void require_keys(const ScenarioTable& table, const std::vector<std::string_view>& keys,
                  const std::string& of) {
  for (const std::string_view key : keys)
    if (!table.find(key))
      refuse(table.place, "'" + table.path + '.' + std::string(key) + "' is missing: " + of + " needs it");
}

Quantity<si::angle> angle(const ScenarioTable& table, std::string_view key) {
  return table.at(key).as<Amount>().in("rad") * si::radian;
}

double positive(const ScenarioValue& value, std::string_view unit) {
  const auto& amount = value.as<Amount>();
  if (!(amount.in(unit) > 0.0))
    refuse(value.place, "'" + value.path + "' is " + amount.text() + "; it must be above 0");
  return amount.in(unit);
}

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : table_(read_scenario_table(file)) {
    scenario_.file = file.string();
    scenario_.title = table_.at("title").text();
  }

  Scenario read() {
    collect_inputs(table_);
    read_time();
    if (const auto* const earth = table_.table("earth")) {
      const auto& value = earth->at("orientation");
      add_input(value.text());
      scenario_.orientation = EarthOrientation::read(value.text());
      choose("orientation of the Earth", value.text(), value.place);
    }
    read_attitude();
    if (const auto* const orbit = table_.table("orbit")) read_orbit(*orbit);
    for (const ScenarioTable& each : table_.tables("frame")) {
      scenario_.frames.push_back(fixed_frame(each));
      const FixedFrame& frame = scenario_.frames.back();
      choose("frame " + frame.name, stated_frame(each), each.place);
    }
    read_measures();
    for (const ScenarioTable& each : table_.tables("require"))
      scenario_.requirements.push_back(requirement(each));
    if (const auto* const output = table_.table("output")) {
      if (const auto* const report = output->find("report")) scenario_.report = named(*report, ".html");
      if (const auto* const csv = output->find("csv")) scenario_.csv = named(*csv, ".csv");
    }
    return std::move(scenario_);
  }

 private:
  void choose(const std::string& what, const std::string& value, const Place& by) {
    scenario_.choices.push_back({what, value, line_of(by)});
  }

  void collect_inputs(const ScenarioTable& table) {
    add_input(table.place.file);
    for (const auto& [name, value] : table.values)
      if (const auto* const parts = std::get_if<std::vector<ScenarioTable>>(&value.value))
        for (const ScenarioTable& part : *parts) collect_inputs(part);
  }
  void add_input(const std::filesystem::path& file) {
    auto& all = scenario_.inputs;
    if (std::find(all.begin(), all.end(), file) == all.end()) all.push_back(file);
  }

  static std::filesystem::path named(const ScenarioValue& value, const std::string& ending) {
    const std::filesystem::path file = value.text();
    if (file.extension() != ending)
      refuse(value.place, "'" + value.path + "' is '" + file.string() + "'; the name must end in " + ending);
    return file;
  }

  void read_time() {
    const auto* const time = table_.table("time");
    if (!time) return;
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
    add_input(file.text());
    scenario_.attitude.file = file.text();
    scenario_.attitude_place = file.place;
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
    if (is_message(file.text())) {
      refuse_keys(from, {"time", "quaternion", "rates"},
                  "is of a table; " + file.text() + " is a message and says it itself");
      if (const auto* const segment = from.find("segment")) selection.segment = segment->as<std::size_t>();
      return;
    }
    refuse_keys(from, {"segment"}, "is of a message; " + file.text() + " is a table");
    require_keys(from, {"time", "quaternion"}, "a table");
    read_columns(from);
  }

  void read_columns(const ScenarioTable& from) {
    TableColumns columns;
    read_time_column(*from.table("time"), columns.time, columns.scale);
    const ScenarioTable& quaternion = *from.table("quaternion");
    columns.quaternion = quaternion.at("columns").as<std::vector<std::string>>();
    const auto& scalar = quaternion.at("scalar");
    const ScenarioTable& maps = *quaternion.table("maps");
    const auto &map_from = maps.at("from"), &map_to = maps.at("to");
    const auto reference_from = inertial(map_from.text()), reference_to = inertial(map_to.text());
    if (reference_from.has_value() == reference_to.has_value())
      refuse(maps.place,
             "'" + map_from.text() + "' and '" + map_to.text() +
                 (reference_from ? "' are both references; one of them must be the body"
                                 : "' are both bodies; one of them must be J2000, EME2000, GCRF or ICRF"));
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

  void read_time_column(const ScenarioTable& from, std::string& column, TimeScale& scale) {
    column = from.at("column").text();
    scale = scales().at(small(from.at("scale").text()));
    choose("times of " + from.path.substr(0, from.path.find('.')),
           "column " + column + ", " + from.at("scale").text(), from.place);
  }

  void read_rates(const ScenarioTable& rates, TableColumns& columns) {
    columns.rates = rates.at("columns").as<std::vector<std::string>>();
    columns.rates_in_degrees = rates.at("unit").text() == "deg/s";
    const auto &of = rates.at("of"), &relative_to = rates.at("relative_to"), &in = rates.at("in");
    scenario_.rates =
        StatedRates{of.place, relative_to.place, in.place, of.text(), relative_to.text(), in.text()};
    if (inertial(relative_to.text()) != columns.reference)
      refuse(relative_to.place, "the rates are relative to '" + relative_to.text() +
                                    "', the quaternions to " + columns.reference +
                                    "; both must be relative to one frame");
    if (const auto axes = inertial(in.text())) {
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
    const auto& file = one_of(from, {"tle", "oem", "table"});
    add_input(file.text());
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
    if (file.path == "orbit.tle") {
      refuse_keys(from, {"interpolation"}, "is of a table or an OEM, 'orbit.tle' is given");
      source.elements = file.text();
    } else if (!is_table) {
      source.message = file.text();
    } else {
      require_keys(from, {"time", "position", "velocity", "unit", "frame", "interpolation"}, "a table");
      source.table = orbit_table(from, file.text());
    }
    scenario_.orbit = source;
  }

  OrbitFile orbit_table(const ScenarioTable& from, const std::string& file) {
    OrbitColumns columns;
    read_time_column(*from.table("time"), columns.time, columns.scale);
    columns.position = from.at("position").as<std::vector<std::string>>();
    columns.velocity = from.at("velocity").as<std::vector<std::string>>();
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

  void read_measures() {
    std::map<std::string, MeasureTarget> named;
    for (const auto& [name, target] : targets) named.emplace(name, target);
    const auto add = [&](const ScenarioTable& from, const MeasureTarget& target) {
      const auto& name = from.at("name");
      if (!named.emplace(small(name.text()), target).second)
        refuse(name.place, "there are two targets '" + name.text() + "'");
    };
    for (const ScenarioTable& each : table_.tables("star")) add(each, star(each));
    for (const ScenarioTable& each : table_.tables("station")) add(each, station(each));
    for (const ScenarioTable& each : table_.tables("measure")) {
      const auto& name = each.at("name");
      for (const Measure& other : scenario_.measures)
        if (other.name == name.text()) refuse(name.place, "there are two measures '" + name.text() + "'");
      scenario_.measures.push_back(measure(each, named));
    }
  }

  static StarTarget star(const ScenarioTable& from) {
    const RightAscensionDeclination at{angle(from, "right_ascension"), angle(from, "declination")};
    require_latitude(from.at("declination"));
    return {from.at("name").text(), at};
  }
  StationTarget station(const ScenarioTable& from) const {
    require_latitude(from.at("latitude"));
    const auto& longitude = from.at("longitude");
    if (!(std::abs(longitude.as<Amount>().in("deg")) <= 360.0))
      refuse(longitude.place,
             "'" + longitude.path + "' is " + longitude.as<Amount>().text() + ", more than a turn");
    if (!scenario_.orientation)
      refuse(from.place,
             "a station needs the orientation of the Earth; missing: orientation = \"FILE\" in [earth]");
    return {from.at("name").text(),
            {GeodeticLatitude(angle(from, "latitude")), angle(from, "longitude"),
             from.at("height").as<Amount>().in("m") * si::metre}};
  }
  static void require_latitude(const ScenarioValue& value) {
    if (!(std::abs(value.as<Amount>().in("deg")) <= 90.0))
      refuse(value.place, "'" + value.path + "' is " + value.as<Amount>().text() + "; it is at most 90 deg");
  }

  Measure measure(const ScenarioTable& from, const std::map<std::string, MeasureTarget>& named) {
    const auto &target = from.at("target"), &axis = from.at("axis");
    const auto found = named.find(small(target.text()));
    if (found == named.end()) {
      std::vector<std::string_view> names;
      for (const auto& [name, value] : named) names.push_back(name);
      refuse(target.place, "there is no target '" + target.text() + "'" + instead_of(target.text(), names));
    }
    Measure made{from.place, from.at("name").text(), fixed_axis(axis), target.place, found->second};
    const auto* const plain = std::get_if<Target>(&made.target);
    const bool is_star = std::holds_alternative<StarTarget>(made.target);
    const auto* const correction = from.find("correction");
    if (correction) {
      if (!is_star && !(plain && is_in_sky(*plain)))
        refuse(correction->place, "'" + correction->path + "' is of the Sun, the Moon and stars");
      if (is_star && correction->text() == "geometric")
        refuse(
            correction->place,
            "a catalogue says where a star is seen, not where it is; needed: \"light_time\" or \"apparent\"");
      made.correction = corrections.at(correction->text());
    } else if (is_star || (plain && is_in_sky(*plain))) {
      refuse(from.place, "'measure.correction' is missing: " + target.text() +
                             " is not where it is seen; one of: " + (is_star ? "" : "\"geometric\", ") +
                             "\"light_time\", \"apparent\"");
    }
    if (!scenario_.orbit && !(plain && *plain == Target::sun))
      refuse(target.place, "the direction of " + target.text() + " needs an orbit; missing: [orbit]");
    if (made.correction) choose("correction of " + made.name, words_of(*made.correction), correction->place);
    return made;
  }

  Requirement requirement(const ScenarioTable& from) const {
    const auto& measure = from.at("measure");
    std::vector<std::string_view> names;
    for (const Measure& each : scenario_.measures) names.push_back(each.name);
    const auto found = std::find(names.begin(), names.end(), measure.text());
    if (found == names.end())
      refuse(measure.place,
             "there is no measure '" + measure.text() + "'" + instead_of(measure.text(), names));
    const auto& limit = one_of(from, {"absolute", "relative"});
    const auto& percent = from.at("percent");
    Requirement made{from.place, static_cast<std::size_t>(found - names.begin()), positive(limit, "deg"),
                     positive(percent, "%")};
    if (made.degrees > 180.0)
      refuse(limit.place, "'" + limit.path + "' is " + limit.as<Amount>().text() + "; it is at most 180 deg");
    if (made.percent > 100.0)
      refuse(percent.place,
             "'" + percent.path + "' is " + percent.as<Amount>().text() + "; it is at most 100 %");
    const bool is_relative = limit.path == "require.relative";
    const auto* const window = from.find("window");
    if (is_relative) {
      if (!window)
        refuse(from.place,
               "'require.window' is missing: a relative error is over a window, as window = \"60 s\"");
      made.window = positive(*window, "s");
    } else if (window) {
      refuse(window->place, "'require.window' is of a relative error; this one is absolute");
    }
    std::string condition;
    if (const auto* const when = from.find("when")) {
      made.when = when->text() == "sunlight" ? When::sunlight : When::shadow;
      condition = " in " + when->text();
      if (!scenario_.orbit)
        refuse(when->place, "whether it is in " + when->text() + " needs an orbit; missing: [orbit]");
    }
    made.text = (is_relative ? "relative error in " + window->as<Amount>().text() : "absolute error") +
                " at most " + limit.as<Amount>().text() + " in " + percent.as<Amount>().text() + " of the " +
                (is_relative ? "windows" : "samples") + condition;
    return made;
  }

  ScenarioTable table_;
  Scenario scenario_;
};

}  // namespace

Scenario read_scenario(const std::filesystem::path& file) {
  return Reader(file).read();
}

}  // namespace vectrix::cli
