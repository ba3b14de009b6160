#pragma once

#include <string>
#include <vector>

class DcmItem;
class DcmTagKey;

/// Texts and numbers of a DICOM data set.
namespace viscera::medical_io {

/// The value as it is in the data set, without white space around it; empty when there is none.
std::string rawTextAt(DcmItem& item, const DcmTagKey& key);

/// A text in UTF-8 on one line, without control characters: `dataset` states its character sets, also those
/// between which escape sequences switch (ISO 2022). Letters that cannot be told become question marks.
std::string textAt(DcmItem& dataset, DcmItem& item, const DcmTagKey& key);

/// A name or a UID of the standard, which has ASCII letters only; others, and control characters, are
/// dropped.
std::string codeAt(DcmItem& item, const DcmTagKey& key);

/// All numbers of a value; empty when one of them is none.
std::vector<double> numbersAt(DcmItem& item, const DcmTagKey& key);

} // namespace viscera::medical_io
