#include "viscera/live/unsuited_motion.h"

#include <algorithm>
#include <optional>

#include "viscera/anatomy/part.h"
#include "viscera/live/sequence_setup.h"

namespace viscera::live {
namespace {

/// "Liver" of "Model_2_liver"; the name itself where it says no organ.
std::string titleFor(const std::string& organName) {
  const auto part = anatomy::partNamed(organName);
  return part ? anatomy::titleOf(*part) : organName;
}

/// The id of the organ of which the name means the whole, a chamber or its muscle; empty for all else: a
/// piece of an organ may be all that was cut out of a scan.
std::string wholeOrganOf(const std::string& name) {
  const auto part = anatomy::partNamed(name);
  if (!part || part->extent != anatomy::Extent::whole)
    return {};
  return std::string(part->organ == "myocardium" ? anatomy::kHeart.organ : part->organ);
}

} // namespace

Text unsuitedTo(const std::string& sequence, const std::string& organName) {
  const auto& all = sampleSequences();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const SampleSequence& one) { return one.id == sequence; });
  if (found == all.end() || matchesOrgan(*found, organName) != SequenceMatch::no)
    return {};
  return phrase("%1 is made for another organ (%2) than this one (%3): its numbers say nothing about it",
                named(found->name), named(titleFor(found->organ)), named(titleFor(organName)));
}

Text unsuitedTo(const std::vector<std::string>& recordedOf, const std::string& organName) {
  const std::string organ = wholeOrganOf(organName);
  if (organ.empty())
    return {};
  std::string other;
  for (const std::string& name : recordedOf) {
    const std::string recorded = wholeOrganOf(name);
    if (recorded == organ)
      return {};
    if (other.empty() && !recorded.empty())
      other = name;
  }
  return other.empty()
             ? Text()
             : phrase("The motion was recorded of another organ (%1) than this one (%2): its numbers "
                      "say nothing about it",
                      named(titleFor(other)), named(titleFor(organName)));
}

Text unsuitedTo(const SequenceFile& sequence, const std::string& organName) {
  std::vector<std::string> names;
  for (const SequenceOrgan& organ : sequence.organs)
    names.push_back(organ.name);
  return unsuitedTo(names, organName);
}

} // namespace viscera::live
