#include "scenario/fixed_frame.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "plain_words.hpp"
#include "reference_frame.hpp"

namespace vectrix::cli {
namespace {

using Eigen::Quaterniond, Eigen::Vector3d;

// The numbers of a quaternion that takes coordinates from one frame to another.
Quaterniond quaternion_of(const ScenarioTable& table) {
  const auto& numbers = table.at("numbers");
  const auto& n = numbers.as<std::vector<double>>();
  const Quaterniond q = table.at("scalar").text() == "first" ? Quaterniond(n[0], n[1], n[2], n[3])
                                                             : Quaterniond(n[3], n[0], n[1], n[2]);
  const double square = q.squaredNorm();
  if (!(square > 0.0 && std::isfinite(square)))
    refuse(numbers.place,
           "the squared norm of the quaternion is " + detail::text(square) + "; it has no direction");
  return q.normalized();
}

Quaterniond dcm_of(const ScenarioTable& table) {
  struct One : moving_frame {};
  struct Other : moving_frame {};
  constexpr double printed = 1e-5;  // rows that are printed with five digits
  const auto& rows = table.at("rows");
  const auto& n = rows.as<std::vector<double>>();
  const Eigen::Matrix3d matrix = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(n.data());
  try {
    const auto nearest = nearest_dcm(to<One>, from<Other>, matrix);
    if (!(nearest.distance <= printed))
      refuse(rows.place, "the rows are no rotation: the nearest one is " + detail::text(nearest.distance) +
                             " off, at most " + detail::text(printed) + " is allowed");
    return quaternion(nearest.dcm).eigen();
  } catch (const BadInput& error) {
    const std::string said = error.what();
    if (said.starts_with(rows.place.file + ':')) throw;
    refuse(rows.place, "the rows are no rotation: " + without_types(said));
  }
}

// R_a^b = R_i(t1) R_j(t2) R_k(t3), b = `of`, a = `relative_to`; active turns.
Quaterniond euler_of(const ScenarioTable& table) {
  const auto& axes = table.at("axes");
  const auto& n = axes.as<std::vector<double>>();
  const auto& angles = table.at("angles").as<Amount>();
  Quaterniond relative_to_from_of = Quaterniond::Identity();
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(n[i] == 1.0 || n[i] == 2.0 || n[i] == 3.0))
      refuse(axes.place, "'frame.euler.axes' holds " + detail::text(n[i]) + "; the axes are 1, 2 and 3");
    if (i > 0 && n[i] == n[i - 1])
      refuse(axes.place, "'frame.euler.axes' turns twice in turn about one axis");
    relative_to_from_of =
        relative_to_from_of *
        Eigen::AngleAxisd(angles.in("rad", i), Vector3d::Unit(static_cast<Eigen::Index>(n[i]) - 1));
  }
  return relative_to_from_of;
}

struct Stated {
  const ScenarioTable& table;
  std::string by, to, from;
  Place place;  // of the two names
};
Stated stated(const ScenarioTable& frame) {
  const ScenarioTable* found = nullptr;
  std::string by;
  for (const char* const key : {"quaternion", "dcm", "euler"}) {
    const auto* const given = frame.table(key);
    if (!given) continue;
    if (found)
      refuse(given->place, "'frame." + by + "' and 'frame." + key + "' are both given; one is needed");
    found = given;
    by = key;
  }
  if (!found) refuse(frame.place, "'frame' needs one of: quaternion, dcm, euler");
  if (by == "euler")
    return {*found, by, found->at("relative_to").text(), found->at("of").text(), found->place};
  const ScenarioTable& maps = *found->table("maps");
  return {*found, by, maps.at("to").text(), maps.at("from").text(), maps.place};
}

}  // namespace

FixedFrame fixed_frame(const ScenarioTable& from) {
  const std::string& name = from.at("name").text();
  if (inertial(name)) refuse(from.at("name").place, "'" + name + "' is the name of a reference");
  if (reference_name(name))
    refuse(from.at("name").place, "'" + name + "' is the name of a frame that is not fixed in a body");
  const Stated said = stated(from);
  if ((said.to == name) == (said.from == name))
    refuse(said.place, "it is stated between '" + said.from + "' and '" + said.to +
                           "'; exactly one of them must be '" + name + "'");
  const Quaterniond to_from_from = said.by == "quaternion" ? quaternion_of(said.table)
                                   : said.by == "dcm"      ? dcm_of(said.table)
                                                           : euler_of(said.table);
  if (said.from == name) return {from.place, name, said.to, to_from_from};
  return {from.place, name, said.from, to_from_from.conjugate()};
}

std::string stated_frame(const ScenarioTable& from) {
  const Stated said = stated(from);
  if (said.by == "euler") {
    const auto& n = said.table.at("axes").as<std::vector<double>>();
    return said.to + " is turned about its own axes " + detail::text(n[0]) + ", " + detail::text(n[1]) +
           ", " + detail::text(n[2]) + " by " + said.table.at("angles").as<Amount>().text() +
           " until it is " + said.from;
  }
  if (said.by == "dcm") return "v_" + said.to + " = R v_" + said.from;
  return "v_" + said.to + " = R(q) v_" + said.from + ", the scalar is " + said.table.at("scalar").text();
}

FixedAxis fixed_axis(const ScenarioValue& from) {
  const std::string& text = from.text();
  const auto refuse_at = [&](std::size_t at, const std::string& why) {
    Place place = from.place;
    place.column += at;
    refuse(place, "'" + from.path + "' is '" + text + "': " + why);
  };
  std::size_t at = 0;
  Vector3d vector = Vector3d::Zero();
  if (text.front() == '[') {
    try {
      const auto numbers = parse_numbers(text, at, 3);
      vector = Vector3d(numbers[0], numbers[1], numbers[2]);
    } catch (const AmountError& error) {
      refuse_at(error.at(), error.what());
    }
    if (!(vector.norm() > 0.0) || !std::isfinite(vector.norm())) refuse_at(0, "it has no direction");
  } else {
    double sign = 1.0;
    if (text[at] == '+' || text[at] == '-') sign = text[at++] == '-' ? -1.0 : 1.0;
    if (at == text.size() || text[at] < 'x' || text[at] > 'z')
      refuse_at(at, "needed: x, y or z, with or without a sign, or [x, y, z]");
    vector[text[at++] - 'x'] = sign;
  }
  constexpr std::string_view of = " of ";
  if (text.compare(at, of.size(), of) != 0 || at + of.size() == text.size())
    refuse_at(at, "it does not say of which frame, as \"-z of body\"");
  return {from.place, text, text.substr(at + of.size()), vector.normalized()};
}

BodyFrames::BodyFrames(const std::string& body, const std::vector<FixedFrame>& frames)
    : frames_{{body, Quaterniond::Identity()}} {
  for (std::size_t i = 0; i < frames.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (frames[i].name == frames[j].name)
        refuse(frames[i].place,
               "there are two frames '" + frames[i].name + "'; the other is at " + frames[j].place.text());
  // A frame may stand before the one on which it hangs.
  std::vector<const FixedFrame*> left;
  for (const FixedFrame& frame : frames) {
    if (frame.name == body) refuse(frame.place, "'" + body + "' is the name of the body of the attitude");
    left.push_back(&frame);
  }
  while (!left.empty()) {
    const auto known =
        std::find_if(left.begin(), left.end(), [&](const FixedFrame* frame) { return find(frame->parent); });
    if (known == left.end()) {
      std::vector<std::string_view> names;
      for (const Report::BodyFrame& frame : frames_) names.push_back(frame.name);
      refuse(left.front()->place, "the frame '" + left.front()->name + "' hangs on '" + left.front()->parent +
                                      "', which is not fixed in '" + body + "'" +
                                      instead_of(left.front()->parent, names));
    }
    frames_.push_back(
        {(*known)->name, find((*known)->parent)->body_from_frame * (*known)->parent_from_frame});
    left.erase(known);
  }
}

const Report::BodyFrame* BodyFrames::find(const std::string& name) const {
  const auto found =
      std::find_if(frames_.begin(), frames_.end(), [&](const auto& frame) { return frame.name == name; });
  return found == frames_.end() ? nullptr : &*found;
}

const Quaterniond& BodyFrames::body_from(const std::string& frame, const Place& place) const {
  if (const auto* const found = find(frame)) return found->body_from_frame;
  std::vector<std::string_view> names;
  for (const Report::BodyFrame& each : frames_) names.push_back(each.name);
  refuse(place, "there is no frame '" + frame + "' fixed in the body" + instead_of(frame, names));
}

Vector3d BodyFrames::in_body(const FixedAxis& axis) const {
  return body_from(axis.frame, axis.place) * axis.vector;
}

}  // namespace vectrix::cli
