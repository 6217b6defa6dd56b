#pragma once

#include <string>

/// The pictures of docs/explanation/theory.md, each an SVG file.
namespace pictures {

std::string coning();
std::string drift();
std::string work_precision();
std::string polhodes();

}  // namespace pictures
