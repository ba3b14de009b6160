#pragma once

#include <QSize>
#include <QString>

#include <vector>

namespace viscera::app {

/// The kind of file that a movie or table is recorded to.
enum class MovieFormat { ogg, mp4, gif, pictures, table };

/// Name, file ending and requirements of a movie format.
struct MovieFormatInfo {
  MovieFormat format = MovieFormat::ogg;
  QString name;   ///< "Ogg movie (.ogv)"
  QString ending; ///< ".ogv"; empty for a folder of pictures.
  bool needsFfmpeg = false;
  bool drawn = true; ///< False: only numbers.
};

/// All formats, in the order in which a list shows them.
std::vector<MovieFormatInfo> movieFormats();
MovieFormatInfo infoOf(MovieFormat format);

/// The settings of a movie: its file, format, size, frames and cycles.
struct MoviePlan {
  MovieFormat format = MovieFormat::ogg;
  QString file; ///< For pictures a folder.
  QSize size = {1280, 720};
  double framesPerSecond = 25;
  int cycles = 1;
  bool caption = true; ///< Phase and volumes are written into the picture.
  bool table = false;  ///< The volumes go into a table beside it as well.

  /// The file of the table: the movie's file name with another ending.
  QString tableFile() const;
};

/// A file in the folder that is not there yet, nor the `table` beside it: "heartbeat_75.ogv",
/// "heartbeat_75_2.ogv".
QString freeMovieFile(const QString& folder, const QString& name, MovieFormat format, bool table);

} // namespace viscera::app
