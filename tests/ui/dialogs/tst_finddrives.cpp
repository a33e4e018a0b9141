// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/scripted_link.h"
#include "tests/support/verify.h"
#include "tests/ui/support/window_test.h"
#include "ui/dialogs/find_drives_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QSemaphore>
#include <QSignalSpy>
#include <QThreadPool>
#include <QTreeWidget>

#include <map>
#include <mutex>
#include <optional>
#include <thread>

namespace tst_finddrives {

using namespace axiscomp;
using namespace axiscomp::ui;
using test::ScriptedLink;

namespace {

const DriveIdentity drive{"Triamec-616", 1559, 2};

} // namespace

class TestFindDrives : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnWindowWarnings();
        m_answers = {};
        m_places = {};
        m_asksForBaudRates = false;
        m_otherThan.clear();
        m_asked.reset();
    }

    void whatAnswersIsChosenAndWhatDoesNotSaysWhy();
    void addGivesTheChosenAddressesOnly();
    void nothingFoundNothingToAdd();
    void aComputerWithoutPortsIsToldInASentence();
    void baudRatesAreTriedWhenAsked();
    void knownPortsAreLeftOut();
    void closedWhileAPortIsSilentItDoesNotWait();
    void aNetworkIsAskedOnlyAfterItsAddressesWereConfirmed();
    void aRangeThatIsNoneSaysWhy();
    void aSearchOfANetworkCanBeStopped();

private:
    void port(const std::string& endpoint, const std::string& hardware, ScriptedLink::Answer answer)
    {
        m_places.push_back({{endpoint}, hardware});
        m_answers[endpoint] = std::move(answer);
    }
    static ScriptedLink::Answer answers()
    {
        return [](const Exchange&) -> Result<DriveIdentity> { return drive; };
    }
    static ScriptedLink::Answer refuses(const std::string& endpoint, const std::string& reason)
    {
        return [=](const Exchange&) -> Result<DriveIdentity> {
            return fail(ErrorCode::NotConnected, {{"endpoint", endpoint}, {"reason", reason}});
        };
    }
    FindDrivesDialog::Options options(std::vector<std::string> otherThan = {})
    {
        FindDrivesDialog::Options options;
        options.linkFactory =
            [this](const std::string& endpoint) -> Result<std::unique_ptr<DriveLink>> {
            return std::make_unique<ScriptedLink>(
                endpoint, m_answers.at(endpoint), m_otherRequests);
        };
        options.candidates = [this](const std::vector<std::string>& known, bool anyBaudRate) {
            const std::lock_guard lock(m_mutex);
            m_asksForBaudRates = anyBaudRate;
            m_otherThan = known;
            return m_places;
        };
        options.otherThan = std::move(otherThan);
        return options;
    }
    /// Shown, and the search has ended.
    static QPointer<FindDrivesDialog> searched(FindDrivesDialog::Options options)
    {
        const QPointer<FindDrivesDialog> dialog = new FindDrivesDialog(std::move(options));
        dialog->show();
        waitForEnd(*dialog);
        return dialog;
    }
    static void waitForEnd(const FindDrivesDialog& dialog)
    {
        auto* again = dialog.findChild<QPushButton*>(QStringLiteral("searchAgain"));
        QTRY_VERIFY2(again->isEnabled(), "the search did not end");
    }
    static QTreeWidget& list(const FindDrivesDialog& dialog)
    {
        return *dialog.findChild<QTreeWidget*>(QStringLiteral("foundDrives"));
    }
    static QPushButton& add(const FindDrivesDialog& dialog)
    {
        return *dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
    }
    static QString note(const FindDrivesDialog& dialog)
    {
        return dialog.findChild<QLabel*>(QStringLiteral("searchNote"))->text();
    }
    static QTreeWidgetItem* row(const FindDrivesDialog& dialog, const char* endpoint)
    {
        const auto rows = list(dialog).findItems(QString::fromUtf8(endpoint), Qt::MatchExactly, 0);
        return rows.value(0);
    }

    FindDrivesDialog::Options networkOptions()
    {
        FindDrivesDialog::Options all = options();
        all.network.ownNetworks = [] { return std::vector<std::string>{"192.168.7.0/24"}; };
        all.network.candidates = [this](
                                     const NetworkRange& range, const std::vector<std::string>&) {
            const std::lock_guard lock(m_mutex);
            m_asked = range;
            return m_places;
        };
        return all;
    }
    static QComboBox& range(const FindDrivesDialog& dialog)
    {
        return *dialog.findChild<QComboBox*>(QStringLiteral("networkRange"));
    }
    static QPushButton& button(const FindDrivesDialog& dialog, const char* name)
    {
        return *dialog.findChild<QPushButton*>(QLatin1StringView(name));
    }
    std::optional<NetworkRange> asked()
    {
        const std::lock_guard lock(m_mutex);
        return m_asked;
    }

    std::optional<NetworkRange> m_asked;
    std::mutex m_mutex;
    std::map<std::string, ScriptedLink::Answer> m_answers;
    std::vector<DriveCandidate> m_places;
    bool m_asksForBaudRates = false;
    std::vector<std::string> m_otherThan;
    std::atomic<int> m_otherRequests = 0;
};

void TestFindDrives::whatAnswersIsChosenAndWhatDoesNotSaysWhy()
{
    port("serial:/dev/ttyUSB0", "FT232R USB UART, FTDI", answers());
    port(
        "serial:/dev/ttyS0", "", refuses("serial:/dev/ttyS0", "another program is using the port"));
    const auto dialog = searched(options());
    QCOMPARE(list(*dialog).topLevelItemCount(), 2);
    const QTreeWidgetItem* found = row(*dialog, "serial:/dev/ttyUSB0");
    QVERIFY(found);
    QCOMPARE(found->checkState(0), Qt::Checked);
    QCOMPARE(found->text(1), QStringLiteral("FT232R USB UART, FTDI"));
    QVERIFY2(found->text(2).contains(QStringLiteral("Triamec-616")), qPrintable(found->text(2)));
    const QTreeWidgetItem* silent = row(*dialog, "serial:/dev/ttyS0");
    QVERIFY(silent);
    QVERIFY(!(silent->flags() & Qt::ItemIsUserCheckable));
    QVERIFY2(
        silent->text(2).contains(QStringLiteral("another program")), qPrintable(silent->text(2)));
    QVERIFY2(
        note(*dialog).contains(u'2') && note(*dialog).contains(u'1'), qPrintable(note(*dialog)));
    QCOMPARE(m_otherRequests.load(), 0);
    delete dialog;
}

void TestFindDrives::addGivesTheChosenAddressesOnly()
{
    port("serial:/dev/ttyUSB0", "", answers());
    port("serial:/dev/ttyUSB1", "", answers());
    const auto dialog = searched(options());
    QSignalSpy chosen(dialog, &FindDrivesDialog::endpointsChosen);
    row(*dialog, "serial:/dev/ttyUSB0")->setCheckState(0, Qt::Unchecked);
    QTest::mouseClick(&add(*dialog), Qt::LeftButton);
    QCOMPARE(chosen.count(), 1);
    QCOMPARE(
        chosen.front().front().toStringList(), QStringList{QStringLiteral("serial:/dev/ttyUSB1")});
    QTRY_VERIFY(!dialog);
}

void TestFindDrives::nothingFoundNothingToAdd()
{
    port("serial:/dev/ttyS0", "", refuses("serial:/dev/ttyS0", "no permission"));
    const auto dialog = searched(options());
    QVERIFY(!add(*dialog).isEnabled());
    QVERIFY(!add(*dialog).toolTip().isEmpty());
    delete dialog;
}

void TestFindDrives::aComputerWithoutPortsIsToldInASentence()
{
    const auto dialog = searched(options());
    QCOMPARE(list(*dialog).topLevelItemCount(), 0);
    QVERIFY2(note(*dialog).contains(QStringLiteral("All serial ports")), qPrintable(note(*dialog)));
    delete dialog;
}

void TestFindDrives::baudRatesAreTriedWhenAsked()
{
    port("serial:/dev/ttyUSB0", "", answers());
    const auto dialog = searched(options());
    QVERIFY(!m_asksForBaudRates);
    auto* box = dialog->findChild<QCheckBox*>(QStringLiteral("anyBaudRate"));
    box->setFocus();
    QTest::keyClick(box, Qt::Key_Space);
    QTest::mouseClick(
        dialog->findChild<QPushButton*>(QStringLiteral("searchAgain")), Qt::LeftButton);
    waitForEnd(*dialog);
    QVERIFY(m_asksForBaudRates);
    QCOMPARE(list(*dialog).topLevelItemCount(), 1);
    delete dialog;
}

void TestFindDrives::knownPortsAreLeftOut()
{
    const auto dialog = searched(options({"serial:/dev/ttyUSB0"}));
    QVERIFY(m_otherThan == std::vector<std::string>{"serial:/dev/ttyUSB0"});
    delete dialog;
}

void TestFindDrives::closedWhileAPortIsSilentItDoesNotWait()
{
    QSemaphore asked;
    QSemaphore stopped;
    port("serial:/dev/ttyS0", "", [&](const Exchange& exchange) -> Result<DriveIdentity> {
        asked.release();
        const std::stop_callback onStop(exchange.stop, [&] { stopped.release(); });
        stopped.acquire();
        stopped.release();
        return fail(ErrorCode::Cancelled);
    });
    const QPointer<FindDrivesDialog> dialog = new FindDrivesDialog(options());
    QVERIFY(asked.tryAcquire(1, test::patienceMs));
    delete dialog;
    QVERIFY2(stopped.tryAcquire(1, test::patienceMs), "the search was not told to stop");
    stopped.release();
    QVERIFY(QThreadPool::globalInstance()->waitForDone(test::patienceMs));
}

void TestFindDrives::aNetworkIsAskedOnlyAfterItsAddressesWereConfirmed()
{
    port("http://192.168.7.20", "", answers());
    port("http://192.168.7.21", "", refuses("http://192.168.7.21", "no route"));
    const auto dialog = searched(networkOptions());
    QTRY_COMPARE(range(*dialog).currentText(), QStringLiteral("192.168.7.0/24"));
    auto& ask = button(*dialog, "searchNetwork");
    QVERIFY(ask.isEnabled());
    QVERIFY2(ask.text().contains(QStringLiteral("254")), qPrintable(ask.text()));
    range(*dialog).setEditText(QStringLiteral("192.168.7.20-21"));
    QVERIFY2(ask.text().contains(QStringLiteral("(2)")), qPrintable(ask.text()));
    QVERIFY(!asked());
    ask.click();
    waitForEnd(*dialog);
    QVERIFY(asked() && toText(*asked()) == "192.168.7.20-192.168.7.21");
    // Where nobody answers, there is nothing to list.
    QCOMPARE(list(*dialog).topLevelItemCount(), 1);
    QVERIFY(row(*dialog, "http://192.168.7.20"));
    QVERIFY2(note(*dialog).contains(QStringLiteral("asked: 2"))
            && note(*dialog).contains(QStringLiteral("found: 1")),
        qPrintable(note(*dialog)));
    QVERIFY(add(*dialog).isEnabled());
    delete dialog;
}

void TestFindDrives::aRangeThatIsNoneSaysWhy()
{
    const auto dialog = searched(networkOptions());
    QTRY_VERIFY(!range(*dialog).currentText().isEmpty());
    auto& ask = button(*dialog, "searchNetwork");
    range(*dialog).setEditText(QStringLiteral("10.0.0.0/8"));
    QVERIFY(!ask.isEnabled());
    QVERIFY2(note(*dialog).contains(QStringLiteral("1024")), qPrintable(note(*dialog)));
    range(*dialog).setEditText(QString());
    QVERIFY(!ask.isEnabled());
    range(*dialog).setEditText(QStringLiteral("10.0.0.1"));
    QVERIFY(ask.isEnabled());
    QVERIFY(!asked());
    delete dialog;
}

void TestFindDrives::aSearchOfANetworkCanBeStopped()
{
    const auto dialog = searched(networkOptions());
    for (int n = 0; n < 100; ++n)
        port("http://192.168.7." + std::to_string(n), "",
            [](const Exchange& exchange) -> Result<DriveIdentity> {
                while (!exchange.stop.stop_requested())
                    std::this_thread::yield();
                return fail(ErrorCode::Cancelled);
            });
    QTRY_VERIFY(!range(*dialog).currentText().isEmpty());
    button(*dialog, "searchNetwork").click();
    QVERIFY(button(*dialog, "stopSearch").isEnabled());
    QVERIFY(!button(*dialog, "searchNetwork").isEnabled());
    button(*dialog, "stopSearch").click();
    waitForEnd(*dialog);
    QVERIFY2(note(*dialog).startsWith(QStringLiteral("Stopped")), qPrintable(note(*dialog)));
    QVERIFY(!button(*dialog, "stopSearch").isEnabled());
    delete dialog;
}

AXISCOMP_WINDOW_TEST(TestFindDrives)

} // namespace tst_finddrives

#include "tst_finddrives.moc"
