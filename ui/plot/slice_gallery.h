// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/async/background_job.h"

#include <QImage>
#include <QWidget>

#include <cstdint>
#include <vector>

class QLabel;
class QListView;

namespace axiscomp::ui {

class SlicesModel;
class TableContentCombo;
class TableViewModel;

/// All slices of a 3D table as small maps, in the colours of one scale, with the place of each. One
/// that is chosen is the slice that picture, values and surface show.
class SliceGallery : public QWidget {
    Q_OBJECT

public:
    /// shown must outlive the gallery.
    explicit SliceGallery(TableViewModel& shown, QWidget* parent = nullptr);
    ~SliceGallery() override;

    void retranslate();

Q_SIGNALS:
    void chosen(); ///< by a click or Enter; the slice is shown already

protected:
    void changeEvent(QEvent* event) override; ///< palette and language
    void showEvent(QShowEvent* event) override;

private:
    void build();
    void showTable();
    void choose(int row);

    TableViewModel& m_shown;
    SlicesModel* m_model;
    TableContentCombo* m_contentBox;
    QLabel* m_note;
    QListView* m_view;
    NewestJob<std::vector<QImage>> m_job;
    bool m_isWanted = false; ///< pictures are made once they are looked at
};

/// Which slices of a dimension have a picture: all, or every so many when they are more than can be
/// looked through; the last one too.
[[nodiscard]] std::vector<int> picturedSlices(std::uint32_t size);

} // namespace axiscomp::ui
