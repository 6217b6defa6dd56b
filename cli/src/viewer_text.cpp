#include "viewer_text.hpp"

#include <array>
#include <cmath>

#include "figures.hpp"
#include "table_text.hpp"
#include "target.hpp"

namespace vectrix::cli {
namespace {

constexpr int decimals_of_epoch = 9;

/// Of norm 1, along the quaternion before.
std::vector<Eigen::Quaterniond> unit_quaternions(const PlainAttitude& attitude) {
  std::vector<Eigen::Quaterniond> all;
  for (const auto& n : attitude.quaternions) {
    Eigen::Quaterniond q = Eigen::Quaterniond(n[0], n[1], n[2], n[3]).normalized();
    if (!all.empty() && all.back().dot(q) < 0.0) q.coeffs() *= -1.0;
    q.coeffs().array() += 0.0;  // no -0
    all.push_back(q);
  }
  return all;
}

/// The text of the first time, and the seconds from it: both to the nanosecond.
struct Start {
  explicit Start(const Epoch& first) : text(first.utc(decimals_of_epoch)), epoch(Epoch::from_utc(text)) {
    if (text.substr(17, 2) == "60")
      throw BadInput("the first time, " + text + " UTC, is in a leap second, which viewers do not know");
  }
  [[nodiscard]] std::string seconds(const Epoch& t) const {
    return detail::text(std::round((t - epoch).value() * 1e9) / 1e9 + 0.0);  // no -0
  }

  std::string text;
  Epoch epoch;
};

std::string quoted(const std::string& text) {
  std::string all = "\"";
  for (const char c : text) all += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
  return all + "\"";
}

std::string czml(const std::string& object, const Epoch& first, const Epoch& last,
                 const std::string& property) {
  return "[{\"id\":\"document\",\"version\":\"1.0\"},\n{\"id\":" + quoted(object) + ",\"availability\":\"" +
         first.utc(decimals_of_epoch) + "Z/" + last.utc(decimals_of_epoch) + "Z\"," + property + "}]\n";
}

}  // namespace

std::string stk_attitude(const PlainAttitude& given) {
  const PlainAttitude attitude = relative_to_frame(given, inertial(given.reference).value_or("GCRF"));
  constexpr std::array months{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                              "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
  const Start start(attitude.times.front());
  const std::string& t = start.text;  // 2026-11-29T00:00:00.000000000
  const auto month = static_cast<std::size_t>(std::stoi(t.substr(5, 2)) - 1);
  std::string text = "stk.v.11.0\n\nBEGIN Attitude\n\nNumberOfAttitudePoints " +
                     std::to_string(attitude.times.size()) + "\nScenarioEpoch " +
                     std::to_string(std::stoi(t.substr(8, 2))) + " " + months.at(month) + " " +
                     t.substr(0, 4) + " " + t.substr(11) + "\nCentralBody Earth\nCoordinateAxes " +
                     (attitude.reference == "GCRF" ? "ICRF" : "J2000") + "\n\nAttitudeTimeQuaternions\n\n";
  const auto all = unit_quaternions(attitude);
  for (std::size_t i = 0; i < all.size(); ++i) {
    text += start.seconds(attitude.times[i]);
    for (const double number : {all[i].x(), all[i].y(), all[i].z(), all[i].w()})
      text += " " + detail::text(number);
    text += "\n";
  }
  return text + "\nEND Attitude\n";
}

std::string czml_attitude(PlainAttitude attitude, const std::string& object) {
  attitude = relative_to_frame(std::move(attitude), "GCRF");
  const Epoch &first = attitude.times.front(), &last = attitude.times.back();
  const TimeSpan span = from_until(first, last);
  const EarthMotion earth(EarthOrientation::unobserved(span, 0.0 * si::second), span);
  for (std::size_t i = 0; i < attitude.times.size(); ++i) {
    const auto R_itrf_from_gcrf = inverse(earth.rotation(attitude.times[i]));
    const auto& n = attitude.quaternions[i];
    const Eigen::Quaterniond q =
        Eigen::Quaterniond(R_itrf_from_gcrf.matrix()) * Eigen::Quaterniond(n[0], n[1], n[2], n[3]);
    attitude.quaternions[i] = {q.w(), q.x(), q.y(), q.z()};
  }
  const Start start(first);
  std::string text =
      "\n\"orientation\":{\"interpolationAlgorithm\":\"LINEAR\",\"interpolationDegree\":1,\"epoch\":\"" +
      start.text + "Z\",\"unitQuaternion\":[";
  const auto all = unit_quaternions(attitude);
  for (std::size_t i = 0; i < all.size(); ++i) {
    text += (i == 0 ? "\n" : ",\n") + start.seconds(attitude.times[i]);
    add_fields(text, std::array{all[i].x(), all[i].y(), all[i].z(), all[i].w()});
  }
  return czml(object, first, last, text + "]}");
}

std::string czml_orbit(const OrbitRecord& orbit, const std::string& object) {
  const std::string frame = inertial(orbit.lines.ref_frame).value_or(orbit.lines.ref_frame);
  const bool is_fixed = frame.starts_with("ITRF");
  if (!is_fixed && frame != "GCRF")
    throw BadInput(orbit.file + ": the orbit is in " + frame +
                   "; CZML has GCRF and ITRF. --frame GCRF turns it");
  if (orbit.message && small(orbit.message->metadata.center_name) != "earth")
    throw BadInput(orbit.file + ": the centre is " + orbit.message->metadata.center_name +
                   "; of CZML it is the Earth");
  const auto& lines = orbit.lines.lines;
  const Start start(lines.front().time);
  std::string text =
      "\n\"position\":{\"referenceFrame\":\"" + std::string(is_fixed ? "FIXED" : "INERTIAL") + "\",";
  if (orbit.message && orbit.message->metadata.interpolation_degree) {
    const std::string method = small(orbit.message->metadata.interpolation);
    if (method == "lagrange" || method == "hermite")
      text += "\"interpolationAlgorithm\":\"" + std::string(method == "hermite" ? "HERMITE" : "LAGRANGE") +
              "\",\"interpolationDegree\":" + std::to_string(*orbit.message->metadata.interpolation_degree) +
              ",";
  }
  text += "\"epoch\":\"" + start.text + "Z\",\"cartesianVelocity\":[";
  for (std::size_t i = 0; i < lines.size(); ++i) {
    text += (i == 0 ? "\n" : ",\n") + start.seconds(lines[i].time);
    add_fields(text, lines[i].position);
    add_fields(text, lines[i].velocity);
  }
  return czml(object, lines.front().time, lines.back().time, text + "]}");
}

}  // namespace vectrix::cli
