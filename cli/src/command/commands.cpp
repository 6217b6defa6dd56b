#include "command/commands.hpp"

#include <CLI/CLI.hpp>

#include "word.hpp"

namespace vectrix::cli {
namespace {

constexpr const char* attitude_file =
    "CCSDS AEM (KVN or XML), a kernel of SPICE (CK), or a table with a header line";
constexpr const char *a_column = "COLUMN", *three_columns = "COLUMN,COLUMN,COLUMN", *a_file = "FILE";

// Options of a command below one title; the value of each is named.
class Options {
 public:
  explicit Options(CLI::App& command, const char* title = "Options") : command_(command), title_(title) {}

  template <class Value>
  CLI::Option& add(const char* name, Value& value, const char* named, const std::string& help) {
    return *command_.add_option(name, value, help)->type_name(named)->group(title_);
  }
  // One of some texts.
  CLI::Option& choose(const char* name, std::string& value, const std::vector<std::string>& from,
                      const std::string& help) {
    CLI::Option& option = add(name, value, joined(from, "|").c_str(), help);
    option.check(CLI::IsMember(from).description(""));
    return option;
  }
  void flag(const char* name, bool& value, const std::string& help) {
    command_.add_flag(name, value, help)->group(title_);
  }

 private:
  CLI::App& command_;
  const char* title_;
};

void add_attitude(CLI::App& command, AttitudeWords& words, const char* what) {
  Options of_all(command);
  of_all.add("file", words.file, a_file, what).required();
  of_all.add("--segment", words.segment, "NUMBER", "of a message with several: which one, counted from 1");
  of_all.add("--from", words.from, "TIME", "only samples from this time on: '2023-04-20T05:00:00 UTC'");
  of_all.add("--until", words.until, "TIME", "only samples until this time");
  Options kernel(command, "A kernel of SPICE");
  kernel.add("--sclk", words.kernel.clock, a_file, "its clock kernel");
  kernel.add("--fk", words.kernel.frames, a_file, "its frame kernel, for names");
  kernel.add("--lsk", words.kernel.leap_seconds, a_file, "a kernel with newer leap seconds");
  kernel.add("--ck-frame", words.kernel.frame, "NAME", "of several frames: which one, by name or number");
  Options table(command, "A table");
  table.add("--time", words.time, a_column, "column of the time");
  table.choose("--scale", words.scale, {"utc", "tai", "tt", "tdb", "gps"}, "of the time");
  table.add("--quaternion", words.quaternion, "COLUMN,COLUMN,COLUMN,COLUMN",
            "the four columns in their order");
  table.choose("--scalar", words.scalar, {"first", "last"}, "which of them is the scalar");
  table.choose("--maps", words.maps, {"body", "reference"}, "to whose axes R(q) takes coordinates");
  table.add(
      "--reference", words.reference, "FRAME",
      "EME2000, J2000, GCRF, ICRF, ITRF, TIRF, CIRF, TEME, TOD or MOD; of an attitude also, of the orbit, "
      "LVLH, RTN, RSW, TNW, NTW or VNC");
  table.add("--rates", words.rates, three_columns, "the rate of the body relative to the reference");
  table.choose("--rate-unit", words.rate_unit, {"rad/s", "deg/s"}, "of the rates");
  table.choose("--rate-axes", words.rate_axes, {"body", "reference"}, "of the rates");
}

void add_interpolation(Options& options, InterpolationWords& words, const char* of) {
  options.choose("--interpolation", words.method, {"hermite", "lagrange"}, of);
  options.add("--degree", words.degree, "NUMBER",
              "of the interpolation: hermite odd, 3 to 15; lagrange 2 to 15");
}

void add_orbit(Options& options, OrbitSource& orbit) {
  options.add("--tle", orbit.elements, a_file, "two-line elements");
  options.add("--omm", orbit.mean_elements, a_file, "the same as CCSDS OMM (KVN or XML)");
  options.add("--satellite", orbit.satellite.value, "NUMBER",
              "of elements of several satellites: which one, by its number in the catalogue, or its "
              "designator as written");
  options.add("--oem", orbit.message, a_file,
              "CCSDS OEM (KVN or XML) in EME2000, GCRF or TEME, or ITRF with --orientation");
  options.add("--spk", orbit.kernel, a_file, "kernel of SPICE (SPK) with one spacecraft");
}

void add_orbit(Options& options, OrbitSource& orbit, InterpolationWords& words) {
  add_orbit(options, orbit);
  add_interpolation(options, words, "of an OEM that does not say it");
}

CLI::Option& add_axis(Options& options, TargetWords& words) {
  return options.add("--axis", words.axis, "X,Y,Z", "in the body: what should look at the target");
}

void add_check(CLI::App& app, CheckWords& words) {
  auto& check =
      *app.add_subcommand("check", "say which reading of an attitude file its rates, orbit or target fit");
  check.footer(
      "Readings: as stated; transposed; with the scalar at the other end; both. None is chosen for you.\n"
      "Exit code: 0 if a comparison confirms the file as stated, none prefers another reading, and the "
      "rates\n"
      "of the file do not contradict it; 1 if not, 2 if the input is wrong.\n\n"
      "  vectrix check attitude.aem --tle satellite.tle\n"
      "  vectrix check attitude.csv --time time_utc --scale utc --quaternion q0,q1,q2,q3 --scalar last "
      "--maps reference "
      "\\\n"
      "      --reference EME2000 --rates wx,wy,wz --rate-unit rad/s --rate-axes body");
  add_attitude(check, words.attitude, attitude_file);
  Options compared(check, "To compare with");
  add_orbit(compared, words.options.orbit, words.interpolation);
  compared.add("--orientation", words.options.orientation, a_file,
               "how the Earth turns, for ITRF, TIRF and CIRF: finals2000A of the IERS");
  add_axis(compared, words.target);
  compared.choose("--target", words.target.target, plain_target_names(),
                  "earth is its centre; velocity is relative to GCRF");
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
  Options where(pointing, "Where it should look");
  add_axis(where, words.target).required();
  where
      .choose("--target", words.target.target, target_names(),
              "earth is its centre; velocity is relative to GCRF")
      .required();
  where.choose("--correction", words.correction, corrections_of(Target::sun),
               "of the Sun, the Moon or a star: where it is, where it was when the light left, or that with "
               "aberration");
  where.choose(
      "--when", words.when, when_names(),
      "only samples at which the whole disc of the Sun is seen, or none of it, or the Earth does not "
      "hide the target; how many are left out is said");
  add_orbit(where, words.options.orbit, words.interpolation);
  Options star(pointing, "A star");
  star.add("--right-ascension", words.target.right_ascension, "DEGREES",
           "along the axes of GCRF, at --epoch, or without proper motion at the date");
  star.add("--declination", words.target.declination, "DEGREES", "positive north");
  star.add("--proper-motion", words.target.proper_motion, "MAS,MAS",
           "of right ascension and declination, milliarcsec in a year; without it the star stands still. Its "
           "radial velocity is taken as zero");
  star.choose("--cos-declination", words.target.cos_declination, {"included", "not_included"},
              "whether the first has the factor cos(declination) in it, as in Hipparcos and Gaia");
  star.add("--epoch", words.target.epoch, "TIME",
           "of the catalogue, when the star was at this place: '2000-01-01T12:00:00 TT'");
  star.add("--parallax", words.target.parallax, "MAS", "at most 1000 milliarcsec; by default zero");
  Options station(pointing, "A station");
  station.add("--latitude", words.target.latitude, "DEGREES", "geodetic, positive north");
  station.add("--longitude", words.target.longitude, "DEGREES", "positive east");
  station.add("--height", words.target.height, "METRES", "above the ellipsoid WGS-84");
  station.add("--orientation", words.options.orientation, a_file,
              "how the Earth turns, also for ITRF: finals2000A of the IERS");
  Options required(pointing, "What is required");
  required.add("--require", words.options.required, "DEGREES", "the largest absolute error that is allowed");
  required.add("--percent", words.options.percent, "PERCENT",
               "how many of the samples, or windows, have to fulfil it");
  required.add("--window", words.options.window, "SECONDS", "of the relative error");
  required.add("--require-relative", words.options.required_relative, "DEGREES",
               "the largest relative error that is allowed");
  Options output(pointing);
  output.add("--csv", words.options.csv, a_file, "writes the angle of every sample to this file");
  output.flag("--force", words.options.force, "overwrites it");
}

void add_convert(CLI::App& app, ConvertWords& words) {
  auto& convert = *app.add_subcommand(
      "convert", "write an attitude, an orbit or elements of SGP4 as a message or a table");
  convert.footer(
      "A table is written with the scalar first; R(q) takes coordinates to the reference; lengths are in "
      "metres; its\n"
      "columns name frames and units. The digits are those of the file; what had to be computed is said.\n"
      "Exit code: 0, or 2 if the input is wrong; then nothing is written.\n\n"
      "  vectrix convert attitude.aem attitude.csv --frame GCRF");
  add_attitude(convert, words.attitude,
               "CCSDS AEM, OEM or OMM (KVN or XML, also in an NDM), a kernel of SPICE (CK, SPK), two-line "
               "elements, or a table with a header line");
  Options output(convert);
  output
      .add("out", words.options.out, a_file,
           "attitude.aem, orbit.oem or elements.omm for a message of CCSDS in keywords, .xml for one in XML, "
           "a .bc for a kernel of SPICE (CK, with --sclk and --ck-frame), a .csv for a table, a .czml for "
           "Cesium, an attitude.a for STK")
      .required();
  output.choose(
      "--kind", words.kind, {"aem", "oem", "omm"},
      "which message of a combined one (NDM), if the name of the file to be written does not say it");
  Options orbit(convert, "A table of an orbit");
  orbit.add("--position", words.orbit.position, three_columns, "x, y and z of the position");
  orbit.add("--velocity", words.orbit.velocity, three_columns, "x, y and z of the velocity");
  orbit.choose("--unit", words.orbit.unit, {"m", "km"}, "of the position; of the velocity m/s or km/s");
  output.add(
      "--step", words.step, "SECONDS",
      "of an orbit that has no samples, of two-line elements, an OMM or an SPK: from --from until --until");
  output.add(
      "--frame", words.options.frame, "FRAME",
      "relative to this instead: EME2000 (J2000), GCRF (ICRF), TEME, TOD, MOD, and with --orientation ITRF, "
      "TIRF or CIRF");
  Options turn(convert, "Orbit and Earth, for --frame");
  add_orbit(turn, words.options.orbit);
  turn.add("--orientation", words.options.orientation, a_file,
           "how the Earth turns, for ITRF: finals2000A of the IERS");
  output.flag("--force", words.options.force, "overwrites an existing file");
  Options message(convert, "A message");
  message.add("--object-name", words.message.object_name, "NAME", "OBJECT_NAME");
  message.add("--object-id", words.message.object_id, "ID", "OBJECT_ID, such as 2018-099A");
  message.add("--originator", words.message.originator, "NAME", "ORIGINATOR");
  message.add("--body", words.message.body, "FRAME", "the name of the frame of the body, such as SC_BODY_1");
  message.choose("--aem-version", words.message.aem_version, {"1.0", "2.0"}, "2.0 if it is not given");
  add_interpolation(message, words.message.interpolation, "of an OEM that is written, or else of --oem");
}

void add_replay(CLI::App& app, ReplayOptions& options) {
  auto& replay = *app.add_subcommand(
      "replay", "say whether a flight fulfils what a scenario file requires, and write a report");
  replay.footer(
      "The scenario file names the attitude, the orbit, the frames on the body, what is measured and what "
      "is\n"
      "required: docs/reference/scenario_file.md and the manual vectrix-scenario(5) list its keys. A short "
      "one:\n\n"
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
  Options all(replay);
  all.add("file", options.file, a_file, "the scenario file, TOML").required();
  all.flag("--check", options.check, "only reads the scenario and its attitude, and says what is wrong");
  all.add("--hdf5", options.hdf5, a_file,
          "writes all results, with the scenario, to this file, .h5: docs/reference/result_file.md");
  all.flag("--force", options.force, "overwrites that file and those that the scenario names in [output]");
}

void add_report(CLI::App& app, StoredReportOptions& options) {
  auto& report = *app.add_subcommand("report", "write the report of a stored result");
  report.footer(
      "The page is that of vectrix replay; the files of the flight are not needed.\n"
      "Exit code: 0, or 2 if the input is wrong; then nothing is written.\n\n"
      "  vectrix replay scenario.toml --hdf5 result.h5\n"
      "  vectrix report result.h5");
  Options all(report);
  all.add("file", options.file, a_file, "what vectrix replay --hdf5 has written").required();
  all.add("--output", options.output, a_file, "the page; by default the same name with .html");
  all.flag("--force", options.force, "overwrites an existing file");
}

void add_frames(CLI::App& app, FramesOptions& options) {
  auto& frames =
      *app.add_subcommand("frames", "the chain between two frames of a scenario file, factor by factor");
  frames.footer(
      "Without --from and --to the frames are listed. Names are those of the scenario, its body, GCRF "
      "(ICRF),\n"
      "EME2000 (J2000), ITRF if the file has [earth], LVLH if it has [orbit], and the reference of the "
      "attitude.\n"
      "Exit code: 0, or 2 if the input is wrong.\n\n"
      "  vectrix frames scenario.toml --from radiometer --to J2000 --at '2023-04-20T05:30:00 UTC'");
  Options all(frames);
  all.add("file", options.file, a_file, "the scenario file, TOML").required();
  all.add("--from", options.from, "FRAME", "v_to = R v_from");
  all.add("--to", options.to, "FRAME", "v_to = R v_from");
  all.add("--at", options.at, "TIME", "the instant; by default the first sample of the attitude");
}

void add_completion(CLI::App& app, std::string& shell) {
  auto& completion =
      *app.add_subcommand("completion", "the script with which a shell completes this command");
  completion.footer(
      "It is installed with the program. Without that, in the shell:\n\n"
      "  source <(vectrix completion bash)");
  Options(completion).choose("shell", shell, {"bash", "zsh"}, "for which one").required();
}

void add_manual(CLI::App& app, std::string& manual) {
  auto& man = *app.add_subcommand("man", "a page of the manual, as troff");
  man.footer(
      "The pages are installed with the program: man vectrix, man vectrix-scenario. Without that:\n\n"
      "  vectrix man vectrix.1 | man -l -");
  Options(man).choose("page", manual, {"vectrix.1", "vectrix-scenario.5"}, "which one").required();
}

// For docs/reference; of no use to others.
void add_pages(CLI::App& app, bool& of_result, std::string& folder) {
  auto& schema = *app.add_subcommand("schema", "the page of the scenario file")->group("");
  Options(schema).flag("--result", of_result, "that of the result file");
  auto& pages = *app.add_subcommand("pages", "the pages of the commands")->group("");
  Options(pages).add("folder", folder, "FOLDER", "where they are written").required();
}

}  // namespace

void add_commands(CLI::App& app, CommandWords& words, const std::string& version) {
  app.description("attitude files checked, measured and converted, flights judged");
  app.set_version_flag("--version", version);
  app.require_subcommand(1);
  add_check(app, words.check);
  add_pointing(app, words.pointing);
  add_convert(app, words.convert);
  add_replay(app, words.replay);
  add_report(app, words.report);
  add_frames(app, words.frames);
  add_completion(app, words.shell);
  add_manual(app, words.manual);
  add_pages(app, words.of_result, words.folder);
}

ProgramDescription described_program(const std::string& version) {
  CLI::App app;
  CommandWords words;
  add_commands(app, words, version);
  return described(app, version);
}

}  // namespace vectrix::cli
