#include "packed_dicom.h"

#include <algorithm>
#include <map>
#include <memory>
#include <stdexcept>
#include <vector>

#include <dcmtk/config/osconfig.h>

#include <dcmtk/dcmdata/dcpixel.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dcrledrg.h>
#include <dcmtk/dcmdata/dcrleerg.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/dcmjpeg/djencode.h>
#include <dcmtk/dcmjpls/djencode.h>
#include <openjpeg.h>

#include "temporary_folder.h"

namespace viscera::tests {
namespace {

void requireDone(const OFCondition& condition) {
  if (condition.bad())
    throw std::runtime_error(std::string("DCMTK cannot pack: ") + condition.text());
}

void requireDone(OPJ_BOOL done) {
  if (done == OPJ_FALSE)
    throw std::runtime_error("OpenJPEG cannot pack");
}

OPJ_SIZE_T append(void* bytes, OPJ_SIZE_T count, void* stream) {
  static_cast<std::string*>(stream)->append(static_cast<const char*>(bytes), count);
  return count;
}

/// A code stream of JPEG 2000 of a picture without loss.
std::string codeStream(const Uint16* pixels, Uint16 columns, Uint16 rows, Uint16 bits) {
  opj_image_cmptparm_t component{};
  component.dx = component.dy = 1;
  component.w = columns;
  component.h = rows;
  component.prec = bits;
  const std::unique_ptr<opj_image_t, void (*)(opj_image_t*)> image(
      opj_image_create(1, &component, OPJ_CLRSPC_GRAY), opj_image_destroy);
  image->x1 = columns;
  image->y1 = rows;
  std::copy_n(pixels, std::size_t(columns) * rows, image->comps[0].data);
  opj_cparameters_t parameters;
  opj_set_default_encoder_parameters(&parameters);
  parameters.tcp_numlayers = 1;
  parameters.cp_disto_alloc = 1;
  parameters.numresolution = 3; // Pictures of tests are small.
  const std::unique_ptr<opj_codec_t, void (*)(opj_codec_t*)> codec(opj_create_compress(OPJ_CODEC_J2K),
                                                                   opj_destroy_codec);
  requireDone(opj_setup_encoder(codec.get(), &parameters, image.get()));
  const std::unique_ptr<opj_stream_t, void (*)(opj_stream_t*)> stream(opj_stream_create(1 << 16, OPJ_FALSE),
                                                                      opj_stream_destroy);
  std::string bytes;
  opj_stream_set_user_data(stream.get(), &bytes, nullptr);
  opj_stream_set_write_function(stream.get(), append);
  requireDone(opj_start_compress(codec.get(), image.get(), stream.get()));
  requireDone(opj_encode(codec.get(), stream.get()));
  requireDone(opj_end_compress(codec.get(), stream.get()));
  return bytes;
}

/// DCMTK has no encoder of JPEG 2000: its pixels are replaced by what OpenJPEG makes of them.
void packAsJpeg2000(DcmDataset& dataset) {
  const Uint16* pixels = nullptr;
  Uint16 columns = 0, rows = 0, bits = 0;
  requireDone(dataset.findAndGetUint16Array(DCM_PixelData, pixels));
  requireDone(dataset.findAndGetUint16(DCM_Columns, columns));
  requireDone(dataset.findAndGetUint16(DCM_Rows, rows));
  requireDone(dataset.findAndGetUint16(DCM_BitsStored, bits));
  std::string stream = codeStream(pixels, columns, rows, bits);
  stream.resize(stream.size() + stream.size() % 2);
  auto sequence = std::make_unique<DcmPixelSequence>(DCM_PixelSequenceTag);
  requireDone(sequence->insert(new DcmPixelItem(DCM_PixelItemTag))); // An empty table of offsets.
  auto item = std::make_unique<DcmPixelItem>(DCM_PixelItemTag);
  requireDone(item->putUint8Array(reinterpret_cast<const Uint8*>(stream.data()), stream.size()));
  requireDone(sequence->insert(item.release()));
  auto pixelData = std::make_unique<DcmPixelData>(DCM_PixelData);
  pixelData->putOriginalRepresentation(EXS_JPEG2000LosslessOnly, nullptr, sequence.release());
  requireDone(dataset.insert(pixelData.release(), OFTrue));
}

} // namespace

std::string packedDicom(const std::string& plain, const std::string& packing) {
  static const std::map<std::string, E_TransferSyntax> kSyntaxes = {
      {"rle", EXS_RLELossless},
      {"jpeg-lossless", EXS_JPEGProcess14SV1},
      {"jpeg-ls", EXS_JPEGLSLossless},
      {"jpeg", EXS_JPEGProcess2_4},
      {"jpeg-2000", EXS_JPEG2000LosslessOnly},
      {"deflated", EXS_DeflatedLittleEndianExplicit},
      {"big-endian", EXS_BigEndianExplicit}};
  DcmRLEEncoderRegistration::registerCodecs();
  DJEncoderRegistration::registerCodecs();
  DJLSEncoderRegistration::registerCodecs();
  const TemporaryFolder folder;
  DcmFileFormat format;
  requireDone(format.loadFile(folder.put("plain.dcm", plain).c_str()));
  requireDone(format.loadAllDataIntoMemory());
  const E_TransferSyntax syntax = kSyntaxes.at(packing);
  if (syntax == EXS_JPEG2000LosslessOnly)
    packAsJpeg2000(*format.getDataset());
  else
    requireDone(format.getDataset()->chooseRepresentation(syntax, nullptr));
  requireDone(format.saveFile((folder / "packed.dcm").c_str(), syntax));
  return contentsOf(folder / "packed.dcm");
}

} // namespace viscera::tests
