#pragma once

#include <string_view>

#include "surface_formats/three_mf_model.h"

namespace viscera::medical_io {

/// Adds what slicers state of a model's objects beside it: the names of their volumes, and which of these are
/// no shapes but settings of the print. PrusaSlicer joins the volumes of an object to one mesh and lists
/// their triangles ("Metadata/Slic3r_PE_model.config"); Bambu Studio and OrcaSlicer keep them as components
/// without names ("Metadata/model_settings.config"). `settings` is such a part, `path` that of the model.
/// What it says that does not fit the model is passed over.
void applySettings(std::string_view settings, std::string_view path, ThreeMfModel& model);

} // namespace viscera::medical_io
