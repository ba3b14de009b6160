#include <algorithm>
#include <array>
#include <fstream>
#include <mutex>
#include <optional>

#include <curl/curl.h>
#include <nlohmann/json.hpp>

#include "archive_parts.h"
#include "dicom_object.h"
#include "multipart.h"
#include "viscera/core/json_reader.h"

// DICOMweb: QIDO-RS, WADO-RS and STOW-RS, by libcurl.
namespace viscera::clinic {
namespace {

using nlohmann::json;

constexpr long kWebConnectSeconds = 10;
constexpr std::size_t kLongestAnswer = std::size_t(64) << 20U; ///< Bytes of a list.
constexpr auto kJsonType = "Accept: application/dicom+json";

/// What an exchange does with bytes; exceptions wait here while libcurl, which is C, unwinds.
struct Exchange {
  std::function<void(std::string_view)> take;
  std::function<std::size_t(char*, std::size_t)> give;
  Progress* progress = nullptr;
  std::exception_ptr thrown;

  template <class Work>
  bool guarded(const Work& work) {
    try {
      work();
      return true;
    } catch (...) {
      thrown = std::current_exception();
      return false;
    }
  }
};

std::size_t takeBytes(char* bytes, std::size_t size, std::size_t count, void* given) {
  auto& exchange = *static_cast<Exchange*>(given);
  const std::size_t all = size * count;
  return exchange.guarded([&] { exchange.take({bytes, all}); }) ? all : 0;
}

std::size_t giveBytes(char* bytes, std::size_t size, std::size_t count, void* given) {
  auto& exchange = *static_cast<Exchange*>(given);
  std::size_t written = 0;
  const bool good = exchange.guarded([&] { written = exchange.give(bytes, size * count); });
  return good ? written : CURL_READFUNC_ABORT;
}

int lookAtProgress(void* given, curl_off_t, curl_off_t, curl_off_t, curl_off_t) {
  return static_cast<Exchange*>(given)->progress->cancelled() ? 1 : 0;
}

struct CurlDeleter {
  void operator()(CURL* curl) const { curl_easy_cleanup(curl); }
  void operator()(curl_slist* list) const { curl_slist_free_all(list); }
};

std::string valueIn(const json& row, const char* tag) {
  const auto element = row.find(tag);
  if (element == row.end() || !element->is_object() || !element->contains("Value"))
    return {};
  std::string text;
  for (const json& value : (*element)["Value"]) {
    if (!text.empty())
      text += ", ";
    if (value.is_string())
      text += value.get<std::string>();
    else if (value.is_number_integer())
      text += std::to_string(value.get<long long>());
    else if (value.is_object() && value.contains("Alphabetic") && value["Alphabetic"].is_string())
      text += value["Alphabetic"].get<std::string>();
  }
  return text;
}

/// A multipart body that is read from the files while it is sent.
class FilesBody {
public:
  explicit FilesBody(const std::vector<std::filesystem::path>& files) : files_(files) {}

  static constexpr auto kBoundary = "viscera-8d1f1f6c2f7b4a5e";

  std::uintmax_t size() const {
    std::uintmax_t all = last().size();
    for (const auto& file : files_)
      all += head().size() + std::filesystem::file_size(file);
    return all;
  }
  std::size_t read(char* bytes, std::size_t room, Progress& progress) {
    while (true) {
      if (!text_.empty()) {
        const std::size_t count = std::min(room, text_.size());
        text_.copy(bytes, count);
        text_.erase(0, count);
        return count;
      }
      if (stream_.is_open()) {
        stream_.read(bytes, std::streamsize(room));
        if (stream_.gcount() > 0)
          return std::size_t(stream_.gcount());
        stream_.close();
        stream_.clear();
      }
      if (next_ == files_.size() + 1)
        return 0;
      if (next_ < files_.size()) {
        progress.report(double(next_) / double(files_.size()), phrase("Send image %1", next_ + 1));
        stream_.open(files_[next_], std::ios::binary);
        if (!stream_)
          throw NoInputError("The file cannot be read", files_[next_].string());
      }
      text_ = next_ < files_.size() ? head() : last();
      ++next_;
    }
  }

private:
  static std::string head() {
    return std::string("\r\n--") + kBoundary + "\r\nContent-Type: application/dicom\r\n\r\n";
  }
  static std::string last() { return std::string("\r\n--") + kBoundary + "--\r\n"; }

  std::vector<std::filesystem::path> files_;
  std::size_t next_ = 0;
  std::string text_;
  std::ifstream stream_;
};

/// Images that arrive, each under a temporary name until its UID is known.
class ArrivingImages {
public:
  ArrivingImages(std::filesystem::path folder, Progress& progress)
      : folder_(std::move(folder)), progress_(progress) {}

  void begin() {
    file_ = folder_ / "arriving";
    stream_.open(file_, std::ios::binary | std::ios::trunc);
  }
  void add(std::string_view bytes) {
    if (!stream_.write(bytes.data(), std::streamsize(bytes.size())))
      throw cannotKeep(file_);
  }
  void end() {
    stream_.close();
    if (!stream_)
      throw cannotKeep(file_);
    DcmFileFormat format;
    OFString uid;
    const bool good = format
                          .loadFileUntilTag(file_.c_str(), EXS_Unknown, EGL_noChange, DCM_MaxReadLength,
                                            ERM_autoDetect, DCM_PatientName)
                          .good() &&
                      format.getDataset()->findAndGetOFString(DCM_SOPInstanceUID, uid).good();
    bad_ = bad_ || !good || !isUid(uid.c_str());
    if (bad_)
      return;
    std::filesystem::rename(file_, folder_ / (std::string(uid.c_str()) + ".dcm"));
    ++count_;
    progress_.report(double(count_) / double(count_ + 1), phrase("Receive image %1", count_));
  }
  bool bad() const { return bad_; }

private:
  std::filesystem::path folder_, file_;
  Progress& progress_;
  std::ofstream stream_;
  std::size_t count_ = 0;
  bool bad_ = false;
};

class WebChannel final : public ArchiveChannel {
public:
  WebChannel(ArchiveConnection connection, std::string password)
      : connection_(std::move(connection)), password_(std::move(password)) {
    static std::once_flag once;
    std::call_once(once, [] { curl_global_init(CURL_GLOBAL_DEFAULT); });
    while (connection_.address.ends_with('/'))
      connection_.address.pop_back();
  }

  void test(Progress& progress) override { list("/studies?limit=1", progress); }

  std::vector<ArchiveStudy> query(const ArchiveQuery& query, Progress& progress) override {
    std::string path = "/studies?includefield=00081030&includefield=00080061";
    const auto ask = [&](const char* key, const std::string& value) {
      if (!value.empty())
        path += std::string("&") + key + "=" + escaped(value);
    };
    ask("PatientName", query.patientName);
    ask("PatientID", query.patientId);
    ask("StudyDate", dayRange(query));
    ask("ModalitiesInStudy", query.modality);
    ask("StudyInstanceUID", query.studyUid);
    std::vector<ArchiveStudy> studies;
    for (const json& row : list(path, progress))
      studies.push_back({valueIn(row, "00100010"),
                         valueIn(row, "00100020"),
                         valueIn(row, "0020000D"),
                         valueIn(row, "00080020"),
                         valueIn(row, "00081030"),
                         valueIn(row, "00080061"),
                         {}});
    if (!query.studyUid.empty())
      for (ArchiveStudy& study : studies)
        study.series = seriesOf(study.studyUid, query.modality, progress);
    return studies;
  }

  void retrieve(const std::string& studyUid, const std::string& seriesUid,
                const std::filesystem::path& folder, Progress& progress) override {
    ArrivingImages images(folder, progress);
    std::optional<MultipartReader> reader;
    Handle curl = handle("/studies/" + studyUid + "/series/" + seriesUid);
    Exchange exchange;
    exchange.take = [&](std::string_view bytes) {
      if (!reader) {
        char* type = nullptr;
        curl_easy_getinfo(curl.get(), CURLINFO_CONTENT_TYPE, &type);
        const std::string boundary = boundaryOf(type != nullptr ? type : "");
        if (status(curl) != 200)
          return;
        if (boundary.empty())
          throw strangeAnswer(connection_);
        reader.emplace(boundary, MultipartReader::Parts{[&] { images.begin(); },
                                                        [&](std::string_view part) { images.add(part); },
                                                        [&] { images.end(); }});
      }
      reader->add(bytes);
    };
    exchangeWith(curl, exchange, {"Accept: multipart/related; type=\"application/dicom\"; transfer-syntax=*"},
                 progress);
    if (status(curl) == 404 || status(curl) == 204 || !reader)
      throw noSeries(connection_);
    if (!reader->complete())
      throw cut(connection_);
    if (images.bad())
      throw strangeAnswer(connection_);
  }

  void send(const std::vector<std::filesystem::path>& files, Progress& progress) override {
    FilesBody body(files);
    std::string answer;
    Handle curl = handle("/studies");
    curl_easy_setopt(curl.get(), CURLOPT_POST, 1L);
    curl_easy_setopt(curl.get(), CURLOPT_POSTFIELDSIZE_LARGE, curl_off_t(body.size()));
    Exchange exchange;
    exchange.take = [&](std::string_view bytes) { keep(answer, bytes); };
    exchange.give = [&](char* bytes, std::size_t room) { return body.read(bytes, room, progress); };
    exchangeWith(curl, exchange,
                 {kJsonType, "Expect:",
                  std::string("Content-Type: multipart/related; type=\"application/dicom\"; boundary=") +
                      FilesBody::kBoundary},
                 progress, true);
    const json found = json::parse(answer, nullptr, false);
    std::size_t failed = status(curl) == 409 ? files.size() : 0;
    if (found.is_object() && found.contains("00081198") && found["00081198"].contains("Value"))
      failed = found["00081198"]["Value"].size();
    if (failed > 0)
      throw notStored(connection_, failed, files.size());
    if (status(curl) == 200 && !found.is_object())
      throw strangeAnswer(connection_);
  }

private:
  using Handle = std::unique_ptr<CURL, CurlDeleter>;

  static long status(const Handle& curl) {
    long code = 0;
    curl_easy_getinfo(curl.get(), CURLINFO_RESPONSE_CODE, &code);
    return code;
  }

  static std::string escaped(const std::string& text) {
    char* made = curl_easy_escape(nullptr, text.c_str(), int(text.size()));
    std::string result = made != nullptr ? made : "";
    curl_free(made);
    // Orthanc takes a wildcard for one only as it is, which a query of an address may hold.
    for (const auto& [code, wildcard] : {std::pair{"%2A", "*"}, std::pair{"%3F", "?"}})
      for (std::size_t at = result.find(code); at != std::string::npos; at = result.find(code))
        result.replace(at, 3, wildcard);
    return result;
  }

  void keep(std::string& answer, std::string_view bytes) const {
    if (answer.size() + bytes.size() > kLongestAnswer)
      throw strangeAnswer(connection_);
    answer += bytes;
  }

  Handle handle(const std::string& path) const {
    Handle curl(curl_easy_init());
    if (curl == nullptr)
      throw std::bad_alloc();
    CURL* c = curl.get();
    curl_easy_setopt(c, CURLOPT_URL, (connection_.address + path).c_str());
    curl_easy_setopt(c, CURLOPT_PROTOCOLS_STR, "http,https");
    curl_easy_setopt(c, CURLOPT_NOSIGNAL, 1L);
    curl_easy_setopt(c, CURLOPT_CONNECTTIMEOUT, kWebConnectSeconds);
    curl_easy_setopt(c, CURLOPT_LOW_SPEED_LIMIT, 1L);
    curl_easy_setopt(c, CURLOPT_LOW_SPEED_TIME, long(connection_.patienceSeconds));
    curl_easy_setopt(c, CURLOPT_USERAGENT, "Viscera/" VISCERA_VERSION);
    for (const char* near : {"://127.0.0.1", "://localhost", "://[::1]"})
      if (connection_.address.find(near) != std::string::npos)
        curl_easy_setopt(c, CURLOPT_PROXY, ""); // A proxy does not reach this machine.
    if (!connection_.certificates.empty())
      curl_easy_setopt(c, CURLOPT_CAINFO, connection_.certificates.c_str());
    if (!connection_.user.empty()) {
      curl_easy_setopt(c, CURLOPT_HTTPAUTH, long(CURLAUTH_BASIC));
      curl_easy_setopt(c, CURLOPT_USERNAME, connection_.user.c_str());
      curl_easy_setopt(c, CURLOPT_PASSWORD, password_.c_str());
    }
    return curl;
  }

  /// Runs it and throws what is wrong; a 404 or 409 is left to the caller.
  void exchangeWith(const Handle& curl, Exchange& exchange, const std::vector<std::string>& headers,
                    Progress& progress, bool sending = false) const {
    CURL* c = curl.get();
    std::unique_ptr<curl_slist, CurlDeleter> list;
    for (const std::string& header : headers)
      list.reset(curl_slist_append(list.release(), header.c_str()));
    exchange.progress = &progress;
    curl_easy_setopt(c, CURLOPT_HTTPHEADER, list.get());
    curl_easy_setopt(c, CURLOPT_WRITEFUNCTION, takeBytes);
    curl_easy_setopt(c, CURLOPT_WRITEDATA, &exchange);
    if (sending) {
      curl_easy_setopt(c, CURLOPT_READFUNCTION, giveBytes);
      curl_easy_setopt(c, CURLOPT_READDATA, &exchange);
    }
    curl_easy_setopt(c, CURLOPT_NOPROGRESS, 0L);
    curl_easy_setopt(c, CURLOPT_XFERINFOFUNCTION, lookAtProgress);
    curl_easy_setopt(c, CURLOPT_XFERINFODATA, &exchange);
    const CURLcode code = curl_easy_perform(c);
    progress.throwIfCancelled();
    if (exchange.thrown)
      std::rethrow_exception(exchange.thrown);
    throwFor(code);
    const long answer = status(curl);
    if (answer == 401 || answer == 403)
      throw wrongPassword(connection_);
    if (answer != 404 && answer != 409 && (answer < 200 || answer > 299))
      throw refusal(connection_, "HTTP " + std::to_string(answer));
  }

  void throwFor(CURLcode code) const {
    switch (code) {
    case CURLE_OK:
      return;
    case CURLE_COULDNT_RESOLVE_HOST:
    case CURLE_COULDNT_RESOLVE_PROXY:
      throw unknownHost(connection_);
    case CURLE_COULDNT_CONNECT:
    case CURLE_URL_MALFORMAT:
      throw unreachable(connection_);
    case CURLE_OPERATION_TIMEDOUT:
      throw silent(connection_);
    case CURLE_PEER_FAILED_VERIFICATION:
    case CURLE_SSL_CACERT_BADFILE:
      throw untrusted(connection_);
    case CURLE_SSL_CONNECT_ERROR:
      throw withoutTls(connection_);
    case CURLE_UNSUPPORTED_PROTOCOL:
    case CURLE_WEIRD_SERVER_REPLY:
      throw strangeAnswer(connection_);
    default:
      throw cut(connection_);
    }
  }

  json list(const std::string& path, Progress& progress) const {
    std::string answer;
    const Handle curl = handle(path);
    Exchange exchange;
    exchange.take = [&](std::string_view bytes) { keep(answer, bytes); };
    exchangeWith(curl, exchange, {kJsonType}, progress);
    if (status(curl) == 204)
      return json::array();
    const json found = status(curl) == 200 ? json::parse(answer, nullptr, false) : json();
    const auto isRow = [](const json& row) { return row.is_object(); };
    if (!found.is_array() || !std::all_of(found.begin(), found.end(), isRow))
      throw strangeAnswer(connection_);
    return found;
  }

  std::vector<ArchiveSeries> seriesOf(const std::string& studyUid, const std::string& modality,
                                      Progress& progress) const {
    std::string path = "/studies/" + studyUid + "/series?includefield=0008103E&includefield=00201209";
    if (!modality.empty())
      path += "&Modality=" + escaped(modality);
    std::vector<ArchiveSeries> series;
    for (const json& row : list(path, progress)) {
      const std::string images = valueIn(row, "00201209");
      series.push_back({valueIn(row, "0020000E"), valueIn(row, "00080060"), valueIn(row, "0008103E"),
                        valueIn(row, "00200011"), images.empty() ? -1 : std::atoi(images.c_str())});
    }
    return series;
  }

  ArchiveConnection connection_;
  std::string password_;
};

} // namespace

std::unique_ptr<ArchiveChannel> webChannel(const ArchiveConnection& connection, const std::string& password) {
  return std::make_unique<WebChannel>(connection, password);
}

} // namespace viscera::clinic
