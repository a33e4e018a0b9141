// SPDX-License-Identifier: GPL-3.0-or-later
// What a person with a terminal program can do, and the programs of lrzsz, which nobody here wrote.
#include "drivecomm/serial/serial_codec.h"
#include "drivecomm/serial/ymodem.h"
#include "tests/drivecomm/serial/serial_link_fixture.h"
#include "tests/support/test_registry.h"

#include <QDir>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>

#include <thread>

namespace tst_serialterminal {

using namespace axiscomp;
using namespace axiscomp::drivecomm;
using namespace axiscomp::test;

namespace {

constexpr int lrzszPatienceMs = 240'000; // lrzsz reads byte by byte

/// Types and reads, without numbers and CRCs.
class Terminal {
public:
    explicit Terminal(const std::string& device)
        : m_port(::open(device.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC))
    {
    }
    void type(const std::string& text) const
    {
        QCOMPARE(
            ::write(m_port.get(), text.data(), text.size()), static_cast<ssize_t>(text.size()));
    }
    /// What came until a line that begins like this, and that line.
    [[nodiscard]] QString readUntil(const std::string& start)
    {
        while (true) {
            const std::size_t place = ("\n" + m_heard).find("\n" + start);
            const std::size_t end = place == std::string::npos ? place : m_heard.find('\n', place);
            if (end != std::string::npos) {
                const std::string text = m_heard.substr(0, end + 1);
                m_heard.erase(0, end + 1);
                return QString::fromStdString(text);
            }
            pollfd polled{m_port.get(), POLLIN, 0};
            std::array<char, 4096> buffer{};
            const bool isReady = ::poll(&polled, 1, 5000) == 1;
            const ssize_t size = isReady ? ::read(m_port.get(), buffer.data(), buffer.size()) : 0;
            if (size <= 0)
                return QStringLiteral("(nothing) ") + QString::fromStdString(m_heard);
            m_heard.append(buffer.data(), static_cast<std::size_t>(size));
        }
    }
    [[nodiscard]] QString ask(const std::string& line, const std::string& start)
    {
        type(line + "\r");
        return readUntil(start);
    }

private:
    FileDescriptor m_port;
    std::string m_heard;
};

/// A program of lrzsz with the port as its standard input and output.
class Lrzsz {
public:
    Lrzsz(const QString& program, const QStringList& arguments, const std::string& device,
        const QString& folder)
    {
        m_process.setWorkingDirectory(folder);
        m_process.setStandardInputFile(QString::fromStdString(device));
        m_process.setStandardOutputFile(QString::fromStdString(device), QIODevice::Append);
        m_process.start(QStringLiteral("timeout"),
            QStringList{QString::number(lrzszPatienceMs / 1000), program, QStringLiteral("-q")}
                + arguments);
    }
    [[nodiscard]] bool succeeds()
    {
        return m_process.waitForFinished(lrzszPatienceMs) && m_process.exitCode() == 0;
    }

private:
    QProcess m_process;
};

Bytes contentOf(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return Bytes(1, std::byte{0xEE});
    const QByteArray bytes = file.readAll();
    const ByteView view = asBytes({bytes.constData(), static_cast<std::size_t>(bytes.size())});
    return {view.begin(), view.end()};
}

void store(const QString& path, const Bytes& bytes)
{
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<qint64>(bytes.size()));
}

/// Runs one side of a transfer on this side of a pseudo-terminal, no quicker than a real line is:
/// rb empties its input after each of its answers, and what came at once would be lost.
template <typename Machine> void runOn(const FileDescriptor& master, Machine& machine)
{
    using Clock = ymodem::Clock;
    while (true) {
        Bytes output = machine.output();
        if (!output.empty())
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        while (!output.empty()) {
            pollfd polled{master.get(), POLLOUT, 0};
            ::poll(&polled, 1, lrzszPatienceMs);
            const ssize_t sent = ::write(master.get(), output.data(), output.size());
            if (sent > 0)
                output.erase(output.begin(), output.begin() + sent);
        }
        if (!machine.isRunning())
            return;
        const auto left =
            std::chrono::ceil<std::chrono::milliseconds>(machine.wakeAt() - Clock::now());
        pollfd polled{master.get(), POLLIN, 0};
        std::array<std::byte, 4096> buffer{};
        ssize_t size = 0;
        if (::poll(&polled, 1, static_cast<int>(std::max<std::int64_t>(left.count(), 0))) == 1)
            size = ::read(master.get(), buffer.data(), buffer.size());
        if (size > 0)
            (void)machine.feed(
                ByteView(buffer).first(static_cast<std::size_t>(size)), Clock::now());
        else
            machine.tick(Clock::now());
    }
}

void addSizes()
{
    QTest::addColumn<int>("size");
    for (const int size : {0, 1, 127, 128, 129, 1023, 1024, 1025, 63360, 2096976})
        QTest::addRow("%d bytes", size) << size;
}

Bytes someFile(int size)
{
    std::mt19937 random(static_cast<std::uint32_t>(size));
    Bytes file(static_cast<std::size_t>(size));
    for (std::byte& byte : file)
        byte = static_cast<std::byte>(random() & 0xFFU);
    return file;
}

} // namespace

class SerialTerminalTest final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void answersAPerson();
    void explainsWhatIsWrong_data();
    void explainsWhatIsWrong();
    void carriesNumberAndCrcWhereTheRequestDoes();
    void survivesGarbage();
    void cancelsByHand();
    void keepsAFileThatIsNoLink();
    void aPersonUploadsWithSb_data();
    void aPersonUploadsWithSb();
    void aPersonDownloadsWithRb_data();
    void aPersonDownloadsWithRb();
    void theSenderSendsToRb_data() { addSizes(); }
    void theSenderSendsToRb();
    void theReceiverTakesFromSb_data() { addSizes(); }
    void theReceiverTakesFromSb();
};

void SerialTerminalTest::answersAPerson()
{
    SerialDrive served;
    Terminal terminal(served.server->device());
    QCOMPARE(terminal.ask("identify", "ok"), QStringLiteral("ok \"Serial-1\" 1559 2 generic\r\n"));
    QCOMPARE(terminal.ask("get " + variable0 + " Axes[1].Signals.Homing.State", "HomingState"),
        QStringLiteral("ok 2\r\nSingle 0\r\nHomingState HomingDone\r\n"));
    QCOMPARE(terminal.ask("set " + variable0 + " 12.5", "ok"), QStringLiteral("ok\r\n"));
    QCOMPARE(terminal.ask("get " + variable0, "Single"), QStringLiteral("ok 1\r\nSingle 12.5\r\n"));
    QVERIFY(terminal.ask("list", "tables/large2")
                .startsWith(QStringLiteral("ok 10\r\ntables/small1.TAMtbl 0 63360\r\n")));
    QVERIFY(terminal.ask("tree Axes[0]/Signals/Homing", "Axes[0]/")
                .startsWith(QStringLiteral("ok 1 1\r\nAxes[0]/Signals/Homing/State ")));
    const auto address = served.drive.readRegisters({stateOfX})->front().address;
    QCOMPARE(terminal.ask("address " + stateOfX, std::to_string(address)),
        QStringLiteral("ok 1\r\n%1\r\n").arg(address));
}

void SerialTerminalTest::explainsWhatIsWrong_data()
{
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("answer");
    QTest::newRow("no request") << "help"
                                << "error DriveRejected \"help is not a request";
    QTest::newRow("unknown register") << "get Axes[0]/Nix"
                                      << "error UnknownRegister \"";
    QTest::newRow("nothing to read") << "get"
                                     << "error DriveRejected \"name 1 to 16";
    QTest::newRow("17 registers") << QStringLiteral("get") + QStringLiteral(" a").repeated(17)
                                  << "error DriveRejected \"name 1 to 16";
    QTest::newRow("9 writes") << QStringLiteral("set") + QStringLiteral(" a 1").repeated(9)
                              << "error DriveRejected \"name 1 to 8";
    QTest::newRow("no value") << "set Application/Variables/Floats[0]"
                              << "error DriveRejected \"name 1 to 8";
    QTest::newRow("wrong value") << "set Application/Variables/Floats[0] twelve"
                                 << "error DriveRejected \"Application/Variables/Floats[0]: ";
    QTest::newRow("no such file") << "put tables/huge.TAMtbl 304 1c291ca3"
                                  << "error UnknownFile \"";
    QTest::newRow("too large") << "put tables/small1.TAMtbl 63361 1c291ca3"
                               << "error TooLargeForSlot \"";
    QTest::newRow("no CRC") << "put tables/small1.TAMtbl 304"
                            << "error DriveRejected \"write put";
    QTest::newRow("wrong CRC") << "#4 identify *0000"
                               << "#4 error BadCrc \"";
    QTest::newRow("open quotation") << "get \"Axes"
                                    << "error DriveRejected \"this is no request";
    QTest::newRow("too long") << QStringLiteral("get ") + QString(5000, QLatin1Char('a'))
                              << "error DriveRejected \"the line has more than 4096";
}

void SerialTerminalTest::explainsWhatIsWrong()
{
    QFETCH(QString, line);
    QFETCH(QString, answer);
    SerialDrive served;
    Terminal terminal(served.server->device());
    const QString said = terminal.ask(line.toStdString(), answer.toStdString());
    QVERIFY2(said.startsWith(answer), qPrintable(said));
    const bool isForPrograms = line.startsWith(u'#'); // these get the sentence as a value, too
    QVERIFY2(isForPrograms || !said.contains(QStringLiteral("text=")), qPrintable(said));
    QVERIFY(terminal.ask("identify", "ok").startsWith(QStringLiteral("ok ")));
    QCOMPARE(served.drive.readRegisters({variable0})->front().value, RegisterValue(0.0F));
}

void SerialTerminalTest::carriesNumberAndCrcWhereTheRequestDoes()
{
    SerialDrive served;
    Terminal terminal(served.server->device());
    QCOMPARE(terminal.ask("#7 get " + variable0, "#7 Single"),
        QStringLiteral("#7 ok 1\r\n#7 Single 0\r\n"));
    const QString checked = terminal.ask(serialLine(8, "get " + variable0, true), "#8 Single");
    std::uint16_t crc = crcCcittFalse;
    for (const QString& line : checked.trimmed().split(QStringLiteral("\r\n"))) {
        const SerialLine parsed = parseSerialLine(line.toStdString(), crc);
        crc = parsed.crc;
        QVERIFY(parsed.state == SerialLine::State::Good && parsed.hasCrc && parsed.number == 8);
    }
    // A line with a CRC that noise has cut in two.
    const std::string cut = "#9 set " + variable0 + " 1";
    QVERIFY(terminal.ask(cut, "#9 ").startsWith(QStringLiteral("#9 error BadCrc")));
    QCOMPARE(served.drive.readRegisters({variable0})->front().value, RegisterValue(0.0F));
}

void SerialTerminalTest::survivesGarbage()
{
    SerialDrive served;
    Terminal terminal(served.server->device());
    std::mt19937 random(11);
    for (int n = 0; n < 200; ++n) {
        std::string junk;
        for (auto size = random() % 300; size > 0; --size)
            junk += static_cast<char>(random() & 0xFFU);
        terminal.type(junk);
        if (n % 20 == 0)
            QVERIFY(terminal.ask("\x18identify", "ok ").endsWith(QStringLiteral("generic\r\n")));
    }
    QVERIFY(terminal.ask("\x18identify", "ok ").endsWith(QStringLiteral("generic\r\n")));
}

void SerialTerminalTest::cancelsByHand()
{
    SerialDrive served;
    Terminal terminal(served.server->device());
    QCOMPARE(terminal.ask("put " + small1 + " 304 1c291ca3", "ready"), QStringLiteral("ready\r\n"));
    terminal.type("\x18\x18"); // Ctrl-X twice
    const QString said = terminal.readUntil("error");
    QVERIFY2(said.contains(QStringLiteral("the sender cancelled it")), qPrintable(said));
    QVERIFY(terminal.ask("identify", "ok").startsWith(QStringLiteral("ok ")));
}

void SerialTerminalTest::keepsAFileThatIsNoLink()
{
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("drive"));
    store(path, someFile(5));
    SerialServerOptions options;
    options.link = path.toStdString();
    VirtualDrive drive(genericProfile(), {});
    FaultPlan faults;
    const auto refused = SerialServer::start(drive, faults, options);
    VERIFY_ERROR(refused, ErrorCode::InvalidEndpoint);
    QCOMPARE(refused.error().context.english("endpoint"), options.link);
    QVERIFY(contentOf(path) == someFile(5));
    QVERIFY(QFile::remove(path));
    {
        const auto server = SerialServer::start(drive, faults, options);
        VERIFY_RESULT(server);
        QCOMPARE(QFile::symLinkTarget(path).toStdString(), (*server)->device());
    }
    QVERIFY(!QFileInfo(path).isSymLink()); // it tidies up
}

void SerialTerminalTest::aPersonUploadsWithSb_data()
{
    QTest::addColumn<int>("size");
    QTest::addColumn<QString>("slot");
    QTest::addColumn<QString>("answer");
    for (const int size : {0, 1, 128, 1025})
        QTest::addRow("%d bytes, no table", size) << size << "small1"
                                                  << "#5 error TableRefused";
    QTest::newRow("63360 bytes") << 63360 << "small1"
                                 << "#5 ok";
    QTest::newRow("2096976 bytes") << 2096976 << "large1"
                                   << "#5 ok";
}

void SerialTerminalTest::aPersonUploadsWithSb()
{
    QFETCH(int, size);
    QFETCH(QString, slot);
    QFETCH(QString, answer);
    const QTemporaryDir folder;
    const Bytes file = answer == u"#5 ok"
        ? serialTableFile(static_cast<std::uint32_t>(size - 128) / 4)
        : someFile(size);
    QCOMPARE(file.size(), static_cast<std::size_t>(size));
    store(folder.filePath(QStringLiteral("my.TAMtbl")), file);
    SerialDrive served;
    Terminal terminal(served.server->device());
    const std::string path = "tables/" + slot.toStdString() + ".TAMtbl";
    const std::string put =
        "#5 put " + path + " " + std::to_string(size) + " " + serialCrc32(crc32(file));
    QCOMPARE(terminal.ask(put, "#5 ready"), QStringLiteral("#5 ready\r\n"));
    QVERIFY(Lrzsz(QStringLiteral("sb"), {QStringLiteral("-k"), QStringLiteral("my.TAMtbl")},
        served.server->device(), folder.path())
                .succeeds());
    // sb may have swallowed the answer: asked again, it comes from memory.
    const QString said = terminal.ask("\r\n" + put, answer.toStdString());
    QVERIFY2(said.contains(answer), qPrintable(said));
    if (answer == u"#5 ok")
        QVERIFY(served.file(path) == file);
}

void SerialTerminalTest::aPersonDownloadsWithRb_data()
{
    QTest::addColumn<int>("size");
    QTest::addColumn<QString>("slot");
    QTest::newRow("empty") << 0 << "small2";
    QTest::newRow("136 bytes") << 136 << "small1";
    QTest::newRow("1152 bytes") << 1152 << "small1";
    QTest::newRow("63360 bytes") << 63360 << "small1";
    QTest::newRow("2096976 bytes") << 2096976 << "large1";
}

void SerialTerminalTest::aPersonDownloadsWithRb()
{
    QFETCH(int, size);
    QFETCH(QString, slot);
    const QTemporaryDir folder;
    SerialDrive served;
    const std::string path = "tables/" + slot.toStdString() + ".TAMtbl";
    Bytes file;
    if (size > 0) {
        file = serialTableFile(static_cast<std::uint32_t>(size - 128) / 4);
        VERIFY_RESULT(served.drive.upload(path, file));
    }
    QCOMPARE(file.size(), static_cast<std::size_t>(size));
    Terminal terminal(served.server->device());
    QCOMPARE(terminal.ask("take " + path, "ready"),
        QStringLiteral("ready %1 %2\r\n")
            .arg(size)
            .arg(QString::fromStdString(serialCrc32(crc32(file)))));
    QVERIFY(
        Lrzsz(QStringLiteral("rb"), {QStringLiteral("-y")}, served.server->device(), folder.path())
            .succeeds());
    QVERIFY(contentOf(folder.filePath(slot + QStringLiteral(".TAMtbl"))) == file);
}

void SerialTerminalTest::theSenderSendsToRb()
{
    QFETCH(int, size);
    const QTemporaryDir folder;
    const Bytes file = someFile(size);
    const PseudoTerminal terminal = PseudoTerminal::open({}).value();
    Lrzsz rb(QStringLiteral("rb"), {QStringLiteral("-y")}, terminal.device(), folder.path());
    ymodem::Sender sender("my.TAMtbl", file, ymodem::Clock::now());
    runOn(terminal.master(), sender);
    QCOMPARE(sender.state(), ymodem::State::Done);
    QVERIFY(rb.succeeds());
    QVERIFY(contentOf(folder.filePath(QStringLiteral("my.TAMtbl"))) == file);
}

void SerialTerminalTest::theReceiverTakesFromSb()
{
    QFETCH(int, size);
    const QTemporaryDir folder;
    const Bytes file = someFile(size);
    store(folder.filePath(QStringLiteral("my.TAMtbl")), file);
    const PseudoTerminal terminal = PseudoTerminal::open({}).value();
    for (const QStringList& options : {QStringList{QStringLiteral("-k")}, QStringList{}}) {
        if (options.isEmpty() && size > 100'000)
            continue; // short blocks once, where they cost little
        Lrzsz sb(QStringLiteral("sb"), options + QStringList{QStringLiteral("my.TAMtbl")},
            terminal.device(), folder.path());
        ymodem::Receiver receiver(std::uint64_t{4} << 20, std::nullopt, ymodem::Clock::now());
        runOn(terminal.master(), receiver);
        QCOMPARE(receiver.state(), ymodem::State::Done);
        QVERIFY(receiver.takeFile() == file);
        QVERIFY(sb.succeeds());
    }
}

AXISCOMP_TEST(SerialTerminalTest)

} // namespace tst_serialterminal

#include "tst_serialterminal.moc"
