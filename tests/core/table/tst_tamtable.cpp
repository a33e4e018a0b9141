// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/field_codec.h"
#include "core/table/tam_table.h"
#include "tests/core/table/table_samples.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryFile>
#include <QTest>

#include <cmath>
#include <limits>
#include <random>

namespace tst_tamtable {

using namespace axiscomp;
using namespace axiscomp::test;

namespace {

template <typename T> T loaded(const Bytes& file, std::size_t offset, bool littleEndian = true)
{
    return loadAt<T>(ByteView(file).subspan(offset), littleEndian);
}

/// What tests/tools/decode_tamtbl.py says about a file.
QJsonObject independentlyRead(const Bytes& bytes)
{
    QTemporaryFile file;
    if (!file.open() || file.write(asText(bytes).data(), static_cast<qint64>(bytes.size())) < 0
        || !file.flush())
        return {};
    QProcess reader;
    reader.setProcessChannelMode(QProcess::ForwardedErrorChannel);
    reader.start(QStringLiteral("python3"),
        {QStringLiteral(AXISCOMP_SOURCE_FOLDER "/tests/tools/decode_tamtbl.py"), file.fileName()});
    reader.waitForFinished();
    return QJsonDocument::fromJson(reader.readAllStandardOutput()).object();
}

} // namespace

class TestTamTable : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { axiscomp::test::failOnWarnings(); }

    void theFileIsTheDocumentedOneByteByByte()
    {
        const CompensationTable table = tamSample(2);
        const Bytes file = encoded(table, genericTableLayout(), true);
        QCOMPARE(file.size(), std::size_t{128 + 4 * 12});
        QCOMPARE(asText(file).substr(0, 4), "TAMT");
        QCOMPARE(loaded<std::uint16_t>(file, 4), 1);
        QCOMPARE(loaded<std::uint16_t>(file, 6), 128);
        QCOMPARE(loaded<std::uint32_t>(file, 8), 1U);
        QCOMPARE(loaded<std::uint32_t>(file, 12), 1U);
        QCOMPARE(loaded<std::uint32_t>(file, 16), 2U);
        QCOMPARE(loaded<std::uint32_t>(file, 20), 3U);
        QCOMPARE(loaded<std::uint32_t>(file, 24), 4U);
        QCOMPARE(loaded<std::uint32_t>(file, 28), 1U);
        QCOMPARE(loaded<double>(file, 32), -10.5);
        QCOMPARE(loaded<double>(file, 40), 100.0);
        QVERIFY(loaded<std::uint64_t>(file, 48) == 0);
        QCOMPARE(loaded<double>(file, 56), 0.25);
        QCOMPARE(loaded<double>(file, 64), 2.0);
        QVERIFY(loaded<std::uint64_t>(file, 72) == 0);
        QCOMPARE(loaded<std::uint32_t>(file, 80), 12U);
        QCOMPARE(loaded<std::uint32_t>(file, 84), crc32(ByteView(file).subspan(128)));
        QCOMPARE(asText(file).substr(88, 32), std::string("X axis") + std::string(26, '\0'));
        QCOMPARE(loaded<std::uint32_t>(file, 120), 0U);
        Bytes header(file.begin(), file.begin() + 124);
        header[12] = std::byte{0};
        QCOMPARE(loaded<std::uint32_t>(file, 124), crc32(header));
        for (std::size_t i = 0; i < table.values.size(); ++i)
            QCOMPARE(loaded<float>(file, 128 + 4 * i), table.values[i]);
    }

    /// AN140: "One 2D demo table is 304 bytes long", which the generic layout makes with 44 values.
    void theDemoTableHasTheKnownLength()
    {
        CompensationTable table;
        table.grid.axes = {{{}, {}, 0.0, 1.0, 11}, {{}, {}, 0.0, 1.0, 4}};
        table.values.assign(44, 0.0F);
        QCOMPARE(encoded(table).size(), std::size_t{304});
        QCOMPARE(tamTableSize(table.grid, genericTableLayout()), std::size_t{304});
    }

    void whatIsWrittenIsReadBack_data()
    {
        QTest::addColumn<int>("dimensions");
        QTest::addColumn<bool>("littleEndian");
        QTest::addColumn<bool>("dimension1Fastest");
        QTest::addColumn<bool>("tellsDimensions");
        for (int dimensions = 1; dimensions <= 3; ++dimensions) {
            for (const bool little : {true, false}) {
                for (const bool fastest : {true, false}) {
                    for (const bool tells : {true, false})
                        QTest::addRow("%dD %s %s %s", dimensions, little ? "little" : "big",
                            fastest ? "first" : "last", tells ? "told" : "counted")
                            << dimensions << little << fastest << tells;
                }
            }
        }
    }
    void whatIsWrittenIsReadBack()
    {
        QFETCH(int, dimensions);
        QFETCH(bool, littleEndian);
        QFETCH(bool, dimension1Fastest);
        QFETCH(bool, tellsDimensions);
        TableLayout layout = genericTableLayout();
        layout.littleEndian = littleEndian;
        layout.dimension1Fastest = dimension1Fastest;
        if (!tellsDimensions)
            layout.place(TableField::Dimensions).reset();
        const CompensationTable table = tamSample(dimensions);
        for (const bool persistent : {false, true}) {
            const auto file = encodeTamTable(table, persistent, layout);
            VERIFY_RESULT(file);
            QCOMPARE(file->size(), tamTableSize(table.grid, layout));
            const auto decoded = decodeTamTable(*file, layout);
            VERIFY_RESULT(decoded);
            QVERIFY(decoded->table == table);
            QCOMPARE(decoded->persistent, persistent);
        }
    }

    void randomTablesComeBackBitByBit()
    {
        std::mt19937 generator(3);
        std::uniform_int_distribution<std::uint32_t> size(2, 9);
        std::uniform_real_distribution<double> number(-1e6, 1e6);
        for (int round = 0; round < 200; ++round) {
            CompensationTable table;
            for (int i = 0; i <= round % 3; ++i)
                table.grid.axes.push_back({{}, {}, number(generator),
                    std::exp(number(generator) * 1e-5), size(generator)});
            for (std::size_t i = 0; i < table.grid.pointCount(); ++i)
                table.values.push_back(static_cast<float>(number(generator)));
            const auto decoded = decodeTamTable(encoded(table), genericTableLayout());
            VERIFY_RESULT(decoded);
            QVERIFY(decoded->table == table);
        }
    }

    void theOrderOfTheElementsIsTheLayouts()
    {
        CompensationTable table;
        table.grid.axes = {{{}, {}, 0.0, 1.0, 2}, {{}, {}, 0.0, 1.0, 3}};
        table.values = {11.0F, 21.0F, 12.0F, 22.0F, 13.0F, 23.0F}; // value = 10 * i1 + i2
        TableLayout layout = genericTableLayout();
        const Bytes first = encoded(table, layout);
        QCOMPARE(loaded<float>(first, 132), 21.0F);
        QCOMPARE(loaded<float>(first, 136), 12.0F);
        layout.dimension1Fastest = false;
        const Bytes last = encoded(table, layout);
        QCOMPARE(loaded<float>(last, 132), 12.0F);
        QCOMPARE(loaded<float>(last, 136), 13.0F);
        QCOMPARE(loaded<float>(last, 140), 21.0F);
    }

    void theOrderOfTheBytesIsTheLayouts()
    {
        TableLayout layout = genericTableLayout();
        layout.littleEndian = false;
        const Bytes file = encoded(tamSample(1), layout);
        QVERIFY(file[4] == std::byte{0} && file[5] == std::byte{1});
        QCOMPARE(loaded<std::uint32_t>(file, 20, false), 3U);
        QCOMPARE(loaded<float>(file, 128, false), -3.0F);
        QVERIFY(!decodeTamTable(file, genericTableLayout()).has_value());
    }

    void aLayoutWithTheMandatoryFieldsAloneIsEnough()
    {
        const TableLayout layout = smallLayout();
        CompensationTable table = tamSample(2);
        table.name.clear();
        const auto file = encodeTamTable(table, true, layout);
        VERIFY_RESULT(file);
        QCOMPARE(file->size(), std::size_t{30 + 48});
        const auto decoded = decodeTamTable(*file, layout);
        VERIFY_RESULT(decoded);
        QVERIFY(decoded->table == table);
        QVERIFY(!decoded->persistent);
        QVERIFY(sameTable(*file, *file, layout));
    }

    void theNameIsCutAtACharacter_data()
    {
        QTest::addColumn<std::string>("name");
        QTest::addColumn<std::string>("expected");
        const std::string letters(31, 'a');
        QTest::newRow("empty") << std::string() << std::string();
        QTest::newRow("fits") << letters + "b" << letters + "b";
        QTest::newRow("too long") << letters + "bc" << letters + "b";
        QTest::newRow("two bytes do not fit") << letters + "\xC3\xA4" << letters;
        QTest::newRow("two bytes fit")
            << letters.substr(1) + "\xC3\xA4" << letters.substr(1) + "\xC3\xA4";
        QTest::newRow("four bytes do not fit")
            << letters.substr(2) + "\xF0\x9F\x98\x80" << letters.substr(2);
        QTest::newRow("not UTF-8") << std::string("a\xFFz") << std::string("a\xEF\xBF\xBDz");
        QTest::newRow("not UTF-8, longer when repaired") << std::string(
            20, '\xFF') << QString(10, QChar(QChar::ReplacementCharacter)).toStdString();
        QTest::newRow("control character") << std::string("a\nb") << std::string("a b");
        QTest::newRow("zero byte") << std::string("a\0b", 3) << std::string("a");
    }
    void theNameIsCutAtACharacter()
    {
        QFETCH(std::string, name);
        QFETCH(std::string, expected);
        CompensationTable table = tamSample(1);
        table.name = name;
        const auto decoded = decodeTamTable(encoded(table), genericTableLayout());
        VERIFY_RESULT(decoded);
        QCOMPARE(decoded->table.name, expected);
    }

    void persistentChangesInPlaceAndTheFileStaysValid()
    {
        Bytes file = encoded(tamSample(3));
        const Bytes before = file;
        setPersistent(file, true, genericTableLayout());
        QVERIFY(file != before);
        QVERIFY(sameTable(file, before, genericTableLayout()));
        const auto decoded = decodeTamTable(file, genericTableLayout());
        VERIFY_RESULT(decoded);
        QVERIFY(decoded->persistent);
        setPersistent(file, false, genericTableLayout());
        QVERIFY(file == before);
    }

    void persistentOfAShortFileIsLeftAlone()
    {
        Bytes file(15);
        setPersistent(file, true, genericTableLayout());
        QVERIFY(file == Bytes(15));
        QVERIFY(sameTable(file, Bytes(15), genericTableLayout()));
    }

    void anyOtherByteMakesAnotherTable()
    {
        const Bytes file = encoded(tamSample(1));
        for (std::size_t i = 0; i < file.size(); ++i) {
            Bytes other = file;
            other[i] ^= std::byte{1};
            QCOMPARE(sameTable(file, other, genericTableLayout()), i >= 12 && i < 16);
        }
        QVERIFY(!sameTable(file, ByteView(file).first(file.size() - 1), genericTableLayout()));
        QVERIFY(sameTable({}, {}, genericTableLayout()));
    }

    void anIndependentReaderFindsTheSame()
    {
        CompensationTable table = tamSample(3);
        table.name = "Tr\xC3\xA4ger";
        Bytes file = encoded(table, genericTableLayout(), true);
        const QJsonObject found = independentlyRead(file);
        QCOMPARE(found[QLatin1String("wrong")], QJsonArray());
        QCOMPARE(found[QLatin1String("name")], QString::fromUtf8("Tr\xC3\xA4ger"));
        QCOMPARE(found[QLatin1String("persistent")], true);
        const QJsonArray axes = found[QLatin1String("axes")].toArray();
        QCOMPARE(axes.size(), 3);
        for (int i = 0; i < 3; ++i) {
            const GridAxis& axis = table.grid.axes[static_cast<std::size_t>(i)];
            QCOMPARE(axes[i][QLatin1String("size")], static_cast<qint64>(axis.size));
            QCOMPARE(axes[i][QLatin1String("start")], axis.start);
            QCOMPARE(axes[i][QLatin1String("distance")], axis.distance);
        }
        QJsonArray values;
        for (const float value : table.values)
            values.append(static_cast<double>(value));
        QCOMPARE(found[QLatin1String("values")], values);

        file.back() ^= std::byte{1};
        QCOMPARE(independentlyRead(file)[QLatin1String("wrong")],
            QJsonArray{QStringLiteral("elementCrc")});
    }

    void theLargestTableOfADriveFits()
    {
        CompensationTable table;
        table.grid.axes = {{{}, {}, 0.0, 1.0, 80}, {{}, {}, 0.0, 1.0, 80}, {{}, {}, 0.0, 1.0, 81}};
        std::mt19937 generator(1);
        std::normal_distribution<float> noise;
        table.values.resize(table.grid.pointCount());
        std::ranges::generate(table.values, [&] { return noise(generator); });
        const Bytes file = encoded(table);
        QVERIFY(file.size() <= 2096976);
        const auto decoded = decodeTamTable(file, genericTableLayout());
        VERIFY_RESULT(decoded);
        QVERIFY(decoded->table == table);
    }
};

AXISCOMP_TEST(TestTamTable)

} // namespace tst_tamtable

#include "tst_tamtable.moc"
