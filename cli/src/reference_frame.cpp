#include "reference_frame.hpp"

#include <map>

#include "earth_frame.hpp"
#include "table_text.hpp"
#include "target.hpp"

namespace vectrix::cli {
namespace {

using Eigen::Matrix3d;

struct Orbit : moving_frame {};

Matrix3d of_orbit(const std::string& reference, const SatelliteMotion& motion) {
  const auto& [r, v] = motion;
  if (reference == "LVLH") return lvlh(from<Orbit>, r, v).matrix();
  if (reference == "RTN") return ric(from<Orbit>, r, v).matrix();
  if (reference == "VNC") return vnb(from<Orbit>, r, v).matrix();
  const Matrix3d R_gcrf_from_ntw = ntw(from<Orbit>, r, v).matrix();
  if (reference == "NTW") return R_gcrf_from_ntw;
  Matrix3d R_gcrf_from_tnw;
  R_gcrf_from_tnw << R_gcrf_from_ntw.col(1), -R_gcrf_from_ntw.col(0), R_gcrf_from_ntw.col(2);
  return R_gcrf_from_tnw;
}

}  // namespace

std::optional<std::string> reference_name(const std::string& name) {
  if (const auto known = earth_frame_name(name)) return known;
  static const std::map<std::string, const char*> names{{"lvlh", "LVLH"}, {"vvlh", "LVLH"}, {"rtn", "RTN"},
                                                        {"rsw", "RTN"},   {"qsw", "RTN"},   {"ric", "RTN"},
                                                        {"tnw", "TNW"},   {"ntw", "NTW"},   {"vnc", "VNC"}};
  std::string word = small(name);
  constexpr std::string_view rotating = "_rotating";
  if (word.ends_with(rotating)) word.resize(word.size() - rotating.size());
  const auto found = names.find(word);
  if (found == names.end()) return std::nullopt;
  return found->second;
}

const char* reference_names() {
  return "EME2000, J2000, GCRF, ICRF, ITRF, TIRF, CIRF, TEME, TOD, MOD, LVLH, RTN, RSW, TNW, NTW and VNC";
}

std::string axes_of_reference(const std::string& reference) {
  static const std::map<std::string, const char*> axes{{"LVLH", "z along -r, y along -(r x v)"},
                                                       {"RTN", "x along r, z along r x v"},
                                                       {"TNW", "x along v, z along r x v"},
                                                       {"NTW", "y along v, z along r x v"},
                                                       {"VNC", "x along v, y along r x v"}};
  const auto found = axes.find(reference);
  return found == axes.end() ? "" : found->second;
}

std::optional<EarthOrientation> read_orientation(const std::filesystem::path& file,
                                                 const std::vector<Epoch>& times) {
  if (file.empty()) return std::nullopt;
  auto orientation = EarthOrientation::read(file);
  try {
    for (const Epoch& t : {times.front(), times.back()}) (void)orientation.at(t);
  } catch (const BadInput& error) {
    throw BadInput(file.string() + ": " + error.what());
  }
  return orientation;
}

std::function<Matrix3d(const Epoch&)> reference_motion(const std::string& file, const std::string& reference,
                                                       const TimeSpan& span, const FlownOrbit& orbit,
                                                       const std::optional<EarthOrientation>& orientation,
                                                       const ReferenceWords& words) {
  const std::string given = file + ": the attitude is relative to " + reference;
  if (earth_frame_name(reference)) {
    const auto frame =
        earth_frame(reference, span, orientation,
                    given + ", which needs the orientation of the Earth; missing: " + words.orientation);
    return [frame](const Epoch& t) { return frame(t).rotation.matrix(); };
  }
  if (!orbit) throw BadInput(given + ", a frame of the orbit; missing: " + words.orbit);
  return [orbit, reference](const Epoch& t) { return of_orbit(reference, orbit(t)); };
}

void require_earth(const AttitudeRecord& record) {
  const std::string centre = record.message ? record.message->metadata.center_name : "";
  if (!centre.empty() && small(centre) != "earth")
    throw BadInput(record.file + ": CENTER_NAME is '" + centre + "'; the attitude must be about EARTH");
}

void turn_to_gcrf(AttitudeRecord& record, const FlownOrbit& orbit,
                  const std::optional<EarthOrientation>& orientation, const ReferenceWords& words) {
  require_earth(record);
  if (inertial(record.reference)) return;
  const auto motion =
      reference_motion(record.file, record.reference, from_until(record.times.front(), record.times.back()),
                       orbit, orientation, words);
  for (const Epoch& t : record.times) record.gcrf_from_stated.emplace_back(motion(t));
  record.motion = nullptr;  // it is relative to the other reference
  record.stated_reference = record.reference;
  record.reference = "GCRF";
}

}  // namespace vectrix::cli
