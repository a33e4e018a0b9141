// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/support/page_fixture.h"
#include "tests/ui/support/window_test.h"
#include "ui/style/plain_label.h"

#include <QHelpEvent>
#include <QLabel>
#include <QTableWidget>
#include <QTest>
#include <QTextDocument>
#include <QToolTip>

namespace tst_plaintexts {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::PageFixture;

namespace {

const QString hostile = QStringLiteral("<img src=\"file:///dev/zero\">");

QString shownToolTip(QWidget& widget, const QPoint& at)
{
    QToolTip::hideText();
    QHelpEvent event(QEvent::ToolTip, at, widget.mapToGlobal(at));
    QCoreApplication::sendEvent(&widget, &event);
    return QToolTip::text();
}

} // namespace

/// What a drive or a file says is shown letter by letter.
class TestPlainTexts : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWindowWarnings(); }

    void everyLabelOfTheWindowIsPlainText()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        QTRY_VERIFY(!bench.user.the<QLabel>("liveValues").text().isEmpty());
        const auto labels = bench.window.findChildren<QLabel*>();
        QVERIFY(labels.size() > 20);
        for (const QLabel* label : labels) {
            const QString shown = label->objectName() + QStringLiteral(": ") + label->text();
            QVERIFY2(label->textFormat() == Qt::PlainText, qPrintable(shown));
            QVERIFY2(!Qt::mightBeRichText(label->text())
                    && !label->text().contains(QLatin1String("&nbsp")),
                qPrintable(shown)); // nobody sees bold letters there any more
        }
    }

    void aToolTipThatLooksLikeMarkupIsShownLetterByLetter()
    {
        PageFixture bench;
        QVERIFY(bench.open());
        QWidget& widget = bench.user.the("writeButton");
        widget.setToolTip(hostile);
        QCOMPARE(shownToolTip(widget, {3, 3}), Qt::convertFromPlainText(hostile));
        widget.setToolTip(QStringLiteral("1 < 2"));
        QCOMPARE(shownToolTip(widget, {3, 3}), QStringLiteral("1 < 2"));

        auto* table = new QTableWidget(1, 1, &bench.wizard);
        table->setItem(0, 0, new QTableWidgetItem(QStringLiteral("X")));
        table->item(0, 0)->setToolTip(hostile);
        table->resize(200, 200);
        table->show();
        const QPoint inItem = table->visualItemRect(table->item(0, 0)).center();
        QCOMPARE(shownToolTip(*table->viewport(), inItem), Qt::convertFromPlainText(hostile));
        delete table;
    }

    void aLongWordMakesNoWideWindow()
    {
        PlainLabel label(QString(300, u'W'));
        QVERIFY(label.sizeHint().width() > 2000);
        QVERIFY(label.minimumSizeHint().width() < 700);
        PlainLabel shortLabel(QStringLiteral("Axis"));
        QCOMPARE(shortLabel.minimumSizeHint(), shortLabel.QLabel::minimumSizeHint());
    }
};

AXISCOMP_WINDOW_TEST(TestPlainTexts)

} // namespace tst_plaintexts

#include "tst_plaintexts.moc"
