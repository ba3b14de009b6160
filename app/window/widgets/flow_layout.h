#pragma once

#include <QLayout>

#include <vector>

namespace viscera::app {

/// A layout that places its items in lines, as many in each as fit, like the words of a text.
class FlowLayout final : public QLayout {
public:
  explicit FlowLayout(QWidget* parent, int spacing);
  ~FlowLayout() override;

  void addItem(QLayoutItem* item) override { items_.push_back(item); }
  int count() const override { return static_cast<int>(items_.size()); }
  QLayoutItem* itemAt(int index) const override {
    return index >= 0 && index < count() ? items_[index] : nullptr;
  }
  QLayoutItem* takeAt(int index) override;
  Qt::Orientations expandingDirections() const override { return {}; }
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override { return arrange(QRect(0, 0, width, 0), false); }
  /// All items in one line.
  QSize sizeHint() const override;
  QSize minimumSize() const override;
  void setGeometry(const QRect& rect) override;

private:
  /// Places the items in `rect`, or only measures; returns the height.
  int arrange(const QRect& rect, bool place) const;

  std::vector<QLayoutItem*> items_;
};

} // namespace viscera::app
