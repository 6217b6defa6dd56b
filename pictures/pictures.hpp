#pragma once

#include <string>

/// The pictures of the docs, each an SVG file.
namespace pictures {

std::string coning();
std::string drift();
std::string work_precision();
std::string polhodes();
std::string passes();

}  // namespace pictures
