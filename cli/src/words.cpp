#include "words.hpp"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "message_kind.hpp"
#include "scales.hpp"
#include "stored_attitude.hpp"
#include "table_text.hpp"
#include "viewer_text.hpp"
#include "word.hpp"

namespace vectrix::cli {
namespace {

Words only_of_attitudes(const AttitudeWords& words) {
  return {
      {"--quaternion", words.quaternion}, {"--scalar", words.scalar},       {"--maps", words.maps},
      {"--rates", words.rates},           {"--rate-unit", words.rate_unit}, {"--rate-axes", words.rate_axes}};
}
Words only_of_orbits(const OrbitWords& words) {
  return {{"--position", words.position}, {"--velocity", words.velocity}, {"--unit", words.unit}};
}

Words only_of_kernels(const AttitudeWords& words) {
  return {{"--sclk", words.kernel.clock},
          {"--fk", words.kernel.frames},
          {"--lsk", words.kernel.leap_seconds},
          {"--ck-frame", words.kernel.frame}};
}

void refuse_columns_of_message(const AttitudeWords& words) {
  const bool is_result = is_stored_result(words.file);
  const std::string is = words.file.string() + ": is a " + (is_result ? "stored result" : "message") +
                         " and says itself what its data are; ";
  if (is_result) refuse({{"--segment", words.segment}}, is, " is of a message");
  refuse({{"--time", words.time}, {"--scale", words.scale}, {"--reference", words.reference}}, is,
         " is of a table");
  refuse(only_of_attitudes(words), is, " is of a table");
}

template <class Number> Number whole_number(const char* option, const std::string& text) {
  const auto number = number_of<Number>(text);
  if (!number || *number < 1)
    throw BadInput(std::string(option) + ' ' + text + " is no whole number from 1 on");
  return *number;
}

Selection selection_of(const AttitudeWords& words) {
  Selection selection;
  if (!words.segment.empty()) selection.segment = whole_number<std::size_t>("--segment", words.segment);
  if (!words.from.empty()) selection.from = Epoch::from(words.from);
  if (!words.until.empty()) selection.until = Epoch::from(words.until);
  return selection;
}

void require_different(const std::filesystem::path& file, const std::string& time,
                       std::initializer_list<std::vector<std::string>> groups) {
  std::vector<std::string> all{time};
  for (const auto& group : groups) all.insert(all.end(), group.begin(), group.end());
  std::sort(all.begin(), all.end());
  if (const auto twice = std::adjacent_find(all.begin(), all.end()); twice != all.end())
    throw BadInput(file.string() + ": the column '" + *twice + "' is named twice by the options");
}

// What any table needs, and what those of this kind do.
void require_table(const AttitudeWords& words, const Words& of_its_kind) {
  const std::string file = words.file.string();
  refuse({{"--segment", words.segment}}, file + ": is a table; ", " is of a message");
  Words needed{{"--time COLUMN", words.time}, {"--scale utc|tai|tt|tdb|gps", words.scale}};
  for (const Word& word : of_its_kind) needed.push_back(word);
  needed.push_back({"--reference EME2000|GCRF", words.reference});
  if (const std::string missing = missing_of(needed); !missing.empty())
    throw BadInput(file + ": a table does not say what its columns mean; missing: " + missing);
}

TableColumns columns_of(const AttitudeWords& words) {
  Words needed{{"--quaternion COLUMN,COLUMN,COLUMN,COLUMN", words.quaternion},
               {"--scalar first|last", words.scalar},
               {"--maps body|reference", words.maps}};
  if (!words.rates.empty()) {
    needed.push_back({"--rate-unit rad/s|deg/s", words.rate_unit});
    needed.push_back({"--rate-axes body|reference", words.rate_axes});
  }
  require_table(words, needed);
  if (words.rates.empty())
    refuse({{"--rate-unit", words.rate_unit}, {"--rate-axes", words.rate_axes}}, words.file.string() + ": ",
           " is of rates; missing: --rates COLUMN,COLUMN,COLUMN");
  TableColumns columns;
  columns.time = words.time;
  columns.scale = scales().at(words.scale);
  columns.reference = words.reference;
  columns.quaternion = fields("--quaternion", words.quaternion, 4);
  if (!words.rates.empty()) columns.rates = fields("--rates", words.rates, 3);
  require_different(words.file, columns.time, {columns.quaternion, columns.rates});
  columns.stated = {words.scalar == "first" ? Convention::Scalar::first : Convention::Scalar::last,
                    words.maps == "body" ? Convention::Maps::to_body : Convention::Maps::to_reference};
  columns.rates_in_degrees = words.rate_unit == "deg/s";
  columns.rate_axes = words.rate_axes == "reference" ? RateAxes::reference : RateAxes::body;
  return columns;
}

OrbitColumns columns_of(const AttitudeWords& words, const OrbitWords& orbit) {
  require_table(words, {{"--position COLUMN,COLUMN,COLUMN", orbit.position},
                        {"--velocity COLUMN,COLUMN,COLUMN", orbit.velocity},
                        {"--unit m|km", orbit.unit}});
  const auto position = fields("--position", orbit.position, 3),
             velocity = fields("--velocity", orbit.velocity, 3);
  require_different(words.file, words.time, {position, velocity});
  return {words.time, scales().at(words.scale), position, velocity, orbit.unit == "km", words.reference};
}

Content content_without_step(const AttitudeWords& words, const OrbitWords& orbit, const std::string& kind,
                             const std::filesystem::path& out) {
  using Kind = Content::Kind;
  const std::string file = words.file.string();
  const bool of_kernel = is_kernel(words.file);
  if (!of_kernel && is_message(words.file)) {
    const auto [found, others] = kind_to_convert(words.file, kind, out);
    if (found == "omm") return {Kind::elements, others};
    refuse(only_of_orbits(orbit), file + ": is a message and says itself what its data are; ",
           " is of a table");
    return {found == "oem" ? Kind::orbit : Kind::attitude, others};
  }
  refuse({{"--kind", kind}}, file + ": is no message; ", " is of a combined one");
  if (of_kernel && is_orbit_kernel(words.file)) return {Kind::sampled};
  if (of_kernel) {
    refuse(only_of_orbits(orbit), file + ": is a kernel and says itself what its data are; ",
           " is of a table");
    return {Kind::attitude};
  }
  if (has_two_lines(words.file)) return {Kind::elements};
  if (!orbit.position.empty() || !orbit.velocity.empty()) return {Kind::orbit};
  refuse({{"--unit", orbit.unit}}, file + ": ", " is of an orbit; missing: --position and --velocity");
  return {Kind::attitude};
}

}  // namespace

AttitudeSource attitude_source(const AttitudeWords& words, bool writes_kernel) {
  AttitudeSource source{words.file};
  const bool of_kernel = is_kernel(words.file);
  if (of_kernel || writes_kernel)
    use_leap_seconds_of(words.kernel);  // before the times of the selection are read
  source.selection = selection_of(words);
  if (of_kernel) {
    const std::string is = words.file.string() + ": is a kernel and says itself what its data are; ";
    refuse({{"--segment", words.segment}}, is, " is of a message");
    refuse({{"--time", words.time}, {"--scale", words.scale}, {"--reference", words.reference}}, is,
           " is of a table");
    refuse(only_of_attitudes(words), is, " is of a table");
    source.kernel = words.kernel;
    return source;
  }
  if (!writes_kernel)
    refuse(only_of_kernels(words), words.file.string() + ": is no kernel of SPICE; ", " is of one");
  require_content(words.file);
  if (is_message(words.file) || is_stored_result(words.file)) {
    refuse_columns_of_message(words);
  } else {
    source.columns = columns_of(words);
  }
  return source;
}

OrbitFile orbit_file(const AttitudeWords& words, const OrbitWords& orbit) {
  refuse(only_of_kernels(words), words.file.string() + ": is no kernel of SPICE; ", " is of one");
  OrbitFile file{words.file};
  file.selection = selection_of(words);
  if (is_message(words.file)) {
    refuse_columns_of_message(words);
  } else {
    refuse(only_of_attitudes(words), "",
           " is of an attitude, --position and --velocity are of an orbit; one is converted at a time");
    file.columns = columns_of(words, orbit);
  }
  return file;
}

ElementFile element_file(const AttitudeWords& words, const OrbitWords& orbit, ConvertOptions& options,
                         const MessageWords& message) {
  refuse_orbit_words(options);
  const std::string has = words.file.string() + ": has elements of SGP4, which have no samples; ";
  const InterpolationWords& interpolation = message.interpolation;
  const std::string orientation = options.orientation.string();
  for (const Words& all : {Words{{"--segment", words.segment},
                                 {"--from", words.from},
                                 {"--until", words.until},
                                 {"--time", words.time},
                                 {"--scale", words.scale},
                                 {"--reference", words.reference},
                                 {"--frame", options.frame},
                                 {"--orientation", orientation}},
                           only_of_attitudes(words), only_of_kernels(words), only_of_orbits(orbit),
                           Words{{"--body", message.body},
                                 {"--aem-version", message.aem_version},
                                 {"--interpolation", interpolation.method},
                                 {"--degree", interpolation.degree}}})
    refuse(all, has, " is not of them");
  options.text.object_name = message.object_name;
  options.text.object_id = message.object_id;
  options.text.originator = message.originator;
  return {words.file};
}

SampledOrbit sampled_orbit_of(const AttitudeWords& words, const OrbitWords& orbit, ConvertOptions& options,
                              const std::string& step) {
  const std::string has = words.file.string() + ": has no samples; ";
  for (const Words& all : {Words{{"--segment", words.segment},
                                 {"--time", words.time},
                                 {"--scale", words.scale},
                                 {"--reference", words.reference}},
                           only_of_attitudes(words), only_of_kernels(words), only_of_orbits(orbit)})
    refuse(all, has, " is not of it");
  SampledOrbit source{words.file, words.from, words.until, step};
  // Of the file that is converted, not of one that turns an attitude.
  source.satellite.value = std::exchange(options.orbit.satellite.value, "");
  if (!source.satellite.value.empty() && is_orbit_kernel(words.file))
    refuse({{"--satellite", source.satellite.value}}, has, " is of elements");
  return source;
}

Content content_of(const AttitudeWords& words, const OrbitWords& orbit, const std::string& kind,
                   const std::filesystem::path& out, const std::string& step) {
  const Content content = content_without_step(words, orbit, kind, out);
  if (content.kind == Content::Kind::sampled) return content;
  const bool is_orbit =
      !step.empty() || ending_of(out) == ".oem" || ending_of(out) == ".csv" || ending_of(out) == ".czml";
  if (content.kind == Content::Kind::elements && is_orbit) return {Content::Kind::sampled, content.left_out};
  refuse({{"--step", step}}, words.file.string() + ": has samples; ",
         " is of elements of SGP4, or of a kernel of an orbit (SPK)");
  return content;
}

void refuse_orbit_words(const ConvertOptions& options) {
  if (!files_of(options.orbit).empty())
    throw BadInput("an orbit, --tle, --omm, --oem or --spk, turns an attitude; none is converted");
}

void set_message_words(ConvertOptions& options, const MessageWords& given, bool of_orbit) {
  MessageWords words = given;
  if (of_orbit) refuse_orbit_words(options);
  // Else of the orbit by which the attitude is turned.
  set_orbit_words(options.orbit, options.orbit.message.empty() ? InterpolationWords{} : words.interpolation);
  if (!options.orbit.message.empty()) words.interpolation = {};
  const InterpolationWords& interpolation = words.interpolation;
  if (ending_of(options.out) == ".csv")
    refuse({{"--object-name", words.object_name},
            {"--object-id", words.object_id},
            {"--originator", words.originator},
            {"--aem-version", words.aem_version},
            {"--interpolation", interpolation.method},
            {"--degree", interpolation.degree}},
           options.out.string() + ": is to be a table; ", " is of a message");
  if (is_viewer_name(options.out)) {
    refuse({{"--object-id", words.object_id},
            {"--originator", words.originator},
            {"--aem-version", words.aem_version},
            {"--interpolation", interpolation.method},
            {"--degree", interpolation.degree}},
           options.out.string() + ": is to be for a viewer; ", " is of a message");
    if (ending_of(options.out) == ".a")
      refuse({{"--object-name", words.object_name}}, options.out.string() + ": ", " has no place in it");
  }
  if (is_kernel_name(options.out)) {
    if (of_orbit) throw BadInput(options.out.string() + ": .bc is of an attitude");
    refuse({{"--object-name", words.object_name},
            {"--object-id", words.object_id},
            {"--originator", words.originator},
            {"--body", words.body},
            {"--aem-version", words.aem_version}},
           options.out.string() + ": is to be a kernel; ", " is of a message");
  }
  if (of_orbit) {
    refuse({{"--body", words.body}, {"--aem-version", words.aem_version}}, "",
           " is of an attitude, and an orbit is converted");
  } else {
    refuse({{"--interpolation", interpolation.method}, {"--degree", interpolation.degree}}, "",
           " is of an orbit, and an attitude is converted");
  }
  options.text.object_name = words.object_name;
  options.text.object_id = words.object_id;
  options.text.originator = words.originator;
  options.body = words.body;
  if (!words.aem_version.empty()) options.aem_version = words.aem_version;
  options.interpolation = interpolation_of(interpolation);
}

std::optional<Interpolation> interpolation_of(const InterpolationWords& words) {
  if (words.method.empty() != words.degree.empty())
    throw BadInput("--interpolation and --degree go together: --interpolation hermite --degree 7");
  if (words.method.empty()) return std::nullopt;
  const Interpolation given{words.method == "hermite" ? "HERMITE" : "LAGRANGE",
                            whole_number<int>("--degree", words.degree)};
  require_degree("", given);
  return given;
}

void set_orbit_words(OrbitSource& orbit, const InterpolationWords& words) {
  orbit.interpolation.value = interpolation_of(words);
  if (orbit.interpolation.value && orbit.message.empty())
    throw BadInput("--interpolation is of an orbit message; missing: --oem FILE");
  if (orbit.elements.empty() && orbit.mean_elements.empty())
    refuse({{"--satellite", orbit.satellite.value}}, "",
           " is of elements; missing: --tle FILE or --omm FILE");
}

}  // namespace vectrix::cli
