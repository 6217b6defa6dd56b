#include <unistd.h>

#include <CLI/CLI.hpp>
#include <ctime>
#include <exception>
#include <iostream>
#include <map>

#include "check.hpp"
#include "convert.hpp"
#include "frames.hpp"
#include "plain_words.hpp"
#include "pointing.hpp"
#include "replay.hpp"
#include "result_file/schema.hpp"
#include "scenario/schema.hpp"
#include "stored_report.hpp"
#include "words.hpp"

namespace {

using namespace vectrix;
using namespace vectrix::cli;

constexpr int yes = 0, no = 1, bad_input = 2;

// What should look where.
struct TargetWords {
  std::string axis, target;
};
struct CheckWords {
  AttitudeWords attitude;
  InterpolationWords interpolation;
  TargetWords target;
  CheckOptions options;
};
struct PointingWords {
  AttitudeWords attitude;
  InterpolationWords interpolation;
  TargetWords target;
  PointingOptions options;
  std::string correction;
};
struct ConvertWords {
  AttitudeWords attitude;
  OrbitWords orbit;
  MessageWords message;
  ConvertOptions options;
};

const std::map<std::string, Target> targets{{"sun", Target::sun},
                                            {"moon", Target::moon},
                                            {"earth", Target::earth},
                                            {"velocity", Target::velocity},
                                            {"velocity_in_itrf", Target::velocity_in_itrf}};
const std::map<std::string, SkyCorrection> corrections{
    {"geometric", geometric}, {"light_time", light_time}, {"apparent", apparent}};

constexpr const char* attitude_file =
    "CCSDS AEM (KVN or XML), a kernel of SPICE (CK), or a table with a header line";

void add_attitude(CLI::App& command, AttitudeWords& words, const char* file) {
  command.add_option("file", words.file, file)->required();
  command.add_option("--segment", words.segment, "of a message with several: which one, counted from 1");
  command.add_option("--from", words.from, "only samples from this time on: '2023-04-20T05:00:00 UTC'");
  command.add_option("--until", words.until, "only samples until this time");
  const char* kernel = "A kernel of SPICE";
  command.add_option("--sclk", words.kernel.clock, "its clock kernel")->group(kernel);
  command.add_option("--fk", words.kernel.frames, "its frame kernel, for names")->group(kernel);
  command.add_option("--lsk", words.kernel.leap_seconds, "a kernel with newer leap seconds")->group(kernel);
  command.add_option("--ck-frame", words.kernel.frame, "of several frames: which one, by name or number")
      ->group(kernel);
  const char* table = "A table";
  command.add_option("--time", words.time, "column of the time")->group(table);
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
  command.add_option("--reference", words.reference, "EME2000 (J2000) or GCRF (ICRF)")->group(table);
  command.add_option("--rates", words.rates, "three columns: the rate of the body relative to the reference")
      ->group(table);
  command.add_option("--rate-unit", words.rate_unit, "rad/s or deg/s")
      ->group(table)
      ->check(CLI::IsMember({"rad/s", "deg/s"}));
  command.add_option("--rate-axes", words.rate_axes, "of the rates: body or reference")
      ->group(table)
      ->check(CLI::IsMember({"body", "reference"}));
}

void add_interpolation(CLI::App& command, InterpolationWords& words, const char* what, const char* group) {
  command.add_option("--interpolation", words.method, what)
      ->group(group)
      ->check(CLI::IsMember({"hermite", "lagrange"}));
  command
      .add_option("--degree", words.degree, "of the interpolation: hermite odd, 3 to 15; lagrange 2 to 15")
      ->group(group);
}

void add_orbit(CLI::App& command, OrbitSource& orbit, InterpolationWords& words, const char* group) {
  command.add_option("--tle", orbit.elements, "file of two-line elements")->group(group);
  command.add_option("--oem", orbit.message, "CCSDS OEM (KVN or XML) in EME2000, GCRF or TEME")->group(group);
  command.add_option("--spk", orbit.kernel, "kernel of SPICE (SPK) with one spacecraft")->group(group);
  add_interpolation(command, words, "of an OEM that does not say it: hermite or lagrange", group);
}

void add_target(CLI::App& command, TargetWords& words, bool needed, const char* group) {
  command.add_option("--axis", words.axis, "x,y,z in the body: what should look at the target")
      ->group(group)
      ->required(needed);
  command
      .add_option("--target", words.target,
                  "sun, moon, earth (its centre), velocity (relative to GCRF) or velocity_in_itrf")
      ->group(group)
      ->check(CLI::IsMember(targets))
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
      "  vectrix check attitude.csv --time time_utc --scale utc --quaternion q0,q1,q2,q3 --scalar last "
      "--maps reference "
      "\\\n"
      "      --reference EME2000 --rates wx,wy,wz --rate-unit rad/s --rate-axes body");
  add_attitude(check, words.attitude, attitude_file);
  add_orbit(check, words.options.orbit, words.interpolation, "To compare with");
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
      ->check(CLI::IsMember(corrections));
  add_orbit(pointing, words.options.orbit, words.interpolation, where);
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
  add_attitude(convert, words.attitude,
               "CCSDS AEM or OEM (KVN or XML), a kernel of SPICE (CK), or a table with a header line");
  convert
      .add_option("out", words.options.out,
                  "attitude.aem or orbit.oem for a message of CCSDS (KVN), a .csv for a table, a .czml for "
                  "Cesium, an attitude.a for STK")
      ->required();
  const char* orbit = "A table of an orbit";
  convert.add_option("--position", words.orbit.position, "the three columns of the position, with commas")
      ->group(orbit);
  convert.add_option("--velocity", words.orbit.velocity, "the three columns of the velocity, with commas")
      ->group(orbit);
  convert.add_option("--unit", words.orbit.unit, "m (and m/s) or km (and km/s)")
      ->group(orbit)
      ->check(CLI::IsMember({"m", "km"}));
  convert.add_option("--frame", words.options.frame,
                     "EME2000 (J2000) or GCRF (ICRF): relative to this instead");
  convert.add_flag("--force", words.options.force, "overwrites an existing file");
  const char* message = "A message";
  convert.add_option("--object-name", words.message.object_name, "OBJECT_NAME")->group(message);
  convert.add_option("--object-id", words.message.object_id, "OBJECT_ID, such as 2018-099A")->group(message);
  convert.add_option("--originator", words.message.originator, "ORIGINATOR")->group(message);
  convert.add_option("--body", words.message.body, "the name of the frame of the body, such as SC_BODY_1")
      ->group(message);
  convert.add_option("--aem-version", words.message.aem_version, "2.0 (default) or 1.0")
      ->group(message)
      ->check(CLI::IsMember({"1.0", "2.0"}));
  add_interpolation(convert, words.message.interpolation, "of an OEM: hermite or lagrange", message);
}

void add_replay(CLI::App& app, ReplayOptions& options) {
  auto& replay = *app.add_subcommand(
      "replay", "say whether a flight fulfils what a scenario file requires, and write a report");
  replay.footer(
      "The scenario file names the attitude, the orbit, the frames on the body, what is measured and what "
      "is\n"
      "required: docs/reference/scenario_file.md lists its keys. A short one:\n\n"
      "  version = 1\n"
      "  title = \"Is the camera on the Sun?\"\n"
      "  [attitude]\n"
      "  file = \"attitude.aem\"\n"
      "  [[measure]]\n"
      "  name = \"off-Sun\"\n"
      "  axis = \"z of SC_BODY_1\"\n"
      "  target = \"sun\"\n"
      "  correction = \"geometric\"\n"
      "  [[require]]\n"
      "  measure = \"off-Sun\"\n"
      "  absolute = \"0.5 deg\"\n"
      "  percent = \"99.7 %\"\n\n"
      "Exit code: 0 if everything required is fulfilled, 1 if not, 2 if the input is wrong.\n\n"
      "  vectrix replay scenario.toml");
  replay.add_option("file", options.file, "the scenario file, TOML")->required();
  replay.add_flag("--check", options.check,
                  "only reads the scenario and its attitude, and says what is wrong");
  replay.add_option(
      "--hdf5", options.hdf5,
      "writes all results, with the scenario, to this file, .h5: docs/reference/result_file.md");
  replay.add_flag("--force", options.force,
                  "overwrites that file and those that the scenario names in [output]");
}

void add_report(CLI::App& app, StoredReportOptions& options) {
  auto& report = *app.add_subcommand("report", "write the report of a stored result");
  report.footer(
      "The page is that of vectrix replay; the files of the flight are not needed.\n"
      "Exit code: 0, or 2 if the input is wrong; then nothing is written.\n\n"
      "  vectrix replay scenario.toml --hdf5 result.h5\n"
      "  vectrix report result.h5");
  report.add_option("file", options.file, "what vectrix replay --hdf5 has written")->required();
  report.add_option("--output", options.output, "the page; by default the same name with .html");
  report.add_flag("--force", options.force, "overwrites an existing file");
}

void add_frames(CLI::App& app, FramesOptions& options) {
  auto& frames =
      *app.add_subcommand("frames", "the chain between two frames of a scenario file, factor by factor");
  frames.footer(
      "Without --from and --to the frames are listed. Names are those of the scenario, its body, GCRF "
      "(ICRF),\n"
      "EME2000 (J2000), ITRF if the file has [earth], and LVLH if it has [orbit].\n"
      "Exit code: 0, or 2 if the input is wrong.\n\n"
      "  vectrix frames scenario.toml --from radiometer --to J2000 --at '2023-04-20T05:30:00 UTC'");
  frames.add_option("file", options.file, "the scenario file, TOML")->required();
  frames.add_option("--from", options.from, "v_to = R v_from");
  frames.add_option("--to", options.to, "v_to = R v_from");
  frames.add_option("--at", options.at, "the instant; by default the first sample of the attitude");
}

// For docs/reference/scenario_file.md and result_file.md; of no use to others.
void add_schema(CLI::App& app, bool& of_result) {
  auto& schema = *app.add_subcommand("schema", "the page of the scenario file")->group("");
  schema.add_flag("--result", of_result, "that of the result file");
}

void require_texts(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options())
    for (const std::string& text : option->results())
      if (text.empty()) throw BadInput(option->get_name() + " is empty");
}

// As a message has it: 2026-11-29T00:00:00.
std::string now() {
  const std::time_t seconds = std::time(nullptr);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%S", std::gmtime(&seconds));
  return text;
}

// Of the messages that name types: of an orbit, or else of the attitude.
std::string place_of(const AttitudeWords& attitude, const OrbitSource& orbit) {
  if (!orbit.message.empty()) return orbit.message.string();
  if (!orbit.kernel.empty()) return orbit.kernel.string();
  return orbit.elements.empty() ? attitude.file.string() : orbit.elements.string();
}

bool run_check(CheckWords& words) {
  set_interpolation(words.options.orbit, words.interpolation);
  words.options.attitude = attitude_source(words.attitude);
  if (!words.target.axis.empty()) words.options.axis = axis_of(words.target.axis);
  if (!words.target.target.empty()) words.options.target = targets.at(words.target.target);
  return in_plain_words(place_of(words.attitude, words.options.orbit),
                        [&] { return check(words.options, std::cout); });
}

bool run_pointing(PointingWords& words) {
  set_interpolation(words.options.orbit, words.interpolation);
  words.options.attitude = attitude_source(words.attitude);
  words.options.axis = axis_of(words.target.axis);
  words.options.target = targets.at(words.target.target);
  if (!words.correction.empty()) words.options.correction = corrections.at(words.correction);
  return in_plain_words(place_of(words.attitude, words.options.orbit),
                        [&] { return pointing(words.options, std::cout); });
}

bool run_convert(ConvertWords& words) {
  words.options.text.creation_date = now();
  const bool of_orbit = is_orbit(words.attitude, words.orbit);
  set_message_words(words.options, words.message, of_orbit);
  if (of_orbit) {
    convert(orbit_file(words.attitude, words.orbit), words.options, std::cout);
  } else {
    convert(attitude_source(words.attitude), words.options, std::cout);
  }
  return true;
}

bool run_replay(ReplayOptions& options) {
  options.version = VECTRIX_VERSION;
  Progress progress(isatty(STDERR_FILENO) != 0 ? &std::cerr : nullptr);
  return replay(options, progress, std::cout);
}

bool run_frames(const FramesOptions& options) {
  frames(options, std::cout);
  return true;
}

bool run_report(const StoredReportOptions& options) {
  stored_report(options, std::cout);
  return true;
}

bool write_schema(bool of_result) {
  std::cout << (of_result ? result_page() : schema_page());
  return true;
}

}  // namespace

int main(int count, char** arguments) {
  CLI::App app("Vectrix: attitude files checked, measured and converted, flights judged");
  app.set_version_flag("--version", VECTRIX_VERSION);
  app.require_subcommand(1);
  CheckWords check;
  PointingWords pointing;
  ConvertWords convert;
  ReplayOptions replay;
  FramesOptions frames;
  StoredReportOptions report;
  bool of_result = false;
  try {
    add_check(app, check);
    add_pointing(app, pointing);
    add_convert(app, convert);
    add_replay(app, replay);
    add_frames(app, frames);
    add_report(app, report);
    add_schema(app, of_result);
    app.parse(count, arguments);
    require_texts(*app.get_subcommands().front());
    const bool good = app.got_subcommand("check")      ? run_check(check)
                      : app.got_subcommand("pointing") ? run_pointing(pointing)
                      : app.got_subcommand("replay")   ? run_replay(replay)
                      : app.got_subcommand("frames")   ? run_frames(frames)
                      : app.got_subcommand("report")   ? run_report(report)
                      : app.got_subcommand("schema")   ? write_schema(of_result)
                                                       : run_convert(convert);
    return good ? yes : no;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : bad_input;
  } catch (const std::exception& error) {
    std::cerr << "vectrix: " << error.what() << '\n';
    return bad_input;
  }
}
