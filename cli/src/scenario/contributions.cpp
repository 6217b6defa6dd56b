#include "scenario/contributions.hpp"

#include <algorithm>

#include "plain_words.hpp"
#include "scenario/given.hpp"

namespace vectrix::cli {
namespace {

template <class U> Vector<ErrorFrame, U> numbers_of(const ScenarioValue& value, std::string_view unit) {
  const auto& amount = value.as<Amount>();
  return vector<U>(in<ErrorFrame>,
                   Eigen::Vector3d(amount.in(unit, 0), amount.in(unit, 1), amount.in(unit, 2)));
}

template <class U>
Covariance<ErrorFrame, U> covariance_of_deviations(const ScenarioValue& value, std::string_view unit) {
  const auto s = numbers_of<U>(value, unit);
  try {
    return covariance_from_standard_deviations(in<ErrorFrame>, s.x(), s.y(), s.z());
  } catch (const BadInput&) {
    refuse(value.place, "'" + value.path + "' is " + value.as<Amount>().text() +
                            "; each must be 0, or positive with a square that a number can hold");
  }
}

Covariance<ErrorFrame, si::angle> covariance_of_rows(const ScenarioTable& from) {
  const auto& rows = from.at("rows");
  const auto& n = rows.as<std::vector<double>>();
  const double unit = Amount::parse("1 " + from.at("unit").text(), Dimension::angle).in("rad");
  const Eigen::Matrix3d matrix = Eigen::Map<const Eigen::Matrix3d>(n.data()).transpose() * (unit * unit);
  try {
    return covariance<si::angle>(in<ErrorFrame>, matrix);
  } catch (const BadInput& error) {
    refuse(rows.place, "'" + rows.path + "': " + without_types(error.what()));
  }
}

Covariance<ErrorFrame, si::angle> covariance_of(const ScenarioTable& from, const ScenarioValue& given) {
  if (const auto* const stated = from.table("covariance")) return covariance_of_rows(*stated);
  return covariance_of_deviations<si::angle>(given, "rad");
}

Quantity<si::time> time_of(const ScenarioTable& from, std::string_view key) {
  return positive(from.at(key), "s") * si::second;
}

PointingError<ErrorFrame> error_of(const ScenarioTable& from) {
  const std::string& kind = from.at("kind").text();
  const std::string other = "is not of a " + kind + " error";
  if (kind == "drift") {
    refuse_keys(from, {"known", "standard_deviations", "covariance", "correlation_time"},
                "is not of a drift");
    want_keys(from, {"since_update"}, "a drift");
    const auto& given = one_of(from, {"known_rate", "standard_deviations_of_rate"});
    const auto since = time_of(from, "since_update");
    if (from.find("known_rate")) return drift_error(numbers_of<si::angular_velocity>(given, "rad/s"), since);
    return drift_error(covariance_of_deviations<si::angular_velocity>(given, "rad/s"), since);
  }
  refuse_keys(from, {"known_rate", "standard_deviations_of_rate", "since_update"}, other);
  if (kind == "random") {
    refuse_keys(from, {"known"}, other);
    want_keys(from, {"correlation_time"}, "a random error");
    const auto& given = one_of(from, {"standard_deviations", "covariance"});
    return random_error(covariance_of(from, given), time_of(from, "correlation_time"));
  }
  refuse_keys(from, {"correlation_time"}, other);
  const auto& given = one_of(from, {"known", "standard_deviations", "covariance"});
  if (from.find("known")) return constant_error(numbers_of<si::angle>(given, "rad"));
  return constant_error(covariance_of(from, given));
}

// "random, in tracker, standard_deviations [6, 6, 40] arcsec, correlation_time 2 s"
std::string stated_contribution(const ScenarioTable& from) {
  std::string all = from.at("kind").text() + ", in " + from.at("in").text();
  for (const char* const key : {"known", "standard_deviations", "known_rate", "standard_deviations_of_rate",
                                "correlation_time", "since_update"})
    if (const auto* const value = from.find(key))
      all += ", " + std::string(key) + ' ' + value->as<Amount>().text();
  if (from.find("covariance")) all += ", covariance";
  return all;
}

std::vector<std::size_t> measures_of(const ScenarioValue& value, const Scenario& scenario) {
  std::vector<std::string_view> names;
  for (const Measure& each : scenario.measures) names.push_back(each.name);
  std::vector<std::size_t> all;
  for (const std::string& name : value.as<std::vector<std::string>>()) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
      refuse(value.place, "there is no measure '" + name + "'" + instead_of(name, names));
    all.push_back(static_cast<std::size_t>(found - names.begin()));
    if (std::count(all.begin(), all.end(), all.back()) > 1)
      refuse(value.place, "'" + value.path + "' names '" + name + "' twice");
  }
  return all;
}

// That the figures of each budget can be given.
void require_figures(const ScenarioTable& from, const Contribution& made, const Scenario& scenario) {
  for (const std::size_t measure : made.measures) {
    bool is_required = false;
    for (const Requirement& required : scenario.requirements) {
      if (required.measure != measure) continue;
      is_required = true;
      if (!(0.01 * required.percent <= 1.0 - least_risk))
        refuse(required.place, "a budget has no figure for " + detail::text(required.percent) +
                                   " %: a normal distribution has no bound; at most " +
                                   detail::text(100.0 - 100.0 * least_risk) + " %");
      const auto* const since = from.find("since_update");
      if (required.window && since && *required.window > since->as<Amount>().in("s"))
        refuse(since->place, "'" + since->path + "' is " + since->as<Amount>().text() +
                                 ", shorter than the window of a requirement, " +
                                 detail::text(*required.window) + " s, at " + required.place.text());
    }
    if (!is_required)
      refuse(from.at("measures").place, "nothing is required of '" + scenario.measures[measure].name +
                                            "'; missing: a [[require]] that says for how many percent the "
                                            "figures of its budget are");
  }
}

}  // namespace

void read_contributions(const ScenarioTable& table, Scenario& scenario) {
  for (const ScenarioTable& from : table.tables("contribution")) {
    const auto &name = from.at("name"), &frame = from.at("in");
    for (const Contribution& other : scenario.contributions)
      if (other.name == name.text()) refuse(name.place, "there are two contributions '" + name.text() + "'");
    scenario.contributions.push_back({from.place, name.text(), measures_of(from.at("measures"), scenario),
                                      frame.place, frame.text(), from.at("kind").text(), error_of(from)});
    require_figures(from, scenario.contributions.back(), scenario);
    scenario.choices.push_back(
        {"contribution " + name.text(), stated_contribution(from), from.place.line_text()});
  }
  for (const Requirement& required : scenario.requirements) {
    const auto contributes = [&](const Contribution& each) {
      return std::find(each.measures.begin(), each.measures.end(), required.measure) != each.measures.end();
    };
    if (required.by_budget &&
        std::none_of(scenario.contributions.begin(), scenario.contributions.end(), contributes))
      refuse(required.place, "'" + scenario.measures[required.measure].name +
                                 "' has no budget; missing: a [[contribution]] to it");
  }
}

}  // namespace vectrix::cli
