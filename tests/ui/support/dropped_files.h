// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/support/page_fixture.h"

#include <QDragEnterEvent>
#include <QMimeData>
#include <QUrl>

namespace axiscomp::test {

/// What a drag is told, and whether its drop was taken.
struct Drop {
    bool isWelcome = false;
    bool showsFrame = false;
    bool isTaken = false;
};

[[nodiscard]] inline Drop drop(PageFixture& bench, const QMimeData& data)
{
    Drop result;
    const QPoint place(300, 300);
    QDragEnterEvent enter(place, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    enter.ignore();
    QCoreApplication::sendEvent(&bench.wizard, &enter);
    result.isWelcome = enter.isAccepted();
    result.showsFrame = bench.user.sees("dropFrame");
    // A platform delivers a drop only where the drag was welcome.
    if (!result.isWelcome)
        return result;
    QDropEvent dropped(place, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    dropped.ignore();
    QCoreApplication::sendEvent(&bench.wizard, &dropped);
    result.isTaken = dropped.isAccepted();
    return result;
}

[[nodiscard]] inline Drop drop(PageFixture& bench, const QStringList& paths)
{
    QList<QUrl> urls;
    for (const QString& path : paths)
        urls += QUrl::fromLocalFile(path);
    QMimeData data;
    data.setUrls(urls);
    return drop(bench, data);
}

} // namespace axiscomp::test
