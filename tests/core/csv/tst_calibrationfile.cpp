// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/csv/csv_reading.h"
#include "tests/support/test_registry.h"

#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <array>
#include <clocale>
#include <cstdlib>
#include <filesystem>
#include <random>

#include <sys/stat.h>
#include <unistd.h>

namespace tst_calibrationfile {

using namespace axiscomp;
using test::describe;
using test::parse;

namespace {

CsvReading read(const std::filesystem::path& file, int dimensions = 1, CsvOptions options = {})
{
    options.dimensions = dimensions;
    return readCalibrationCsv(file, options);
}

std::filesystem::path dataFile(const char* name)
{
    return std::filesystem::path(AXISCOMP_SOURCE_FOLDER "/tests/data/csv") / name;
}

/// A locale with a decimal comma for the time of a test, made here when the system has none.
class CommaLocale {
public:
    CommaLocale()
    {
        for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_CH.UTF-8"})
            if (isComma(name))
                return;
        const QString made = m_folder.filePath(QStringLiteral("de_DE.UTF-8"));
        QProcess::execute(QStringLiteral("localedef"),
            {QStringLiteral("--no-archive"), QStringLiteral("-i"), QStringLiteral("de_DE"),
                QStringLiteral("-f"), QStringLiteral("UTF-8"), made});
        qputenv("LOCPATH", m_folder.path().toLocal8Bit());
        isComma("de_DE.UTF-8");
        qunsetenv("LOCPATH");
    }
    CommaLocale(const CommaLocale&) = delete;
    CommaLocale& operator=(const CommaLocale&) = delete;
    ~CommaLocale() { std::setlocale(LC_ALL, "C.UTF-8"); }
    [[nodiscard]] bool isSet() const { return *std::localeconv()->decimal_point == ','; }

private:
    bool isComma(const char* name) { return std::setlocale(LC_ALL, name) != nullptr && isSet(); }
    QTemporaryDir m_folder;
};

} // namespace

class TestCalibrationFile : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void filesOfOtherProgramsAreRead_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<int>("dimensions");
        QTest::addColumn<QByteArray>("axes");
        QTest::addColumn<int>("diagnostics");
        QTest::newRow("German spreadsheet") << QByteArray("german-spreadsheet.csv") << 1
                                            << QByteArray("Position[mm]:-2.5+0.5*11 ") << 1;
        QTest::newRow("serpentine measurement")
            << QByteArray("serpentine.csv") << 2 << QByteArray("X[mm]:0+25*5 Y[mm]:10+20*4 ") << 0;
        QTest::newRow("numpy.savetxt") << QByteArray("numpy-savetxt.csv") << 2
                                       << QByteArray("x[]:-1+0.25*9 y[]:0+0.1*3 ") << 0;
        QTest::newRow("all quoted, CR") << QByteArray("quoted-cr.csv") << 3
                                        << QByteArray("X[]:0+1*2 Y[]:0+1*2 Z[]:0+1*3 ") << 0;
    }
    void filesOfOtherProgramsAreRead()
    {
        QFETCH(QByteArray, name);
        QFETCH(int, dimensions);
        QFETCH(QByteArray, axes);
        QFETCH(int, diagnostics);
        const CsvReading reading = read(dataFile(name.constData()), dimensions);
        QVERIFY2(reading.data, describe(reading).join('\n').constData());
        QByteArray found;
        for (const GridAxis& axis : reading.data->grid.axes)
            found += QByteArray::fromStdString(axis.name + '[' + axis.unit + "]:")
                + QByteArray::number(axis.start) + '+' + QByteArray::number(axis.distance) + '*'
                + QByteArray::number(axis.size) + ' ';
        QCOMPARE(found, axes);
        QCOMPARE(static_cast<int>(reading.diagnostics.size()), diagnostics);
    }

    void aFileThatCannotBeReadSaysWhy()
    {
        QTemporaryDir folder;
        const std::filesystem::path base(folder.path().toStdString());
        const auto only = [](const CsvReading& reading) { return describe(reading).join('\n'); };
        QCOMPARE(only(read(base / "none.csv")), QByteArray("0:0 IoError it does not exist|"));
        QCOMPARE(only(read(base)), QByteArray("0:0 IoError it is a folder|"));
        QCOMPARE(message(read(base / "none.csv").diagnostics.at(0)),
            "the file cannot be read: it does not exist (IoError)");
        if (::geteuid() != 0) { // root may read everything
            QFile file(folder.filePath(QStringLiteral("secret.csv")));
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.close();
            QVERIFY(file.setPermissions({}));
            QCOMPARE(only(read(base / "secret.csv")), QByteArray("0:0 IoError no permission|"));
        }
    }

    void aFileOfTwoGigabytesIsRefusedUnread()
    {
        QTemporaryDir folder;
        const std::string name = folder.filePath(QStringLiteral("huge.csv")).toStdString();
        QVERIFY(QFile(QString::fromStdString(name)).open(QIODevice::WriteOnly));
        QCOMPARE(::truncate(name.c_str(), 2147483648), 0);
        QCOMPARE(describe(read(name)),
            QByteArrayList{"0:0 TooLarge 2147483648 bytes|at most 1073741824 bytes"});
    }

    void aStoppedReadingGivesNothing_data()
    {
        QTest::addColumn<int>("calls");
        for (const int calls : {1, 2, 20})
            QTest::addRow("after %d steps", calls) << calls;
    }
    void aStoppedReadingGivesNothing()
    {
        QFETCH(int, calls);
        QByteArray text = "X,T\n";
        for (int i = 0; i < 300'000; ++i)
            text += QByteArray::number(i) + ",0.25\n";
        std::stop_source stop;
        CsvOptions options;
        options.stop = stop.get_token();
        int seen = 0;
        options.progress = [&](double) {
            if (++seen == calls)
                stop.request_stop();
        };
        const CsvReading reading = parse(text, 1, options);
        QVERIFY(reading.cancelled);
        QVERIFY(!reading.data);
        QCOMPARE(seen, calls);
    }

    void progressIsReportedInSteps()
    {
        QByteArray text = "X,A,B,C,D,E,F\n";
        for (int i = 0; i < 400'000; ++i)
            text += QByteArray::number(i)
                + ",0.00000001,0.00000002,0.00000003,0.00000004,0.00000005"
                + (i % 5 == 0 ? ",\"0.25\"\n" : ",0.25\n");
        std::vector<double> seen;
        CsvOptions options;
        options.progress = [&](double fraction) { seen.push_back(fraction); };
        const CsvReading reading = parse(text, 1, options);
        QVERIFY(reading.data && !reading.cancelled);
        QVERIFY(seen.size() > 200 && seen.size() < 400);
        QVERIFY(std::ranges::is_sorted(seen));
        QCOMPARE(seen.front(), 0.0);
        QCOMPARE(seen.back(), 1.0);
    }

    void aFileCutOffAnywhereIsReadOrRefused()
    {
        const QByteArray whole = "\xEF\xBB\xBF// n\xC3\xB6te\r\n\"X [mm]\";T\r\n-0,5;\"0,001\"\r\n"
                                 "0,0 ;1e-3\r\n+0,5;0,002\r\n";
        QVERIFY(parse(whole, 1).data);
        for (qsizetype length = 0; length < whole.size(); ++length) {
            // A copy of exactly this length, so that a step beyond its end is noticed.
            const std::vector<char> cut(whole.begin(), whole.begin() + length);
            const CsvReading reading = parseCalibrationCsv({cut.data(), cut.size()}, {});
            QCOMPARE(reading.data.has_value(), !reading.hasErrors());
        }
    }

    void anyBytesAreReadOrRefused()
    {
        std::mt19937 random(29);
        constexpr std::string_view alphabet = "0123456789.,;\"+-eE \t\r\n/XT[]n\xC3";
        for (int round = 0; round < 20'000; ++round) {
            std::vector<char> text(random() % 60);
            for (char& c : text)
                c = alphabet[random() % alphabet.size()];
            CsvOptions options;
            options.dimensions = 1 + round % 3;
            const CsvReading reading = parseCalibrationCsv({text.data(), text.size()}, options);
            QCOMPARE(reading.data.has_value(), !reading.hasErrors());
        }
    }

    void theProcessLocaleDoesNotMatter()
    {
        const QByteArray text = "X [mm],T\n-0.5,0.001\n0,-0.0025\n0.5,1.5e-3\n";
        const CsvReading due = parse(text, 1);
        QVERIFY(due.data);
        const std::string written = writeCalibrationCsv(*due.data);
        const CommaLocale locale;
        if (!locale.isSet())
            QSKIP("no locale with a decimal comma here, nor localedef's sources to make one "
                  "(Debian: locales)");
        QVERIFY(QByteArray::fromStdString(written).contains("-0.5,0.001\n"));
        const CsvReading reading = parse(text, 1);
        QVERIFY(reading.data);
        QVERIFY(reading.data->tables == due.data->tables);
        QCOMPARE(writeCalibrationCsv(*reading.data), written);
        QVERIFY(parse("X;T\n0;0,001\n0,5;0,002\n", 1).data);
        QCOMPARE(describe(parse("X,T\n0,1.5x\n0.5,0.002\n", 1)),
            (QByteArrayList{"2:2 NotANumber 1.5x|a number such as 0.5"}));
    }
};

AXISCOMP_TEST(TestCalibrationFile)

} // namespace tst_calibrationfile

#include "tst_calibrationfile.moc"
