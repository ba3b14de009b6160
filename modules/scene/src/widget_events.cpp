#include "viscera/scene/widget_events.h"

#include <utility>

#include <vtkCommand.h>
#include <vtkNew.h>

#include "viscera/scene/vtkVisceraGizmoWidget.h"
#include "viscera/scene/vtkVisceraHandleSetWidget.h"

namespace viscera::scene {
namespace {

template <class Event>
class Listener final : public vtkCommand {
public:
  static Listener* New() { return new Listener; }

  std::function<void(const Event&)> call;
  void Execute(vtkObject*, unsigned long, void* data) override {
    if (data)
      call(*static_cast<const Event*>(data));
  }
};

template <class Event>
unsigned long addListener(vtkObject* widget, unsigned long event,
                          std::function<void(const Event&)> listener) {
  vtkNew<Listener<Event>> command;
  command->call = std::move(listener);
  return widget->AddObserver(event, command);
}

} // namespace

unsigned long observe(vtkVisceraHandleSetWidget* widget, unsigned long event,
                      std::function<void(const HandleEvent&)> listener) {
  return addListener(widget, event, std::move(listener));
}

unsigned long observe(vtkVisceraGizmoWidget* widget, unsigned long event,
                      std::function<void(const GizmoEvent&)> listener) {
  return addListener(widget, event, std::move(listener));
}

} // namespace viscera::scene
