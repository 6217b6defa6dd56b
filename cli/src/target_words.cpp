#include "target_words.hpp"

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
  const Words of_station{{"--latitude DEGREES", words.latitude},
                         {"--longitude DEGREES", words.longitude},
                         {"--height METRES", words.height}};
  const std::string other = ", and the target is " + words.target;
  if (words.target != "star") refuse(of_star, "", " is of a star" + other);
  if (words.target != "station") refuse(of_station, "", " is of a station" + other);
  if (words.target == "star") {
    require(of_star, words.target);
    return StarTarget{"the star at right ascension " + words.right_ascension + " deg, declination " +
                          words.declination + " deg",
                      {angle("--right-ascension", words.right_ascension, most_of_a_longitude),
                       angle("--declination", words.declination, most_of_a_latitude)}};
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
