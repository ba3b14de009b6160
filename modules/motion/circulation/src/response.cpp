#include "viscera/circulation/response.h"

#include <optional>

#include "viscera/circulation/periodic_state.h"
#include "viscera/core/error.h"
#include "viscera/core/text.h"

namespace viscera::circulation {

std::vector<ResponsePoint> responseTo(const Parameters& parameters, const std::string& name,
                                      const std::vector<double>& values, Progress& progress) {
  std::vector<ResponsePoint> points;
  std::optional<State> nearby;
  Parameters changed = parameters;
  for (std::size_t i = 0; i < values.size(); ++i) {
    setParameter(changed, name, values[i]);
    Progress quiet;
    progress.throwIfCancelled();
    // y(T; y_0) = y_0 at this value. The solution moves little from one value to the next, so that each
    // search begins with the one before.
    const PeriodicState found = findPeriodicState(changed, quiet, {}, nearby ? &*nearby : nullptr);
    if (!found.converged)
      throw DataError(found.failureReason, name + "=" + significant(values[i], 6));
    nearby = found.start;
    points.push_back({values[i], indicesOf(changed, found.beat)});
    progress.report(static_cast<double>(i + 1) / static_cast<double>(values.size()), name);
  }
  return points;
}

} // namespace viscera::circulation
