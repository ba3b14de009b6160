#pragma once

#include <string>
#include <variant>

#include "session_scene.h"
#include "viscera/document/key_sequence_commands.h"
#include "viscera/document/measurement_commands.h"
#include "viscera/report/report.h"

/// A bound session and the report on it.
namespace viscera::tests {

/// A session with organs of these names, the first around the others.
struct ReportedSession : BoundSession {
  explicit ReportedSession(const std::vector<std::string>& names = {"Ball"}) {
    undo.perform(document::removeOrgans({organ()}));
    for (std::size_t i = 0; i < names.size(); ++i)
      undo.perform(document::addOrgans({ball(names[i], 30 - 8.0 * static_cast<double>(i))}));
  }

  /// The last handles drawn outward.
  void pose() {
    Points moved(1, 3);
    moved << 70, 3, -1;
    undo.perform(document::moveHandles({handle(9)}, moved));
  }
  /// A recorded cycle from rest through that pose.
  void record() {
    undo.perform(document::recordKey(0));
    pose();
    undo.perform(document::recordKey(1));
  }

  report::ReportSource source() {
    report::ReportSource source;
    source.state = document.state();
    source.organs = &live;
    source.systems = &registry;
    source.date = "1 March 2026";
    return source;
  }
  report::Report report(const report::ReportSource& source) const {
    Progress progress;
    return report::makeReport(source, {}, progress);
  }
};

/// The section of that title, or null.
inline const report::Section* sectionOf(const report::Report& report, const std::string& title) {
  for (const report::Section& section : report.sections)
    if (section.title == title)
      return &section;
  return nullptr;
}

/// The tables of a section that have a head.
inline std::vector<report::Table> tablesOf(const report::Section& section) {
  std::vector<report::Table> tables;
  for (const report::Block& block : section.blocks)
    if (const auto* table = std::get_if<report::Table>(&block); table && !table->head.empty())
      tables.push_back(*table);
  return tables;
}

} // namespace viscera::tests
