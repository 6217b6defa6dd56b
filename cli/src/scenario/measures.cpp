#include "scenario/measures.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "figures.hpp"
#include "scenario/fixed_frame.hpp"
#include "scenario/given.hpp"
#include "table_text.hpp"
#include "word.hpp"

namespace vectrix::cli {
namespace {

const std::map<std::string, Target> targets{{"sun", Target::sun},
                                            {"moon", Target::moon},
                                            {"earth", Target::earth},
                                            {"velocity relative to gcrf", Target::velocity},
                                            {"velocity relative to itrf", Target::velocity_in_itrf}};

class MeasureReader {
 public:
  MeasureReader(const ScenarioTable& table, Scenario& scenario) : table_(table), scenario_(scenario) {}

  void read() {
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
    for (const ScenarioTable& each : table_.tables("require"))
      scenario_.requirements.push_back(requirement(each));
  }

 private:
  StarTarget star(const ScenarioTable& from) const {
    require_at_most_a_turn(from.at("right_ascension"));
    const RightAscensionDeclination at{angle_of(from, "right_ascension"), angle_of(from, "declination")};
    require_latitude(from.at("declination"));
    const std::string name = from.at("name").text();
    const ScenarioTable* const proper = from.table("proper_motion");
    scenario_.choices.push_back(
        proper ? Report::Choice{"motion of " + name, "its proper motion", proper->place.line_text()}
               : Report::Choice{"motion of " + name, "none: no proper motion is given", "the program"});
    return {name, at, proper ? std::optional(star_motion(*proper, at.declination.value())) : std::nullopt};
  }
  static StarMotion star_motion(const ScenarioTable& from, double declination) {
    const auto rate = [&](const char* key) { return from.at(key).as<Amount>().in("arcsec/yr"); };
    const auto* const parallax = from.find("parallax");
    const double arcseconds = parallax ? parallax->as<Amount>().in("arcsec") : 0.0;
    if (!is_parallax(arcseconds))
      refuse(parallax->place, "'star.proper_motion.parallax' is " + parallax->as<Amount>().text() +
                                  "; it is from 0 to 1 arcsec");
    const Eigen::Vector2d moves(rate("right_ascension"), rate("declination"));
    const bool is_included = from.at("cos_declination").text() == "included";
    if (!is_proper_motion(moves, is_included, declination))
      refuse(from.place,
             "'star.proper_motion' is more than 10.4 arcsec/yr, that of Barnard's star, the fastest");
    return cli::star_motion(moves, is_included, arcseconds, from.at("epoch").as<Epoch>());
  }
  StationTarget station(const ScenarioTable& from) const {
    require_latitude(from.at("latitude"));
    require_at_most_a_turn(from.at("longitude"));
    if (!scenario_.orientation)
      refuse(from.place,
             "a station needs the orientation of the Earth; missing: orientation = \"FILE\" in [earth]");
    return {from.at("name").text(),
            {GeodeticLatitude(angle_of(from, "latitude")), angle_of(from, "longitude"),
             from.at("height").as<Amount>().in("m") * si::metre}};
  }
  static void require_at_most_a_turn(const ScenarioValue& value) {
    if (!(std::abs(value.as<Amount>().in("deg")) <= most_of_a_longitude))
      refuse(value.place, "'" + value.path + "' is " + value.as<Amount>().text() + ", more than a turn");
  }
  static void require_latitude(const ScenarioValue& value) {
    if (!(std::abs(value.as<Amount>().in("deg")) <= most_of_a_latitude))
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
    const auto names = corrections_of(made.target);
    const std::string possible = '"' + joined(names, "\", \"") + '"';
    const auto* const correction = from.find("correction");
    if (correction) {
      if (names.empty())
        refuse(correction->place, "'" + correction->path + "' is of the Sun, the Moon and stars");
      if (possible.find(correction->text()) == std::string::npos)
        refuse(correction->place,
               "a catalogue says where a star is seen, not where it is; needed one of: " + possible);
      made.correction = corrections().at(correction->text());
    } else if (!names.empty()) {
      refuse(from.place, "'measure.correction' is missing: " + target.text() +
                             " is not where it is seen; one of: " + possible);
    }
    if (!scenario_.orbit && needs_orbit(made.target))
      refuse(target.place, "the direction of " + target.text() + " needs an orbit; missing: [orbit]");
    made.when = when(from, made.target);
    if (made.correction)
      scenario_.choices.push_back(
          {"correction of " + made.name, words_of(*made.correction), correction->place.line_text()});
    return made;
  }

  When when(const ScenarioTable& from, const MeasureTarget& target) const {
    const auto* const value = from.find("when");
    if (!value) return When::always;
    const When when = when_of(value->text());
    try {
      require_known(when, target, scenario_.orbit.has_value(), "[orbit]");
    } catch (const BadInput& error) {
      refuse(value->place, error.what());
    }
    return when;
  }

  Requirement requirement(const ScenarioTable& from) const {
    const auto& measure = from.at("measure");
    std::vector<std::string_view> names;
    for (const Measure& each : scenario_.measures) names.push_back(each.name);
    const auto found = std::find(names.begin(), names.end(), measure.text());
    if (found == names.end())
      refuse(measure.place,
             "there is no measure '" + measure.text() + "'" + instead_of(measure.text(), names));
    const auto& limit = one_of(from, {"absolute", "relative", "budget"});
    const auto& percent = from.at("percent");
    Requirement made{from.place, static_cast<std::size_t>(found - names.begin()), 0.0,
                     positive(percent, "%")};
    made.by_budget = limit.path == "require.budget";
    if (!made.by_budget) made.degrees = positive(limit, "deg");
    if (made.degrees > 180.0)
      refuse(limit.place, "'" + limit.path + "' is " + limit.as<Amount>().text() + "; it is at most 180 deg");
    if (made.percent > 100.0)
      refuse(percent.place,
             "'" + percent.path + "' is " + percent.as<Amount>().text() + "; it is at most 100 %");
    const bool is_relative = made.by_budget ? limit.text() == "relative" : limit.path == "require.relative";
    const auto* const window = from.find("window");
    if (is_relative) {
      if (!window)
        refuse(from.place,
               "'require.window' is missing: a relative error is over a window, as window = \"60 s\"");
      made.window = positive(*window, "s");
    } else if (window) {
      refuse(window->place, "'require.window' is of a relative error; this one is absolute");
    }
    const Measure& of = scenario_.measures[made.measure];
    made.when = of.when;
    if (from.find("when")) {
      made.when = when(from, of.target);
      if (of.when != When::always && made.when != of.when)
        refuse(from.at("when").place, "'require.when' is \"" + from.at("when").text() + "\", and '" +
                                          of.name + "' is measured only" + words_of(of.when));
    }
    made.text = (is_relative ? "relative error in " + window->as<Amount>().text() : "absolute error") +
                " at most " + (made.by_budget ? "that of the budget" : limit.as<Amount>().text()) + " in " +
                percent.as<Amount>().text() + " of the " +
                (is_relative && !made.by_budget ? "windows" : "samples") + words_of(made.when);
    return made;
  }

  const ScenarioTable& table_;
  Scenario& scenario_;
};

}  // namespace

void read_measures(const ScenarioTable& table, Scenario& scenario) {
  MeasureReader(table, scenario).read();
}

}  // namespace vectrix::cli
