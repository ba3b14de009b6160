#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// DCMTK's configuration has to be known before its other headers.
#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dctk.h>

#include "viscera/clinic/dicom_objects.h"

/// What all DICOM objects of this module share.
namespace viscera::clinic {

/// A concept of a coding scheme.
struct Code {
  std::string value;
  std::string scheme; ///< "SCT", "DCM", "UCUM", "LN"
  std::string meaning;
};

/// Each throws `CannotCreateError` when DCMTK does not take the value.
void put(DcmItem& item, const DcmTagKey& key, const std::string& text);
void putWord(DcmItem& item, const DcmTagKey& key, int value);
void putLong(DcmItem& item, const DcmTagKey& key, std::uint32_t value);
/// Numbers with at most 16 characters each, as decimal strings are.
void putNumbers(DcmItem& item, const DcmTagKey& key, const std::vector<double>& numbers);
void putPoint(DcmItem& item, const DcmTagKey& key, const Vec3& point);
void putColor(DcmItem& item, const Vec3& color);
/// A new item at the end of a sequence, which is made when it is not there.
DcmItem& addItem(DcmItem& item, const DcmTagKey& sequence);
/// A sequence without items.
void putEmptySequence(DcmItem& item, const DcmTagKey& sequence);
/// A sequence of one code.
void putCode(DcmItem& item, const DcmTagKey& sequence, const Code& code);

/// "12.5"; at most 16 characters.
std::string decimalText(double value);

/// Writes whose it is, study, series, equipment and the object's own UIDs and times. `modality`: "SEG".
void putCommon(DcmDataset& dataset, const StudyIdentity& identity, const ObjectSeries& series,
               const std::string& classUid, const std::string& modality);

/// Writes which images an object refers to: sequences of series and instances below `item`.
void putReferencedSeries(DcmItem& item, const StudyIdentity& identity);

/// A part of the body in SNOMED CT.
struct PartCode {
  Code type;
  std::optional<Code> side; ///< Right or left, where the type does not say it.
};

/// What the organ's name means by `anatomy`'s table; "Anatomical Structure" for a name that it does not know.
PartCode codeOf(const std::string& organName);

/// Writes the whole file or none. Throws `CannotCreateError`.
WrittenObject save(DcmFileFormat& format, const std::filesystem::path& file, const ObjectSeries& series,
                   E_TransferSyntax syntax = EXS_LittleEndianExplicit);

} // namespace viscera::clinic
