#pragma once

#include <string>
#include <string_view>
#include <vector>

/// Names of organs within files.
namespace viscera::medical_io {

/// Whether a program generated the name: "Mesh1", "default", "Object_1", "grp2"; also of the empty name.
bool saysNothing(std::string_view name);

/// The name as it is compared with what a user types: in lower case, "_" as a space, without space around it.
std::string comparableName(std::string_view name);

/// The names with a number behind those that come twice, and `stem` with a number for those that are empty.
std::vector<std::string> uniqueNames(std::vector<std::string> names, const std::string& stem);

} // namespace viscera::medical_io
