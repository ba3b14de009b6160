#pragma once

#include <filesystem>
#include <string>

#include "viscera/report/report.h"

/// Writes reports as PDF or HTML files.
namespace viscera::report {

/// Whether the name ends like a report (.pdf, .html, .htm).
bool isReportFile(const std::filesystem::path& file);

/// The report as one page of HTML that needs no other file: pictures are inside, nothing is a script.
std::string htmlOf(const Report& report);

/// Writes `.pdf` (A4, with the title at the head and the number at the foot of each page) or `.html` by the
/// name's ending and returns the number of pages; an HTML file is one. Atomic. Where no `QGuiApplication`
/// runs, it creates one without a display for the time of the call: call it from the main thread then. Throws
/// `UsageError` for another extension, `CannotCreateError`, and `Error` when no font is found.
int writeReport(const std::filesystem::path& file, const Report& report);

} // namespace viscera::report
