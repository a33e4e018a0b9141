// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/patience.h"
#include "tests/ui/support/translation_file.h"

#include <QDir>
#include <QProcess>
#include <QTemporaryDir>

namespace axiscomp::test {

/// What lupdate finds in the sources now, and what it has to say about them.
struct SourceMessages {
    std::vector<Message> messages;
    QByteArray complaints;
};

/// As the target update-translations does.
inline SourceMessages findSourceMessages()
{
    const QString sources = QStringLiteral(AXISCOMP_SOURCE_FOLDER);
    const QTemporaryDir folder;
    const QString found = folder.filePath(QStringLiteral("sources.ts"));
    QProcess lupdate;
    lupdate.setWorkingDirectory(sources);
    lupdate.setProcessChannelMode(QProcess::MergedChannels);
    lupdate.start(QStringLiteral(AXISCOMP_LUPDATE),
        {QStringLiteral("-silent"), QStringLiteral("-locations"), QStringLiteral("absolute"),
            QStringLiteral("-no-ui-lines"), QStringLiteral("-tr-function-alias"),
            QStringLiteral("QT_TRANSLATE_NOOP+=AXISCOMP_TEXT,QT_TRANSLATE_NOOP+=AXISCOMP_HELP,"
                           "QT_TRANSLATE_N_NOOP3+=AXISCOMP_COUNTED"),
            QStringLiteral("-I"), QStringLiteral("."), QStringLiteral("core"),
            QStringLiteral("drivecomm"), QStringLiteral("ui"), QStringLiteral("app"),
            QStringLiteral("-ts"), found});
    if (!lupdate.waitForFinished(patienceMs))
        return {{}, "lupdate did not end"};
    std::vector<Message> messages = readTranslationFile(found);
    for (Message& message : messages) // the places are told from the folder of the file
        message.place =
            QDir(sources).relativeFilePath(QDir::cleanPath(folder.filePath(message.place)));
    return {std::move(messages), lupdate.readAll()};
}

} // namespace axiscomp::test
