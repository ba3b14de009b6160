#include "packed_dicom.h"

#include <map>
#include <stdexcept>

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dcrledrg.h>
#include <dcmtk/dcmdata/dcrleerg.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/dcmjpeg/djencode.h>
#include <dcmtk/dcmjpls/djencode.h>

#include "temporary_folder.h"

namespace viscera::tests {
namespace {

void require(const OFCondition& condition) {
  if (condition.bad())
    throw std::runtime_error(std::string("DCMTK cannot pack: ") + condition.text());
}

} // namespace

std::string packedDicom(const std::string& plain, const std::string& packing) {
  static const std::map<std::string, E_TransferSyntax> kSyntaxes = {
      {"rle", EXS_RLELossless},
      {"jpeg-lossless", EXS_JPEGProcess14SV1},
      {"jpeg-ls", EXS_JPEGLSLossless},
      {"jpeg", EXS_JPEGProcess2_4},
      {"deflated", EXS_DeflatedLittleEndianExplicit},
      {"big-endian", EXS_BigEndianExplicit}};
  DcmRLEEncoderRegistration::registerCodecs();
  DJEncoderRegistration::registerCodecs();
  DJLSEncoderRegistration::registerCodecs();
  const TemporaryFolder folder;
  DcmFileFormat format;
  require(format.loadFile(folder.put("plain.dcm", plain).c_str()));
  require(format.loadAllDataIntoMemory());
  const E_TransferSyntax syntax = kSyntaxes.at(packing);
  require(format.getDataset()->chooseRepresentation(syntax, nullptr));
  require(format.saveFile((folder / "packed.dcm").c_str(), syntax));
  return contentsOf(folder / "packed.dcm");
}

} // namespace viscera::tests
