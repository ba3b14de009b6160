#pragma once

class QApplication;

namespace viscera::app {

/// What has to be said before the QApplication is made: the surface format that VTK needs, high density.
void prepareForApplication();

/// Name, version, and the plurals of the English texts.
void setUpApplication(QApplication& application);

} // namespace viscera::app
