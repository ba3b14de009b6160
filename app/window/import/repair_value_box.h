#pragma once

#include <QFrame>

#include <memory>

#include "viscera/document/import_draft.h"
#include "viscera/medical_io/surface_pieces.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;

namespace viscera::app {

/// Asks for the value of a repair of one organ: below which size pieces go, how fine a new surface is, by
/// which factor it is scaled. Says beforehand what the value does. Changes nothing itself.
class RepairValueBox final : public QFrame {
  Q_OBJECT

public:
  /// `repair`: an id of `medical_io::surfaceRepairs` that takes a value.
  RepairValueBox(const document::DraftOrgan& organ, std::string repair, QWidget* parent = nullptr);

  /// The repair with the value: "remove-fragments=5mm".
  QString id() const;

Q_SIGNALS:
  void chosen(const QString& id);
  /// The value was changed: `id` as it would be chosen.
  void changed(const QString& id);
  void closed();

private:
  QWidget* makeValue();
  QWidget* makeButtons();
  void setUnit();
  void tell();
  QString effect() const;

  std::shared_ptr<const geometry::TriangleMesh> mesh_;
  std::string repair_;
  Vec3 sizeMm_;
  double volumeMl_;
  std::optional<double> lifeSize_;
  std::unique_ptr<medical_io::SurfacePieces> pieces_; ///< Null for other repairs.
  QDoubleSpinBox* value_;
  QComboBox* unit_;
  QLabel* effect_;
};

} // namespace viscera::app
