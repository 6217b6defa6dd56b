#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace pictures {

/// The names of the examples whose tables can be drawn, for the usage: a|b|c.
std::string drawn_examples();
/// The picture of the table that an example has written. Throws BadInput for a table that is not of it; empty
/// for an unknown example.
std::string of_table(std::string_view example, const std::filesystem::path& table);

}  // namespace pictures
