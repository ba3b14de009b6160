#include "sha256.h"

#include <QByteArray>
#include <QCryptographicHash>
#include <QFile>

#include <limits>

namespace viscera::document {
namespace {

constexpr std::size_t kMostAtOnce = std::numeric_limits<int>::max() / 2; // Qt counts in int.

void addTo(QCryptographicHash& hash, std::string_view bytes) {
  while (!bytes.empty()) {
    const std::string_view part = bytes.substr(0, kMostAtOnce);
    hash.addData(part.data(), static_cast<int>(part.size()));
    bytes.remove_prefix(part.size());
  }
}

} // namespace

std::string sha256(std::initializer_list<std::string_view> pieces) {
  QCryptographicHash hash(QCryptographicHash::Sha256);
  for (const std::string_view piece : pieces)
    addTo(hash, piece);
  return hash.result().toHex().toStdString();
}

std::string sha256OfFile(const std::filesystem::path& file) {
  QFile source(QFile::decodeName(file.c_str()));
  QCryptographicHash hash(QCryptographicHash::Sha256);
  if (!source.open(QIODevice::ReadOnly) || !hash.addData(&source))
    return {};
  return hash.result().toHex().toStdString();
}

} // namespace viscera::document
