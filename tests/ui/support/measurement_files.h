// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QFile>
#include <QString>
#include <QTemporaryDir>

namespace axiscomp::test {

/// A public measurement, with figures and outliers that are known (docs/metrology.md):
/// "ess_mcu1025" ...
[[nodiscard]] inline QString publicMeasurement(const char* name)
{
    return QStringLiteral(AXISCOMP_SOURCE_FOLDER "/tests/data/metrology/%1.csv")
        .arg(QLatin1StringView(name));
}

/// A file with this text in a folder; empty: it could not be written.
[[nodiscard]] inline QString writtenMeasurement(
    const QTemporaryDir& folder, const char* name, const QByteArray& text)
{
    QFile file(folder.filePath(QLatin1StringView(name)));
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size() ? file.fileName()
                                                                              : QString();
}

} // namespace axiscomp::test
