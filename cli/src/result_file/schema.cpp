#include "result_file/schema.hpp"

#include <algorithm>
#include <cctype>

namespace vectrix::cli {
namespace {

// Of instants and of samples, which may be one dataset.
constexpr const char* meaning_of_tai = "the Julian date in TAI in two parts, which lose nothing";
constexpr const char* meaning_of_seconds = "the same times, SI seconds since the first instant";
constexpr const char* meaning_of_quaternion =
    "R(q) takes coordinates from the body to the reference; scalar first, Hamilton's product, norm 1, the "
    "sign without jumps";
constexpr const char* meaning_of_gaps = "beginning and end of each step longer than longest_step";

// With N for each part that is a number.
std::string general(const std::string& path) {
  std::string all;
  for (std::size_t at = 0; at < path.size();) {
    const std::size_t end = std::min(path.find('/', at + 1), path.size());
    const bool is_number = std::all_of(path.begin() + static_cast<std::ptrdiff_t>(at) + 1,
                                       path.begin() + static_cast<std::ptrdiff_t>(end),
                                       [](unsigned char c) { return std::isdigit(c) != 0; });
    all += is_number ? "/N" : path.substr(at, end - at);
    at = end;
  }
  return all;
}

std::string form_of(const Hdf5Entry& entry) {
  std::string form = entry.kind == Hdf5Kind::numbers         ? "numbers"
                     : entry.kind == Hdf5Kind::whole_numbers ? "whole numbers"
                                                             : "texts";
  if (!entry.rows.empty()) form += ", one row for each " + std::string(entry.rows);
  if (entry.columns > 1) form += ", " + std::to_string(entry.columns) + " columns";
  return form;
}

}  // namespace

const std::vector<Hdf5Entry>& result_entries() {
  using enum Hdf5Kind;
  static const std::vector<Hdf5Entry> all{
      {"/attitude/tai", numbers, "instant", 2, "d", meaning_of_tai,
       "scale, tai_minus_utc_first, tai_minus_utc_last"},
      {"/attitude/seconds", numbers, "instant", 1, "s", meaning_of_seconds, "since_utc, since_tt"},
      {"/attitude/quaternion", numbers, "instant", 4, "1", meaning_of_quaternion, "from, to, scalar"},
      {"/attitude/gaps", numbers, "gap", 2, "s", meaning_of_gaps, "since_utc, since_tt, longest_step"},
      {"/samples/tai", numbers, "sample", 2, "d", meaning_of_tai,
       "scale, tai_minus_utc_first, tai_minus_utc_last"},
      {"/samples/seconds", numbers, "sample", 1, "s", meaning_of_seconds, "since_utc, since_tt"},
      {"/samples/quaternion", numbers, "sample", 4, "1", meaning_of_quaternion, "from, to, scalar"},
      {"/samples/gaps", numbers, "gap", 2, "s", meaning_of_gaps, "since_utc, since_tt, longest_step"},
      {"/samples/rate", numbers, "sample", 3, "rad/s",
       "the angular velocity that the file has, of the body relative to the reference, in the body; if it "
       "has one",
       "of, relative_to, in"},
      {"/orbit/position", numbers, "instant", 3, "m",
       "of the satellite relative to the centre of the Earth; /orbit only if the scenario has one",
       "of, relative_to, in"},
      {"/orbit/velocity", numbers, "instant", 3, "m/s", "its velocity", "of, relative_to, observed_from, in"},
      {"/orbit/geodetic", numbers, "instant", 2, "deg", "geodetic latitude and longitude, WGS-84", ""},
      {"/orbit/visible_sun", numbers, "instant", 1, "1",
       "the part of the Sun's disc that the Earth does not hide: 1 in sunlight, 0 in shadow", ""},
      {"/frames/names", texts, "frame", 1, "", "the frames that are fixed in the body", ""},
      {"/frames/quaternion", numbers, "frame", 4, "1",
       "R(q) takes coordinates from the frame to the body; scalar first", "to, scalar"},
      {"/measures/names", texts, "measure", 4, "",
       "name; what the angle is; its axis; its target. The data of the first are in /measures/1, and so on",
       ""},
      {"/measures/axis", numbers, "measure", 3, "1", "unit vector of the axis", "in"},
      {"/measures/N/angle", numbers, "instant", 1, "deg", "the angle between axis and target", "name, what"},
      {"/measures/N/hidden", whole_numbers, "instant", 1, "1",
       "1: the Earth hides the target, 0: not; only of the Sun, the Moon, stars and stations, seen from an "
       "orbit",
       "name"},
      {"/measures/N/direction", numbers, "instant", 3, "1", "unit vector to the target", "in, name"},
      {"/verdicts/measure", whole_numbers, "requirement", 1, "1", "of which measure, from 1 on", ""},
      {"/verdicts/required", numbers, "requirement", 1, "deg", "the largest error that is allowed", ""},
      {"/verdicts/percent", numbers, "requirement", 1, "%", "of the samples or windows", ""},
      {"/verdicts/window", numbers, "requirement", 1, "s",
       "of the relative error; 0 if the absolute error is judged", ""},
      {"/verdicts/when", texts, "requirement", 1, "", "always, sunlight, shadow or visible", ""},
      {"/verdicts/reached", numbers, "requirement", 1, "deg", "the least that so many percent do not exceed",
       ""},
      {"/verdicts/margin", numbers, "requirement", 1, "deg", "required less reached", ""},
      {"/verdicts/within", whole_numbers, "requirement", 1, "1",
       "how many samples or windows are at most required", ""},
      {"/verdicts/judged", whole_numbers, "requirement", 1, "1", "of how many", ""},
      {"/verdicts/fulfilled", whole_numbers, "requirement", 1, "1", "1: yes, 0: no", ""},
      {"/verdicts/texts", texts, "requirement", 4, "", "what; required; reached; margin", ""},
      {"/choices", texts, "convention", 3, "", "what; its value; who states it, with the line", ""},
      {"/inputs/paths", texts, "file", 1, "", "every file that was read", ""},
      {"/inputs/bytes", whole_numbers, "file", 1, "B", "its size", ""},
      {"/inputs/sha256", texts, "file", 1, "", "its checksum", ""},
      {"/scenario/paths", texts, "file", 1, "", "the scenario file, then those that it includes", ""},
      {"/scenario/texts", texts, "file", 1, "", "its whole text", ""},
      {"/page/facts", texts, "fact", 2, "", "what the report says was asked: name; value", ""},
      {"/page/tables/titles", texts, "table", 1, "", "the tables of the report; the first is /page/tables/1",
       ""},
      {"/page/tables/N/headings", texts, "column", 1, "", "of the columns", ""},
      {"/page/tables/N/rows", texts, "row", 0, "", "the rows", ""},
  };
  return all;
}

const Hdf5Entry& result_entry(const std::string& path) {
  const std::string wanted = general(path);
  const auto& all = result_entries();
  return *std::find_if(all.begin(), all.end(), [&](const Hdf5Entry& each) { return each.path == wanted; });
}

std::string result_page() {
  std::string page =
      "# The result file\n\n"
      "`vectrix replay file.toml --hdf5 out.h5` writes what it found as HDF5. This page is written by `./dev "
      "docs` from the\n"
      "description with which the program writes and reads the file;\n"
      "[store_a_result.md](../howto/store_a_result.md) shows how to use it.\n\n"
      "- Every dataset has the attribute `meaning`, and numbers have `unit`. Frames are attributes too: "
      "`from`, `to`, `of`,\n"
      "  `relative_to`, `observed_from`, `in`, with the words of [notation.md](notation.md).\n"
      "- The file itself has the attributes `format`, `form` (" +
      std::to_string(result_form) +
      "), `version`, `title`, `body` and `reference`, the frames of the attitude.\n"
      "- `/attitude` has the instants that are looked at. `/samples` has the samples of the attitude file, "
      "from "
      "the one before the\n"
      "  first instant to the one after the last; without `time.step` they are the instants.\n"
      "- Numbers are stored as they are in the program, in 8 bytes, compressed (shuffle and deflate) and "
      "with checksums. There is\n"
      "  no NaN: a gap is between two rows.\n"
      "- Texts are UTF-8, filled with zeros to one length.\n\n"
      "| dataset | form | unit | meaning | attributes |\n| --- | --- | --- | --- | --- |\n";
  for (const Hdf5Entry& entry : result_entries())
    page += "| `" + std::string(entry.path) + "` | " + form_of(entry) + " | " + std::string(entry.unit) +
            " | " + std::string(entry.meaning) + " | " + std::string(entry.words) + " |\n";
  return page;
}

}  // namespace vectrix::cli
