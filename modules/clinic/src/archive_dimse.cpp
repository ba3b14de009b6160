#include <algorithm>
#include <array>
#include <fstream>

#include <netdb.h>

#include "dicom_object.h"

#include <dcmtk/dcmnet/diutil.h>
#include <dcmtk/dcmnet/scu.h>
#include <dcmtk/dcmtls/tlslayer.h>

#include "archive_parts.h"
#include "viscera/medical_io/quiet_dcmtk.h"

// The classic services: C-ECHO, C-FIND, C-GET and C-STORE, by DCMTK.
namespace viscera::clinic {
namespace {

constexpr int kConnectSeconds = 10;
constexpr std::array<const char*, 32> kFetchedClasses = {
    UID_CTImageStorage,
    UID_EnhancedCTImageStorage,
    UID_LegacyConvertedEnhancedCTImageStorage,
    UID_MRImageStorage,
    UID_EnhancedMRImageStorage,
    UID_EnhancedMRColorImageStorage,
    UID_LegacyConvertedEnhancedMRImageStorage,
    UID_UltrasoundImageStorage,
    UID_UltrasoundMultiframeImageStorage,
    UID_EnhancedUSVolumeStorage,
    UID_XRayAngiographicImageStorage,
    UID_EnhancedXAImageStorage,
    UID_XRay3DAngiographicImageStorage,
    UID_ComputedRadiographyImageStorage,
    UID_DigitalXRayImageStorageForPresentation,
    UID_NuclearMedicineImageStorage,
    UID_PositronEmissionTomographyImageStorage,
    UID_EnhancedPETImageStorage,
    UID_SecondaryCaptureImageStorage,
    UID_MultiframeGrayscaleByteSecondaryCaptureImageStorage,
    UID_MultiframeGrayscaleWordSecondaryCaptureImageStorage,
    UID_MultiframeTrueColorSecondaryCaptureImageStorage,
    UID_SegmentationStorage,
    UID_SurfaceSegmentationStorage,
    UID_RTStructureSetStorage,
    UID_RTDoseStorage,
    UID_BasicTextSRStorage,
    UID_EnhancedSRStorage,
    UID_ComprehensiveSRStorage,
    UID_Comprehensive3DSRStorage,
    UID_EncapsulatedPDFStorage,
    UID_EncapsulatedSTLStorage};

OFList<OFString> plainSyntaxes() {
  OFList<OFString> syntaxes;
  syntaxes.push_back(UID_LittleEndianExplicitTransferSyntax);
  syntaxes.push_back(UID_LittleEndianImplicitTransferSyntax);
  return syntaxes;
}

OFList<OFString> packedSyntaxes() {
  OFList<OFString> syntaxes;
  for (const char* uid :
       {UID_JPEG2000LosslessOnlyTransferSyntax, UID_JPEGProcess14SV1TransferSyntax,
        UID_JPEGLSLosslessTransferSyntax, UID_RLELosslessTransferSyntax, UID_JPEGProcess1TransferSyntax,
        UID_JPEGProcess2_4TransferSyntax, UID_JPEG2000TransferSyntax, UID_JPEGLSLossyTransferSyntax})
    syntaxes.push_back(uid);
  return syntaxes;
}

std::string valueOf(DcmItem& item, const DcmTagKey& key) {
  OFString text;
  return item.findAndGetOFStringArray(key, text).good() ? std::string(text.c_str()) : std::string();
}

/// Whether the network knows a machine of that name; DCMTK does not tell.
bool hasAddress(const std::string& host) {
  addrinfo* found = nullptr;
  if (::getaddrinfo(host.c_str(), nullptr, nullptr, &found) != 0)
    return false;
  ::freeaddrinfo(found);
  return true;
}

/// DCMTK's association with what a series needs that arrives.
class Association : public DcmSCU {
public:
  explicit Association(const ArchiveConnection& connection) : connection_(connection) {
    setPeerHostName(connection.address.c_str());
    setPeerPort(Uint16(connection.port));
    setPeerAETitle(connection.calledTitle.c_str());
    setAETitle(connection.ownTitle.c_str());
    setConnectionTimeout(kConnectSeconds);
    setACSETimeout(Uint32(connection.patienceSeconds));
    setDIMSETimeout(Uint32(connection.patienceSeconds));
    setDIMSEBlockingMode(DIMSE_NONBLOCKING);
    setProgressNotificationMode(OFFalse);
    setMaxReceivePDULength(ASC_MAXIMUMPDUSIZE);
  }
  ~Association() override {
    if (isConnected())
      closeAssociation(DCMSCU_ABORT_ASSOCIATION);
    freeNetwork(); // Before the layer that it points to.
  }

  /// Throws what is wrong.
  void open() {
    if (connection_.tls)
      secure();
    if (initNetwork().bad())
      throwUnreached();
    const OFCondition found = negotiateAssociation();
    if (found.good())
      return;
    throwFor(found, true);
  }

  [[noreturn]] void throwUnreached() const {
    throw hasAddress(connection_.address) ? unreachable(connection_) : unknownHost(connection_);
  }

  /// The sentence for a failure. While a connection is made, it is not there; later it was cut.
  [[noreturn]] void throwFor(const OFCondition& found, bool opening) const {
    const std::string text = found.text();
    if (found == DUL_ASSOCIATIONREJECTED)
      throw wrongTitles(connection_);
    if (found == NET_EC_NoAcceptablePresentationContexts || found == DIMSE_NOVALIDPRESENTATIONCONTEXTID)
      throw notOffered(connection_, "this service");
    // DCMTK tells a failed handshake no better than this.
    if (text.find("certificate") != std::string::npos ||
        (opening && connection_.tls && found == DUL_PEERABORTEDASSOCIATION))
      throw untrusted(connection_);
    if (found == DIMSE_NODATAAVAILABLE || found == DUL_READTIMEOUT ||
        text.find("Timeout") != std::string::npos)
      throw silent(connection_);
    if (opening && (found == DUL_REQUESTASSOCIATIONFAILED || text.find("TCP") != std::string::npos ||
                    text.find("unknown host") != std::string::npos))
      throwUnreached();
    throw cut(connection_);
  }

  void offer(const char* service) { addPresentationContext(service, plainSyntaxes()); }

  std::filesystem::path folder; ///< Where images that arrive are kept.
  Progress* progress = nullptr;
  std::optional<std::filesystem::path> unwritten; ///< The file that could not be.
  std::size_t arrived = 0, failed = 0;

protected:
  OFCondition handleSTORERequest(const T_ASC_PresentationContextID presentation, DcmDataset* dataset,
                                 OFBool& goOn, Uint16& status) override {
    static_cast<void>(presentation);
    const std::string uid = dataset != nullptr ? valueOf(*dataset, DCM_SOPInstanceUID) : std::string();
    status = STATUS_Success;
    if (progress->cancelled() || !isUid(uid)) {
      goOn = OFFalse;
      status = STATUS_STORE_Refused_OutOfResources;
      return EC_Normal;
    }
    const std::filesystem::path file = folder / (uid + ".dcm");
    DcmFileFormat format(dataset, OFFalse);
    const OFCondition written = format.saveFile(file.c_str(), dataset->getOriginalXfer());
    format.getAndRemoveDataset(); // DCMTK deletes it.
    if (written.bad()) {
      unwritten = file;
      goOn = OFFalse;
      status = STATUS_STORE_Refused_OutOfResources;
      return EC_Normal;
    }
    ++arrived;
    return EC_Normal;
  }

  OFCondition handleCGETResponse(const T_ASC_PresentationContextID presentation, RetrieveResponse* response,
                                 OFBool& goOn) override {
    if (response != nullptr) {
      failed = std::max<std::size_t>(failed, response->m_numberOfFailedSubops);
      const double all = double(arrived) + response->m_numberOfRemainingSubops;
      if (all > 0)
        progress->report(double(arrived) / all, phrase("Receive image %1", arrived));
    }
    return DcmSCU::handleCGETResponse(presentation, response, goOn);
  }

private:
  void secure() {
    layer_ = std::make_unique<DcmTLSTransportLayer>(NET_REQUESTOR, nullptr, OFTrue);
    const std::string issuers =
        connection_.certificates.empty() ? "/etc/ssl/certs/ca-certificates.crt" : connection_.certificates;
    if (layer_->addTrustedCertificateFile(issuers.c_str(), DCF_Filetype_PEM).bad())
      throw NoInputError("The certificates cannot be read", issuers);
    layer_->setTLSProfile(TSP_Profile_BCP195);
    layer_->activateCipherSuites();
    layer_->setCertificateVerification(DCV_requireCertificate);
    useSecureConnection(layer_.get());
  }

  const ArchiveConnection& connection_;
  std::unique_ptr<DcmTLSTransportLayer> layer_;
};

/// Deletes what DCMTK has answered.
template <class Response>
struct Responses {
  OFList<Response*> list;
  Responses() = default;
  Responses(const Responses&) = delete;
  Responses& operator=(const Responses&) = delete;
  ~Responses() {
    for (Response* each : list)
      delete each;
  }
};

class DimseChannel final : public ArchiveChannel {
public:
  explicit DimseChannel(const ArchiveConnection& connection) : connection_(connection) {}

  void test(Progress&) override {
    Association association(connection_);
    association.offer(UID_VerificationSOPClass);
    association.open();
    const OFCondition found = association.sendECHORequest(0);
    if (found.bad())
      association.throwFor(found, false);
    association.releaseAssociation();
  }

  std::vector<ArchiveStudy> query(const ArchiveQuery& query, Progress& progress) override {
    Association association(connection_);
    association.offer(UID_FINDStudyRootQueryRetrieveInformationModel);
    association.open();
    std::vector<ArchiveStudy> studies;
    DcmDataset keys = studyKeys(query);
    find(association, keys, [&](DcmDataset& row) {
      row.convertToUTF8();
      std::string modalities = valueOf(row, DCM_ModalitiesInStudy);
      for (std::size_t at = 0; (at = modalities.find('\\', at)) != std::string::npos; at += 2)
        modalities.replace(at, 1, ", ");
      studies.push_back({valueOf(row, DCM_PatientName),
                         valueOf(row, DCM_PatientID),
                         valueOf(row, DCM_StudyInstanceUID),
                         valueOf(row, DCM_StudyDate),
                         valueOf(row, DCM_StudyDescription),
                         modalities,
                         {}});
    });
    progress.throwIfCancelled();
    if (!query.studyUid.empty())
      for (ArchiveStudy& study : studies)
        study.series = seriesOf(association, study.studyUid, query.modality);
    association.releaseAssociation();
    return studies;
  }

  void retrieve(const std::string& studyUid, const std::string& seriesUid,
                const std::filesystem::path& folder, Progress& progress) override {
    Association association(connection_);
    association.folder = folder;
    association.progress = &progress;
    association.offer(UID_GETStudyRootQueryRetrieveInformationModel);
    for (const char* uid : kFetchedClasses) {
      association.addPresentationContext(uid, plainSyntaxes(), ASC_SC_ROLE_SCP);
      association.addPresentationContext(uid, packedSyntaxes(), ASC_SC_ROLE_SCP);
    }
    association.open();
    const auto context =
        association.findAnyPresentationContextID(UID_GETStudyRootQueryRetrieveInformationModel, "");
    if (context == 0)
      throw notOffered(connection_, "C-GET");
    DcmDataset keys;
    put(keys, DCM_QueryRetrieveLevel, "SERIES");
    put(keys, DCM_StudyInstanceUID, studyUid);
    put(keys, DCM_SeriesInstanceUID, seriesUid);
    Responses<RetrieveResponse> responses;
    const OFCondition found = association.sendCGETRequest(context, &keys, &responses.list);
    progress.throwIfCancelled();
    if (association.unwritten)
      throw cannotKeep(*association.unwritten);
    if (found.bad())
      association.throwFor(found, false);
    if (responses.list.empty())
      throw cut(connection_);
    const Uint16 status = responses.list.back()->m_status;
    if (association.arrived == 0 && (status == STATUS_Success || association.failed == 0))
      throw noSeries(connection_);
    if (status != STATUS_Success || association.failed > 0)
      throw refusal(connection_, DU_cgetStatusString(status));
    association.releaseAssociation();
  }

  void send(const std::vector<std::filesystem::path>& files, Progress& progress) override {
    Association association(connection_);
    std::vector<std::pair<std::string, std::string>> offered;
    for (const std::filesystem::path& file : files)
      offerFor(association, file, offered);
    association.open();
    std::size_t refused = 0;
    for (std::size_t i = 0; i < files.size(); ++i) {
      progress.throwIfCancelled();
      progress.report(double(i) / double(files.size()), phrase("Send image %1", i + 1));
      Uint16 status = STATUS_Success;
      const OFCondition found =
          association.sendSTORERequest(0, OFFilename(files[i].c_str()), nullptr, status);
      if (found == DIMSE_NOVALIDPRESENTATIONCONTEXTID)
        ++refused;
      else if (found.bad())
        association.throwFor(found, false);
      else if (status != STATUS_Success && (status & 0xF000) != 0xB000) // B000: stored, with a warning.
        ++refused;
    }
    association.releaseAssociation();
    if (refused > 0)
      throw notStored(connection_, refused, files.size());
  }

private:
  static DcmDataset studyKeys(const ArchiveQuery& query) {
    DcmDataset keys;
    put(keys, DCM_SpecificCharacterSet, "ISO_IR 192");
    put(keys, DCM_QueryRetrieveLevel, "STUDY");
    put(keys, DCM_PatientName, query.patientName);
    put(keys, DCM_PatientID, query.patientId);
    put(keys, DCM_StudyInstanceUID, query.studyUid);
    put(keys, DCM_StudyDate, dayRange(query));
    put(keys, DCM_StudyDescription, "");
    put(keys, DCM_ModalitiesInStudy, query.modality);
    return keys;
  }

  template <class Row>
  void find(Association& association, DcmDataset& keys, const Row& row) const {
    const auto context =
        association.findAnyPresentationContextID(UID_FINDStudyRootQueryRetrieveInformationModel, "");
    if (context == 0)
      throw notOffered(connection_, "C-FIND");
    Responses<QRResponse> responses;
    const OFCondition found = association.sendFINDRequest(context, &keys, &responses.list);
    if (found.bad())
      association.throwFor(found, false);
    for (QRResponse* each : responses.list) {
      if (each->m_dataset != nullptr)
        row(*each->m_dataset);
      else if (each->m_status != STATUS_Success)
        throw refusal(connection_, DU_cfindStatusString(each->m_status));
    }
  }

  std::vector<ArchiveSeries> seriesOf(Association& association, const std::string& studyUid,
                                      const std::string& modality) const {
    DcmDataset keys;
    put(keys, DCM_QueryRetrieveLevel, "SERIES");
    put(keys, DCM_StudyInstanceUID, studyUid);
    put(keys, DCM_Modality, modality);
    for (const DcmTagKey& key :
         {DCM_SeriesInstanceUID, DCM_SeriesDescription, DCM_SeriesNumber, DCM_NumberOfSeriesRelatedInstances})
      put(keys, key, "");
    std::vector<ArchiveSeries> series;
    find(association, keys, [&](DcmDataset& row) {
      row.convertToUTF8();
      const std::string images = valueOf(row, DCM_NumberOfSeriesRelatedInstances);
      series.push_back({valueOf(row, DCM_SeriesInstanceUID), valueOf(row, DCM_Modality),
                        valueOf(row, DCM_SeriesDescription), valueOf(row, DCM_SeriesNumber),
                        images.empty() ? -1 : std::atoi(images.c_str())});
    });
    return series;
  }

  /// The file's own class and transfer syntax, once each: nothing is repacked.
  static void offerFor(Association& association, const std::filesystem::path& file,
                       std::vector<std::pair<std::string, std::string>>& offered) {
    DcmFileFormat format;
    if (format
            .loadFileUntilTag(file.c_str(), EXS_Unknown, EGL_noChange, DCM_MaxReadLength, ERM_autoDetect,
                              DCM_PatientName)
            .bad())
      throw DataError("The file is no DICOM file", file.string());
    const std::string uid = valueOf(*format.getDataset(), DCM_SOPClassUID);
    const std::string syntax = DcmXfer(format.getDataset()->getOriginalXfer()).getXferID();
    const std::pair<std::string, std::string> wanted{uid, syntax};
    if (std::find(offered.begin(), offered.end(), wanted) != offered.end())
      return;
    OFList<OFString> syntaxes;
    syntaxes.push_back(syntax.c_str());
    association.addPresentationContext(uid.c_str(), syntaxes);
    offered.push_back(wanted);
  }

  ArchiveConnection connection_;
};

} // namespace

std::unique_ptr<ArchiveChannel> dimseChannel(const ArchiveConnection& connection) {
  medical_io::silenceDcmtk();
  return std::make_unique<DimseChannel>(connection);
}

} // namespace viscera::clinic
