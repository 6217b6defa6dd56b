#include "earth_frame.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <string_view>

#include <vectrix/kinematics/named/nearest_name.hpp>

#include "selection.hpp"
#include "table_text.hpp"
#include "target.hpp"

namespace vectrix::cli {
namespace {

using earth::Gcrf;

constexpr std::string_view names_of_earth_frames[] = {"EME2000", "J2000", "GCRF", "ICRF", "ITRF",
                                                      "TIRF",    "CIRF",  "TEME", "TOD",  "MOD"};

template <class Axes = EarthAxes, class F> MovingDcm<Gcrf, Axes> as_axes(const MovingDcm<Gcrf, F>& moving) {
  return {trust_dcm(to<Gcrf>, from<Axes>, moving.rotation.matrix()),
          AngularVelocity<Gcrf, Axes, In<Axes>>{detail::trusted, moving.angular_velocity.coordinates()}};
}

// Over ITRF: the turn of the Earth cancels.
EarthFrame teme_frame(const TimeSpan& span) {
  const EarthMotion earth(EarthOrientation::unobserved(span, 0.0 * si::second), span);
  return [earth](const Epoch& t) {
    return as_axes(without_acceleration(earth.at(t)) *
                   inverse(without_acceleration(teme_from_itrf(t, earth))));
  };
}

// Back from ITRF, whose motion is fast.
EarthFrame observed_frame(const std::string& name, const TimeSpan& span,
                          const EarthOrientation& orientation) {
  const EarthMotion earth(orientation, span);
  if (name == "ITRF") return [earth](const Epoch& t) { return as_axes(without_acceleration(earth.at(t))); };
  const auto tirf = [earth, orientation](const Epoch& t) {
    return without_acceleration(earth.at(t)) * inverse(tirf_from_itrf(t, orientation.parameters(t)));
  };
  if (name == "TIRF") return [tirf](const Epoch& t) { return as_axes(tirf(t)); };
  return [tirf, orientation](const Epoch& t) {
    return as_axes(tirf(t) * inverse(cirf_from_tirf(t, orientation.parameters(t))));
  };
}

}  // namespace

std::optional<std::string> earth_frame_name(const std::string& name) {
  if (const auto known = inertial(name)) return known;
  const std::string word = small(name);
  if (word.starts_with("itrf") && word.find_first_not_of("-0123456789", 4) == std::string::npos)
    return "ITRF";
  static const std::map<std::string, const char*> all{
      {"teme", "TEME"}, {"temeofdate", "TEME"}, {"tod", "TOD"},   {"tod_earth", "TOD"},
      {"mod", "MOD"},   {"mod_earth", "MOD"},   {"cirf", "CIRF"}, {"tirf", "TIRF"}};
  const auto found = all.find(word);
  if (found == all.end()) return std::nullopt;
  return found->second;
}

std::string earth_frame_names() {
  std::string all;
  for (const std::string_view& name : names_of_earth_frames) {
    if (!all.empty()) all += &name == std::end(names_of_earth_frames) - 1 ? " and " : ", ";
    all += name;
  }
  return all;
}

std::string stated_earth_frame(const std::string& what, const std::string& name) {
  if (const auto known = earth_frame_name(name)) return *known;
  const std::string_view nearest = detail::nearest_name(name, names_of_earth_frames);
  throw BadInput(what + " '" + name + "' is none of " + earth_frame_names() +
                 (nearest.empty() ? "" : "; the nearest is '" + std::string(nearest) + "'"));
}

std::string axes_of_date(const std::string& frame) {
  static const std::map<std::string, const char*> axes{
      {"TEME", "true equator, mean equinox of date"},
      {"TOD", "true equator and equinox of date"},
      {"MOD", "mean equator and equinox of date"},
      {"CIRF", "the celestial intermediate pole and origin of date"},
      {"TIRF", "the intermediate pole of date and the terrestrial intermediate origin"}};
  const auto found = axes.find(frame);
  return found == axes.end() ? "" : found->second;
}

bool is_observed(const std::string& frame) {
  return frame == "ITRF" || frame == "TIRF" || frame == "CIRF";
}

void require_observed(const std::string& stated, const std::string& before, const std::string& words) {
  if (!stated.empty() && (is_observed(*earth_frame_name(stated)) || is_observed(before))) return;
  throw BadInput("--orientation is for --frame, to or from ITRF, TIRF or CIRF; " + words + before +
                 (stated.empty() ? "" : ", and is to be in " + stated));
}

bool is_slow(const std::string& frame) {
  return earth_frame_name(frame) && frame != "ITRF" && frame != "TIRF";
}

EarthFrame earth_frame(const std::string& name, const TimeSpan& span,
                       const std::optional<EarthOrientation>& orientation, const std::string& needed) {
  if (is_observed(name)) {
    if (!orientation) throw BadInput(needed);
    return observed_frame(name, span, *orientation);
  }
  if (name == "TEME") return teme_frame(span);
  if (name == "TOD") return [](const Epoch& t) { return as_axes(inverse(true_of_date_from_gcrf(t))); };
  if (name == "MOD") return [](const Epoch& t) { return as_axes(inverse(mean_of_date_from_gcrf(t))); };
  const auto w = AngularVelocity<Gcrf, EarthAxes, In<EarthAxes>>{detail::trusted, Eigen::Vector3d::Zero()};
  return [R = MovingDcm<Gcrf, EarthAxes>{trust_dcm(to<Gcrf>, from<EarthAxes>, gcrf_from(name)), w}](
             const Epoch&) { return R; };
}

std::function<MovingDcm<NewAxes, OldAxes>(const Epoch&)> turn_of_axes(
    const std::string& before, const std::string& after, const TimeSpan& span,
    const std::optional<EarthOrientation>& orientation, const std::string& file) {
  const auto frame = [&](const std::string& name) {
    return earth_frame(name, span, orientation,
                       file + ": from " + before + " to " + after +
                           " needs the orientation of the Earth; missing: "
                           "--orientation FILE");
  };
  return [before = frame(before), after = frame(after)](const Epoch& t) {
    return inverse(as_axes<NewAxes>(after(t))) * as_axes<OldAxes>(before(t));
  };
}

}  // namespace vectrix::cli
