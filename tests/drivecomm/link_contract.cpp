// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/drivecomm/link_contract.h"
#include "tests/drivecomm/known_paths.h"

#include "core/table/tam_table.h"
#include "drivecomm/profile/profile_loader.h"
#include "tests/support/verify.h"

#include <algorithm>
#include <limits>
#include <map>

namespace axiscomp::test {

using namespace drivecomm;
using namespace std::chrono_literals;
using Progress = std::vector<std::pair<std::uint64_t, std::uint64_t>>;

namespace {

std::string variable(int n)
{
    return "Application/Variables/Floats[" + std::to_string(n) + "]";
}

Bytes tableFile(std::uint32_t points, bool persistent = false, float scale = 0.001F)
{
    CompensationTable table;
    table.name = "contract";
    table.grid.axes.push_back({{}, {}, 0.0, 1.0, points});
    for (std::uint32_t i = 0; i < points; ++i)
        table.values.push_back(scale * static_cast<float>(i % 17));
    return encodeTamTable(table, persistent, genericProfile().layout).value_or(Bytes{});
}

Result<void> useAndActivate(VirtualDrive& drive)
{
    if (auto uploaded = drive.upload(small1, tableFile(200)); !uploaded)
        return uploaded;
    const auto source = drive.readRegisters({masterX});
    if (!source)
        return fail(source.error());
    if (auto chosen =
            drive.writeRegisters({{tableOfX, "Small1"}, {source1OfX, source->front().address}});
        !chosen)
        return chosen;
    return drive.writeRegisters({{activationOfX, "AddToEncoders"}});
}

RegisterValue valueOf(VirtualDrive& drive, const std::string& path)
{
    const auto readings = drive.readRegisters({path});
    return readings ? readings->front().value : RegisterValue{"no such register"};
}

} // namespace

struct LinkContract::Scene {
    Scene(const AttachmentKind& kind, int axes)
        : drive(genericProfile(), options(axes))
        , attachment(kind.attach(drive, faults))
    {
        (void)attachment->link(); // so that it counts none of a test's faults
    }

    static VirtualDriveOptions options(int axes)
    {
        VirtualDriveOptions options;
        options.name = "Contract-1";
        options.serialNumber = -4711;
        for (int n = 0; n < axes; ++n)
            options.axes.push_back({.name = "A" + std::to_string(n)});
        return options;
    }

    FaultPlan faults;
    VirtualDrive drive;
    std::unique_ptr<LinkAttachment> attachment;
};

LinkContract::LinkContract(std::vector<AttachmentKind> kinds) : m_kinds(std::move(kinds)) { }

LinkContract::~LinkContract() = default;

DriveLink& LinkContract::link()
{
    return m_scene->attachment->link();
}

VirtualDrive& LinkContract::drive()
{
    return m_scene->drive;
}

void LinkContract::initTestCase_data()
{
    QTest::addColumn<int>("attachment");
    for (std::size_t i = 0; i < m_kinds.size(); ++i)
        QTest::newRow(m_kinds[i].name) << static_cast<int>(i);
}

void LinkContract::init()
{
    failOnWarnings();
    build(2);
}

void LinkContract::cleanup()
{
    m_scene.reset();
}

const AttachmentKind& LinkContract::kind() const
{
    QFETCH_GLOBAL(int, attachment);
    return m_kinds[static_cast<std::size_t>(attachment)];
}

void LinkContract::build(int axes)
{
    m_scene.reset();
    m_scene = std::make_unique<Scene>(kind(), axes);
}

void LinkContract::identifiesTheDrive_data()
{
    QTest::addColumn<int>("axes");
    for (const int axes : {1, 2, 3, 63, 64})
        QTest::addRow("%d axes", axes) << axes;
}

void LinkContract::identifiesTheDrive()
{
    QFETCH(int, axes);
    build(axes);
    const auto identity = link().identify({});
    VERIFY_RESULT(identity);
    QCOMPARE(QString::fromStdString(identity->name), QStringLiteral("Contract-1"));
    QCOMPARE(identity->serialNumber, -4711);
    QCOMPARE(identity->axes, axes);
}

void LinkContract::readsRegistersInTheOrderAskedFor_data()
{
    QTest::addColumn<int>("count");
    for (const int count : {1, 2, 63, 64, 65, 200})
        QTest::addRow("%d registers", count) << count;
}

void LinkContract::readsRegistersInTheOrderAskedFor()
{
    QFETCH(int, count);
    std::vector<std::string> paths;
    for (int i = 0; i < count; ++i)
        paths.push_back(variable((i * 7) % 256));
    for (int n = 0; n < 256; n += 32) {
        std::vector<RegisterWrite> writes;
        for (int i = n; i < n + 32; ++i)
            writes.push_back({variable(i), static_cast<float>(i) + 0.1F});
        VERIFY_RESULT(drive().writeRegisters(writes));
    }
    const auto readings = link().readRegisters(paths, {});
    VERIFY_RESULT(readings);
    QCOMPARE(readings->size(), paths.size());
    for (int i = 0; i < count; ++i) {
        const RegisterReading& reading = (*readings)[static_cast<std::size_t>(i)];
        QCOMPARE(reading.path, paths[static_cast<std::size_t>(i)]);
        QCOMPARE(reading.type, std::string("Single"));
        QCOMPARE(reading.value, RegisterValue(static_cast<float>((i * 7) % 256) + 0.1F));
        QVERIFY(reading.address != 0);
    }
}

void LinkContract::readsNothingWhenNothingIsAskedFor()
{
    const auto readings = link().readRegisters({}, {});
    VERIFY_RESULT(readings);
    QVERIFY(readings->empty());
}

void LinkContract::takesPathsInBothSpellings()
{
    const std::vector<std::string> paths{"Axes[0].Signals.Homing.State", "/" + tableOfX + "/"};
    const auto readings = link().readRegisters(paths, {});
    VERIFY_RESULT(readings);
    QCOMPARE(readings->at(0).path, std::string("Axes[0]/Signals/Homing/State"));
    QCOMPARE(readings->at(0).value, RegisterValue("HomingDone"));
    QCOMPARE(readings->at(1).path, tableOfX);
}

void LinkContract::namesTheRegisterThatIsUnknown()
{
    const std::vector<std::string> paths{tableOfX, "Axes[0]/Nix", "Axes[9]/Nix"};
    const auto readings = link().readRegisters(paths, {});
    VERIFY_ERROR(readings, ErrorCode::UnknownRegister);
    QCOMPARE(readings.error().context.english("path"), std::string("Axes[0]/Nix"));
    const std::vector<std::string> misspelt{"Axes[0]/Signals/Homing/Stat"};
    const auto other = link().readRegisters(misspelt, {});
    VERIFY_ERROR(other, ErrorCode::UnknownRegister);
    QVERIFY(other.error().context.english("nearest").starts_with("Axes[0]/Signals/Homing/State"));
}

void LinkContract::readsATreeByItsPrefix_data()
{
    QTest::addColumn<QString>("prefix");
    QTest::newRow("a folder") << "Axes[1]/Signals";
    QTest::newRow("not what merely begins alike") << "Axes[1]";
    QTest::newRow("one register") << QString::fromStdString(masterX);
    QTest::newRow("everything") << "";
    QTest::newRow("nothing") << "Axes[0]/Sig";
}

void LinkContract::readsATreeByItsPrefix()
{
    QFETCH(QString, prefix);
    build(12);
    const auto readings = link().readTree(prefix.toStdString(), {});
    VERIFY_RESULT(readings);
    const auto expected = drive().readTree(prefix.toStdString());
    const auto samePlace = [](const RegisterReading& a, const RegisterReading& b) {
        return a.path == b.path && a.address == b.address && a.type == b.type
            && a.value.index() == b.value.index();
    };
    QVERIFY(std::ranges::equal(*readings, expected, samePlace));
    QCOMPARE(readings->empty(), prefix.endsWith(QStringLiteral("/Sig")));
}

void LinkContract::keepsEveryValueExactly_data()
{
    QTest::addColumn<float>("value");
    using Limits = std::numeric_limits<float>;
    const std::map<const char*, float> values{{"0.1", 0.1F}, {"a third", 1.0F / 3.0F},
        {"zero", 0.0F}, {"minus zero", -0.0F}, {"largest", Limits::max()},
        {"lowest", Limits::lowest()}, {"smallest", Limits::denorm_min()},
        {"smallest normal", Limits::min()}, {"whole", 16777216.0F}};
    for (const auto& [name, value] : values)
        QTest::newRow(name) << value;
}

void LinkContract::keepsEveryValueExactly()
{
    QFETCH(float, value);
    const std::vector<RegisterWrite> writes{{variable(5), value}};
    VERIFY_RESULT(link().writeRegisters(writes, {}));
    const float stored = std::get<float>(valueOf(drive(), variable(5)));
    const std::vector<std::string> paths{variable(5)};
    const auto readings = link().readRegisters(paths, {});
    VERIFY_RESULT(readings);
    const float readBack = std::get<float>(readings->front().value);
    QCOMPARE(std::bit_cast<std::uint32_t>(stored), std::bit_cast<std::uint32_t>(value));
    QCOMPARE(std::bit_cast<std::uint32_t>(readBack), std::bit_cast<std::uint32_t>(value));
}

void LinkContract::writesSeveralRegistersAtOnce()
{
    std::vector<RegisterWrite> writes;
    for (int n = 0; n < static_cast<int>(kind().writesAtOnce); ++n)
        writes.push_back({variable(n), static_cast<float>(n) * 0.3F});
    writes[0] = {tableOfX, "Small3"};
    writes[1] = {source1OfX, std::uint32_t{1234}};
    writes[2] = {"Application/Tables/Small1/Header/Persistent", false};
    VERIFY_RESULT(link().writeRegisters(writes, {}));
    for (const RegisterWrite& write : writes)
        QCOMPARE(valueOf(drive(), write.path), write.value);
}

void LinkContract::writesAllOrNone_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("value");
    QTest::addColumn<int>("copies");
    QTest::addColumn<ErrorCode>("code");
    const QString good = QString::fromStdString(variable(9));
    QTest::newRow("unknown register") << "Axes[0]/Nix"
                                      << "1" << 1 << ErrorCode::UnknownRegister;
    QTest::newRow("read-only") << QString::fromStdString(masterX) << "" << 1
                               << ErrorCode::DriveRejected;
    QTest::newRow("no such enum value")
        << QString::fromStdString(tableOfX) << "Small99" << 1 << ErrorCode::DriveRejected;
    QTest::newRow("text for a number") << good << "twelve" << 1 << ErrorCode::DriveRejected;
    QTest::newRow("too many") << good << "" << 32 << ErrorCode::DriveRejected;
}

void LinkContract::writesAllOrNone()
{
    QFETCH(QString, path);
    QFETCH(QString, value);
    QFETCH(int, copies);
    QFETCH(ErrorCode, code);
    std::vector<RegisterWrite> writes{{variable(0), 42.0F}};
    for (int i = 0; i < copies; ++i) {
        const std::string target = copies == 1 ? path.toStdString() : variable(i + 1);
        writes.push_back({target, value.isEmpty() ? RegisterValue(1.0F) : value.toStdString()});
    }
    const auto result = link().writeRegisters(writes, {});
    VERIFY_ERROR(result, code);
    QVERIFY(!sentence(result.error()).empty());
    QCOMPARE(valueOf(drive(), variable(0)), RegisterValue(0.0F));
}

void LinkContract::listsEverySlot()
{
    VERIFY_RESULT(drive().upload("tables/large2.TAMtbl", tableFile(1000)));
    const auto files = link().listFiles({});
    VERIFY_RESULT(files);
    QCOMPARE(files->size(), genericProfile().tableSlots.size());
    for (const TableSlot& slot : genericProfile().tableSlots) {
        const DriveFile expected{slot.file, slot.name == "Large2" ? 4128U : 0U, slot.maximumSize};
        QCOMPARE(std::ranges::count(*files, expected), 1);
    }
}

void LinkContract::bringsATableToEverySlotAndBack()
{
    for (const TableSlot& slot : genericProfile().tableSlots) {
        const Bytes file = tableFile((slot.maximumSize - 128) / 4, false, 0.01F);
        QCOMPARE(file.size(), std::size_t{slot.maximumSize});
        VERIFY_RESULT(link().upload(slot.file, file, {}));
        const auto readBack = link().download(slot.file, {});
        VERIFY_RESULT(readBack);
        QVERIFY(*readBack == file);
    }
}

void LinkContract::downloadsNothingFromAnEmptySlot()
{
    const auto bytes = link().download(small1, {});
    VERIFY_RESULT(bytes);
    QVERIFY(bytes->empty());
}

void LinkContract::refusesAFile_data()
{
    QTest::addColumn<QString>("path");
    QTest::addColumn<QByteArray>("bytes");
    QTest::addColumn<ErrorCode>("code");
    const auto raw = [](const Bytes& bytes) {
        return QByteArray(
            reinterpret_cast<const char*>(bytes.data()), static_cast<qsizetype>(bytes.size()));
    };
    const QString file = QString::fromStdString(small1);
    QByteArray broken = raw(tableFile(100));
    broken[200] = static_cast<char>(~broken[200]);
    QTest::newRow("unknown file") << "tables/huge.TAMtbl" << raw(tableFile(100))
                                  << ErrorCode::UnknownFile;
    QTest::newRow("path trick") << "../etc/passwd" << raw(tableFile(100)) << ErrorCode::UnknownFile;
    QTest::newRow("larger than the slot")
        << file << raw(tableFile(15810)) << ErrorCode::TooLargeForSlot;
    QTest::newRow("larger than any slot")
        << file << raw(tableFile(750'000)) << ErrorCode::TooLargeForSlot;
    QTest::newRow("no table") << file << QByteArray("hello") << ErrorCode::TableRefused;
    QTest::newRow("empty") << file << QByteArray() << ErrorCode::TableRefused;
    QTest::newRow("one byte flipped") << file << broken << ErrorCode::TableRefused;
}

void LinkContract::refusesAFile()
{
    QFETCH(QString, path);
    QFETCH(QByteArray, bytes);
    QFETCH(ErrorCode, code);
    const Bytes before = tableFile(50);
    VERIFY_RESULT(drive().upload(small1, before));
    const auto result = link().upload(path.toStdString(),
        asBytes({bytes.constData(), static_cast<std::size_t>(bytes.size())}), {});
    VERIFY_ERROR(result, code);
    if (code == ErrorCode::UnknownFile)
        QCOMPARE(result.error().context.english("path"), path.toStdString());
    else
        QVERIFY(!result.error().context.english("reason").empty());
    QVERIFY(drive().download(small1).value() == before);
    if (code == ErrorCode::UnknownFile)
        VERIFY_ERROR(link().download(path.toStdString(), {}), ErrorCode::UnknownFile);
}

void LinkContract::refusesWhileTheCompensationIsActive()
{
    VERIFY_RESULT(useAndActivate(drive()));
    const auto upload = link().upload(small1, tableFile(60), {});
    VERIFY_ERROR(upload, ErrorCode::NotAllowedNow);
    QVERIFY(!upload.error().context.english("reason").empty());
    const std::vector<RegisterWrite> writes{{tableOfX, "Small2"}};
    VERIFY_ERROR(link().writeRegisters(writes, {}), ErrorCode::NotAllowedNow);
    QCOMPARE(valueOf(drive(), tableOfX), RegisterValue("Small1"));
}

void LinkContract::saysHowLongFlashWearLasts()
{
    const int most = genericProfile().flashWear.operations;
    for (int i = 0; i < most; ++i)
        VERIFY_RESULT(drive().upload(small1, tableFile(50, true, static_cast<float>(i + 1))));
    const auto result = link().upload(small1, tableFile(50, true, 0.5F), {});
    VERIFY_ERROR(result, ErrorCode::FlashWear);
    const int seconds = std::stoi(result.error().context.english("seconds"));
    QVERIFY(seconds > 0 && seconds <= genericProfile().flashWear.window.count());
}

void LinkContract::reportsProgressThatOnlyGrows()
{
    const Bytes file = tableFile(400'000);
    Progress seen;
    Exchange exchange;
    exchange.progress = [&seen](auto done, auto total) { seen.emplace_back(done, total); };
    const auto check = [&] {
        QVERIFY(!seen.empty());
        QVERIFY(std::ranges::is_sorted(seen));
        QVERIFY(std::ranges::all_of(
            seen, [&](const auto& each) { return each.second == file.size(); }));
        QCOMPARE(seen.back().first, std::uint64_t{file.size()});
    };
    VERIFY_RESULT(link().upload("tables/large1.TAMtbl", file, exchange));
    check();
    seen.clear();
    VERIFY_RESULT(link().download("tables/large1.TAMtbl", exchange));
    check();
}

void LinkContract::doesNothingOnceItIsStopped()
{
    std::stop_source source;
    Exchange exchange;
    exchange.stop = source.get_token();
    source.request_stop();
    const std::vector<RegisterWrite> writes{{variable(0), 1.0F}};
    const std::vector<std::string> paths{variable(0)};
    VERIFY_ERROR(link().identify(exchange), ErrorCode::Cancelled);
    VERIFY_ERROR(link().readRegisters(paths, exchange), ErrorCode::Cancelled);
    VERIFY_ERROR(link().readTree("Axes[0]", exchange), ErrorCode::Cancelled);
    VERIFY_ERROR(link().writeRegisters(writes, exchange), ErrorCode::Cancelled);
    VERIFY_ERROR(link().listFiles(exchange), ErrorCode::Cancelled);
    VERIFY_ERROR(link().download(small1, exchange), ErrorCode::Cancelled);
    VERIFY_ERROR(link().upload(small1, tableFile(50), exchange), ErrorCode::Cancelled);
    QCOMPARE(valueOf(drive(), variable(0)), RegisterValue(0.0F));
    QVERIFY(drive().download(small1).value().empty());
}

void LinkContract::endsAtItsDeadline_data()
{
    QTest::addColumn<QString>("fault");
    QTest::newRow("no reply") << "no-reply=1";
    QTest::newRow("a late reply") << "slow=60000";
}

void LinkContract::endsAtItsDeadline()
{
    QFETCH(QString, fault);
    m_scene->faults.add(parseFault(fault.toStdString()).value());
    const std::vector<RegisterWrite> writes{{variable(0), 1.0F}};
    const auto result = link().writeRegisters(writes, within(200ms));
    VERIFY_ERROR(result, ErrorCode::Timeout);
    QVERIFY(result.error().context.contains("endpoint"));
    QVERIFY(result.error().context.contains("seconds"));
    QCOMPARE(valueOf(drive(), variable(0)), RegisterValue(1.0F));
}

void LinkContract::reportsWhatTheDriveRefuses_data()
{
    QTest::addColumn<ErrorCode>("code");
    for (const ErrorCode code : {ErrorCode::DriveRejected, ErrorCode::UnknownRegister,
             ErrorCode::UnknownFile, ErrorCode::NotAllowedNow, ErrorCode::TooLargeForSlot,
             ErrorCode::TableRefused, ErrorCode::FlashWear})
        QTest::newRow(std::string(errorName(code)).c_str()) << code;
}

void LinkContract::reportsWhatTheDriveRefuses()
{
    QFETCH(ErrorCode, code);
    const std::string name(errorName(code));
    m_scene->faults.add(parseFault("reject=" + name).value());
    const std::vector<RegisterWrite> writes{{variable(0), 1.0F}};
    const auto written = link().writeRegisters(writes, {});
    VERIFY_ERROR(written, code);
    QVERIFY(sentence(written.error()).find('?') == std::string::npos);
    VERIFY_ERROR(link().upload(small1, tableFile(50), {}), code);
    QCOMPARE(valueOf(drive(), variable(0)), RegisterValue(0.0F));
    QVERIFY(drive().download(small1).value().empty());
}

void LinkContract::reportsALostConnectionWhenTheDriveReboots()
{
    VERIFY_RESULT(drive().upload(small1, tableFile(50)));
    m_scene->faults.add(parseFault("reboot-after=1").value());
    const std::vector<RegisterWrite> writes{{variable(0), 1.0F}};
    VERIFY_ERROR(link().writeRegisters(writes, {}), ErrorCode::ConnectionLost);
    QVERIFY(drive().download(small1).value().empty());
}

void LinkContract::neverTakesAGarbledReplyForAnAnswer()
{
    VERIFY_RESULT(drive().writeRegisters({{variable(0), 12.5F}}));
    m_scene->faults.add(parseFault("garble=1").value());
    const std::vector<std::string> paths{variable(0)};
    const auto result = link().readRegisters(paths, {});
    if (kind().asksAgain) {
        VERIFY_RESULT(result);
        QCOMPARE(result->front().value, RegisterValue(12.5F));
        return;
    }
    VERIFY_ERROR(result, ErrorCode::Protocol);
    QVERIFY(result.error().context.contains("quote"));
}

void LinkContract::storesSomethingElseWhenAskedTo()
{
    m_scene->faults.add(parseFault("stores-wrong=1").value());
    m_scene->faults.add(parseFault("stores-wrong=2").value());
    const std::vector<RegisterWrite> writes{{variable(0), 1.0F}};
    VERIFY_RESULT(link().writeRegisters(writes, {}));
    QVERIFY(valueOf(drive(), variable(0)) != writes.front().value);
    const Bytes file = tableFile(50);
    VERIFY_RESULT(link().upload(small1, file, {}));
    const auto readBack = link().download(small1, {});
    VERIFY_RESULT(readBack);
    QCOMPARE(readBack->size(), file.size());
    QVERIFY(*readBack != file);
}

void LinkContract::keepsTheOldFileWhenAnUploadIsCut_data()
{
    QTest::addColumn<int>("bytes");
    for (const int bytes : {1, 50, 500, 5000, 40'000})
        QTest::addRow("after %d bytes", bytes) << bytes;
}

void LinkContract::keepsTheOldFileWhenAnUploadIsCut()
{
    QFETCH(int, bytes);
    const Bytes before = tableFile(50);
    VERIFY_RESULT(drive().upload(small1, before));
    const Bytes file = tableFile(15'000);
    m_scene->faults.add(parseFault("drop-after=" + std::to_string(bytes)).value());
    const auto cut = link().upload(small1, file, {});
    VERIFY_ERROR(cut, ErrorCode::ConnectionLost);
    QVERIFY(cut.error().context.contains("endpoint"));
    QVERIFY(drive().download(small1).value() == before);
    VERIFY_RESULT(link().upload(small1, file, {}));
    QVERIFY(drive().download(small1).value() == file);
}

void LinkContract::neverTakesPartOfAFileForTheWhole()
{
    const Bytes file = tableFile(15'000);
    VERIFY_RESULT(drive().upload(small1, file));
    for (int n = 0; n < 3; ++n) // a link may ask again
        m_scene->faults.add({FaultSpec::Kind::DropAfter, 20'000, {}});
    const auto cut = link().download(small1, {});
    if (!cut)
        QCOMPARE(cut.error().code, ErrorCode::ConnectionLost);
    else
        QVERIFY(*cut == file);
    m_scene->faults.clear();
    const auto whole = link().download(small1, {});
    VERIFY_RESULT(whole);
    QVERIFY(*whole == file);
}

void LinkContract::worksAgainAfterAFault_data()
{
    QTest::addColumn<QString>("fault");
    for (const char* fault :
        {"no-reply=1", "garble=1", "reboot-after=1", "drop-after=1", "drop-after=100"})
        QTest::newRow(fault) << fault;
}

void LinkContract::worksAgainAfterAFault()
{
    QFETCH(QString, fault);
    m_scene->faults.add(parseFault(fault.toStdString()).value());
    const std::vector<RegisterWrite> writes{
        {variable(0), 1.0F}, {variable(2), 1.0F}, {variable(3), 1.0F}, {variable(4), 1.0F}};
    const auto first = link().writeRegisters(writes, within(200ms));
    QCOMPARE(first.has_value(), kind().asksAgain && fault.startsWith(QStringLiteral("garble")));
    const std::vector<RegisterWrite> again{{variable(1), 2.0F}};
    VERIFY_RESULT(link().writeRegisters(again, {}));
    QCOMPARE(valueOf(drive(), variable(1)), RegisterValue(2.0F));
}

} // namespace axiscomp::test
