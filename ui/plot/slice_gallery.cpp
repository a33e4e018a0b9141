// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/slice_gallery.h"

#include "core/table/table_math.h"
#include "ui/data/table_view_model.h"
#include "ui/drawing/table_map.h"
#include "ui/plot/table_content_combo.h"
#include "ui/style/plain_label.h"
#include "ui/text/value_text.h"

#include <QAbstractListModel>
#include <QBoxLayout>
#include <QEvent>
#include <QIcon>
#include <QLabel>
#include <QListView>
#include <QPixmap>

#include <algorithm>
#include <cmath>

namespace axiscomp::ui {

namespace {

constexpr int mostPictures = 240;
constexpr int longerSide = 140; // pixels of a picture
constexpr int shorterSide = 40; // at least

/// As long as both dimensions are, but never a thread.
QSize pictureSize(const Grid& grid)
{
    const double width = grid.axes[0].last() - grid.axes[0].start;
    const double height = grid.axes[1].last() - grid.axes[1].start;
    const double longer = std::max(width, height);
    const auto pixels = [&](double span) {
        return std::max(shorterSide, static_cast<int>(std::round(span / longer * longerSide)));
    };
    return {pixels(width), pixels(height)};
}

QImage pictureOf(const CompensationTable& table, std::size_t dimension, std::size_t index,
    double scale, bool isDark, double ratio)
{
    const auto slice =
        std::make_shared<const CompensationTable>(tableSlice(table, dimension, index));
    const auto& axes = slice->grid.axes;
    const QSize size = (QSizeF(pictureSize(slice->grid)) * ratio).toSize();
    QImage image = imageOf(
        {slice, divergingGradient(isDark), QCPRange(-scale, scale), QRectF(QPointF(), size),
            QCPRange(axes[0].start, axes[0].last()), QCPRange(axes[1].start, axes[1].last())},
        size);
    image.setDevicePixelRatio(ratio);
    return image;
}

} // namespace

/// A row for each slice that has a picture.
class SlicesModel : public QAbstractListModel {
public:
    explicit SlicesModel(const TableViewModel& shown, QObject* parent)
        : QAbstractListModel(parent)
        , m_shown(shown)
    {
    }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override
    {
        return parent.isValid() ? 0 : static_cast<int>(m_slices.size());
    }
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override
    {
        if (!index.isValid() || !m_shown.isCut())
            return {};
        const auto row = static_cast<std::size_t>(index.row());
        const auto slice = static_cast<std::size_t>(m_slices[row]);
        if (role == Qt::DecorationRole)
            return row < m_pictures.size() ? m_pictures[row] : m_empty;
        if (role == Qt::DisplayRole || role == Qt::AccessibleTextRole)
            return placeText(slice);
        return {};
    }

    void setSlices(std::vector<int> slices, const QSize& size)
    {
        beginResetModel();
        m_slices = std::move(slices);
        m_pictures.clear();
        QPixmap empty(size);
        empty.fill(Qt::transparent);
        m_empty = iconOf(empty);
        endResetModel();
    }
    void setPictures(const std::vector<QImage>& images)
    {
        m_pictures.clear();
        for (const QImage& image : images)
            m_pictures.push_back(iconOf(QPixmap::fromImage(image)));
        if (!m_slices.empty())
            Q_EMIT dataChanged(index(0), index(rowCount() - 1));
    }
    [[nodiscard]] const std::vector<int>& slices() const { return m_slices; }

private:
    /// In its own colours when it is selected, too.
    static QIcon iconOf(const QPixmap& picture)
    {
        QIcon icon(picture);
        icon.addPixmap(picture, QIcon::Selected);
        return icon;
    }
    [[nodiscard]] QString placeText(std::size_t slice) const
    {
        const auto dimension = static_cast<std::size_t>(m_shown.sliceDimension()) - 1;
        const GridAxis& axis = m_shown.table()->grid.axes[dimension];
        return dimensionName(m_shown.table()->grid, dimension) + u' '
            + alignedPositionText(axis, slice) + unitSuffix(axis.unit);
    }

    const TableViewModel& m_shown;
    std::vector<int> m_slices;
    std::vector<QIcon> m_pictures;
    QIcon m_empty;
};

SliceGallery::SliceGallery(TableViewModel& shown, QWidget* parent)
    : QWidget(parent)
    , m_shown(shown)
    , m_model(new SlicesModel(shown, this))
    , m_contentBox(new TableContentCombo(shown, this))
    , m_note(new PlainLabel(this))
    , m_view(new QListView(this))
    , m_job([this](const std::vector<QImage>& images) { m_model->setPictures(images); })
{
    build();
    connect(&m_shown, &TableViewModel::changed, this, &SliceGallery::showTable);
    // A click is enough, whatever the desktop's habit: there is nothing else to do with a slice.
    connect(m_view, &QListView::clicked, this,
        [this](const QModelIndex& index) { choose(index.row()); });
    connect(m_view, &QListView::activated, this,
        [this](const QModelIndex& index) { choose(index.row()); });
    retranslate();
    showTable();
}

SliceGallery::~SliceGallery() = default;

void SliceGallery::build()
{
    m_contentBox->setObjectName(QStringLiteral("galleryContent"));
    m_note->setObjectName(QStringLiteral("galleryNote"));
    m_note->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_view->setObjectName(QStringLiteral("sliceGalleryView"));
    m_view->setViewMode(QListView::IconMode);
    m_view->setMovement(QListView::Static);
    m_view->setResizeMode(QListView::Adjust);
    m_view->setUniformItemSizes(true);
    constexpr int gap = 10;
    m_view->setSpacing(gap);
    m_view->setModel(m_model);
    auto* top = new QHBoxLayout;
    top->addWidget(m_contentBox);
    top->addWidget(m_note, 1);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(4);
    layout->addLayout(top);
    layout->addWidget(m_view, 1);
}

void SliceGallery::retranslate()
{
    m_contentBox->retranslate();
    m_view->setAccessibleName(tr("Slices of the table"));
    m_view->setAccessibleDescription(tr("Enter shows the slice as a picture"));
    showTable();
}

void SliceGallery::showTable()
{
    if (!m_shown.isCut()) {
        m_job.cancel();
        m_model->setSlices({}, {});
        return;
    }
    const auto dimension = static_cast<std::size_t>(m_shown.sliceDimension()) - 1;
    const std::uint32_t count = m_shown.table()->grid.axes[dimension].size;
    std::vector<int> slices = picturedSlices(count);
    const QString range = tr("colours from %1 to %2")
                              .arg(m_shown.valueScale().textWithUnit(-m_shown.scale()),
                                  m_shown.valueScale().textWithUnit(m_shown.scale()));
    m_note->setText(slices.size() == count
            ? range
            : tr("%1 of %2 slices · %3").arg(countText(slices.size()), countText(count), range));
    const QSize size = pictureSize(m_shown.drawn()->grid);
    m_view->setIconSize(size);
    m_model->setSlices(std::move(slices), size);
    const auto row = std::ranges::lower_bound(m_model->slices(), m_shown.sliceIndex());
    m_view->setCurrentIndex(m_model->index(
        std::min(static_cast<int>(row - m_model->slices().begin()), m_model->rowCount() - 1)));
    m_isWanted = true;
    if (!isVisible())
        return;
    m_isWanted = false;
    m_job.start([table = m_shown.table(), dimension, slices = m_model->slices(),
                    scale = m_shown.scale(), ratio = devicePixelRatioF(),
                    isDark = palette().color(QPalette::Base).lightness() < 128](
                    const std::stop_token& stop) {
        std::vector<QImage> images;
        for (const int slice : slices) {
            if (stop.stop_requested())
                break;
            images.push_back(pictureOf(
                *table, dimension, static_cast<std::size_t>(slice), scale, isDark, ratio));
        }
        return images;
    });
}

void SliceGallery::choose(int row)
{
    if (row < 0 || row >= m_model->rowCount())
        return;
    m_shown.setSlice(m_shown.sliceDimension(), m_model->slices()[static_cast<std::size_t>(row)]);
    Q_EMIT chosen();
}

void SliceGallery::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (m_isWanted)
        showTable();
}

void SliceGallery::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::PaletteChange)
        showTable();
}

std::vector<int> picturedSlices(std::uint32_t size)
{
    const std::uint32_t step = (size - 1) / mostPictures + 1;
    std::vector<int> slices;
    for (std::uint32_t n = 0; n + 1 < size; n += step)
        slices.push_back(static_cast<int>(n));
    slices.push_back(static_cast<int>(size) - 1);
    return slices;
}

} // namespace axiscomp::ui
