// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/window_test.h"
#include "ui/page/page_menu.h"

#include <QDesktopServices>
#include <QDir>
#include <QFile>
#include <QScopeGuard>
#include <QTemporaryDir>
#include <QTest>

namespace tst_documentationsite {

using namespace axiscomp;
using namespace axiscomp::ui;

/// All documents in the browser, where they are installed.
class TestDocumentationSite : public QObject {
    Q_OBJECT

public Q_SLOTS:
    /// In place of a browser.
    void open(const QUrl& url) { m_opened += url; }

private Q_SLOTS:
    void init()
    {
        test::failOnWindowWarnings();
        m_opened.clear();
    }

    void theMenuOffersTheDocumentationOnlyWhereItIsInstalled()
    {
        const QTemporaryDir data;
        const QByteArray before = qgetenv("XDG_DATA_DIRS");
        qputenv("XDG_DATA_DIRS", data.path().toUtf8());
        const auto restored = qScopeGuard([&before] { qputenv("XDG_DATA_DIRS", before); });
        PageMenu menu;
        auto* help = menu.findChild<QMenu*>(QStringLiteral("helpMenu"));
        auto* action = menu.findChild<QAction*>(QStringLiteral("documentationAction"));
        QVERIFY(help && action);
        QVERIFY(!action->isVisible());

        // It may be installed and removed while the window is open.
        const QString page = installSite(data.path());
        Q_EMIT help->aboutToShow();
        QVERIFY(action->isVisible());
        QVERIFY(QFile::remove(page));
        Q_EMIT help->aboutToShow();
        QVERIFY(!action->isVisible());
    }

    void theDocumentationOpensInTheBrowserFromTheDisk()
    {
        const QTemporaryDir data;
        const QByteArray before = qgetenv("XDG_DATA_DIRS");
        qputenv("XDG_DATA_DIRS", data.path().toUtf8());
        QDesktopServices::setUrlHandler(QStringLiteral("file"), this, "open");
        const auto restored = qScopeGuard([&before] {
            QDesktopServices::unsetUrlHandler(QStringLiteral("file"));
            qputenv("XDG_DATA_DIRS", before);
        });
        const QString page = installSite(data.path());
        PageMenu menu;
        auto* action = menu.findChild<QAction*>(QStringLiteral("documentationAction"));
        QVERIFY(action && action->isVisible());
        action->trigger();
        QCOMPARE(m_opened, QList<QUrl>{QUrl::fromLocalFile(page)});
    }

private:
    /// As the package does.
    static QString installSite(const QString& dataFolder)
    {
        const QDir folder(dataFolder + QStringLiteral("/doc/axiscomp-doc/html"));
        QFile page(folder.filePath(QStringLiteral("index.html")));
        if (!folder.mkpath(QStringLiteral(".")) || !page.open(QIODevice::WriteOnly))
            qWarning("cannot write %s", qPrintable(page.fileName()));
        return page.fileName();
    }

    QList<QUrl> m_opened;
};

AXISCOMP_WINDOW_TEST(TestDocumentationSite)

} // namespace tst_documentationsite

#include "tst_documentationsite.moc"
