// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/guide_places.h"

#include <QHash>
#include <QWidget>

namespace axiscomp::ui {

namespace {

const QHash<QString, GuidePlace>& placesByName()
{
    const QString connect = QStringLiteral("2. Connect the drive");
    const QString choose = QStringLiteral("3. Choose");
    const QString write = QStringLiteral("4. Write");
    const QString activate = QStringLiteral("5. Activate, and see the proof");
    const GuidePlace formats{
        QStringLiteral("Files of other controllers, and uneven measurements"), {}};
    const GuidePlace configurations{QStringLiteral("Parameters of a TAM configuration"), {}};
    const GuidePlace judging{QStringLiteral("What a measurement says of the axis"), {}};
    const GuidePlace sources{choose, QStringLiteral("Dim1..3 Source")};
    const GuidePlace data{choose, QStringLiteral("Compensation data")};
    static const QHash<QString, GuidePlace> places{
        {QStringLiteral("driveBar"), {connect, {}}},
        {QStringLiteral("axisField"), {choose, QStringLiteral("Axis")}},
        {QStringLiteral("dimensionalityField"), {choose, QStringLiteral("Dimensionality")}},
        {QStringLiteral("source1Field"), sources},
        {QStringLiteral("source2Field"), sources},
        {QStringLiteral("source3Field"), sources},
        {QStringLiteral("dataField"), data},
        {QStringLiteral("openButton"), data},
        {QStringLiteral("recentButton"), data},
        {QStringLiteral("tableField"), {choose, QStringLiteral("Table")}},
        {QStringLiteral("persistencyField"), {choose, QStringLiteral("Persistency")}},
        {QStringLiteral("setupPanel"), {choose, {}}},
        {QStringLiteral("previewPanel"), {choose, {}}},
        {QStringLiteral("saveExampleButton"),
            {QStringLiteral("1. Prepare a calibration file"), {}}},
        {QStringLiteral("problems"), {QStringLiteral("What to do when ..."), {}}},
        {QStringLiteral("writePreview"), {write, {}}},
        {QStringLiteral("writeButton"), {write, {}}},
        {QStringLiteral("activateButton"), {activate, {}}},
        {QStringLiteral("activateMenuButton"), {activate, {}}},
        {QStringLiteral("deactivateButton"), {activate, {}}},
        {QStringLiteral("actionPanel"),
            {QStringLiteral("What the line under the buttons says"), {}}},
        {QStringLiteral("connectionsDialog"), {connect, {}}},
        {QStringLiteral("findDrivesDialog"), {connect, {}}},
        {QStringLiteral("certificateDialog"), {connect, {}}},
        {QStringLiteral("importDialog"), formats},
        {QStringLiteral("exportDialog"), formats},
        {QStringLiteral("multiAxisDialog"), {QStringLiteral("Several axes from one file"), {}}},
        {QStringLiteral("importConfigurationDialog"), configurations},
        {QStringLiteral("exportConfigurationDialog"), configurations},
        {QStringLiteral("backupDialog"), {QStringLiteral("Backups"), {}}},
        {QStringLiteral("restoreDriveDialog"), {QStringLiteral("Backups"), {}}},
        {QStringLiteral("judgePage"), judging},
        {QStringLiteral("correctionsDialog"), judging},
        {QStringLiteral("measurePage"), {QStringLiteral("Measurements"), {}}},
        {QStringLiteral("measurePage"), {QStringLiteral("Measurements"), {}}},
        {QStringLiteral("recordBar"), {QStringLiteral("The record, and the proof"), {}}},
        {QStringLiteral("provePage"), {QStringLiteral("The record, and the proof"), {}}},
        {QStringLiteral("fitPage"), {QStringLiteral("From the measurement to the table"), {}}},
        {QStringLiteral("logView"), {QStringLiteral("What to do when ..."), {}}},
    };
    return places;
}

} // namespace

GuidePlace guidePlaceOf(const QWidget* widget)
{
    for (; widget; widget = widget->parentWidget()) {
        const auto place = placesByName().constFind(widget->objectName());
        if (place != placesByName().cend())
            return *place;
    }
    return {};
}

} // namespace axiscomp::ui
