// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/change_pictures.h"

#include "ui/plot/table_thumbnail.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>

#include <cmath>

namespace axiscomp::ui {

namespace {

constexpr int widestPicture = 50; // in letters: one alone stays small

} // namespace

ChangePictures::ChangePictures(QWidget* parent)
    : QWidget(parent)
    , m_before(new TableThumbnail)
    , m_after(new TableThumbnail)
    , m_difference(new TableThumbnail)
{
    setObjectName(QStringLiteral("changePictures"));
    m_before->setObjectName(QStringLiteral("pictureBefore"));
    m_after->setObjectName(QStringLiteral("pictureAfter"));
    m_difference->setObjectName(QStringLiteral("pictureDifference"));
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(10);
    for (TableThumbnail* thumbnail : {m_before, m_after, m_difference}) {
        thumbnail->setMaximumWidth(widestPicture * fontMetrics().averageCharWidth());
        layout->addWidget(thumbnail, 1);
    }
    layout->addStretch();
}

void ChangePictures::setChange(const TableChange& change, const std::string& unit)
{
    setPicture(*m_before, change.before, change.scale(), tr("On the drive"), unit);
    setPicture(*m_after, change.after, change.scale(), tr("New"), unit);
    setPicture(*m_difference, change.difference, std::abs(change.difference.largest.change),
        tr("Difference, new − old"), unit);
}

void ChangePictures::setPicture(TableThumbnail& thumbnail, const TablePicture& picture,
    double scale, const QString& title, const std::string& unit)
{
    thumbnail.setVisible(picture.drawn != nullptr);
    thumbnail.setPicture(picture.drawn, scale, unitSymbol(unit).toStdString());
    if (!picture.drawn)
        return;
    thumbnail.setTexts(title, pictureText(picture, unit));
}

QString pictureText(const TablePicture& picture, const std::string& unit)
{
    const QString largest =
        ChangePictures::tr("largest %1").arg(changeText(picture.largest, picture.grid, unit));
    if (!picture.cutAt)
        return largest;
    return ChangePictures::tr(
        "%1; shown: the middle slice, %2 %3", "largest value, dimension, place")
        .arg(largest, dimensionName(picture.grid, 2), numberText(*picture.cutAt));
}

QString changeText(const LargestChange& change, const Grid& grid, const std::string& unit)
{
    const QString value = smallValueText(change.change, unit);
    if (change.isBound)
        return ChangePictures::tr("up to %1").arg(value);
    QStringList places;
    for (std::size_t n = 0; n < grid.axes.size(); ++n)
        places +=
            QStringLiteral("%1 %2").arg(dimensionName(grid, n), numberText(change.position.at(n)));
    return ChangePictures::tr("%1 at %2", "value at position").arg(value, listText(places));
}

} // namespace axiscomp::ui
