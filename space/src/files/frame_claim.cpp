#include "frame_claim.hpp"

#include <vectrix/frames/errors.hpp>

#include "kvn.hpp"
#include "text_file.hpp"

namespace vectrix::detail {
namespace {

constexpr const char* type_names[] = {"",
                                      "earth::Gcrf",
                                      "earth::Eme2000",
                                      "earth::Itrf",
                                      "earth::Teme",
                                      "earth::TrueOfDate",
                                      "earth::MeanOfDate"};
constexpr const char* written_names[] = {"", "GCRF", "EME2000", "ITRF", "TEME", "TOD", "MOD"};

std::size_t index(StandardFrame frame) {
  return static_cast<std::size_t>(frame);
}

StandardFrame standard_of(const std::string& name) {
  const std::string capitals = upper_case(name);
  if (capitals == "GCRF" || capitals == "ICRF") return StandardFrame::gcrf;
  if (capitals == "EME2000" || capitals == "J2000") return StandardFrame::eme2000;
  if (capitals == "TEME" || capitals == "TEMEOFDATE") return StandardFrame::teme;
  if (capitals == "TOD" || capitals == "TOD_EARTH") return StandardFrame::true_of_date;
  if (capitals == "MOD" || capitals == "MOD_EARTH") return StandardFrame::mean_of_date;
  if (capitals.starts_with("ITRF")) {
    std::string year = capitals.substr(4);
    if (year.starts_with('-')) year.erase(0, 1);
    if (year.find_first_not_of("0123456789") == std::string::npos) return StandardFrame::itrf;
  }
  return StandardFrame::none;
}

}  // namespace

std::string name_of(const FrameClaim& claim) {
  return claim.name ? *claim.name : written_names[index(claim.standard)];
}

bool names(const FrameClaim& claim, const std::string& name) {
  return claim.name ? upper_case(name) == upper_case(*claim.name) : standard_of(name) == claim.standard;
}

void require_named(const std::string& place, const std::string& keyword, const std::string& name,
                   const FrameClaim& claim) {
  const StandardFrame meant = standard_of(name);
  const std::string found =
      place + ": " + keyword + " is '" + excerpt(name) + "'" +
      (meant == StandardFrame::none ? "" : ", " + std::string{type_names[index(meant)]});
  if (!names(claim, name)) throw BadInput(found + "; asked for " + shown(claim));
  if (meant != claim.standard && meant != StandardFrame::none && claim.standard != StandardFrame::none)
    throw BadInput(found + "; it was claimed to be " + claim.type);
}

std::string shown(const FrameClaim& claim) {
  return "'" + excerpt(name_of(claim)) + "' (" + claim.type + ")";
}

bool is_of_date(StandardFrame frame) {
  return frame != StandardFrame::none && frame != StandardFrame::gcrf && frame != StandardFrame::eme2000;
}

}  // namespace vectrix::detail
