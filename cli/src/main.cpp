#include <CLI/CLI.hpp>
#include <charconv>
#include <ctime>
#include <exception>
#include <iostream>
#include <map>
#include <sstream>
#include <system_error>

#include "check.hpp"
#include "convert.hpp"
#include "pointing.hpp"

namespace {

using namespace vectrix;
using namespace vectrix::cli;

constexpr int yes = 0, no = 1, bad_input = 2;

// What the options say of an attitude, before the file tells whether it is a table.
struct AttitudeWords {
  AttitudeSource source;
  TableColumns columns;
  std::string quaternion, rates;  // names of columns, with commas
  std::string from, until, scale = "utc", scalar, maps, rate_unit, rate_axes = "body";
};
// What should look where.
struct TargetWords {
  std::string axis, target;
};
struct CheckWords {
  AttitudeWords attitude;
  TargetWords target;
  CheckOptions options;
};
struct PointingWords {
  AttitudeWords attitude;
  TargetWords target;
  PointingOptions options;
  std::string correction;
};
struct ConvertWords {
  AttitudeWords attitude;
  std::string position, velocity, unit;  // of an orbit
  ConvertOptions options;
};

const std::map<std::string, TimeScale> scales{
    {"utc", scale::utc}, {"tai", scale::tai}, {"tt", scale::tt}, {"tdb", scale::tdb}, {"gps", scale::gps}};
const std::map<std::string, Target> targets{
    {"sun", Target::sun}, {"moon", Target::moon}, {"earth", Target::earth}, {"velocity", Target::velocity}};
const std::map<std::string, SkyCorrection> corrections{
    {"geometric", geometric}, {"light_time", light_time}, {"apparent", apparent}};

// What stands between commas.
std::vector<std::string> fields(const char* option, const std::string& text, std::size_t count) {
  std::vector<std::string> all;
  std::istringstream in(text + ",");
  for (std::string field; std::getline(in, field, ',');) all.push_back(field);
  if (all.size() != count)
    throw BadInput(std::string(option) + ' ' + text + " has " + detail::text(all.size()) +
                   " fields between commas, not " + detail::text(count));
  return all;
}

// No convention is taken that nobody has stated.
class Needed {
 public:
  void operator()(bool given, const char* option) {
    if (!given) missing_ += std::string(missing_.empty() ? "" : ", ") + option;
  }
  void check(const std::filesystem::path& file) const {
    if (!missing_.empty())
      throw BadInput(file.string() + ": a table does not say what its columns mean; missing: " + missing_);
  }

 private:
  std::string missing_;
};

TableColumns columns_of(const AttitudeWords& words) {
  Needed need;
  need(!words.columns.time.empty(), "--time COLUMN");
  need(!words.quaternion.empty(), "--quaternion COLUMN,COLUMN,COLUMN,COLUMN");
  need(!words.scalar.empty(), "--scalar first|last");
  need(!words.maps.empty(), "--maps body|reference");
  need(!words.columns.reference.empty(), "--reference EME2000|GCRF");
  need(words.rates.empty() || !words.rate_unit.empty(), "--rate-unit rad/s|deg/s");
  need.check(words.source.file);
  TableColumns columns = words.columns;
  columns.quaternion = fields("--quaternion", words.quaternion, 4);
  if (!words.rates.empty()) columns.rates = fields("--rates", words.rates, 3);
  columns.scale = scales.at(words.scale);
  columns.stated = {words.scalar == "first" ? Convention::Scalar::first : Convention::Scalar::last,
                    words.maps == "body" ? Convention::Maps::to_body : Convention::Maps::to_reference};
  columns.rates_in_degrees = words.rate_unit == "deg/s";
  columns.rate_axes = words.rate_axes == "body" ? RateAxes::body : RateAxes::reference;
  return columns;
}

Selection selection_of(const AttitudeWords& words) {
  Selection selection = words.source.selection;
  if (!words.from.empty()) selection.from = Epoch::from(words.from);
  if (!words.until.empty()) selection.until = Epoch::from(words.until);
  return selection;
}

AttitudeSource source_of(const AttitudeWords& words) {
  AttitudeSource source = words.source;
  source.selection = selection_of(words);
  if (!is_message(source.file)) source.columns = columns_of(words);
  return source;
}

OrbitFile orbit_of(const ConvertWords& words) {
  OrbitFile orbit{words.attitude.source.file};
  orbit.selection = selection_of(words.attitude);
  if (is_message(orbit.file)) return orbit;
  const TableColumns& shared = words.attitude.columns;
  Needed need;
  need(!shared.time.empty(), "--time COLUMN");
  need(!words.position.empty(), "--position COLUMN,COLUMN,COLUMN");
  need(!words.velocity.empty(), "--velocity COLUMN,COLUMN,COLUMN");
  need(!words.unit.empty(), "--unit m|km");
  need(!shared.reference.empty(), "--reference EME2000|GCRF");
  need.check(orbit.file);
  orbit.columns = OrbitColumns{shared.time,
                               scales.at(words.attitude.scale),
                               fields("--position", words.position, 3),
                               fields("--velocity", words.velocity, 3),
                               words.unit == "km",
                               shared.reference};
  return orbit;
}

Eigen::Vector3d axis_of(const TargetWords& words) {
  Eigen::Vector3d axis;
  const auto numbers = fields("--axis", words.axis, 3);
  for (std::size_t i = 0; i < 3; ++i) {
    double& number = axis[static_cast<Eigen::Index>(i)];
    const char* const end = numbers[i].data() + numbers[i].size();
    if (const auto read = std::from_chars(numbers[i].data(), end, number);
        read.ec != std::errc() || read.ptr != end)
      throw BadInput("--axis " + words.axis + ": '" + numbers[i] + "' is no number");
  }
  return axis;
}

constexpr const char* attitude_file = "CCSDS AEM (KVN), or a table with a header line";

void add_attitude(CLI::App& command, AttitudeWords& words, const char* file) {
  command.add_option("file", words.source.file, file)->required();
  command.add_option("--segment", words.source.selection.segment,
                     "of a message with several: which one, counted from 1");
  command.add_option("--from", words.from, "only samples from this time on: '2023-04-20T05:00:00 UTC'");
  command.add_option("--until", words.until, "only samples until this time");
  const char* table = "A table";
  command.add_option("--time", words.columns.time, "column of the time")->group(table);
  command.add_option("--scale", words.scale, "of the time: utc, tai, tt, tdb, gps")
      ->group(table)
      ->check(CLI::IsMember({"utc", "tai", "tt", "tdb", "gps"}));
  command.add_option("--quaternion", words.quaternion, "the four columns, with commas, in their order")
      ->group(table);
  command.add_option("--scalar", words.scalar, "which of them is the scalar: first or last")
      ->group(table)
      ->check(CLI::IsMember({"first", "last"}));
  command.add_option("--maps", words.maps, "R(q) takes coordinates to the axes of: body or reference")
      ->group(table)
      ->check(CLI::IsMember({"body", "reference"}));
  command.add_option("--reference", words.columns.reference, "EME2000 (J2000) or GCRF (ICRF)")->group(table);
  command.add_option("--rates", words.rates, "three columns: the rate of the body relative to the reference")
      ->group(table);
  command.add_option("--rate-unit", words.rate_unit, "rad/s or deg/s")
      ->group(table)
      ->check(CLI::IsMember({"rad/s", "deg/s"}));
  command.add_option("--rate-axes", words.rate_axes, "of the rates: body (default) or reference")
      ->group(table)
      ->check(CLI::IsMember({"body", "reference"}));
}

void add_orbit(CLI::App& command, OrbitSource& orbit, const char* group) {
  command.add_option("--tle", orbit.elements, "file of two-line elements")->group(group);
  command.add_option("--oem", orbit.message, "CCSDS OEM (KVN) in EME2000, GCRF or TEME")->group(group);
}

void add_target(CLI::App& command, TargetWords& words, bool needed, const char* group) {
  command.add_option("--axis", words.axis, "x,y,z in the body: what should look at the target")
      ->group(group)
      ->required(needed);
  command
      .add_option("--target", words.target, "sun, moon, earth (its centre) or velocity (relative to GCRF)")
      ->group(group)
      ->check(CLI::IsMember({"sun", "moon", "earth", "velocity"}))
      ->required(needed);
}

void add_check(CLI::App& app, CheckWords& words) {
  auto& check =
      *app.add_subcommand("check", "say which reading of an attitude file its rates, orbit or target fit");
  check.footer(
      "Readings: as stated; transposed; with the scalar at the other end; both. None is chosen for you.\n"
      "Exit code: 0 if a comparison confirms the file as stated and none prefers another reading, 1 if not,\n"
      "2 if the input is wrong.\n\n"
      "  vectrix check attitude.aem --tle satellite.tle\n"
      "  vectrix check attitude.csv --time time_utc --quaternion q0,q1,q2,q3 --scalar last --maps reference "
      "\\\n"
      "      --reference EME2000 --rates wx,wy,wz --rate-unit rad/s");
  add_attitude(check, words.attitude, attitude_file);
  add_orbit(check, words.options.orbit, "To compare with");
  add_target(check, words.target, false, "To compare with");
}

void add_pointing(CLI::App& app, PointingWords& words) {
  auto& pointing = *app.add_subcommand(
      "pointing", "how far an axis of the body is from a target, and whether that is good enough");
  pointing.footer(
      "Absolute error (APE): the angle at each sample. Relative error (RPE): for each window that begins at "
      "a\n"
      "sample, the most that the target moves in the body from its mean direction.\n"
      "Exit code: 0 if what is required is fulfilled, or nothing is required, 1 if not, 2 if the input is "
      "wrong.\n\n"
      "  vectrix pointing attitude.aem --tle satellite.tle --axis 0,0,1 --target sun --correction apparent "
      "\\\n"
      "      --require 0.5 --percent 99.7");
  add_attitude(pointing, words.attitude, attitude_file);
  const char* where = "Where it should look";
  add_target(pointing, words.target, true, where);
  pointing
      .add_option(
          "--correction", words.correction,
          "of the Sun or the Moon: geometric (where it is), light_time (where it was when the light left), "
          "apparent (that with aberration)")
      ->group(where)
      ->check(CLI::IsMember({"geometric", "light_time", "apparent"}));
  add_orbit(pointing, words.options.orbit, where);
  const char* required = "What is required";
  pointing.add_option("--require", words.options.required, "deg: the largest absolute error that is allowed")
      ->group(required);
  pointing
      .add_option("--percent", words.options.percent,
                  "how many of the samples, or windows, have to fulfil it")
      ->group(required);
  pointing.add_option("--window", words.options.window, "s: of the relative error")->group(required);
  pointing
      .add_option("--require-relative", words.options.required_relative,
                  "deg: the largest relative error that is allowed")
      ->group(required);
  pointing.add_option("--csv", words.options.csv, "writes the angle of every sample to this file");
  pointing.add_flag("--force", words.options.force, "overwrites it");
}

void add_convert(CLI::App& app, ConvertWords& words) {
  auto& convert = *app.add_subcommand("convert", "write an attitude or an orbit as a message or as a table");
  convert.footer(
      "A table is written with the scalar first; R(q) takes coordinates to the reference; lengths are in "
      "metres; its\n"
      "columns name frames and units. The digits are those of the file; what had to be computed is said.\n"
      "Exit code: 0, or 2 if the input is wrong; then nothing is written.\n\n"
      "  vectrix convert attitude.aem attitude.csv --frame GCRF");
  add_attitude(convert, words.attitude, "CCSDS AEM or OEM (KVN), or a table with a header line");
  convert
      .add_option("out", words.options.out,
                  "attitude.aem or orbit.oem for a message of CCSDS (KVN), a .csv for a table")
      ->required();
  const char* orbit = "A table of an orbit";
  convert.add_option("--position", words.position, "the three columns of the position, with commas")
      ->group(orbit);
  convert.add_option("--velocity", words.velocity, "the three columns of the velocity, with commas")
      ->group(orbit);
  convert.add_option("--unit", words.unit, "m (and m/s) or km (and km/s)")
      ->group(orbit)
      ->check(CLI::IsMember({"m", "km"}));
  convert.add_option("--frame", words.options.frame,
                     "EME2000 (J2000) or GCRF (ICRF): relative to this instead");
  convert.add_flag("--force", words.options.force, "overwrites an existing file");
  const char* message = "A message";
  convert.add_option("--object-name", words.options.text.object_name, "OBJECT_NAME")->group(message);
  convert.add_option("--object-id", words.options.text.object_id, "OBJECT_ID, such as 2018-099A")
      ->group(message);
  convert.add_option("--originator", words.options.text.originator, "ORIGINATOR")->group(message);
  convert.add_option("--body", words.options.body, "the name of the frame of the body, such as SC_BODY_1")
      ->group(message);
  convert.add_option("--aem-version", words.options.aem_version, "2.0 (default) or 1.0")
      ->group(message)
      ->check(CLI::IsMember({"1.0", "2.0"}));
}

// As a message has it: 2026-11-29T00:00:00.
std::string now() {
  const std::time_t seconds = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S", std::gmtime(&seconds));
  return text;
}

bool run_check(CheckWords& words) {
  words.options.attitude = source_of(words.attitude);
  if (!words.target.axis.empty()) words.options.axis = axis_of(words.target);
  if (!words.target.target.empty()) words.options.target = targets.at(words.target.target);
  return check(words.options, std::cout);
}

bool run_pointing(PointingWords& words) {
  words.options.attitude = source_of(words.attitude);
  words.options.axis = axis_of(words.target);
  words.options.target = targets.at(words.target.target);
  if (!words.correction.empty()) words.options.correction = corrections.at(words.correction);
  return pointing(words.options, std::cout);
}

bool run_convert(ConvertWords& words) {
  words.options.text.creation_date = now();
  const bool has_orbit = !words.position.empty() || !words.velocity.empty();
  if (has_orbit && !words.attitude.quaternion.empty())
    throw BadInput(
        "--quaternion is of an attitude, --position and --velocity are of an orbit; one is converted at a "
        "time");
  if (has_orbit || is_orbit_message(words.attitude.source.file)) {
    convert(orbit_of(words), words.options, std::cout);
  } else {
    convert(source_of(words.attitude), words.options, std::cout);
  }
  return true;
}

}  // namespace

int main(int count, char** arguments) {
  CLI::App app("Vectrix: attitude files checked, measured and converted");
  app.set_version_flag("--version", VECTRIX_VERSION);
  app.require_subcommand(1);
  CheckWords check;
  PointingWords pointing;
  ConvertWords convert;
  try {
    add_check(app, check);
    add_pointing(app, pointing);
    add_convert(app, convert);
    app.parse(count, arguments);
    const bool good = app.got_subcommand("check")      ? run_check(check)
                      : app.got_subcommand("pointing") ? run_pointing(pointing)
                                                       : run_convert(convert);
    return good ? yes : no;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : bad_input;
  } catch (const std::exception& error) {
    std::cerr << "vectrix: " << error.what() << '\n';
    return bad_input;
  }
}
