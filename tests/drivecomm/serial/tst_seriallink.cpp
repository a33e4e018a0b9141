// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/link_factory.h"
#include "drivecomm/serial/serial_codec.h"
#include "tests/drivecomm/serial/serial_link_fixture.h"
#include "tests/support/test_registry.h"

#include <QAbstractEventDispatcher>
#include <QDeadlineTimer>
#include <QDir>
#include <QEventLoop>
#include <QFile>
#include <QTemporaryDir>
#include <QTimer>

#include <grp.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <thread>

namespace tst_seriallink {

using namespace axiscomp;
using namespace axiscomp::drivecomm;
using namespace axiscomp::test;

namespace {

std::string reasonOf(const Result<DriveIdentity>& result)
{
    return result.error().context.english("reason");
}

/// The first line of what came.
SerialLine requestIn(const std::string& came)
{
    const std::size_t begin = came.find_first_not_of("\r\n\x18");
    const std::string_view line = std::string_view(came).substr(begin == came.npos ? 0 : begin);
    return parseSerialLine(line.substr(0, line.find_first_of("\r\n")));
}

/// Root may do everything: for a while this is somebody else.
struct WithoutPrivileges {
    WithoutPrivileges()
    {
        constexpr uid_t nobody = 65534;
        if (::geteuid() == 0)
            m_isChanged = ::seteuid(nobody) == 0;
    }
    ~WithoutPrivileges()
    {
        if (m_isChanged && ::seteuid(0) != 0)
            std::abort();
    }

private:
    bool m_isChanged = false;
};

} // namespace

class SerialLinkTest final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void saysThatThereIsNoSuchPort();
    void saysThatItIsNoSerialPort();
    void saysWhoMayUseThePort_data();
    void saysWhoMayUseThePort();
    void saysThatAnotherProgramUsesThePort();
    void saysThatSomethingElseAnswers_data();
    void saysThatSomethingElseAnswers();
    void saysThatNothingAnswers();
    void sendsNothingButIdentifyToAStranger();
    void doesAnySpeed_data();
    void doesAnySpeed();
    void isUnpluggedInMidWrite();
    void isUnpluggedBetweenCalls();
    void findsTheDriveAgainUnderItsLink();
    void stopsWhileItWaits();
    void worksAtOnceAfterAStoppedTransfer_data();
    void worksAtOnceAfterAStoppedTransfer();
    void endsATransferAtItsDeadline();
    void aSlowLinesOwnTimeDoesNotCount();
    void talkThatNobodyAskedForDoesNotMoveTheDeadline_data();
    void talkThatNobodyAskedForDoesNotMoveTheDeadline();
    void aReplyWithoutItsCrcIsNoReply();
    void aLineInAnotherPlaceIsNotTakenForThatOne_data();
    void aLineInAnotherPlaceIsNotTakenForThatOne();
    void leavesTheTransferOfAProgramThatVanished();
    void takesNoReplyMeantForAnotherProgram();
    void writesNothingToAnotherDrive();
    void worksOnAnyThread();
    void theDriveOutlivesSignals();
    void makesLinksFromEndpoints();
};

void SerialLinkTest::saysThatThereIsNoSuchPort()
{
    const auto result = serialLinkTo("serial:/dev/no-such-port")->identify({});
    VERIFY_ERROR(result, ErrorCode::NotConnected);
    QCOMPARE(result.error().context.english("endpoint"), std::string("serial:/dev/no-such-port"));
    QVERIFY2(reasonOf(result).find("no such port") != std::string::npos, reasonOf(result).c_str());
}

void SerialLinkTest::saysThatItIsNoSerialPort()
{
    const QTemporaryDir folder;
    QFile file(folder.filePath(QStringLiteral("file")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    const auto result = serialLinkTo("serial:" + file.fileName().toStdString())->identify({});
    VERIFY_ERROR(result, ErrorCode::NotConnected);
    QVERIFY2(
        reasonOf(result).find("no serial port") != std::string::npos, reasonOf(result).c_str());
}

void SerialLinkTest::saysWhoMayUseThePort_data()
{
    QTest::addColumn<bool>("groupMay");
    QTest::newRow("a group") << true;
    QTest::newRow("nobody else") << false;
}

void SerialLinkTest::saysWhoMayUseThePort()
{
    QFETCH(bool, groupMay);
    const SerialDrive served;
    const std::string device = served.server->device();
    const group* dialout = ::getgrnam("dialout");
    const bool isRoot = ::geteuid() == 0;
    if (groupMay && (!isRoot || dialout == nullptr))
        QSKIP("needs root and the group dialout");
    if (groupMay)
        QCOMPARE(::chown(device.c_str(), 0, dialout->gr_gid), 0);
    QCOMPARE(::chmod(device.c_str(), groupMay ? 0660 : 0), 0);
    const auto link = serialLinkTo(served.server->url());
    {
        const WithoutPrivileges unprivileged;
        const auto result = link->identify({});
        VERIFY_ERROR(result, ErrorCode::NotConnected);
        const char* said = groupMay ? "join the group dialout" : "ask the administrator";
        QVERIFY2(reasonOf(result).find(said) != std::string::npos, reasonOf(result).c_str());
    }
    QCOMPARE(::chmod(device.c_str(), 0600), 0);
    VERIFY_RESULT(link->identify({}));
}

void SerialLinkTest::saysThatAnotherProgramUsesThePort()
{
    const QTemporaryDir folder;
    SerialServerOptions options;
    options.link = folder.filePath(QStringLiteral("drive")).toStdString();
    const SerialDrive served(options);
    auto first = serialLinkTo(served.server->url());
    VERIFY_RESULT(first->identify({}));
    for (const std::string& url : {served.server->url(), "serial:" + served.server->device()}) {
        const auto result = serialLinkTo(url)->identify({});
        VERIFY_ERROR(result, ErrorCode::NotConnected);
        QVERIFY2(reasonOf(result).find("another program is using the port") != std::string::npos,
            reasonOf(result).c_str());
    }
    VERIFY_RESULT(first->identify({}));
    first.reset();
    VERIFY_RESULT(serialLinkTo(served.server->url())->identify({}));
}

void SerialLinkTest::saysThatSomethingElseAnswers_data()
{
    QTest::addColumn<int>("kind");
    QTest::addColumn<QString>("quote");
    QTest::newRow("an echo") << 0 << "identify";
    QTest::newRow("a modem") << 1 << "ERROR";
    QTest::newRow("another speed") << 2 << "..";
    QTest::newRow("another protocol") << 3 << "login:";
}

void SerialLinkTest::saysThatSomethingElseAnswers()
{
    QFETCH(int, kind);
    QFETCH(QString, quote);
    const SerialStranger stranger([kind](const std::string& came) -> std::string {
        switch (kind) {
        case 0:
            return came;
        case 1:
            return "\r\nERROR\r\n";
        case 2:
            return std::string(came.size(), '\xFE');
        default:
            return "login: ";
        }
    });
    const auto result = serialLinkTo(stranger.url())->identify({});
    VERIFY_ERROR(result, ErrorCode::Protocol);
    QVERIFY(QString::fromStdString(result.error().context.english("quote")).contains(quote));
    QVERIFY(result.error().context.english("expected").find("115200 baud") != std::string::npos);
}

void SerialLinkTest::saysThatNothingAnswers()
{
    const SerialStranger stranger([](const std::string&) { return std::string(); });
    const auto result = serialLinkTo(stranger.url())->identify(within(300ms));
    VERIFY_ERROR(result, ErrorCode::Timeout);
    QCOMPARE(result.error().context.english("seconds"), std::string("0.3"));
    QCOMPARE(result.error().context.english("endpoint"), stranger.url());
}

void SerialLinkTest::sendsNothingButIdentifyToAStranger()
{
    const SerialStranger stranger([](const std::string&) { return std::string(); });
    const auto link = serialLinkTo(stranger.url());
    const std::vector<RegisterWrite> writes{{variable0, 1.0F}};
    VERIFY_ERROR(link->writeRegisters(writes, within(400ms)), ErrorCode::Timeout);
    const QRegularExpression identify(
        QStringLiteral("^#[0-9]{1,5} identify \\*[0-9a-f]{4}\\r\\n$"));
    QTRY_VERIFY(stranger.heard().ends_with('\n'));
    const QString heard = QString::fromStdString(stranger.heard());
    QVERIFY2(identify.match(heard).hasMatch(), qPrintable(heard));
}

void SerialLinkTest::doesAnySpeed_data()
{
    QTest::addColumn<int>("baud");
    for (const int baud : {9600, 115200, 250'000, 921'600, 12'345, 3'000'000})
        QTest::addRow("%d baud", baud) << baud;
}

void SerialLinkTest::doesAnySpeed()
{
    QFETCH(int, baud);
    const SerialDrive served;
    const std::string url = "serial:" + served.server->device() + "?baud=" + std::to_string(baud);
    const auto link = serialLinkTo(url);
    const auto identity = link->identify({});
    VERIFY_RESULT(identity);
    QVERIFY((*identity == DriveIdentity{"Serial-1", 1559, 2}));
}

void SerialLinkTest::isUnpluggedInMidWrite()
{
    SerialDrive served;
    const auto link = serialLinkTo(served.server->url());
    // Half-way by what has gone over the line: a cable that is pulled by another thread may come
    // after the end.
    const Bytes table = fullTable();
    served.faults.add({FaultSpec::Kind::DropAfter, table.size() / 2, {}});
    std::uint64_t most = 0;
    Exchange exchange;
    exchange.progress = [&most](std::uint64_t done, auto) { most = done; };
    const auto result = link->upload(small1, table, exchange);
    VERIFY_ERROR(result, ErrorCode::ConnectionLost);
    QVERIFY(result.error().context.english("reason").find("unplugged") != std::string::npos);
    QVERIFY(most > 0 && most < table.size());
    QVERIFY(served.file(small1).empty());
    served.server.reset();
    VERIFY_ERROR(link->identify({}), ErrorCode::NotConnected);
}

/// Qt 6.4 reports the lost peer of an open port hundreds of thousands of times a second.
void SerialLinkTest::isUnpluggedBetweenCalls()
{
    SerialDrive served;
    const auto link = serialLinkTo(served.server->url());
    VERIFY_RESULT(link->identify({}));
    served.server.reset();
    int turns = 0;
    const auto counting = connect(QAbstractEventDispatcher::instance(),
        &QAbstractEventDispatcher::awake, this, [&turns] { ++turns; });
    QEventLoop loop;
    QTimer::singleShot(200, &loop, &QEventLoop::quit);
    loop.exec();
    disconnect(counting);
    QVERIFY2(turns < 100, qPrintable(QString::number(turns)));
    VERIFY_ERROR(link->listFiles({}), ErrorCode::NotConnected);
}

void SerialLinkTest::findsTheDriveAgainUnderItsLink()
{
    const QTemporaryDir folder;
    SerialServerOptions options;
    options.link = folder.filePath(QStringLiteral("drive")).toStdString();
    SerialDrive served(options);
    const auto link = serialLinkTo(served.server->url());
    VERIFY_RESULT(link->identify({}));
    const std::string before = served.server->device();
    served.faults.add({FaultSpec::Kind::DropAfter, 30, {}});
    VERIFY_ERROR(link->listFiles({}), ErrorCode::ConnectionLost);
    VERIFY_RESULT(link->listFiles({}));
    QVERIFY(served.server->device() != before);
}

void SerialLinkTest::stopsWhileItWaits()
{
    std::stop_source source;
    const SerialStranger stranger([&source](const std::string&) {
        source.request_stop(); // from another thread, with the request on its way
        return std::string();
    });
    Exchange exchange = within(60s);
    exchange.stop = source.get_token();
    VERIFY_ERROR(serialLinkTo(stranger.url())->identify(exchange), ErrorCode::Cancelled);
}

void SerialLinkTest::worksAtOnceAfterAStoppedTransfer_data()
{
    QTest::addColumn<bool>("isUpload");
    QTest::addColumn<int>("blocks");
    for (const int blocks : {1, 2, 17}) {
        QTest::addRow("upload, block %d", blocks) << true << blocks;
        QTest::addRow("download, block %d", blocks) << false << blocks;
    }
}

void SerialLinkTest::worksAtOnceAfterAStoppedTransfer()
{
    QFETCH(bool, isUpload);
    QFETCH(int, blocks);
    SerialDrive served;
    const Bytes before = fullTable(0.002F);
    VERIFY_RESULT(served.drive.upload(small1, before));
    const auto link = serialLinkTo(served.server->url());
    const auto stopTransfer = [&] {
        std::stop_source source;
        Exchange exchange;
        exchange.stop = source.get_token();
        int seen = 0;
        exchange.progress = [&](auto, auto) {
            if (++seen == blocks)
                source.request_stop();
        };
        if (isUpload)
            VERIFY_ERROR(link->upload(small1, fullTable(), exchange), ErrorCode::Cancelled);
        else
            VERIFY_ERROR(link->download(small1, exchange), ErrorCode::Cancelled);
    };
    stopTransfer();
    QVERIFY(served.file(small1) == before);
    // Less than it takes to find out that a line has to be synchronised. A machine that stands
    // still for a moment gets a second try; a line that was out of step would be so again.
    if (!link->listFiles(within(450ms))) {
        VERIFY_RESULT(link->identify({}));
        stopTransfer();
        VERIFY_RESULT(link->listFiles(within(450ms)));
    }
    VERIFY_RESULT(link->upload(small1, fullTable(), {}));
    QVERIFY(served.file(small1) == fullTable());
}

void SerialLinkTest::endsATransferAtItsDeadline()
{
    SerialServerOptions options;
    options.baud = 9600;
    SerialDrive served(options);
    const auto link = serialLinkTo("serial:" + served.server->device() + "?baud=3000000");
    VERIFY_ERROR(link->upload(small1, fullTable(), within(1500ms)), ErrorCode::Timeout);
    QVERIFY(served.file(small1).empty());
    VERIFY_RESULT(link->identify({}));
}

void SerialLinkTest::aSlowLinesOwnTimeDoesNotCount()
{
    SerialServerOptions options;
    options.baud = 57'600;
    SerialDrive served(options);
    const auto link = serialLinkTo(served.server->url());
    const Bytes file = serialTableFile(4000);
    VERIFY_RESULT(link->upload(small1, file, within(1500ms))); // takes three seconds
    QVERIFY(served.file(small1) == file);
}

void SerialLinkTest::talkThatNobodyAskedForDoesNotMoveTheDeadline_data()
{
    QTest::addColumn<int>("kind");
    QTest::newRow("the line garbled the request, again and again") << 0;
    QTest::newRow("lines of somebody else") << 1;
    QTest::newRow("bytes without an end of line") << 2;
}

void SerialLinkTest::talkThatNobodyAskedForDoesNotMoveTheDeadline()
{
    QFETCH(int, kind);
    // At 1200 baud the line needs half an hour for these bytes; the deadline is a second.
    const SerialStranger stranger([kind](const std::string& came) -> std::string {
        const SerialLine request = requestIn(came);
        const auto reply = [&request](std::string_view words) {
            return serialLine(request.number, words, true) + "\r\n";
        };
        if (!request.words.empty() && request.words.front() == "identify")
            return reply("ok " + serialIdentity({"Serial-1", 1559, 2}, "generic"));
        std::string talk;
        while (talk.size() < 200'000) {
            if (kind == 0)
                return reply("error BadCrc \"garbled\"");
            talk += kind == 1 ? serialLine(7, "ok 5 6 7", true) + "\r\n" : std::string(1000, 'x');
        }
        return talk;
    });
    const auto link = serialLinkTo(stranger.url() + "?baud=1200");
    const auto result = link->readRegisters(
        std::vector<std::string>{"Axes[0]/Signals/PositionController/MasterPosition"}, within(1s));
    QVERIFY(!result);
    QVERIFY2(result.error().code == ErrorCode::Timeout
            || result.error().code == ErrorCode::ConnectionLost,
        describe(result.error()).c_str());
}

void SerialLinkTest::aReplyWithoutItsCrcIsNoReply()
{
    const SerialStranger stranger([](const std::string& came) -> std::string {
        const SerialLine request = requestIn(came);
        if (request.words.empty())
            return {};
        const bool isIdentify = request.words.front() == "identify";
        const std::string words = isIdentify
            ? "ok " + serialIdentity({"Serial-1", 1559, 2}, "generic")
            : std::string("ok 1\r\n") + "Double 5";
        return serialLine(request.number, words, isIdentify) + "\r\n";
    });
    const auto link = serialLinkTo(stranger.url());
    VERIFY_RESULT(link->identify(within(5s)));
    const auto read = link->readRegisters(
        std::vector<std::string>{"Axes[0]/Signals/PositionController/MasterPosition"}, within(1s));
    VERIFY_ERROR(read, ErrorCode::Timeout);
}

void SerialLinkTest::aLineInAnotherPlaceIsNotTakenForThatOne_data()
{
    QTest::addColumn<QList<int>>("order"); // of "ok 2" and the two lines behind it
    QTest::addColumn<int>("asked"); // what did not come intact is asked for again
    QTest::newRow("as it was sent") << QList<int>{0, 1, 2} << 1;
    QTest::newRow("the first line came twice") << QList<int>{0, 0, 1, 2} << 1;
    QTest::newRow("a line came twice") << QList<int>{0, 1, 1, 2} << 2;
    QTest::newRow("a line is missing") << QList<int>{0, 2, 2} << 2;
    QTest::newRow("the lines changed places") << QList<int>{0, 2, 1} << 2;
}

void SerialLinkTest::aLineInAnotherPlaceIsNotTakenForThatOne()
{
    QFETCH(QList<int>, order);
    QFETCH(int, asked);
    std::atomic<int> gets = 0;
    const SerialStranger stranger([&](const std::string& came) -> std::string {
        const SerialLine request = requestIn(came);
        if (request.words.empty())
            return {};
        const auto reply = [&](const std::vector<std::string>& lines) {
            return serialReply(request.number, lines, true);
        };
        if (request.words.front() == "identify")
            return reply({"ok " + serialIdentity({"Serial-1", 1559, 2}, "generic")});
        if (request.words.front() == "address")
            return reply({"ok 2", "1", "2"});
        const std::string whole = reply({"ok 2", "Double 1", "Double 2"});
        if (++gets > 1)
            return whole;
        const QByteArrayList lines = QByteArray::fromStdString(whole).split('\n');
        std::string changed;
        for (const int n : order)
            changed += lines[n].toStdString() + '\n';
        return changed;
    });
    const std::vector<std::string> paths{masterX, variable0};
    const auto read = serialLinkTo(stranger.url())->readRegisters(paths, within(20s));
    VERIFY_RESULT(read);
    QCOMPARE(read->at(0).value, RegisterValue(1.0));
    QCOMPARE(read->at(1).value, RegisterValue(2.0));
    QCOMPARE(gets.load(), asked);
}

void SerialLinkTest::leavesTheTransferOfAProgramThatVanished()
{
    SerialDrive served;
    {
        const FileDescriptor client(
            ::open(served.server->device().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC));
        const std::string begun = "put " + small1 + " 304 1c291ca3\r";
        QCOMPARE(
            ::write(client.get(), begun.data(), begun.size()), static_cast<ssize_t>(begun.size()));
        std::array<char, 64> buffer{};
        QVERIFY(::read(client.get(), buffer.data(), buffer.size()) > 0);
        const std::string half = std::string("\x01\x00\xFF", 3) + "small1.TAMtbl";
        QCOMPARE(
            ::write(client.get(), half.data(), half.size()), static_cast<ssize_t>(half.size()));
    }
    const auto link = serialLinkTo(served.server->url());
    VERIFY_RESULT(link->identify({}));
    VERIFY_RESULT(link->upload(small1, fullTable(), {}));
    QVERIFY(served.file(small1) == fullTable());
}

void SerialLinkTest::takesNoReplyMeantForAnotherProgram()
{
    SerialDrive served;
    const auto exchange = [&](const std::string& text) {
        const FileDescriptor client(
            ::open(served.server->device().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC));
        [[maybe_unused]] const ssize_t size = ::write(client.get(), text.data(), text.size());
        std::string reply;
        while (!reply.ends_with('\n')) {
            std::array<char, 256> buffer{};
            const ssize_t count = ::read(client.get(), buffer.data(), buffer.size());
            reply.append(buffer.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
        }
        return reply;
    };
    QCOMPARE(exchange("#3 set " + variable0 + " 1\n"), std::string("#3 ok\r\n"));
    VERIFY_RESULT(served.drive.writeRegisters({{variable0, 2.0F}}));
    QCOMPARE(exchange("#3 set " + variable0 + " 1\n"), std::string("#3 ok\r\n")); // from memory
    QCOMPARE(served.drive.readRegisters({variable0})->front().value, RegisterValue(2.0F));
    QVERIFY(exchange("#9 identify\n").starts_with("#9 ok \"Serial-1\" 1559 2 generic"));
    QCOMPARE(exchange("#3 set " + variable0 + " 1\n"), std::string("#3 ok\r\n")); // a new program
    QCOMPARE(served.drive.readRegisters({variable0})->front().value, RegisterValue(1.0F));
}

void SerialLinkTest::writesNothingToAnotherDrive()
{
    const QTemporaryDir folder;
    SerialServerOptions options;
    options.link = folder.filePath(QStringLiteral("drive")).toStdString();
    const std::vector<std::string> paths{variable0, stateOfX};
    auto first = std::make_unique<SerialDrive>(options);
    const auto link = serialLinkTo(first->server->url());
    const auto before = link->readRegisters(paths, {});
    VERIFY_RESULT(before);
    QCOMPARE(before->at(0).address, first->drive.readRegisters(paths)->at(0).address);
    first.reset();
    VirtualDriveOptions other = SerialDrive::options();
    other.axes.resize(1);
    other.serialNumber = 1560;
    VirtualDrive drive(genericProfile(), other);
    FaultPlan faults;
    const auto server = SerialServer::start(drive, faults, options).value();
    const std::vector<RegisterWrite> writes{{variable0, 1.0F}};
    const auto refused = link->writeRegisters(writes, {});
    VERIFY_ERROR(refused, ErrorCode::OtherDrive);
    QCOMPARE(refused.error().context.english("found"), std::string("1560"));
    QCOMPARE(drive.readRegisters({variable0})->front().value, RegisterValue(0.0F));
    VERIFY_RESULT(link->identify({})); // whoever asks who it is knows
    VERIFY_RESULT(link->writeRegisters(writes, {}));
    const auto after = link->readRegisters(paths, {});
    VERIFY_RESULT(after);
    for (std::size_t i = 0; i < paths.size(); ++i)
        QCOMPARE(after->at(i).address, drive.readRegisters(paths)->at(i).address);
}

void SerialLinkTest::worksOnAnyThread()
{
    const SerialDrive served;
    Result<DriveIdentity> identity = fail(ErrorCode::Cancelled);
    std::thread plain([&] { // no QThread, no event loop
        const auto link = serialLinkTo(served.server->url());
        identity = link->identify({});
    });
    plain.join();
    VERIFY_RESULT(identity);
    QCOMPARE(identity->axes, 2);
}

void SerialLinkTest::theDriveOutlivesSignals()
{
    // A change of the process's user, a profiler's timer: each thread gets a signal.
    const auto before = std::signal(SIGUSR1, [](int) {});
    const auto threads = [] {
        return QDir(QStringLiteral("/proc/self/task")).entryList(QDir::Dirs | QDir::NoDotAndDotDot);
    };
    const QStringList others = threads();
    const SerialDrive served;
    for (const QString& thread : threads())
        for (int i = 0; i < 20'000 && !others.contains(thread); ++i)
            ::tgkill(::getpid(), thread.toInt(), SIGUSR1);
    VERIFY_RESULT(serialLinkTo(served.server->url())->identify({}));
    std::signal(SIGUSR1, before);
}

void SerialLinkTest::makesLinksFromEndpoints()
{
    const SerialDrive served;
    const std::string url = "serial:" + served.server->device() + "?baud=921600";
    const auto link = makeLink(parseEndpoint(url).value(), genericProfile());
    VERIFY_RESULT(link);
    QCOMPARE((*link)->endpoint(), url);
    VERIFY_RESULT((*link)->identify({}));
}

AXISCOMP_TEST(SerialLinkTest)

} // namespace tst_seriallink

#include "tst_seriallink.moc"
