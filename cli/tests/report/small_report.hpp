#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "report/report.hpp"

namespace vectrix::cli {

/// Small reports, and what their pages hold.

inline Report::Plot plot(std::vector<double> values) {
  Report::Plot plot{"P", "deg", "Body", {}, {{"x", std::move(values)}}};
  for (std::size_t i = 0; i < plot.curves[0].values.size(); ++i)
    plot.seconds.push_back(0.5 * static_cast<double>(i));
  return plot;
}
inline Report::Scene scene(std::size_t count) {
  Report::Scene scene{.body = "Body", .reference = "GCRF", .seconds = {}, .reference_from_body = {}};
  for (std::size_t i = 0; i < count; ++i) {
    scene.seconds.push_back(static_cast<double>(i));
    scene.reference_from_body.push_back(Eigen::Quaterniond::Identity());
  }
  return scene;
}
inline Report report(std::vector<Report::Plot> plots = {}) {
  Report report{.title = "T", .start = Epoch::from_utc("2026-11-29T00:00:00"), .version = "0"};
  report.plots = std::move(plots);
  return report;
}
inline Report report(Report::Scene scene) {
  Report all = report();
  all.scene = std::move(scene);
  return all;
}
// A page is too long to be shown.
inline ::testing::AssertionResult holds(const std::string& page, const std::string& words) {
  if (page.find(words) != std::string::npos) return ::testing::AssertionSuccess();
  return ::testing::AssertionFailure() << "'" << words << "' is not in the page";
}
inline std::size_t count_of(const std::string& text, const std::string& words) {
  std::size_t count = 0;
  for (auto at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++count;
  return count;
}

}  // namespace vectrix::cli
