#pragma once

#include <string>
#include <string_view>

/// Names of organs within files.
namespace viscera::medical_io {

/// Whether a program generated the name: "Mesh1", "default", "Object_1", "grp2"; also of the empty name.
bool saysNothing(std::string_view name);

/// The name as it is compared with what a user types: in lower case, "_" as a space, without space around it.
std::string comparableName(std::string_view name);

} // namespace viscera::medical_io
