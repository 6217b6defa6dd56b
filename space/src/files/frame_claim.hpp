#pragma once

#include <cstdint>
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
/// Refuses a claim that a frame which every kernel knows is one of the library that it is not.
void require_kernel_claim(const std::string& place, std::int32_t frame, const FrameClaim& claim);

}  // namespace vectrix::detail
