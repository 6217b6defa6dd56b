#include "frame_claim.hpp"

#include <initializer_list>
#include <string_view>

#include <vectrix/frames/errors.hpp>

#include "kernel_names.hpp"
#include "kvn.hpp"
#include "text_file.hpp"

namespace vectrix::detail {
namespace {

/// A frame of the library, and its names in files. The first is written.
struct StandardNames {
  StandardFrame frame;
  const char* type;
  std::initializer_list<const char*> names;
};
constexpr StandardNames standard_names[] = {
    {StandardFrame::none, "", {""}},
    {StandardFrame::gcrf, "earth::Gcrf", {"GCRF", "ICRF"}},
    {StandardFrame::eme2000, "earth::Eme2000", {"EME2000", "J2000"}},
    {StandardFrame::itrf, "earth::Itrf", {"ITRF"}},
    {StandardFrame::teme, "earth::Teme", {"TEME", "TEMEOFDATE"}},
    {StandardFrame::true_of_date, "earth::TrueOfDate", {"TOD", "TOD_EARTH"}},
    {StandardFrame::mean_of_date, "earth::MeanOfDate", {"MOD", "MOD_EARTH"}}};

const StandardNames& standard(StandardFrame frame) {
  return standard_names[static_cast<std::size_t>(frame)];
}

// ITRF of a year: ITRF2014, ITRF-2000, or of the last century ITRF97, ITRF-93. The first was ITRF88.
bool is_itrf_of_a_year(std::string_view capitals) {
  if (!capitals.starts_with("ITRF")) return false;
  capitals.remove_prefix(4);
  if (capitals.starts_with('-')) capitals.remove_prefix(1);
  if (capitals.find_first_not_of("0123456789") != std::string_view::npos) return false;
  return (capitals.size() == 2 && capitals >= "88") ||
         (capitals.size() == 4 && capitals >= "1988" && capitals < "2100");
}

StandardFrame standard_of(const std::string& name) {
  const std::string capitals = upper_case(name);
  for (const StandardNames& known : standard_names) {
    for (const char* written : known.names) {
      if (capitals == written) return known.frame;
    }
  }
  return is_itrf_of_a_year(capitals) ? StandardFrame::itrf : StandardFrame::none;
}

}  // namespace

std::string name_of(const FrameClaim& claim) {
  return claim.name ? *claim.name : *standard(claim.standard).names.begin();
}

bool names(const FrameClaim& claim, const std::string& name) {
  return claim.name ? upper_case(name) == upper_case(*claim.name) : standard_of(name) == claim.standard;
}

void require_named(const std::string& place, const std::string& keyword, const std::string& name,
                   const FrameClaim& claim) {
  const StandardFrame meant = standard_of(name);
  const std::string found = place + ": " + keyword + " is '" + excerpt(name) + "'" +
                            (meant == StandardFrame::none ? "" : ", " + std::string{standard(meant).type});
  if (!names(claim, name)) throw BadInput(found + "; asked for " + shown(claim));
  if (meant != claim.standard && meant != StandardFrame::none && claim.standard != StandardFrame::none)
    throw BadInput(found + "; it was claimed to be " + claim.type);
}

void require_kernel_claim(const std::string& place, std::int32_t frame, const FrameClaim& claim) {
  const auto name = name_of_frame(frame);
  if (!name || claim.standard == StandardFrame::none) return;
  const bool is_it = frame == j2000_id
                         ? claim.standard == StandardFrame::gcrf || claim.standard == StandardFrame::eme2000
                         : frame == itrf93_id && claim.standard == StandardFrame::itrf;
  if (!is_it) throw BadInput(place + ": '" + *name + "' was claimed to be " + claim.type);
}

std::string shown(const FrameClaim& claim) {
  return "'" + excerpt(name_of(claim)) + "' (" + claim.type + ")";
}

bool is_of_date(StandardFrame frame) {
  return frame != StandardFrame::none && frame != StandardFrame::gcrf && frame != StandardFrame::eme2000;
}

}  // namespace vectrix::detail
