#include "viscera/scene/handle_event.h"

#include <utility>

#include <vtkNew.h>

#include "viscera/scene/vtkVisceraHandleSetWidget.h"

namespace viscera::scene {
namespace {

class Listener : public vtkCommand {
public:
  static Listener* New() { return new Listener; }
  vtkTypeMacro(Listener, vtkCommand)

      std::function<void(const HandleEvent&)> call;
  void Execute(vtkObject*, unsigned long, void* data) override {
    if (data)
      call(*static_cast<const HandleEvent*>(data));
  }
};

} // namespace

unsigned long observe(vtkVisceraHandleSetWidget* widget, unsigned long event,
                      std::function<void(const HandleEvent&)> listener) {
  vtkNew<Listener> command;
  command->call = std::move(listener);
  return widget->AddObserver(event, command);
}

} // namespace viscera::scene
