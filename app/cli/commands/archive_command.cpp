#include "cli/commands/all_commands.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <termios.h>
#include <unistd.h>

#include "cli/listing.h"
#include "viscera/clinic/archive.h"
#include "viscera/clinic/key_ring.h"
#include "viscera/core/error.h"

namespace viscera::app::cli {
namespace {

using clinic::ArchiveConnection;
using clinic::ArchiveKind;
using nlohmann::ordered_json;

/// Reads a line from the terminal without showing it.
std::string askedPassword(const ArchiveConnection& connection) {
  termios shown{};
  if (::tcgetattr(STDIN_FILENO, &shown) != 0)
    throw UsageError("the archive asks for a password", connection.name,
                     "set VISCERA_ARCHIVE_PASSWORD, or run it in a terminal");
  termios hidden = shown;
  hidden.c_lflag &= ~tcflag_t(ECHO);
  std::cerr << "Password of " << connection.user << " at " << connection.name << ": " << std::flush;
  ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &hidden);
  std::string password;
  std::getline(std::cin, password);
  ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &shown);
  std::cerr << "\n";
  return password;
}

/// Takes the password from the environment, else from the system's key ring, else from the terminal.
std::string passwordFor(const ArchiveConnection& connection, Progress& progress) {
  if (!clinic::wantsPassword(connection))
    return {};
  if (const char* given = std::getenv("VISCERA_ARCHIVE_PASSWORD"))
    return given;
  const auto kept = clinic::systemKeyRing()->find(connection, progress);
  return kept ? *kept : askedPassword(connection);
}

ordered_json connectionJson(const ArchiveConnection& one) {
  ordered_json row = {{"name", one.name},
                      {"kind", one.kind == ArchiveKind::dimse ? "dimse" : "dicomweb"},
                      {"address", one.address}};
  if (one.kind == ArchiveKind::dimse)
    row.update(
        {{"port", one.port}, {"calledTitle", one.calledTitle}, {"ownTitle", one.ownTitle}, {"tls", one.tls}});
  row["user"] = one.user;
  return row;
}

ordered_json studyJson(const clinic::ArchiveStudy& study) {
  ordered_json row = {{"patientName", study.patientName}, {"patientId", study.patientId},
                      {"studyUid", study.studyUid},       {"date", study.date},
                      {"description", study.description}, {"modalities", study.modalities},
                      {"series", ordered_json::array()}};
  for (const clinic::ArchiveSeries& series : study.series) {
    ordered_json one = {{"seriesUid", series.seriesUid},
                        {"modality", series.modality},
                        {"number", series.number},
                        {"description", series.description}};
    one["images"] = series.images < 0 ? ordered_json(nullptr) : ordered_json(series.images);
    row["series"].push_back(one);
  }
  return row;
}

/// `viscera archive`: the hospital's archive of images.
class ArchiveCommand final : public Command {
public:
  std::string name() const override { return "archive"; }
  std::string summary() const override { return "Ask an archive (PACS), fetch series and send files"; }

  void addOptions(CLI::App& options) override {
    options
        .add_option(
            "WHAT", what_,
            "list the archives; add or remove one; test it; query studies; get a series or study; send files")
        ->required()
        ->check(CLI::IsMember({"list", "add", "remove", "test", "query", "get", "send"}));
    options.add_option("FILE", files_, "send: DICOM files");
    options.add_option("--connection", connection_.name, "Name of the archive")->type_name("NAME");
    options.add_option("--address", connection_.address, "add: https://HOST/dicom-web, or a DIMSE host")
        ->type_name("ADDRESS");
    options.add_option("--port", connection_.port, "add: port of DIMSE [104]")->type_name("N");
    options.add_option("--called", connection_.calledTitle, "add: the archive's title; makes it DIMSE")
        ->type_name("TITLE");
    options.add_option("--own", connection_.ownTitle, "add: this program's title [VISCERA]")
        ->type_name("TITLE");
    options.add_flag("--tls", connection_.tls, "add: DIMSE with TLS");
    options.add_option("--certificates", connection_.certificates, "add: trusted issuers (.pem)")
        ->type_name("FILE");
    options.add_option("--user", connection_.user, "add: user of DICOMweb")->type_name("NAME");
    options.add_flag("--keep-password", keep_, "test: keep the password in the system's key ring");
    options.add_option("--patient-name", query_.patientName, "query: with * and ?")->type_name("PATTERN");
    options.add_option("--patient-id", query_.patientId, "query: with * and ?")->type_name("PATTERN");
    options.add_option("--from", query_.from, "query: first day of the study")->type_name("YYYYMMDD");
    options.add_option("--to", query_.to, "query: last day of the study")->type_name("YYYYMMDD");
    options.add_option("--modality", query_.modality, "query: CT, MR, ...")->type_name("M");
    options.add_option("--study", query_.studyUid, "query, get: UID of the study")->type_name("UID");
    options.add_option("--series", series_, "get: UID of the series; without it, the whole study")
        ->type_name("UID");
    options.add_option("-o,--output", output_, "get: folder to make")->type_name("DIR");
  }

  Outcome run(CommandContext& context) override {
    const std::filesystem::path file = clinic::archiveConnectionsFile();
    std::vector<ArchiveConnection> all = clinic::readArchiveConnections(file);
    if (what_ == "list")
      return listed(all);
    if (connection_.name.empty())
      throw UsageError("no archive is named", "--connection", "viscera archive list shows them");
    if (what_ == "add" || what_ == "remove")
      return changed(file, std::move(all), context.progress);
    const auto found = std::find_if(all.begin(), all.end(), [this](const ArchiveConnection& one) {
      return one.name == connection_.name;
    });
    if (found == all.end())
      throw UsageError("no archive has this name", connection_.name, "viscera archive list shows them");
    if (what_ == "query")
      return queried(*found, context.progress);
    if (what_ == "get")
      return fetched(*found, context.progress);
    if (what_ == "send")
      return sent(*found, context.progress);
    return tested(*found, context.progress);
  }

private:
  Outcome tested(const ArchiveConnection& archive, Progress& progress) const {
    const std::string password = passwordFor(archive, progress);
    clinic::testArchive(archive, password, progress);
    Outcome outcome;
    if (keep_ && !password.empty() && !clinic::systemKeyRing()->keep(archive, password, progress))
      outcome.warnings.push_back("There is no key ring that keeps the password");
    outcome.json = {{"connection", archive.name}, {"answers", true}};
    outcome.text = "The archive answers.\n";
    return outcome;
  }

  static Outcome listed(const std::vector<ArchiveConnection>& all) {
    Outcome outcome;
    outcome.json["connections"] = ordered_json::array();
    Listing listing;
    for (const ArchiveConnection& one : all) {
      outcome.json["connections"].push_back(connectionJson(one));
      listing.add(one.name, one.kind == ArchiveKind::dimse
                                ? one.calledTitle + "@" + one.address + ":" + std::to_string(one.port)
                                : one.address);
    }
    outcome.text = listing.text();
    return outcome;
  }

  Outcome changed(const std::filesystem::path& file, std::vector<ArchiveConnection> all, Progress& progress) {
    const auto isIt = [this](const ArchiveConnection& one) { return one.name == connection_.name; };
    const auto found = std::find_if(all.begin(), all.end(), isIt);
    if (what_ == "remove" && found == all.end())
      throw UsageError("no archive has this name", connection_.name, "viscera archive list shows them");
    if (what_ == "remove" && clinic::wantsPassword(*found))
      clinic::systemKeyRing()->forget(*found, progress);
    std::erase_if(all, isIt);
    if (what_ == "add") {
      connection_.kind = connection_.calledTitle.empty() ? ArchiveKind::dicomWeb : ArchiveKind::dimse;
      clinic::checkArchiveConnection(connection_);
      all.push_back(connection_);
    }
    clinic::writeArchiveConnections(file, all);
    return listed(all);
  }

  Outcome queried(const ArchiveConnection& archive, Progress& progress) const {
    Outcome outcome;
    outcome.json["studies"] = ordered_json::array();
    for (const auto& study :
         clinic::queryArchive(archive, passwordFor(archive, progress), query_, progress)) {
      outcome.json["studies"].push_back(studyJson(study));
      outcome.text += study.date + "  " + study.patientId + "  " + study.patientName + "  " +
                      study.modalities + "  " + study.description + "  " + study.studyUid + "\n";
      for (const clinic::ArchiveSeries& series : study.series)
        outcome.text += "  " + series.modality + "  " + series.description +
                        (series.images < 0 ? "" : "  " + std::to_string(series.images) + " images") + "  " +
                        series.seriesUid + "\n";
    }
    return outcome;
  }

  Outcome fetched(const ArchiveConnection& archive, Progress& progress) const {
    if (query_.studyUid.empty() || output_.empty())
      throw UsageError("get needs --study and -o", {}, "viscera archive query shows the UIDs");
    const std::string password = passwordFor(archive, progress);
    const std::size_t files =
        series_.empty()
            ? clinic::retrieveStudy(archive, password, query_.studyUid, output_, progress)
            : clinic::retrieveSeries(archive, password, query_.studyUid, series_, output_, progress).size();
    Outcome outcome;
    outcome.json = {{"folder", output_}, {"files", files}};
    outcome.text = std::to_string(files) + " files in " + output_ + "\n";
    return outcome;
  }

  Outcome sent(const ArchiveConnection& archive, Progress& progress) const {
    if (files_.empty())
      throw UsageError("no file is named", "send");
    clinic::sendToArchive(archive, passwordFor(archive, progress), {files_.begin(), files_.end()}, progress);
    Outcome outcome;
    outcome.json = {{"connection", archive.name}, {"files", files_.size()}};
    outcome.text = std::to_string(files_.size()) + " files sent to " + archive.name + "\n";
    return outcome;
  }

  std::string what_, series_, output_;
  bool keep_ = false;
  std::vector<std::string> files_;
  ArchiveConnection connection_;
  clinic::ArchiveQuery query_;
};

} // namespace

std::unique_ptr<Command> archiveCommand() {
  return std::make_unique<ArchiveCommand>();
}

} // namespace viscera::app::cli
