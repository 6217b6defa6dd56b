#include "target_words.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "figures.hpp"
#include "word.hpp"

namespace vectrix::cli {
namespace {

const std::map<std::string, Target> plain_targets{{"sun", Target::sun},
                                                  {"moon", Target::moon},
                                                  {"earth", Target::earth},
                                                  {"velocity", Target::velocity},
                                                  {"velocity_in_itrf", Target::velocity_in_itrf}};

Quantity<si::angle> angle(const char* option, const std::string& text, double most) {
  const auto number = number_of<double>(text);
  if (!number || !(std::abs(*number) <= most))
    throw BadInput(std::string(option) + ' ' + text + " is no number of degrees from -" + detail::text(most) +
                   " to " + detail::text(most));
  return *number / degrees * si::radian;
}

Quantity<si::length> height(const std::string& metres) {
  const auto number = number_of<double>(metres);
  if (!number || !std::isfinite(*number))
    throw BadInput("--height " + metres + " is no finite number of metres");
  return *number * si::metre;
}

void require(const Words& words, const std::string& target) {
  if (const std::string missing = missing_of(words); !missing.empty())
    throw BadInput("--target " + target + " is not all; missing: " + missing);
}

double milliarcseconds(const char* option, const std::string& text) {
  const auto number = number_of<double>(text);
  if (!number || !std::isfinite(*number))
    throw BadInput(std::string(option) + ": '" + text + "' is no finite number of milliarcseconds");
  return *number;
}

// Nothing if it is not said how the star moves.
std::optional<StarMotion> motion_of(const TargetWords& words, double declination) {
  const Words needed{{"--proper-motion MAS,MAS", words.proper_motion},
                     {"--cos-declination included|not_included", words.cos_declination},
                     {"--epoch TIME", words.epoch}};
  const std::string missing = missing_of(needed);
  const auto is_empty = [](const Word& word) { return word.text.empty(); };
  if (words.parallax.empty() && std::all_of(needed.begin(), needed.end(), is_empty)) return std::nullopt;
  if (!missing.empty()) throw BadInput("the motion of the star is not all; missing: " + missing);
  const auto rates = fields("--proper-motion", words.proper_motion, 2);
  constexpr double milli = 1e-3;
  const double parallax =
      words.parallax.empty() ? 0.0 : milli * milliarcseconds("--parallax", words.parallax);
  if (!is_parallax(parallax))
    throw BadInput("--parallax " + words.parallax + " is not from 0 to 1000 milliarcseconds");
  const Eigen::Vector2d moves(milli * milliarcseconds("--proper-motion", rates[0]),
                              milli * milliarcseconds("--proper-motion", rates[1]));
  const bool is_included = words.cos_declination == "included";
  if (!is_proper_motion(moves, is_included, declination))
    throw BadInput("--proper-motion " + words.proper_motion +
                   " is more than 10400 milliarcseconds in a year, " + "that of Barnard's star, the fastest");
  return star_motion(moves, is_included, parallax, Epoch::from(words.epoch));
}

}  // namespace

std::vector<std::string> plain_target_names() {
  std::vector<std::string> names;
  for (const auto& [name, target] : plain_targets) names.push_back(name);
  return names;
}

std::vector<std::string> target_names() {
  std::vector<std::string> names = plain_target_names();
  names.insert(names.end(), {"star", "station"});
  return names;
}

Eigen::Vector3d axis_of(const std::string& text) {
  Eigen::Vector3d axis;
  const auto numbers = fields("--axis", text, 3);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto number = number_of<double>(numbers[i]);
    if (!number) throw BadInput("--axis " + text + ": '" + numbers[i] + "' is no number");
    axis[static_cast<Eigen::Index>(i)] = *number;
  }
  return axis;
}

MeasureTarget target_of(const TargetWords& words) {
  const Words of_star{{"--right-ascension DEGREES", words.right_ascension},
                      {"--declination DEGREES", words.declination}};
  const Words of_its_motion{{"--proper-motion", words.proper_motion},
                            {"--cos-declination", words.cos_declination},
                            {"--epoch", words.epoch},
                            {"--parallax", words.parallax}};
  const Words of_station{{"--latitude DEGREES", words.latitude},
                         {"--longitude DEGREES", words.longitude},
                         {"--height METRES", words.height}};
  const std::string other = ", and the target is " + words.target;
  if (words.target != "star")
    for (const Words& each : {of_star, of_its_motion}) refuse(each, "", " is of a star" + other);
  if (words.target != "station") refuse(of_station, "", " is of a station" + other);
  if (words.target == "star") {
    require(of_star, words.target);
    const auto declination = angle("--declination", words.declination, most_of_a_latitude);
    const auto motion = motion_of(words, declination.value());
    return StarTarget{"the star at right ascension " + words.right_ascension + " deg, declination " +
                          words.declination + " deg" +
                          (motion ? " at " + words.epoch + ", with its proper motion"
                                  : ", standing still: no proper motion is given"),
                      {angle("--right-ascension", words.right_ascension, most_of_a_longitude), declination},
                      motion};
  }
  if (words.target == "station") {
    require(of_station, words.target);
    return StationTarget{"the station at latitude " + words.latitude + " deg, longitude " + words.longitude +
                             " deg, height " + words.height + " m",
                         {GeodeticLatitude(angle("--latitude", words.latitude, most_of_a_latitude)),
                          angle("--longitude", words.longitude, most_of_a_longitude), height(words.height)}};
  }
  return plain_targets.at(words.target);
}

}  // namespace vectrix::cli
