#include <CLI/CLI.hpp>
#include <exception>
#include <fstream>
#include <iostream>
#include <map>

#include "check.hpp"

namespace {

using namespace vectrix;
using namespace vectrix::cli;

constexpr int fits = 0, does_not_fit = 1, bad_input = 2;

// What the options of `check` say, before the file tells whether it is a table.
struct Words {
  CheckOptions options;
  TableColumns columns;
  std::string time, scale = "utc", scalar, maps, rate_unit, rate_axes = "body", target;
  std::vector<double> axis;
};

bool is_message(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw BadInput(file.string() + ": cannot be read");
  std::string word;
  in >> word;
  if (word.starts_with("\xef\xbb\xbf")) word.erase(0, 3);
  return word.starts_with("CCSDS_") || word.starts_with("<?xml") || word == "COMMENT";
}

const std::map<std::string, TimeScale> scales{
    {"utc", scale::utc}, {"tai", scale::tai}, {"tt", scale::tt}, {"tdb", scale::tdb}, {"gps", scale::gps}};
const std::map<std::string, Target> targets{
    {"sun", Target::sun}, {"moon", Target::moon}, {"earth", Target::earth}};

// No convention is taken that nobody has stated.
TableColumns columns_of(const Words& words) {
  std::string missing;
  const auto need = [&](bool given, const char* option) {
    if (!given) missing += std::string(missing.empty() ? "" : ", ") + option;
  };
  need(!words.columns.time.empty(), "--time COLUMN");
  need(!words.columns.quaternion.empty(), "--quaternion COLUMN,COLUMN,COLUMN,COLUMN");
  need(!words.scalar.empty(), "--scalar first|last");
  need(!words.maps.empty(), "--maps body|reference");
  need(!words.columns.reference.empty(), "--reference EME2000|GCRF");
  need(words.columns.rates.empty() || !words.rate_unit.empty(), "--rate-unit rad/s|deg/s");
  if (!missing.empty())
    throw BadInput(words.options.file.string() +
                   ": a table does not say what its columns mean; missing: " + missing);
  TableColumns columns = words.columns;
  columns.scale = scales.at(words.scale);
  columns.stated = {words.scalar == "first" ? Convention::Scalar::first : Convention::Scalar::last,
                    words.maps == "body" ? Convention::Maps::to_body : Convention::Maps::to_reference};
  columns.rates_in_degrees = words.rate_unit == "deg/s";
  columns.rate_axes = words.rate_axes == "body" ? RateAxes::body : RateAxes::reference;
  return columns;
}

void add_check(CLI::App& app, Words& words) {
  auto& check = *app.add_subcommand("check", "say which reading of an attitude file its rates, orbit or target fit");
  check.footer(
      "Readings: as stated; transposed; with the scalar at the other end; both. None is chosen for you.\n"
      "Exit code: 0 if a comparison confirms the file as stated and none prefers another reading, 1 if not,\n"
      "2 if the input is wrong.\n\n"
      "  vectrix check attitude.aem --tle satellite.tle\n"
      "  vectrix check attitude.csv --time time_utc --quaternion q0,q1,q2,q3 --scalar last --maps reference \\\n"
      "      --reference EME2000 --rates wx,wy,wz --rate-unit rad/s");
  check.add_option("file", words.options.file, "CCSDS AEM (KVN), or a table with a header line")->required();
  check.add_option("--segment", words.options.segment, "of an AEM with several, counted from 1");
  const char* table = "A table";
  check.add_option("--time", words.columns.time, "column of the time")->group(table);
  check.add_option("--scale", words.scale, "of the time: utc, tai, tt, tdb, gps")
      ->group(table)
      ->check(CLI::IsMember({"utc", "tai", "tt", "tdb", "gps"}));
  check.add_option("--quaternion", words.columns.quaternion, "the four columns, with commas, in their order")
      ->group(table)
      ->delimiter(',')
      ->expected(4);
  check.add_option("--scalar", words.scalar, "which of them is the scalar: first or last")
      ->group(table)
      ->check(CLI::IsMember({"first", "last"}));
  check.add_option("--maps", words.maps, "R(q) takes coordinates to the axes of: body or reference")
      ->group(table)
      ->check(CLI::IsMember({"body", "reference"}));
  check.add_option("--reference", words.columns.reference, "EME2000 (J2000) or GCRF (ICRF)")->group(table);
  check.add_option("--rates", words.columns.rates, "three columns: the rate of the body relative to the reference")
      ->group(table)
      ->delimiter(',')
      ->expected(3);
  check.add_option("--rate-unit", words.rate_unit, "rad/s or deg/s")
      ->group(table)
      ->check(CLI::IsMember({"rad/s", "deg/s"}));
  check.add_option("--rate-axes", words.rate_axes, "of the rates: body (default) or reference")
      ->group(table)
      ->check(CLI::IsMember({"body", "reference"}));
  const char* compared = "To compare with";
  check.add_option("--tle", words.options.elements, "file of two-line elements")->group(compared);
  check.add_option("--oem", words.options.orbit, "CCSDS OEM (KVN) in EME2000, GCRF or TEME")->group(compared);
  check.add_option("--axis", words.axis, "x,y,z in the body: what should look at the target")
      ->group(compared)
      ->delimiter(',')
      ->expected(3);
  check.add_option("--target", words.target, "sun, moon or earth")
      ->group(compared)
      ->check(CLI::IsMember({"sun", "moon", "earth"}));
}

int run_check(Words& words) {
  if (!is_message(words.options.file)) words.options.columns = columns_of(words);
  if (!words.axis.empty()) words.options.axis = Eigen::Vector3d(words.axis[0], words.axis[1], words.axis[2]);
  if (!words.target.empty()) words.options.target = targets.at(words.target);
  return check(words.options, std::cout) ? fits : does_not_fit;
}

}  // namespace

int main(int count, char** arguments) {
  CLI::App app("Vectrix: attitude files read, compared and checked");
  app.set_version_flag("--version", VECTRIX_VERSION);
  app.require_subcommand(1);
  Words words;
  try {
    add_check(app, words);
    app.parse(count, arguments);
    return run_check(words);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : bad_input;
  } catch (const std::exception& error) {
    std::cerr << "vectrix: " << error.what() << '\n';
    return bad_input;
  }
}
