#pragma once

#include <string>

#include <vectrix/space/files/file_frame.hpp>

namespace vectrix::detail {

/// The name that is written for the claimed frame.
std::string name_of(const FrameClaim& claim);
/// Whether the name in a file is that of the claim.
bool names(const FrameClaim& claim, const std::string& name);
/// Throws BadInput, which begins with `place` and names both frames, unless the name is that of the claim.
void require_named(const std::string& place, const std::string& keyword, const std::string& name,
                   const FrameClaim& claim);
/// 'EME2000' (earth::Eme2000), for messages.
std::string shown(const FrameClaim& claim);
/// Whether the axes of the frame move with the date, so that REF_FRAME_EPOCH stops them.
bool is_of_date(StandardFrame frame);

}  // namespace vectrix::detail
