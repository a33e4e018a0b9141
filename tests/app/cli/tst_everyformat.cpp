// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/formats.h"
#include "tests/app/program_run.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

namespace tst_everyformat {

using namespace axiscomp;
using test::ProgramRun;
using test::Sandbox;

namespace {

const QByteArray line = "1 [mm],Table 1 [mm]\n0,0\n10,0.01\n20,0.02\n";
const QByteArray plane = "1 [mm],2 [mm],3 [mm]\n0,0,0\n10,0,0.01\n0,10,0.02\n10,10,0.03\n";

/// Of formats that are only read.
QByteArray fileOf(const TableFormat& format)
{
    if (format.facts.name == "klipper")
        return "[bed_mesh default]\nversion = 1\npoints =\n  0, 0.01\n  0.02, 0.03\nx_count = 2\n"
               "y_count = 2\nmin_x = 0\nmax_x = 10\nmin_y = 0\nmax_y = 10\n";
    if (format.facts.name == "klipper-twist")
        return "[axis_twist_compensation]\nz_compensations = 0.01, 0.02\n"
               "compensation_start_x = 0\ncompensation_end_x = 20\n";
    if (format.facts.name == "reprap")
        return "RepRapFirmware height map file v2 generated at 2026-05-01 12:00, mean error 0.0\n"
               "axis0,axis1,min0,max0,min1,max1,radius,spacing0,spacing1,num0,num1\n"
               "X,Y,0,10,0,10,-1,10,10,2,2\n 0.001, 0.01\n 0.02, 0.03\n";
    return {};
}

/// What the format leaves open, of a drive with 1000 counts for a unit.
QStringList settingsOf(const TableFormat& format, bool isWritten)
{
    const char* const option = isWritten ? "--set-out" : "--set-in";
    QStringList settings;
    for (const FormatSetting& setting : format.facts.settings) {
        if (!(isWritten ? setting.forWriting : setting.forReading))
            continue;
        const bool isUnit = setting.key == "value-unit" || setting.key == "position-unit";
        const bool isAxis =
            setting.key == "axis" || setting.key == "input-axis" || setting.key == "output-axis";
        if (setting.key == "counts-per-unit")
            settings += {option, "counts-per-unit=1000"};
        else if (isAxis && format.facts.name.starts_with("siemens"))
            settings += {option, QString::fromStdString(std::string(setting.key)) + "=X1"};
        else if (setting.key == "reference-number")
            settings += {option, "reference-number=100", option, "detection-unit=0.01"};
        else if (setting.key == "interval")
            settings += {option, "interval=10"};
        else if (setting.key == "any-distance")
            settings += {option, "any-distance=yes"};
        else if (isAxis
            && (format.facts.name.starts_with("heidenhain") || format.facts.name == "weihong"))
            settings += {option, "axis=X"};
        else if (format.facts.name == "acs-1d" && isAxis)
            settings += {option, "axis=0"};
        else if (format.facts.name == "acs-2d" && setting.key.ends_with("-1"))
            settings += {option, "source-axis-1=0", option, "source-axis-2=1"};
        else if (format.facts.name == "acs-2d" && setting.key == "target-axis")
            settings += {option, "target-axis=2"};
        else if (isUnit && format.facts.name != "csv" && format.facts.name != "tamtbl")
            settings += {option, QString::fromStdString(std::string(setting.key)) + "=mm"};
    }
    return settings;
}

} // namespace

/// No command ends without an answer, whatever format it is asked for: files of it are inspected,
/// converted and looked up, and a table is converted to it, looked up as it and written from it.
class tst_EveryFormat : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void everyCommandTakesIt_data()
    {
        QTest::addColumn<int>("index");
        const auto formats = tableFormats();
        for (int i = 0; i < static_cast<int>(formats.size()); ++i)
            QTest::newRow(std::string(formats[static_cast<std::size_t>(i)]->facts.name).c_str())
                << i;
    }
    void everyCommandTakesIt();
};

void tst_EveryFormat::everyCommandTakesIt()
{
    QFETCH(int, index);
    const TableFormat& format = *tableFormats()[static_cast<std::size_t>(index)];
    const QString name = QString::fromStdString(std::string(format.facts.name));
    const bool isPlane = format.facts.fewestDimensions == 2;
    const QStringList position = isPlane ? QStringList{"5", "5"} : QStringList{"15"};
    const QStringList table{isPlane ? "plane.csv" : "line.csv", "--dims", isPlane ? "2" : "1"};
    const bool isKmotion = name == QStringLiteral("kmotion-geo"); // X, Y and Z have their places
    const bool isOfOwnAxis = !isPlane && name != QStringLiteral("klipper-twist");
    const QString target = isKmotion ? "other" : isOfOwnAxis ? "#1" : "3";
    const QString side = QString::fromStdString(std::string(signName(format.facts.sign)));
    const QStringList toSide =
        format.facts.needsSign() ? QStringList{"--to-sign", side} : QStringList{};
    const QStringList fromSide =
        format.facts.needsSign() ? QStringList{"--sign", side} : QStringList{};
    const QStringList to = QStringList{"--target", target} + settingsOf(format, true) + toSide;
    const Sandbox box;
    box.file("line.csv", line);
    box.file("plane.csv", plane);
    VERIFY_CODE(box.run({"formats", name}), 0);

    const bool isWritten = static_cast<bool>(format.write);
    const ProgramRun written =
        box.run(QStringList{"convert"} + table + QStringList{"file", "--to", name} + to);
    VERIFY_CODE(written, isWritten ? 0 : 2);
    const ProgramRun as =
        box.run(QStringList{"lookup"} + table + position + QStringList{"--as", name} + to);
    VERIFY_CODE(as, isWritten ? 0 : 2);
    if (!isWritten) {
        QVERIFY2(written.err.contains("can be read, not written"), written.err.constData());
        QVERIFY2(as.err.contains("can be read, not written"), as.err.constData());
        box.file("file", fileOf(format));
    }

    QStringList from = QStringList{"--from", name} + settingsOf(format, false);
    if (format.facts.name == "csv")
        from += {"--dims", "1"};
    const QStringList linear{"--no-wrap"};
    const QStringList first{"--table", isKmotion ? "#3" : "#1"};
    const test::VirtualDriveProcess drive(box, {"--axes", "3"});
    QStringList write{"write", "--drive", drive.url(), "--dry-run", "--axis",
        isOfOwnAxis ? "0" : "2", "--source1", test::positionSource(0), "--data", "file"};
    if (isPlane)
        write += {"--source2", test::positionSource(1)};
    const std::vector<QStringList> reading{QStringList{"inspect", "file"} + from,
        QStringList{"convert", "file", "back.csv", "--target", target} + from + fromSide + linear,
        QStringList{"lookup", "file"} + position + from + first,
        write + from + fromSide + first + linear};
    for (const QStringList& command : reading) {
        const ProgramRun run = box.run(command);
        if (!format.read) {
            VERIFY_CODE(run, 2);
            QVERIFY2(run.err.contains("can be written, not read"), run.err.constData());
            continue;
        }
        VERIFY_CODE(run, 0);
    }
}

AXISCOMP_TEST(tst_EveryFormat)

} // namespace tst_everyformat

#include "tst_everyformat.moc"
