#include "scenario/schema.hpp"

#include <algorithm>

#include "scenario/place.hpp"

namespace vectrix::cli {
namespace {

constexpr bool needed = true, optional = false;

Key choice(std::string name, bool is_needed, std::string help, std::vector<std::string_view> choices) {
  return {std::move(name), Kind::choice, is_needed, std::move(help), std::move(choices)};
}
Key amount(std::string name, bool is_needed, Dimension dimension, std::string help) {
  return {std::move(name), Kind::amount, is_needed, std::move(help), {}, dimension, 1};
}
Key several(std::string name, Kind kind, bool is_needed, std::size_t count, std::string help) {
  return {std::move(name), kind, is_needed, std::move(help), {}, Dimension::angle, count};
}
Key table(std::string name, bool is_needed, std::string help, std::vector<Key> keys) {
  return {std::move(name),  Kind::table,    is_needed,      std::move(help), {},
          Dimension::angle, std::size_t{0}, std::move(keys)};
}
Key tables(std::string name, std::string help, std::vector<Key> keys) {
  Key key = table(std::move(name), optional, std::move(help), std::move(keys));
  key.kind = Kind::tables;
  return key;
}

Key time_column() {
  return table("time", optional, "the times of a table",
               {{"column", Kind::text, needed, "its column"},
                choice("scale", needed, "the time scale", {"UTC", "TAI", "TT", "TDB", "GPS"})});
}
Key scalar(bool is_needed) {
  return choice("scalar", is_needed, "which of the four numbers is the scalar", {"first", "last"});
}
Key maps(const std::string& more = "") {
  return table(
      "maps", needed, "v_to = R v_from: between which frames it takes coordinates" + more,
      {{"from", Kind::text, needed, "the frame of v_from"}, {"to", Kind::text, needed, "the frame of v_to"}});
}

Key time() {
  return table(
      "time", optional, "the part of the flight that is looked at; by default all of it",
      {{"start", Kind::epoch, optional, "its begin"},
       {"end", Kind::epoch, optional, "its end"},
       amount("step", optional, Dimension::duration,
              "look at start, start + step and so on, the attitude turning at a constant rate between its "
              "samples; a gap between two instants is not seen; by default at the samples")});
}

Key earth() {
  return table("earth", optional,
               "how the Earth turns; needed by an orbit or an attitude relative to ITRF, and by stations",
               {{"orientation", Kind::input, needed, "file finals2000A of the IERS"}});
}

Key orbit() {
  return table(
      "orbit", optional, "the orbit: one of tle, omm, oem, spk and table",
      {{"tle", Kind::input, optional,
        "file of two-line elements; the set nearest to the middle of the time that is looked at is taken"},
       {"omm", Kind::input, optional, "the same elements as messages of CCSDS (OMM, KVN or XML)"},
       {"satellite", Kind::text, optional,
        "of elements of several satellites: which one, by its number in the catalogue, \"25544\", or its "
        "designator as written"},
       {"oem", Kind::input, optional,
        "orbit message of CCSDS (OEM, KVN or XML) in EME2000, GCRF, TEME or ITRF"},
       {"spk", Kind::input, optional, "kernel of SPICE (SPK) with one spacecraft"},
       {"table", Kind::input, optional,
        "table (CSV); it needs time, position, velocity, unit, frame and interpolation"},
       table("interpolation", optional, "of a table, or of an OEM that does not say it",
             {choice("method", needed, "the polynomial", {"hermite", "lagrange"}),
              {"degree", Kind::whole_number, needed, "hermite odd, 3 to 15; lagrange 2 to 15"}}),
       time_column(),
       several("position", Kind::texts, optional, 3, "the columns x, y, z of the position"),
       several("velocity", Kind::texts, optional, 3,
               "the columns of the velocity, as seen in the same frame"),
       choice("unit", optional, "of positions, and with /s of velocities", {"m", "km"}),
       choice("frame", optional, "in whose axes they are", {"GCRF", "ICRF", "EME2000", "J2000", "ITRF"})});
}

Key attitude() {
  return table(
      "attitude", needed, "the attitude that was flown",
      {{"file", Kind::input, needed,
        "attitude message of CCSDS (AEM, KVN or XML), which says the rest itself, kernel of SPICE (CK), "
        "result of an earlier replay (HDF5), of which the samples are taken, or table (CSV)"},
       {"clock", Kind::input, optional, "of a kernel of SPICE, which needs it: its clock kernel (SCLK)"},
       {"frames", Kind::input, optional, "of a kernel of SPICE: its frame kernel (FK), for names"},
       {"kernel_frame", Kind::text, optional,
        "of a kernel of SPICE with several frames: which one, by name or number"},
       {"leap_seconds", Kind::input, optional,
        "of a kernel of SPICE: a kernel (LSK) with newer leap seconds, for every time in UTC"},
       {"segment", Kind::whole_number, optional, "of a message with several, counted from 1"},
       time_column(),
       table("quaternion", optional, "the quaternions of a table",
             {several("columns", Kind::texts, needed, 4, "their columns, in the order of the file"),
              scalar(needed),
              maps("; one is a reference: EME2000 (J2000), GCRF (ICRF), TEME, TOD, MOD, CIRF, TIRF, ITRF, or "
                   "a frame of the orbit, "
                   "LVLH, "
                   "RTN (RSW), TNW, NTW or VNC")}),
       table("rates", optional, "angular velocities of a table: compared with the turns of the quaternions",
             {several("columns", Kind::texts, needed, 3, "their columns"),
              choice("unit", needed, "of the numbers", {"rad/s", "deg/s"}),
              {"of", Kind::text, needed, "what turns: the body, or a frame fixed in it"},
              {"relative_to", Kind::text, needed, "relative to what: the reference of the quaternions"},
              {"in", Kind::text, needed, "in whose axes: the reference, the body, or a frame fixed in it"}}),
       amount("gap", optional, Dimension::duration,
              "a longer step between samples is a gap; by default three times the usual step")});
}

Key frame() {
  return tables(
      "frame", "a frame fixed in the body, by one of quaternion, dcm and euler",
      {{"name", Kind::name, needed, "its name"},
       table("quaternion", optional, "by Hamilton's product: v_to = q v_from q*, of any norm",
             {several("numbers", Kind::numbers, needed, 4, "the four numbers"), scalar(needed), maps()}),
       table("dcm", optional, "by a direction cosine matrix",
             {several("rows", Kind::rows, needed, 3, "its rows"), maps()}),
       table("euler", optional,
             "by Euler angles: `relative_to` is turned about its own axes until it is `of`",
             {several("axes", Kind::numbers, needed, 3, "about which axes, in turn: [3, 2, 1]"),
              {"angles",
               Kind::amounts,
               needed,
               "by which angles: \"[10, 20, 30] deg\"",
               {},
               Dimension::angle,
               3},
              {"of", Kind::text, needed, "the frame after the turns"},
              {"relative_to", Kind::text, needed, "the frame before them"}})});
}

Key star() {
  return tables(
      "star", "a star as a target",
      {{"name", Kind::name, needed, "its name"},
       amount("right_ascension", needed, Dimension::angle,
              "along the axes of GCRF, at the epoch of `proper_motion`, or without it at the date"),
       amount("declination", needed, Dimension::angle, "positive north"),
       table("proper_motion", optional,
             "how it moves; without it the star stands still, which for most is below an arcsecond in a "
             "year. Its "
             "radial velocity is taken as zero",
             {{"epoch", Kind::epoch, needed, "of the catalogue, when the star was at this place"},
              amount("right_ascension", needed, Dimension::proper_motion, "of the right ascension"),
              amount("declination", needed, Dimension::proper_motion, "of the declination"),
              choice("cos_declination", needed,
                     "whether the first rate has the factor cos(declination) in it, as in Hipparcos and Gaia",
                     {"included", "not included"}),
              amount("parallax", optional, Dimension::angle, "at most 1 arcsec; by default zero")})});
}

Key station() {
  return tables("station", "a place on the Earth as a target",
                {{"name", Kind::name, needed, "its name"},
                 amount("latitude", needed, Dimension::angle, "geodetic, positive north"),
                 amount("longitude", needed, Dimension::angle, "positive east"),
                 amount("height", needed, Dimension::length, "above the ellipsoid WGS-84")});
}

Key when(std::string help) {
  return choice("when", optional, std::move(help), {"sunlight", "shadow", "visible"});
}

Key measure() {
  return tables(
      "measure", "how far an axis of the body is from a target",
      {{"name", Kind::name, needed, "its name"},
       {"axis", Kind::axis, needed,
        "what should look at the target: \"-z of body\", \"[0, 0.1, 1] of body\""},
       {"target", Kind::text, needed,
        "sun, moon, earth (its centre), \"velocity relative to GCRF\", \"velocity relative to ITRF\", a star "
        "or a "
        "station"},
       choice(
           "correction", optional,
           "of the Sun, the Moon and stars: where it is, where it was when the light left, where it is seen",
           {"geometric", "light_time", "apparent"}),
       when(
           "the figures and what is required are only while the whole disc of the Sun is seen (sunlight) or "
           "none of it (shadow), or while the Earth does not hide the target (visible): the line to the Sun, "
           "the Moon or a star passes beside the ellipsoid, a station has the satellite above its horizon; "
           "how many instants are left out is said; by default none is")});
}

Key contribution() {
  const auto three = [](std::string name, Dimension dimension, std::string help) {
    return Key{std::move(name), Kind::amounts, optional, std::move(help), {}, dimension, 3};
  };
  return tables(
      "contribution",
      "an error that is expected: a small turn, a part of the pointing error budget of some measures",
      {{"name", Kind::name, needed, "its name"},
       several("measures", Kind::texts, needed, 0, "the names of the measures in whose budget it is"),
       {"in", Kind::text, needed,
        "the frame in which it arises: its numbers are turns about the axes x, y, z of this one"},
       choice("kind", needed,
              "the same at all times, a Gauss-Markov process of first order, or a rate times the time since "
              "the last update",
              {"constant", "random", "drift"}),
       three("known", Dimension::angle, "of a constant one that is known: the turns"),
       three("standard_deviations", Dimension::angle,
             "of a constant or a random one: of three independent turns"),
       table("covariance", optional, "the same for turns that are not independent",
             {several("rows", Kind::rows, needed, 3, "its rows"),
              choice("unit", needed, "whose square is the unit of the numbers",
                     {"deg", "rad", "mrad", "arcmin", "arcsec", "mas"})}),
       amount("correlation_time", optional, Dimension::duration,
              "of a random one: after it the correlation is 1/e"),
       three("known_rate", Dimension::rate, "of a drift that is known: the rates"),
       three("standard_deviations_of_rate", Dimension::rate, "of a drift: of three independent rates"),
       amount("since_update", optional, Dimension::duration,
              "of a drift: the time since the last update, for whose end the figures are; a window ends "
              "there")});
}

Key requirement() {
  return tables(
      "require", "what a measure has to fulfil: the exit code is 1 if one does not",
      {{"measure", Kind::text, needed, "the name of the measure"},
       amount("absolute", optional, Dimension::angle, "the largest absolute error that is allowed"),
       amount("relative", optional, Dimension::angle,
              "the largest relative error that is allowed, in a window"),
       choice("budget", optional,
              "instead of these two: at most what the budget says, of the absolute error, or of the "
              "relative one at any time of a window",
              {"absolute", "relative"}),
       amount("window", optional, Dimension::duration, "of the relative error"),
       amount("percent", needed, Dimension::share, "of the samples, or of the windows"),
       when("what is judged: as of a measure, whose word is taken by default")});
}

Key output() {
  return table("output", optional, "files that are written, relative to the folder of the command",
               {{"report", Kind::output, optional, "a page with all results, .html"},
                {"csv", Kind::output, optional, "a table with the angles of every measure, .csv"}});
}

Key whole_file() {
  return table(
      "", needed, "",
      {{"version", Kind::whole_number, needed, "of this description of the file: 1"},
       {"title", Kind::text, needed, "what the scenario asks"},
       {"include", Kind::inputs, optional,
        "files of the same form, whose keys are taken as if they stood here; a key may be given once"},
       time(),
       earth(),
       orbit(),
       attitude(),
       frame(),
       star(),
       station(),
       measure(),
       requirement(),
       contribution(),
       output()});
}

std::string with_unit(const Key& key) {
  return "with a unit (" + listed(units_of(key.dimension)) + ")";
}

}  // namespace

const Key* Key::find(std::string_view key) const {
  const auto found =
      std::find_if(keys.begin(), keys.end(), [&](const Key& each) { return each.name == key; });
  return found == keys.end() ? nullptr : &*found;
}

const Key& schema() {
  static const Key whole = whole_file();
  return whole;
}

std::string form_of(const Key& key) {
  const std::string count = std::to_string(key.count);
  switch (key.kind) {
    case Kind::text:
      return "text";
    case Kind::name:
      return "text, without commas and quotation marks";
    case Kind::whole_number:
      return "whole number from 1 on";
    case Kind::choice: {
      std::string all;
      for (const std::string_view each : key.choices)
        all.append(all.empty() ? "" : ", ").append(1, '"').append(each) += '"';
      return "one of " + all;
    }
    case Kind::numbers:
      return count + " numbers";
    case Kind::rows:
      return "3 rows of 3 numbers";
    case Kind::texts:
      return key.count == 0 ? "texts, at least one" : count + " texts";
    case Kind::amount:
      return "text: a number " + with_unit(key);
    case Kind::amounts:
      return "text: " + count + " numbers in brackets " + with_unit(key);
    case Kind::axis:
      return "text: an axis, and of which frame";
    case Kind::epoch:
      return "date and time in UTC with Z, or text that ends with its scale";
    case Kind::input:
    case Kind::output:
      return "file";
    case Kind::inputs:
      return "files";
    case Kind::table:
      return "table";
    default:
      return "any number of tables";
  }
}

}  // namespace vectrix::cli
