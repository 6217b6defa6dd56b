// What the examples write to their tables, over time.
#include "tables.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <vectrix/space/files/csv_table.hpp>

#include "chart.hpp"

namespace pictures {
namespace {

using vectrix::CsvTable;

/// A column of the rows of one case; of all rows if there is none.
struct Curve {
  std::string name, column, of_case;
};
struct Diagram {
  std::string title, unit;
  std::vector<Curve> curves;
};
struct Picture {
  std::string title;
  std::array<Diagram, 2> diagrams;
};

/// Two cases, with one column in each diagram.
Picture of_cases(std::string title, const std::array<std::string, 2>& cases, const Diagram& left,
                 const Diagram& right) {
  Picture picture{std::move(title), {left, right}};
  for (Diagram& diagram : picture.diagrams) {
    const std::string column = diagram.curves.front().column;
    diagram.curves.clear();
    for (const std::string& name : cases) diagram.curves.push_back({name, column, name});
  }
  return picture;
}

const std::map<std::string, Picture, std::less<>>& all() {
  static const std::map<std::string, Picture, std::less<>> pictures{
      {"slew_with_panels",
       of_cases("A slew with flexible panels", {"Switched torque", "Smooth torque"},
                {"Turned", "deg", {{"", "turned_deg", ""}}}, {"Panel 1", "µrad", {{"", "panel_urad", ""}}})},
      {"deploy_panels",
       {"Two wings unfold and latch",
        {Diagram{"Hinges",
                 "deg",
                 {{"wing 1, inner", "inner1_deg", ""},
                  {"wing 1, outer", "outer1_deg", ""},
                  {"wing 2, inner", "inner2_deg", ""},
                  {"wing 2, outer", "outer2_deg", ""}}},
         Diagram{"Rate of the hub",
                 "deg/s",
                 {{"x", "wx_deg_s", ""}, {"y", "wy_deg_s", ""}, {"z", "wz_deg_s", ""}}}}}},
      {"flat_spin",
       {"Flat spin and dual-spin turn",
        {Diagram{"Nutation in a flat spin", "deg", {{"", "nutation_deg", "Flat spin"}}},
         Diagram{"Nutation in a dual-spin turn",
                 "deg",
                 {{"0.05 N m", "nutation_deg", "Dual-spin turn by 0.05 N m"},
                  {"0.005 N m", "nutation_deg", "Dual-spin turn by 0.005 N m"}}}}}},
      {"cmg_pyramid",
       of_cases("Four control moment gyros pass a singularity",
                {"Pseudo-inverse", "Singularity-robust inverse"}, {"Turned", "deg", {{"", "turned_deg", ""}}},
                {"det A Aᵀ", "", {{"", "det", ""}}})},
      {"slosh_burn",
       of_cases("Slosh in a burn",
                {"Controller with baffles of 0.5 N m s", "Controller with a notch and baffles of 0.5 N m s"},
                {"Pendulum in the tank", "deg", {{"", "slosh_deg", ""}}},
                {"Pitch", "deg", {{"", "pitch_deg", ""}}})}};
  return pictures;
}

std::vector<Point> points_of(const CsvTable& table, const Curve& curve) {
  std::vector<Point> points;
  for (std::size_t row = 0; row < table.rows(); ++row)
    if (curve.of_case.empty() || table.text(row, "case") == curve.of_case)
      points.push_back({table.number(row, "t_s"), table.number(row, curve.column)});
  if (points.empty()) throw vectrix::BadInput("no row of the table has the case " + curve.of_case);
  return points;
}

void draw(Svg& svg, const CsvTable& table, const Diagram& diagram, double left) {
  constexpr std::array colours{colour::orange, colour::blue, colour::green, colour::purple};
  std::vector<std::vector<Point>> curves;
  Point least{0.0, 0.0}, most{0.0, 0.0};
  for (const Curve& curve : diagram.curves) {
    curves.push_back(points_of(table, curve));
    for (const Point& p : curves.back()) {
      least = {std::min(least.x, p.x), std::min(least.y, p.y)};
      most = {std::max(most.x, p.x), std::max(most.y, p.y)};
    }
  }
  const double names = diagram.curves.size() > 1 ? 0.2 * (most.y - least.y) : 0.0;
  const Axis x = round_steps("time, s", least.x, most.x),
             y = round_steps(diagram.unit, least.y, most.y + names);
  Chart chart(svg, {left, 40}, {left + 380, 410}, diagram.title, x, y);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    chart.curve(curves[i], {colours[i], 1.5}, false);
    chart.label({x.from, y.to}, diagram.curves[i].name, {colours[i], 12.0}, {8, 17.0 + 15.0 * double(i)});
  }
}

}  // namespace

std::string drawn_examples() {
  std::string names;
  for (const auto& [name, picture] : all()) names += (names.empty() ? "" : "|") + name;
  return names;
}

std::string of_table(std::string_view example, const std::filesystem::path& path) {
  const auto found = all().find(example);
  if (found == all().end()) return {};
  const auto table = CsvTable::read(path, {"t_s"});
  Svg svg(960, 470, found->second.title);
  draw(svg, table, found->second.diagrams[0], 78);
  draw(svg, table, found->second.diagrams[1], 552);
  return svg.text();
}

}  // namespace pictures
