#pragma once

#include <string>

#include <vtkNew.h>

class vtkObject;
class vtkCallbackCommand;

namespace viscera::medical_io {

/// Collects the errors and warnings of a VTK object, which VTK would print on stderr, until this object is
/// destroyed.
class QuietVtk {
public:
  explicit QuietVtk(vtkObject* watched);
  ~QuietVtk();
  QuietVtk(const QuietVtk&) = delete;
  QuietVtk& operator=(const QuietVtk&) = delete;

  bool failed() const { return !error_.empty(); }
  /// The first error, without VTK's file and line.
  const std::string& error() const { return error_; }

private:
  vtkObject* watched_;
  vtkNew<vtkCallbackCommand> command_;
  unsigned long errorTag_ = 0;
  unsigned long warningTag_ = 0;
  std::string error_;
};

} // namespace viscera::medical_io
