#include "report/report.hpp"

#include <algorithm>
#include <sstream>

#include "figures.hpp"
#include "report/assets.hpp"
#include "report/check.hpp"
#include "report/data.hpp"
#include "report/plot.hpp"
#include "report/scene.hpp"
#include "report/text.hpp"
#include "report/thinning.hpp"

namespace vectrix::cli {
namespace {

std::string time_text(const Report& report, double seconds) {
  std::ostringstream out;
  out << report.start + seconds * si::second;
  return out.str();
}
std::string start_text(const Report& report) {
  return time_text(report, 0.0);
}

std::string page_section(const std::string& name, const std::string& inside) {
  return element("section", element("h2", escaped(name)) + inside) + "\n";
}

std::string table_row(const char* cell, const std::vector<std::string>& texts) {
  std::string cells;
  for (const std::string& text : texts) cells += element(cell, escaped(text));
  return element("tr", cells);
}
std::string html_table(const std::vector<std::string>& headings,
                       const std::vector<std::vector<std::string>>& rows) {
  std::string body;
  for (const auto& texts : rows) body += table_row("td", texts) + "\n";
  return element("div", {{"class", "wide"}},
                 element("table", element("thead", table_row("th", headings)) + element("tbody", body)));
}

std::string page_header(const Report& report) {
  std::string under = "Time 0 is " + start_text(report);
  if (const auto axis = time_axis(report))
    under = (axis->first == 0.0 ? "" : under + ". ") + "From " + time_text(report, axis->first) + " to " +
            time_text(report, axis->last) + ", " + shown(axis->in_unit(axis->last - axis->first)) + " " +
            axis->unit;
  return element("header", element("h1", escaped(report.title)) + element("p", escaped(under)));
}

std::string facts_section(const Report& report) {
  if (report.facts.empty()) return "";
  std::string list;
  for (const auto& fact : report.facts)
    list += element("div", element("dt", escaped(fact.name)) + element("dd", escaped(fact.value)));
  return page_section("What was asked", element("dl", list));
}

std::string verdicts_section(const Report& report) {
  if (report.verdicts.empty()) return "";
  std::string rows;
  for (const auto& v : report.verdicts)
    rows += element("tr", element("td", {{"class", v.fulfilled ? "good" : "bad"}},
                                  v.fulfilled ? "\u2713 fulfilled" : "\u2717 not fulfilled") +
                              element("td", escaped(v.what)) + element("td", escaped(v.required)) +
                              element("td", {{"class", "number"}}, escaped(v.reached)) +
                              element("td", {{"class", "number"}}, escaped(v.margin)));
  const auto good = std::count_if(report.verdicts.begin(), report.verdicts.end(),
                                  [](const auto& verdict) { return verdict.fulfilled; });
  const std::string sum =
      detail::text(good) + " of " + counted(report.verdicts.size(), "requirement") + " fulfilled";
  return page_section(
      sum, element("div", {{"class", "wide"}},
                   element("table", {{"class", "verdicts"}},
                           element("thead", table_row("th", {"Verdict", "Requirement", "Required", "Reached",
                                                             "Margin"})) +
                               element("tbody", rows))));
}

std::string select_option(const std::string& value, const std::string& text) {
  return element("option", {{"value", value}}, escaped(text));
}
std::string select_box(const std::string& id, const std::string& name, const std::string& options) {
  return element("label", escaped(name) + " " + element("select", {{"id", id}}, options));
}

// Hidden until the script works them.
std::string time_controls(const Report& report) {
  std::string text =
      "<button id=\"play\" type=\"button\">Play</button>"
      "<input id=\"time\" type=\"range\" aria-label=\"time\">"
      "<output id=\"clock\" for=\"time\"></output>" +
      select_box("speed", "speed", "");
  if (report.scene) {
    std::string views = select_option("reference", report.scene->reference), trails;
    for (std::size_t i = 0; i < report.scene->views.size(); ++i)
      views += select_option(detail::text(i), report.scene->views[i].name);
    views += select_option("body", report.scene->body);
    for (const auto& axis : report.scene->axes) trails += select_option("", axis.name);
    for (const char* axis : {"x", "y", "z"})
      trails += select_option("", std::string(axis) + " " + report.scene->body);
    text += select_box("view", "seen from", views) +
            select_box("trail", "trail of", trails + select_option("none", "none"));
  }
  return element(
      "div", {{"id", "controls"}, {"hidden", ""}, {"role", "group"}, {"aria-label", "time and view"}}, text);
}

// How the samples between those that are kept turn.
std::string attitude_caption(const Report::Scene& scene, const std::string& first) {
  const auto are_gaps = gaps_of(scene);
  const auto places = even_samples(are_gaps, most_samples(scene));
  double largest = 0.0;
  for (std::size_t k = 0; k + 1 < places.size(); ++k) {
    double turn = 0.0;
    for (std::size_t i = places[k]; i < places[k + 1]; ++i)
      turn += scene.reference_from_body[i].angularDistance(scene.reference_from_body[i + 1]);
    largest = std::max(largest, turn);  // not of gaps, which are NaN
  }
  const auto kept_gaps =
      std::count_if(places.begin(), places.end(), [&](std::size_t i) { return are_gaps[i]; });
  const auto gaps = std::count(are_gaps.begin(), are_gaps.end(), true);
  return detail::text(places.size() - static_cast<std::size_t>(kept_gaps)) + " of " +
         counted(scene.seconds.size() - static_cast<std::size_t>(gaps), "sample") +
         "; from one to the next the body turns by at most " + shown(degrees * largest) +
         " deg. On paper, and in a browser without WebGL, the drawing is of the first time, " + first + ".";
}

std::string scene_figure(const Report::Scene& scene, const std::string& first) {
  return element(
      "figure", {{"id", "scene"}},
      element("figcaption", element("b", escaped(scene.body + " relative to " + scene.reference))) +
          "<div id=\"canvas\" hidden tabindex=\"0\" role=\"img\" aria-label=\"three-dimensional view; "
          "the arrow keys turn it, plus and minus change its size\"></div>" +
          scene_svg(scene) + element("p", {{"class", "note"}}, escaped(attitude_caption(scene, first))) +
          element("details", {{"id", "shown"}, {"hidden", ""}}, element("summary", "What is shown")));
}

std::string track_figure(const Report::Scene& scene) {
  if (scene.ground_track.empty()) return "";
  return element("figure", {{"id", "ground"}},
                 element("figcaption", element("b", "Ground track")) + ground_track_svg(scene.ground_track));
}

std::string plot_figure(const Report::Plot& plot, const Report& report, const TimeAxis& axis) {
  std::string legend;
  for (std::size_t i = 0; i < plot.curves.size(); ++i)
    legend += element("li", element("i", {{"class", curve_class(i)}}, "") + escaped(plot.curves[i].name) +
                                " " + element("output", ""));
  const std::size_t kept = kept_samples(plot.curves, most_samples(plot, report.plots.size())).size();
  std::string note;
  if (kept < plot.seconds.size())
    note = element("p", {{"class", "note"}},
                   escaped(detail::text(kept) + " of " + counted(plot.seconds.size(), "sample") +
                           " are kept: of equal parts of them, the smallest and the largest of each curve."));
  return element("figure", {{"class", "plot"}},
                 element("figcaption", element("b", escaped(heading_of(plot))) + element("ul", legend)) +
                     element("div", {{"class", "live"}}, "") + plot_svg(plot, axis, start_text(report)) +
                     note) +
         "\n";
}

std::string motion_section(const Report& report) {
  const auto axis = time_axis(report);
  if (!axis) return "";
  std::string plots;
  for (const auto& each : report.plots) plots += plot_figure(each, report, *axis);
  if (report.scene) plots += track_figure(*report.scene);
  const std::string keys = element(
      "details", {{"id", "keys"}, {"hidden", ""}},
      "<summary>Keys</summary><p><kbd>space</kbd> plays and pauses. <kbd>\u2190</kbd> <kbd>\u2192</kbd> "
      "step, "
      "with <kbd>shift</kbd> ten times as far; <kbd>Home</kbd> <kbd>End</kbd> go to the ends. <kbd>+</kbd> "
      "<kbd>-</kbd> zoom the time of all plots, <kbd>0</kbd> shows all of it. In the view the arrows turn "
      "it. With a "
      "mouse: drag in a plot to zoom, double-click to see all, click to go to a time.</p>");
  return page_section(
      report.scene ? "Motion" : "Curves",
      time_controls(report) + keys +
          element(
              "div", {{"id", "figures"}, {"class", report.scene ? "two" : "one"}},
              (report.scene ? scene_figure(*report.scene, time_text(report, report.scene->seconds.front()))
                            : "") +
                  element("div", {{"id", "plots"}}, plots)));
}

std::string table_sections(const Report& report) {
  std::string text;
  for (const auto& each : report.tables)
    text += page_section(each.title, html_table(each.headings, each.rows));
  return text;
}

std::string provenance_section(const Report& report) {
  std::string text;
  if (!report.inputs.empty()) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& input : report.inputs)
      rows.push_back({input.path, detail::text(input.bytes), input.sha256});
    text += element("h3", "Inputs") + html_table({"File", "Bytes", "SHA-256"}, rows);
  }
  if (!report.choices.empty()) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& choice : report.choices) rows.push_back({choice.what, choice.value, choice.by});
    text += element("h3", "Conventions, and who states them") +
            html_table({"Convention", "Value", "Stated by"}, rows);
  }
  text += element("p", "Written by vectrix " + escaped(report.version) + ".");
  text += element("details", "<summary>Licences of the software in this page</summary>" +
                                 element("pre", escaped(report_licences)));
  return page_section("Provenance", text);
}

}  // namespace

std::string html(const Report& report) {
  require_consistent(report);
  // The browser itself keeps the page from the network.
  return "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
         "script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:\">"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">"
         "<meta name=\"color-scheme\" content=\"light dark\">" +
         element("title", escaped(report.title)) + element("style", report_style) + "</head>\n<body>\n" +
         page_header(report) +
         element("main", verdicts_section(report) + facts_section(report) + motion_section(report) +
                             table_sections(report) + provenance_section(report)) +
         "\n" + element("script", {{"type", "application/json"}, {"id", "data"}}, data_of_page(report)) +
         "\n" + element("script", report_script) + "\n</body></html>\n";
}

}  // namespace vectrix::cli
