#include "ranks.h"

#include <algorithm>
#include <exception>

#include <vtkCommunicator.h>
#include <vtkMultiProcessController.h>

#include "viscera/core/error.h"
#include "viscera/core/phrase.h"

namespace viscera::vtk_filters {
namespace {

/// Lists of any length from all ranks.
template <typename Value>
std::vector<std::vector<Value>> gatherLists(vtkMultiProcessController* controller, std::vector<Value> mine) {
  const int ranks = controller->GetNumberOfProcesses();
  vtkIdType count = static_cast<vtkIdType>(mine.size());
  std::vector<vtkIdType> counts(static_cast<std::size_t>(ranks)), offsets(counts.size() + 1, 0);
  controller->AllGather(&count, counts.data(), 1);
  for (std::size_t rank = 0; rank < counts.size(); ++rank)
    offsets[rank + 1] = offsets[rank] + counts[rank];
  std::vector<Value> all(static_cast<std::size_t>(std::max<vtkIdType>(offsets.back(), 1)));
  mine.resize(std::max<std::size_t>(mine.size(), 1));
  controller->AllGatherV(mine.data(), all.data(), count, counts.data(), offsets.data());
  std::vector<std::vector<Value>> parts(counts.size());
  for (std::size_t rank = 0; rank < parts.size(); ++rank)
    parts[rank].assign(all.begin() + offsets[rank], all.begin() + offsets[rank + 1]);
  return parts;
}

} // namespace

int Ranks::count() const {
  return controller_ ? controller_->GetNumberOfProcesses() : 1;
}

bool Ranks::first() const {
  return count() == 1 || controller_->GetLocalProcessId() == 0;
}

std::vector<std::string> Ranks::gatherTexts(const std::string& mine) const {
  if (count() == 1)
    return {mine};
  std::vector<std::string> texts;
  for (const auto& text : gatherLists(controller_, std::vector<char>(mine.begin(), mine.end())))
    texts.emplace_back(text.begin(), text.end());
  return texts;
}

void Ranks::together(const std::function<void()>& part) const {
  std::string failure;
  try {
    part();
  } catch (const std::exception& error) {
    failure = explanationOf(error).english();
    if (failure.empty())
      failure = "it failed without a message";
  }
  const auto failures = gatherTexts(failure);
  for (std::size_t rank = 0; rank < failures.size(); ++rank)
    if (!failures[rank].empty())
      throw DataError(failures[rank], count() == 1 ? Text() : phrase("rank %1", rank));
}

std::vector<std::vector<double>> Ranks::gather(std::vector<double> mine) const {
  if (count() == 1)
    return {std::move(mine)};
  return gatherLists(controller_, std::move(mine));
}

void Ranks::add(std::vector<ExactSum*> sums) const {
  if (count() == 1)
    return;
  std::vector<vtkTypeInt64> mine, all;
  for (ExactSum* sum : sums)
    mine.insert(mine.end(), sum->limbs().begin(), sum->limbs().end());
  all.resize(mine.size());
  controller_->AllReduce(mine.data(), all.data(), static_cast<vtkIdType>(mine.size()),
                         vtkCommunicator::SUM_OP);
  auto from = all.begin();
  for (ExactSum* sum : sums) {
    ExactSum::Limbs limbs;
    std::copy_n(from, limbs.size(), limbs.begin());
    from += ExactSum::kLimbs;
    *sum = ExactSum::fromLimbs(limbs);
  }
}

void Ranks::add(std::int64_t& value) const {
  if (count() == 1)
    return;
  const vtkTypeInt64 mine = value;
  vtkTypeInt64 all = 0;
  controller_->AllReduce(&mine, &all, 1, vtkCommunicator::SUM_OP);
  value = all;
}

double Ranks::largest(double value) const {
  if (count() == 1)
    return value;
  double all = value;
  controller_->AllReduce(&value, &all, 1, vtkCommunicator::MAX_OP);
  return all;
}

} // namespace viscera::vtk_filters
