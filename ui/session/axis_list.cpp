// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/axis_list.h"

#include <QCoreApplication>
#include <QHash>

#include <algorithm>
#include <functional>

namespace axiscomp::ui {

namespace {

const QString separator = QStringLiteral(" · ");

class Labels {
    Q_DECLARE_TR_FUNCTIONS(axiscomp::ui::AxisList)

public:
    explicit Labels(std::vector<AxisEntry>& entries) : m_entries(entries) { }

    void make()
    {
        m_axes.reserve(static_cast<qsizetype>(m_entries.size()));
        for (const AxisEntry& entry : m_entries) {
            m_axes.append(axisName(entry));
            m_drives.append(entry.driveName.isEmpty() ? entry.endpoint : entry.driveName);
        }
        // Each step adds to the labels that are still the same as another.
        extend(m_axes, [](const AxisEntry& entry) {
            return entry.axis.name.empty() ? QString()
                                           : QStringLiteral(" [%1]").arg(entry.axis.index);
        });
        extend(m_drives,
            [](const AxisEntry& entry) { return QStringLiteral(" #%1").arg(entry.serialNumber); });
        extend(
            m_drives, [](const AxisEntry& entry) { return QStringLiteral(" ") + entry.endpoint; });
        for (std::size_t i = 0; i < m_entries.size(); ++i) {
            m_entries[i].place = label(i).mid(axisName(m_entries[i]).size());
            m_entries[i].label = text(m_entries[i]);
        }
    }

    [[nodiscard]] static QString text(const AxisEntry& entry)
    {
        return axisName(entry) + entry.place + suffix(entry);
    }

    [[nodiscard]] static QString onDrive(const AxisEntry& entry)
    {
        return axisName(entry) + entry.place.left(entry.place.indexOf(separator));
    }

    [[nodiscard]] static QString problem(const AxisEntry& entry, bool isConnected)
    {
        if (!isConnected)
            return tr("The drive %1 is not connected.").arg(entry.driveName);
        if (!entry.axis.hasCompensation())
            return tr("This axis has no compensation registers.");
        return {};
    }

private:
    [[nodiscard]] static QString axisName(const AxisEntry& entry)
    {
        const QString name = QString::fromStdString(entry.axis.name).simplified();
        return name.isEmpty() ? tr("Axis %1").arg(entry.axis.index) : name;
    }

    [[nodiscard]] static QString suffix(const AxisEntry& entry)
    {
        if (!entry.axis.hasCompensation())
            return tr(" (no compensation)");
        return entry.isDemo ? tr(" (demo)") : QString();
    }

    [[nodiscard]] QString label(std::size_t index) const
    {
        const auto i = static_cast<qsizetype>(index);
        return m_axes[i] + separator + m_drives[i];
    }

    void extend(QStringList& parts, const std::function<QString(const AxisEntry&)>& addition)
    {
        QHash<QString, int> counts;
        for (std::size_t i = 0; i < m_entries.size(); ++i)
            ++counts[label(i)];
        QStringList extended = parts;
        for (std::size_t i = 0; i < m_entries.size(); ++i) {
            if (counts[label(i)] > 1)
                extended[static_cast<qsizetype>(i)] += addition(m_entries[i]);
        }
        parts = extended;
    }

    std::vector<AxisEntry>& m_entries;
    QStringList m_axes;
    QStringList m_drives;
};

} // namespace

std::vector<AxisEntry> axisEntries(std::span<const DriveAxes> drives)
{
    std::vector<AxisEntry> entries;
    for (const DriveAxes& drive : drives) {
        for (const AxisInfo& axis : drive.axes) {
            AxisEntry entry;
            entry.endpoint = drive.endpoint;
            entry.driveName = QString::fromStdString(drive.drive.name);
            entry.serialNumber = drive.drive.serialNumber;
            entry.axis = axis;
            entry.isDemo = drive.isDemo;
            entry.problem = Labels::problem(entry, drive.isConnected);
            entry.isUsable = entry.problem.isEmpty();
            entries.push_back(std::move(entry));
        }
    }
    Labels(entries).make();
    return entries;
}

QString axisLabel(const AxisEntry& entry)
{
    return Labels::text(entry);
}

QString axisNameOnDrive(const AxisEntry& entry)
{
    return Labels::onDrive(entry);
}

QString registerName(const std::string& path, std::span<const AxisEntry> axesOfDrive)
{
    for (const AxisEntry& entry : axesOfDrive) {
        const AxisInfo& axis = entry.axis;
        if (axis.folder.empty() || !path.starts_with(axis.folder))
            continue;
        const bool isSignal = !axis.signalFolder.empty() && path.starts_with(axis.signalFolder);
        const auto rest = path.substr((isSignal ? axis.signalFolder : axis.folder).size());
        const QString name = axis.name.empty()
            ? QCoreApplication::translate("ValueText", "Axis %1").arg(axis.index)
            : QString::fromStdString(axis.name);
        return name + QStringLiteral(" · ") + QString::fromStdString(rest);
    }
    return QString::fromStdString(path);
}

} // namespace axiscomp::ui
