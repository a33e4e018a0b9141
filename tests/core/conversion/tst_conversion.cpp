// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/conversion.h"
#include "core/conversion/table_export.h"
#include "core/conversion/table_import.h"
#include "core/formats/triamec/triamec_tables.h"
#include "core/neutral/controller_lookup.h"
#include "core/neutral/drive_note.h"
#include "core/neutral/sign_note.h"
#include "core/table/position_unit.h"
#include "core/table/table_layout.h"
#include "core/table/tam_table.h"
#include "tests/core/formats/format_checks.h"
#include "tests/support/test_registry.h"

#include <QFile>
#include <QTemporaryDir>

#include <algorithm>

namespace tst_conversion {

using namespace axiscomp;

namespace {

const TableLayout& layout()
{
    static const TableLayout generic = genericTableLayout();
    return generic;
}

/// A closed table over one or two axes that every format can hold, within a revolution: the first
/// value and the last are 0, and so is the one at position 0.
NeutralTable exampleTable(int dimensions, SignConvention sign)
{
    NeutralTable table;
    table.sign = sign;
    table.axes.push_back(test::evenAxis("X1", "mm", 0, 10, 5));
    if (dimensions == 2)
        table.axes.push_back(test::evenAxis("Y2", "mm", 0, 10, 4));
    CompensationColumn column;
    column.target = "X1";
    column.unit = "mm";
    for (std::size_t i = 0; i < table.pointCount(); ++i) {
        const double x = table.axes[0].knots[i % 5];
        column.values.push_back(0.004 * std::sin(x / 40.0 * 6.283185307179586));
    }
    table.columns = {column};
    return table;
}

/// Some formats have names for axes, most have numbers.
void nameAxes(NeutralTable& table, const TableFormat& format)
{
    const bool hasNames = format.facts.name.starts_with("siemens");
    table.axes[0].name = hasNames ? "X1" : "1";
    table.columns[0].target = table.axes[0].name;
    if (table.axes.size() == 2)
        table.axes[1].name = hasNames ? "Y2" : "2";
}

/// What a format must be told to write such a table.
FormatSettings writeSettings(const FormatFacts& facts)
{
    FormatSettings settings;
    for (const FormatSetting& setting : facts.settings)
        if (setting.isNeeded && setting.forWriting)
            settings[std::string(setting.key)] =
                setting.kind == FormatSetting::Kind::Text ? "X" : "100000";
        else if (setting.key == "unit")
            settings["unit"] = "mm";
    if (facts.name == "weihong" || facts.name.starts_with("heidenhain"))
        settings["axis"] = "X";
    if (facts.name == "heidenhain-com-530")
        settings["any-distance"] = "yes";
    if (facts.name == "acs-2d")
        settings = {{"source-axis-1", "0"}, {"source-axis-2", "1"}};
    if (facts.name == "fanuc")
        settings = {
            {"reference-number", "100"}, {"detection-unit", "0.00001"}, {"largest-step", "1000"}};
    return settings;
}

TableReadOptions readOptions(const FormatFacts& facts, int dimensions)
{
    TableReadOptions options;
    options.layout = &layout();
    options.dimensions = dimensions;
    for (const FormatSetting& setting : facts.settings)
        if ((setting.isNeeded || setting.key == "counts-per-unit") && setting.forReading)
            options.settings[std::string(setting.key)] = "100000";
        else if (setting.key == "unit" && setting.forReading)
            options.settings["unit"] = "mm";
    if (facts.name == "fanuc")
        options.settings = {
            {"reference-number", "100"}, {"interval", "10"}, {"detection-unit", "0.00001"}};
    if (!facts.holdsUnits && facts.name != "tamtbl") {
        options.settings["position-unit"] = "mm";
        options.settings["value-unit"] = "mm";
    }
    return options;
}

ConversionRequest requestFor(const TableFormat& from, const TableFormat& to)
{
    ConversionRequest request;
    request.from = &from;
    request.to = &to;
    request.writing.layout = &layout();
    request.writing.settings = writeSettings(to.facts);
    request.writing.fileName = "table.txt";
    // What a person has to say of formats whose sign nobody has published.
    if (from.facts.needsSign())
        request.sourceSign = from.facts.sign;
    if (to.facts.needsSign())
        request.targetSign = to.facts.sign;
    return request;
}

/// Two columns that correct its two sources, with slopes that nobody can take for rounding.
NeutralTable tableThatMovesBoth(bool ofCommands)
{
    NeutralTable table =
        exampleTable(2, ofCommands ? SignConvention::Command : SignConvention::Feedback);
    table.axes[0].name = "1";
    table.axes[1].name = "2";
    table.columns.push_back(table.columns[0]);
    for (std::size_t i = 0; i < table.pointCount(); ++i) {
        table.columns[0].values[i] = 0.1 * std::sin(static_cast<double>(3 * i));
        table.columns[1].values[i] = 0.1 * std::sin(static_cast<double>(2 * i + 1));
    }
    table.columns[0].target = "1";
    table.columns[1].target = "2";
    return table;
}

/// Two positions, in um and in mm.
NeutralTable tableOverTwoUnits()
{
    NeutralTable table = exampleTable(2, SignConvention::Feedback);
    nameAxes(table, calibration_csv::format());
    table.axes[0].unit = "um";
    table.axes[1].unit = "mm";
    return table;
}

/// A table that the format can write, in um.
NeutralTable inMicrometres(const TableFormat& format)
{
    NeutralTable table = exampleTable(format.facts.fewestDimensions, SignConvention::Feedback);
    nameAxes(table, format);
    for (SourceAxis& axis : table.axes) {
        axis.unit = "um";
        for (double& knot : axis.knots)
            knot *= 1000.0;
    }
    for (CompensationColumn& column : table.columns) {
        column.unit = "um";
        for (double& value : column.values)
            value *= 1000.0;
    }
    return table;
}

/// Those that are written, but for the calibration file, which stays as it is.
void addFormats()
{
    QTest::addColumn<int>("index");
    const auto formats = tableFormats();
    for (int i = 0; i < static_cast<int>(formats.size()); ++i) {
        const TableFormat& format = *formats[static_cast<std::size_t>(i)];
        if (format.write && &format != &calibration_csv::format())
            QTest::newRow(std::string(format.facts.name).c_str()) << i;
    }
}

bool takes(const TableFormat& format, int dimensions)
{
    return format.facts.fewestDimensions <= dimensions && dimensions <= format.facts.mostDimensions;
}

bool contains(const std::vector<Text>& lines, std::string_view part)
{
    return test::mentions(test::joined(lines), part);
}

/// A file of this content, as a person understands it.
TableImport imported(const QString& name, std::string_view content, const ImportChoices& choices)
{
    const QTemporaryDir folder;
    QFile file(folder.filePath(name));
    if (file.open(QIODevice::WriteOnly))
        file.write(content.data(), static_cast<qint64>(content.size()));
    file.close();
    TableImportRequest request;
    request.file = file.fileName().toStdString();
    request.choices = choices;
    request.layout = &layout();
    return importTables(request);
}

/// Half a millimetre up and down within 10 mm, so that it matters where it is looked up.
CompensationTable steepTable()
{
    CompensationTable table;
    table.name = "X";
    table.unit = "mm";
    table.grid.axes = {{.name = "X", .unit = "mm", .start = 0, .distance = 10, .size = 5}};
    table.values = {0.0F, 0.5F, -0.25F, 0.5F, 0.0F};
    return table;
}

std::vector<float> valuesOf(const TableImport& import)
{
    return import.data ? import.data->tables.front().values : std::vector<float>{};
}

} // namespace

class TestConversion : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void whatAPersonSaysOfAFileCounts()
    {
        ImportChoices choices;
        choices.format = &linuxcnc::format();
        choices.settings = {{"type", "1"}, {"position-unit", "mm"}};
        const QString name = QStringLiteral("x.comp");
        const std::string text = "0 0.1 0.3\n10 0.1 0.3\n";
        QVERIFY(imported(name, text, choices).refusal); // which direction?
        choices.direction = DirectionChoice::Positive;
        QCOMPARE(valuesOf(imported(name, text, choices)), (std::vector<float>{-0.1F, -0.1F}));
        choices.direction = DirectionChoice::Negative;
        QCOMPARE(valuesOf(imported(name, text, choices)), (std::vector<float>{-0.3F, -0.3F}));
        choices.sign = SignConvention::Feedback;
        QCOMPARE(valuesOf(imported(name, text, choices)), (std::vector<float>{0.3F, 0.3F}));
    }

    void whatAPersonSaysOfATargetAndATurnCounts()
    {
        ImportChoices choices;
        choices.format = &softmc::format();
        choices.settings = {{"position-unit", "mm"}, {"value-unit", "mm"}};
        const std::string plain = "1 2\n0 0.5\n10 0.25\n";
        const auto unstated = imported(QStringLiteral("x.txt"), plain, choices);
        QVERIFY(unstated.refusal && unstated.refusal->code == ErrorCode::TargetNotKnown);
        choices.target = "other";
        QCOMPARE(valuesOf(imported(QStringLiteral("x.txt"), plain, choices)),
            (std::vector<float>{-0.5F, -0.25F}));

        ImportChoices turn;
        turn.format = &icube::format();
        turn.settings = {{"position-unit", "deg"}, {"wrap-range", "360"}};
        const std::string round = "0,0\n180,0\n360,0\n";
        const auto refused = imported(QStringLiteral("c.csv"), round, turn);
        QVERIFY(refused.hasWrap && refused.refusal);
        turn.dropsWrap = true;
        QCOMPARE(valuesOf(imported(QStringLiteral("c.csv"), round, turn)), std::vector<float>(3));
    }

    /// The corrections of softMC are in the user unit of the axis that they are added to.
    void anAxisOfSoftMCHasOneUnit()
    {
        ImportChoices choices;
        choices.format = &softmc::format();
        choices.settings = {{"position-unit", "mm"}, {"value-unit", "um"}};
        const std::string file = "1 2\n0 0.5\n10 0.25\n";
        for (const char* target : {"#1", "1"}) {
            choices.target = target;
            const auto refused = imported(QStringLiteral("x.txt"), file, choices);
            QVERIFY(refused.refusal && refused.refusal->code == ErrorCode::InvalidArgument);
            QVERIFY(contains({textOf(*refused.refusal)}, "positions in mm and values in um"));
        }
        choices.target = "other";
        QVERIFY(imported(QStringLiteral("x.txt"), file, choices).data);
    }

    void aMeasurementIsNotImportedUnlessItsFormatIsNamed()
    {
        const std::string_view runs =
            "target [mm],direction,run,deviation [mm]\n0,1,1,0.001\n10,1,1,0.002\n20,1,1,0.003\n";
        ImportChoices choices;
        const TableImport refused = imported(QStringLiteral("m.csv"), runs, choices);
        QVERIFY(refused.format == nullptr);
        QVERIFY(!refused.data);
        QCOMPARE(refused.problems.size(), std::size_t(1));
        choices.format = &calibration_csv::format();
        QVERIFY(imported(QStringLiteral("m.csv"), runs, choices).data);
    }

    void whatAPersonSaysOfTheUnitsOfADrivesFileCounts()
    {
        CompensationTable table;
        table.name = "straightness";
        table.grid.axes = {{.name = {}, .unit = {}, .start = 0, .distance = 10, .size = 2}};
        table.values = {0.5F, 0.25F};
        const auto file = encodeTamTable(table, false, layout());
        VERIFY_RESULT(file);
        ImportChoices choices;
        choices.format = &tam_table::format();
        choices.settings = {{"position-unit", "mm"}, {"value-unit", "um"}};
        const auto import = imported(QStringLiteral("x.TAMtbl"), asText(*file), choices);
        QVERIFY(import.data);
        QCOMPARE(import.data->tables[0].unit, std::string("um"));
        QCOMPARE(import.data->grid.axes[0].unit, std::string("mm"));
    }

    /// What a file calls um may be read in mm, so that the statement would be about other numbers.
    void noUnitIsStatedAgainstThatOfAControllersFile()
    {
        const QString name = QStringLiteral("x.cal");
        const std::string file = ":START 1 POSUNIT=METRIC CORUNIT=METRIC/1000\n"
                                 ":START SAMPLEDIST=10\n0.5 0.25 0\n:END\n";
        ImportChoices choices;
        for (const StatedUnits& stated : {StatedUnits{"um", {}}, StatedUnits{{}, "um"}}) {
            choices.units = stated;
            const auto refused = imported(name, file, choices);
            QVERIFY(refused.refusal && !refused.data);
            QVERIFY(contains({textOf(*refused.refusal)},
                "the unit um is stated, and the numbers of the file were read in mm"));
        }
        choices.units = {"mm", "mm"};
        const auto same = imported(name, file, choices);
        choices.units = {};
        QCOMPARE(valuesOf(same), valuesOf(imported(name, file, choices)));
        QVERIFY(same.data);
    }

    void aFileIsWrittenInTheSignThatAPersonSays()
    {
        CompensationTable table;
        table.name = "Z";
        table.unit = "mm";
        table.grid.axes = {{.name = "X", .unit = "mm", .start = 0, .distance = 10, .size = 2}};
        table.values = {0.5F, 0.25F};
        ImportChoices choices;
        choices.format = &softmc::format();
        choices.target = "other";
        const auto command = exportTable(table, choices, "x.txt", layout());
        VERIFY_RESULT(command);
        QCOMPARE(command->bytes, std::string("1 2\n0 -0.5\n10 -0.25\n"));
        choices.sign = SignConvention::Feedback;
        const auto feedback = exportTable(table, choices, "x.txt", layout());
        VERIFY_RESULT(feedback);
        QCOMPARE(feedback->bytes, std::string("1 2\n0 0.5\n10 0.25\n"));
    }

    /// The set position is x where another controller is commanded to x: the drive moves the
    /// encoder to x - c(x), so that controller's value is -c(x), at the same position.
    void whatIsLookedUpAtTheSetPositionHasTheSamePositionsInAFileOfCommandValues()
    {
        ImportChoices choices;
        choices.format = &softmc::format();
        choices.target = "#1";
        choices.place.lookupAt = LookupAt::Set;
        const auto set = exportTable(steepTable(), choices, "x.txt", layout());
        VERIFY_RESULT(set);
        QCOMPARE(set->bytes, std::string("1 5\n0 0\n10 -0.5\n20 0.25\n30 -0.5\n40 0\n"));
        QVERIFY(contains(set->report, "at the set position (lookup: set)"));

        // The encoder is at 10 where it is commanded to 10.5.
        choices.place.lookupAt = LookupAt::Encoder;
        const auto encoder = exportTable(steepTable(), choices, "x.txt", layout());
        VERIFY_RESULT(encoder);
        QVERIFY(encoder->bytes != set->bytes);
        QVERIFY(!contains(encoder->report, "(lookup: set)"));
    }

    /// As of one that was fitted, and of which a zero was taken out.
    void ofATableThatWasComputedNoReferenceIsTold()
    {
        for (const TableFormat* to :
            {&softmc::format(), &calibration_csv::format(), &tam_table::format()})
            for (const LookupAt lookupAt : {LookupAt::Encoder, LookupAt::Set})
                for (const bool isComputed : {false, true}) {
                    ImportChoices choices;
                    choices.format = to;
                    choices.target = "#1";
                    choices.place.lookupAt = lookupAt;
                    const auto exported =
                        exportTable(steepTable(), choices, "x.txt", layout(), {{}, isComputed});
                    VERIFY_RESULT(exported);
                    QCOMPARE(contains(exported->report, "the reference says"), !isComputed);
                }
    }

    void anExportedTableKeepsItsNotes()
    {
        const TableFacts facts{
            {"made of x.csv", "lookup: set", "drive: Mill, serial number 4711"}, false};
        ImportChoices choices;
        choices.target = "#1";
        choices.place.lookupAt = LookupAt::Set;
        choices.format = &calibration_csv::format();
        const auto csv = exportTable(steepTable(), choices, "x.csv", layout(), facts);
        VERIFY_RESULT(csv);
        const auto read = parseCalibrationCsv(csv->bytes, CsvOptions());
        QVERIFY(read.data);
        for (const std::string& note : facts.notes)
            QCOMPARE(std::ranges::count(read.data->notes, note), 1);
        // What has no notes is said not to have them.
        choices.format = &tam_table::format();
        const auto bare = exportTable(steepTable(), choices, "x.TAMtbl", layout(), facts);
        VERIFY_RESULT(bare);
        QVERIFY(contains(bare->report, "does not say that the drive with the serial number 4711"));
        QVERIFY(contains(bare->report, "look it up at the set position"));
    }

    void aFileOfCommandValuesIsMadeForThePlaceWhereTheDriveLooksItUp()
    {
        ImportChoices choices;
        choices.format = &softmc::format();
        choices.settings = {{"position-unit", "mm"}, {"value-unit", "mm"}};
        choices.target = "#1";
        const std::string file = "1 5\n0 0\n10 -0.5\n20 0.25\n30 -0.5\n40 0\n";
        choices.place.lookupAt = LookupAt::Set;
        const auto set = imported(QStringLiteral("x.txt"), file, choices);
        QVERIFY(set.data);
        QCOMPARE(valuesOf(set), steepTable().values);
        QCOMPARE(lookupInNotes(set.data->notes).value(), std::optional(LookupAt::Set));

        // u + c(u) = x and c(u) = 0.5 x / 10 up to x = 10: at the encoder's 10 the axis is
        // commanded to between 10 and 20, where -e = 0.5 - 0.075 (x - 10).
        choices.place.lookupAt = LookupAt::Encoder;
        const auto encoder = imported(QStringLiteral("x.txt"), file, choices);
        QVERIFY(encoder.data);
        const double at10 = 0.5 / (1.0 + 0.075);
        QVERIFY2(std::abs(static_cast<double>(valuesOf(encoder)[1]) - at10) < 1e-7,
            qPrintable(QString::number(static_cast<double>(valuesOf(encoder)[1]), 'g', 9)));
        QCOMPARE(lookupInNotes(encoder.data->notes).value(), std::optional(LookupAt::Encoder));
        QVERIFY(!contains(encoder.report, "is taken to look the table up"));

        choices.place.lookupAt.reset();
        const auto assumed = imported(QStringLiteral("x.txt"), file, choices);
        QVERIFY(assumed.data);
        QCOMPARE(valuesOf(assumed), valuesOf(encoder));
        QVERIFY(contains(assumed.report, "its corrections would differ by up to 0.0375 mm"));
        QCOMPARE(lookupInNotes(assumed.data->notes).value(), std::optional(LookupAt::Encoder));

        choices.target = "other"; // the place of X does not depend on what Z does
        choices.place.lookupAt = LookupAt::Set;
        const auto cross = imported(QStringLiteral("x.txt"), file, choices);
        QVERIFY(cross.data);
        QCOMPARE(valuesOf(cross), steepTable().values);
        QCOMPARE(lookupInNotes(cross.data->notes).value(), std::optional<LookupAt>());
    }

    void forWhatOfAPlaceATableWasMadeIsKnown()
    {
        const AxisPlace own{"#1", LookupAt::Set};
        const AxisPlace other{std::string(otherAxis), LookupAt::Set};
        const AxisPlace encoder{"#1", LookupAt::Encoder};
        ImportChoices choices;
        choices.format = &softmc::format();
        choices.settings = {{"position-unit", "mm"}, {"value-unit", "mm"}};
        choices.place = own;
        const std::string file = "1 5\n0 0\n10 -0.5\n20 0.25\n30 -0.5\n40 0\n";
        const UsedPlace suggested = imported(QStringLiteral("x.txt"), file, choices).usedPlace;
        QVERIFY(suggested.differs(own, other));
        QVERIFY(suggested.differs(own, encoder));
        QVERIFY(!suggested.differs(own, own));
        choices.target = "#1";
        const UsedPlace stated = imported(QStringLiteral("x.txt"), file, choices).usedPlace;
        QVERIFY(!stated.differs(own, other));
        QVERIFY(stated.differs(own, encoder));
        choices = {};
        choices.place = own;
        const UsedPlace ofDrive =
            imported(QStringLiteral("x.csv"), "X [mm],X error [mm]\n0,0\n10,0.5\n20,0\n", choices)
                .usedPlace;
        QVERIFY(!ofDrive.differs(own, other));
        QVERIFY(!ofDrive.differs(own, encoder));
    }

    void aTableOfTheDriveIsMadeAnewForTheOtherPlace()
    {
        NeutralTable table = neutralTable({steepTable().grid, {steepTable()}, {}});
        ConversionRequest request =
            requestFor(calibration_csv::format(), calibration_csv::format());
        request.targets = {"#1"};
        request.lookupAt = LookupAt::Encoder;
        const auto unsaid = convertTables(std::span(&table, 1), request);
        VERIFY_ERROR(unsaid, ErrorCode::InvalidArgument);
        QVERIFY(contains({textOf(unsaid.error())}, "// lookup: encoder or // lookup: set"));

        table.notes = {lookupNote(LookupAt::Set), "measured on Monday"};
        const auto made = convertTables(std::span(&table, 1), request);
        VERIFY_RESULT(made);
        const NeutralTable& held = made->written.held.front();
        QVERIFY(std::abs(held.columns[0].values[1] - 0.5 / 1.075) < 1e-7);
        const std::string& file = made->written.bytes;
        QVERIFY(file.find("// lookup: encoder") != std::string::npos);
        QVERIFY(file.find("lookup: set") == std::string::npos);
        QVERIFY(file.find("measured on Monday") != std::string::npos);

        request.lookupAt = LookupAt::Set; // as it is
        const auto same = convertTables(std::span(&table, 1), request);
        VERIFY_RESULT(same);
        QCOMPARE(same->written.held.front().columns[0].values, table.columns[0].values);
        QVERIFY(contains(conversionReport(*same, request),
            "commanded to 10 mm, the controller moves the encoder to 9.5 mm, where the reference "
            "says 10 mm: the file says +0.5 mm"));
    }

    /// Then the numbers are not those that the drive adds, wherever it looks them up.
    void aCalibrationFileOfCommandValuesIsAFileOfAnotherController()
    {
        const std::string file = "X [mm],X error [mm]\n0,0\n10,-0.5\n20,0.25\n30,-0.5\n40,0\n";
        ImportChoices choices;
        choices.sign = SignConvention::Command;
        choices.place = {"#1", LookupAt::Set};
        const auto set = imported(QStringLiteral("x.csv"), file, choices);
        QVERIFY(set.data);
        QCOMPARE(valuesOf(set), steepTable().values);
        QCOMPARE(lookupInNotes(set.data->notes).value(), std::optional(LookupAt::Set));
        choices.place.lookupAt = LookupAt::Encoder;
        const auto encoder = imported(QStringLiteral("x.csv"), "// lookup: set\n" + file, choices);
        QVERIFY(encoder.data);
        QVERIFY(std::abs(static_cast<double>(valuesOf(encoder)[1]) - 0.5 / 1.075) < 1e-7);
        QCOMPARE(lookupInNotes(encoder.data->notes).value(), std::optional(LookupAt::Encoder));

        const NeutralTable table =
            neutralTable({steepTable().grid, {steepTable()}, {lookupNote(LookupAt::Set)}});
        ConversionRequest request =
            requestFor(calibration_csv::format(), calibration_csv::format());
        request.targets = {"#1"};
        request.targetSign = SignConvention::Command;
        const auto command = convertTables(std::span(&table, 1), request);
        VERIFY_RESULT(command);
        QCOMPARE(command->written.held.front().columns[0].values,
            (std::vector<double>{0.0, -0.5, 0.25, -0.5, 0.0}));
        QVERIFY(command->written.bytes.find("lookup:") == std::string::npos);
        QVERIFY(contains(conversionReport(*command, request), "the command file says -0.5 mm"));

        ConversionRequest back = requestFor(calibration_csv::format(), softmc::format());
        back.targets = {"#1"};
        back.sourceSign = SignConvention::Command;
        back.lookupAt = LookupAt::Set; // of neither of the two
        VERIFY_ERROR(convertTables(std::span(&table, 1), back), ErrorCode::InvalidArgument);
    }

    void aCalibrationFileSaysThatItHoldsCommandValues()
    {
        const NeutralTable table =
            neutralTable({steepTable().grid, {steepTable()}, {lookupNote(LookupAt::Set)}});
        ConversionRequest request =
            requestFor(calibration_csv::format(), calibration_csv::format());
        request.targets = {"#1"};
        request.targetSign = SignConvention::Command;
        const auto command = convertTables(std::span(&table, 1), request);
        VERIFY_RESULT(command);
        const std::string& file = command->written.bytes;
        QVERIFY2(file.find("// sign: command\n") != std::string::npos, file.c_str());

        // It is read so without being told, and what is made of it says it no more.
        ImportChoices choices;
        choices.place = {"#1", LookupAt::Set};
        const auto import = imported(QStringLiteral("x.csv"), file, choices);
        QVERIFY(import.data);
        QVERIFY(import.sign == SignConvention::Command);
        QCOMPARE(valuesOf(import), steepTable().values);
        for (const std::string& note : import.data->notes)
            QVERIFY2(note.find("sign:") == std::string::npos, note.c_str());

        choices.sign = SignConvention::Feedback;
        const auto refused = imported(QStringLiteral("x.csv"), file, choices);
        QVERIFY(refused.refusal);
        QVERIFY(contains({textOf(*refused.refusal)}, "the file says sign: command"));

        QVERIFY(signOfTable(std::vector<std::string>{" Sign :  COMMAND ,,"}, std::nullopt).value()
            == SignConvention::Command);
        QVERIFY(!signOfTable(std::vector<std::string>{"sign: deviation"}, std::nullopt).value());
    }

    /// Any other word was taken as feedback, so that the drive got the opposite.
    /// Looked up beyond its ends as a linear axis, it would not be closed with the other sign.
    void aTableThatASettingMakesAWholeTurnIsConvertedAsOne()
    {
        NeutralTable table;
        table.sign = SignConvention::Feedback;
        SourceAxis& axis = table.axes.emplace_back();
        axis.unit = "deg";
        CompensationColumn& column = table.columns.emplace_back();
        column.unit = "deg";
        column.target = "#1";
        const auto errorAt = [](int degrees) {
            return 0.05 * (std::sin((degrees % 360) * 0.017453292519943295 + 0.7) + std::sin(0.7));
        };
        for (int degrees = 0; degrees <= 360; degrees += 30) {
            axis.knots.push_back(degrees);
            column.values.push_back(degrees == 180 ? 0.0 : errorAt(degrees));
        }
        NeutralTable turn = table;
        turn.axes[0].wrap = 360.0;
        ConversionRequest request = requestFor(calibration_csv::format(), fanuc::format());
        request.writing.settings = {{"reference-number", "10"}, {"detection-unit", "0.0001"},
            {"largest-step", "100000"}, {"reference-position", "180"}, {"wrap-range", "360"}};
        const auto made = convertTables(std::span(&table, 1), request);
        VERIFY_RESULT(made);
        const auto ofTurn = convertTables(std::span(&turn, 1), request);
        VERIFY_RESULT(ofTurn);
        QCOMPARE(made->written.bytes, ofTurn->written.bytes);
        // In another unit, too.
        request.writing.settings["position-unit"] = "arcmin";
        request.writing.settings["wrap-range"] = "21600";
        request.writing.settings["reference-position"] = "10800";
        VERIFY_RESULT(convertTables(std::span(&table, 1), request));
        // Ends that differ are an error, which is not to be hidden.
        table.columns[0].values.back() += 0.01;
        const auto open = convertTables(std::span(&table, 1), request);
        VERIFY_ERROR(open, ErrorCode::FormatCannotHold);
    }

    void aSignThatIsNotUnderstoodIsRefused_data()
    {
        QTest::addColumn<std::vector<std::string>>("notes");
        QTest::addColumn<std::string>("said");
        const auto row = [](const char* name, std::vector<std::string> notes, std::string said) {
            QTest::newRow(name) << std::move(notes) << std::move(said);
        };
        row("more words", {"sign: command values"}, "says \"sign: command values\", where one");
        row("a full stop", {"sign: command."}, "says \"sign: command.\"");
        row("another word", {"Sign : cmd"}, "says \"Sign : cmd\"");
        row("no word", {"sign:"}, "says \"sign:\"");
        row("both", {"sign: feedback", "sign: command"}, "says \"sign: command\", where one");
        row("both, as deviation", {"sign: command", "sign: deviation"}, "\"sign: deviation\"");
        row("of measurements", {"sign: Correction"}, "turn them with --scale -1");
    }
    void aSignThatIsNotUnderstoodIsRefused()
    {
        QFETCH(const std::vector<std::string>, notes);
        QFETCH(const std::string, said);
        const auto sign = signOfTable(notes, std::nullopt);
        VERIFY_ERROR(sign, ErrorCode::InvalidArgument);
        QVERIFY2(test::mentions(sentence(sign.error()), said), sentence(sign.error()).c_str());
        std::string file;
        for (const std::string& note : notes)
            file += "// " + note + '\n';
        file += "X [mm],Error [mm]\n0,0\n10,-0.5\n";
        QVERIFY(imported(QStringLiteral("x.csv"), file, {}).refusal);
    }

    void aSignThatIsStatedAndThatOfTheFileAreTheSame()
    {
        const std::vector<std::string> notes{"sign: feedback"};
        QVERIFY(signOfTable(notes, SignConvention::Feedback).value() == SignConvention::Feedback);
        QVERIFY(!signOfTable(notes, std::nullopt).value());
        VERIFY_ERROR(signOfTable(notes, SignConvention::Command), ErrorCode::InvalidArgument);
        QCOMPARE(withSignNote({"sign: deviation", "a note"}, SignConvention::Command),
            (std::vector<std::string>{"a note", "sign: command"}));
    }

    /// The drive knows the target of the file, but not whether its columns are those of the axis.
    void whatThePlaceSaysOfTheTargetIsNoStatement()
    {
        const std::string file = "Position [mm],Error [mm]\n0,0\n10,-0.5\n20,0\n";
        ImportChoices choices;
        choices.sign = SignConvention::Command;
        choices.place = {"#1", LookupAt::Set};
        const auto ofDrive = imported(QStringLiteral("x.csv"), file, choices);
        QVERIFY(ofDrive.data);
        QVERIFY(targetOf(ofDrive.data->tables.front()) == TargetAxis{0});
        QVERIFY(!isStatedSource(ofDrive.data->tables.front(), 0));
        choices.target = "#1";
        const auto stated = imported(QStringLiteral("x.csv"), file, choices);
        QVERIFY(stated.data);
        QVERIFY(isStatedSource(stated.data->tables.front(), 0));
    }

    void aTableWhoseTargetNobodyKnowsSaysItsPlaceAllTheSame()
    {
        ImportChoices choices;
        choices.format = &softmc::format();
        choices.settings = {{"position-unit", "mm"}, {"value-unit", "mm"}};
        choices.place.lookupAt = LookupAt::Set;
        const auto import =
            imported(QStringLiteral("x.txt"), "1 3\n0 0\n10 -0.5\n20 0.25\n", choices);
        QVERIFY(import.data);
        QCOMPARE(lookupInNotes(import.data->notes).value(), std::optional(LookupAt::Set));
    }

    void whatATableFileHasNoRoomForIsStated()
    {
        const NeutralTable table = neutralTable({steepTable().grid, {steepTable()}, {}});
        ConversionRequest request = requestFor(tam_table::format(), calibration_csv::format());
        request.lookupAt = LookupAt::Set;
        const auto made = convertTables(std::span(&table, 1), request);
        VERIFY_RESULT(made);
        QCOMPARE(made->written.held.front().columns[0].values, table.columns[0].values);
        QVERIFY(made->written.bytes.find("// lookup: set") != std::string::npos);
    }

    void theDriveThatWasMeasuredIsInTheFileOrSaid_data() { addFormats(); }
    void theDriveThatWasMeasuredIsInTheFileOrSaid()
    {
        QFETCH(const int, index);
        const TableFormat& to = *tableFormats()[static_cast<std::size_t>(index)];
        NeutralTable table = exampleTable(to.facts.fewestDimensions, SignConvention::Feedback);
        nameAxes(table, to);
        table.notes = {driveNote(driveText("Mill", 850618))};
        const ConversionRequest request = requestFor(calibration_csv::format(), to);
        const auto conversion = convertTables(std::span(&table, 1), request);
        VERIFY_RESULT(conversion);
        QCOMPARE(test::mentions(conversion->written.bytes, "850618"), to.facts.holdsNotes);
        QCOMPARE(contains(conversion->remarks, "the serial number 850618"), !to.facts.holdsNotes);
        if (to.facts.holdsNotes)
            return;
        table.notes.push_back(driveNote(driveText("Twin", 850619)));
        VERIFY_ERROR(convertTables(std::span(&table, 1), request), ErrorCode::InvalidArgument);
    }

    /// One for the set position is written for the encoder's as it is, once its file does not say.
    void whereATableIsLookedUpIsInTheFileOrSaid()
    {
        const std::string_view said =
            "does not say that the drive has to look it up at the set position";
        const NeutralTable table =
            neutralTable({steepTable().grid, {steepTable()}, {lookupNote(LookupAt::Set)}});
        for (const TableFormat* to : {&calibration_csv::format(), &tam_table::format()}) {
            const bool isLost = to == &tam_table::format();
            ConversionRequest request = requestFor(calibration_csv::format(), *to);
            request.targets = {"#1"};
            const auto converted = convertTables(std::span(&table, 1), request);
            VERIFY_RESULT(converted);
            QCOMPARE(contains(conversionReport(*converted, request), said), isLost);
            ImportChoices choices;
            choices.format = to;
            choices.target = "#1";
            choices.place.lookupAt = LookupAt::Set;
            const auto exported = exportTable(steepTable(), choices, "x", layout());
            VERIFY_RESULT(exported);
            QCOMPARE(contains(exported->report, said), isLost);
        }
    }

    void aPlaceOfTheLookupThatContradictsTheFileIsRefused()
    {
        NeutralTable table =
            neutralTable({steepTable().grid, {steepTable()}, {lookupNote(LookupAt::Set)}});
        ConversionRequest request = requestFor(calibration_csv::format(), softmc::format());
        request.targets = {"#1"};
        request.lookupAt = LookupAt::Encoder;
        VERIFY_ERROR(convertTables(std::span(&table, 1), request), ErrorCode::InvalidArgument);
        ConversionRequest others = requestFor(softmc::format(), linuxcnc::format());
        others.targets = {"#1"};
        others.lookupAt = LookupAt::Set;
        table.notes.clear();
        table.sign = SignConvention::Command;
        VERIFY_ERROR(convertTables(std::span(&table, 1), others), ErrorCode::InvalidArgument);
    }

    void moreThanAFormatHoldsIsRefused()
    {
        NeutralTable table = test::tableOf(SignConvention::Feedback,
            {test::evenAxis("X", "mm", 0, 1, 257)}, {test::waveColumn("X", "mm", 257, 1e-3)});
        const std::vector tables{table};
        VERIFY_ERROR(
            convertTables(tables, requestFor(calibration_csv::format(), linuxcnc::format())),
            ErrorCode::FormatCannotHold);
    }

    void aSettingForAnAxisIsRefusedForTablesOfDifferentAxes()
    {
        const auto sag = [](const char* from, const char* to) {
            return test::commandTable({test::evenAxis(from, "mm", 0, 10, 3)},
                {test::columnOf(to, "mm", {0, 0.001, -0.002})});
        };
        const TableFormat& cec = siemens_cec::format();
        ConversionRequest request = requestFor(cec, cec);
        request.writing.settings = {{"input-axis", "X"}};
        const std::vector different{sag("Z1", "Y1"), sag("X1", "Y1")};
        const auto refused = convertTables(different, request);
        VERIFY_ERROR(refused, ErrorCode::InvalidArgument);
        const std::string said = sentence(refused.error());
        QVERIFY2(test::mentions(said, "input-axis says X") && test::mentions(said, "Z1, X1")
                && test::mentions(said, "--table"),
            said.c_str());
        VERIFY_RESULT(convertTables(std::span(different).first(1), request));
        const std::vector same{sag("X1", "Y1"), sag("X1", "Z1")};
        const auto renamed = convertTables(same, request);
        VERIFY_RESULT(renamed);
        for (const NeutralTable& table : renamed->written.held)
            QCOMPARE(table.axes.front().name, std::string("X"));
    }

    /// No file says it, and a drive's table has other points after a resampling.
    void whatWasFilledIsKnownWhileThePointsStay()
    {
        NeutralTable table =
            test::tableOf(SignConvention::Feedback, {test::evenAxis("1", "mm", 0, 10, 5)},
                {test::columnOf("1", "mm", {0, 0.001, 0.002, 0.001, 0})});
        table.columns[0].filled = {1, 3};
        const std::vector tables{table};
        const auto filledBy = [&](const ConversionRequest& request) {
            const auto conversion = convertTables(tables, request);
            return conversion ? conversion->tables[0].result.columns[0].filled
                              : std::vector<std::uint32_t>{99};
        };
        for (const TableFormat* to : {&calibration_csv::format(), &isg_ssfk::format()})
            QCOMPARE(filledBy(requestFor(calibration_csv::format(), *to)),
                (std::vector<std::uint32_t>{1, 3}));
        ConversionRequest denser = requestFor(calibration_csv::format(), calibration_csv::format());
        denser.resampling =
            ResamplingRequest{.axes = {{.points = 9, .distance = 0.0, .start = {}, .end = {}}}};
        QVERIFY(filledBy(denser).empty());
    }

    void positionsThatAreRoundedAndEndsThatAreHeldAreSaid()
    {
        NeutralTable table = test::tableOf(SignConvention::Feedback,
            {test::evenAxis("1", "mm", 0.00003, 10, 3)}, {test::columnOf("1", "mm", {0, 0, 0})});
        const auto rounded = convertTables(
            std::vector{table}, requestFor(calibration_csv::format(), isg_ssfk::format()));
        VERIFY_RESULT(rounded);
        QVERIFY(std::abs(rounded->tables[0].positionRounding.at(0) - 3e-5) < 1e-12);

        table.sign = SignConvention::Command;
        table.columns[0].values = {1, 0, -1};
        const auto held = convertTables(
            std::vector{table}, requestFor(rapidcode::format(), calibration_csv::format()));
        VERIFY_RESULT(held);
        QVERIFY(contains(held->remarks, "with the end values held"));
    }

    void everyFormatIsConvertedIntoEveryOther_data()
    {
        QTest::addColumn<int>("dimensions");
        QTest::addColumn<int>("source");
        QTest::addColumn<int>("target");
        const auto formats = tableFormats();
        for (int dimensions = 1; dimensions <= 2; ++dimensions)
            for (std::size_t s = 0; s < formats.size(); ++s)
                for (std::size_t t = 0; t < formats.size(); ++t)
                    if (formats[s]->read && formats[s]->write && formats[t]->write
                        && takes(*formats[s], dimensions) && takes(*formats[t], dimensions))
                        QTest::addRow("%dD %s to %s", dimensions, formats[s]->facts.name.data(),
                            formats[t]->facts.name.data())
                            << dimensions << static_cast<int>(s) << static_cast<int>(t);
    }
    void everyFormatIsConvertedIntoEveryOther()
    {
        QFETCH(int, dimensions);
        QFETCH(int, source);
        QFETCH(int, target);
        const TableFormat& from = *tableFormats()[static_cast<std::size_t>(source)];
        const TableFormat& to = *tableFormats()[static_cast<std::size_t>(target)];
        std::array original{exampleTable(dimensions, from.facts.sign)};
        nameAxes(original[0], from);
        const auto file =
            convertTables(original, requestFor(from, from)); // as the source's format holds it
        VERIFY_RESULT(file);
        const auto reading = from.read(file->written.bytes, readOptions(from.facts, dimensions));
        VERIFY_RESULT(reading);
        QVERIFY2(!reading->tables.empty(), test::problemLines(*reading).c_str());
        std::vector<NeutralTable> tables = separateColumns(reading->tables);
        tables.resize(1); // some formats add columns of zeros
        if (tables.front().columns.size() > 1)
            tables.front().columns.resize(1);
        tables.front().columns.front().direction = Direction::Both;
        nameAxes(tables.front(), to);
        ConversionRequest request = requestFor(from, to);
        request.dropsWrap = true;
        const auto conversion = convertTables(tables, request);
        VERIFY_RESULT(conversion);
        const TableConversion& result = conversion->tables.front();
        QCOMPARE(result.difference.columns.size(), std::size_t(1));
        // Of steps of the target, and of the slope times the rounding of positions.
        const std::string& unit = result.source.columns.front().unit;
        const double factor = unit.empty() ? 1.0 : unitFactor("mm", unit).value_or(1.0);
        const double largest = result.difference.columns.front().largestInside;
        QVERIFY2(largest <= 2e-4 * factor,
            qPrintable(QString::number(largest) + QString::fromStdString(" " + unit)));
        QVERIFY(!conversionReport(*conversion, request).empty());
    }

    void theStepsAreTakenInTheirOrder()
    {
        // Two directions, uneven knots, the other convention: all of it in one conversion.
        NeutralTable table;
        table.axes = {test::evenAxis("1", "mm", 0, 10, 3)};
        table.axes[0].knots = {0, 5, 20};
        CompensationColumn positive = test::waveColumn("1", "um", 3, 2.0);
        CompensationColumn negative = positive;
        positive.direction = Direction::Positive;
        negative.direction = Direction::Negative;
        negative.values[1] += 1.0;
        table.columns = {positive, negative};
        ConversionRequest request = requestFor(calibration_csv::format(), softmc::format());
        request.direction = DirectionChoice::Mean;
        request.resampling = WantedDeviation{0.01, ResamplingMethod::Linear};
        const std::array tables{table};
        const auto conversion = convertTables(tables, request);
        VERIFY_RESULT(conversion);
        const TableConversion& result = conversion->tables.front();
        QCOMPARE(result.directionLosses.size(), std::size_t(1));
        QCOMPARE(result.directionLosses[0].largestHalfDifference, 0.5);
        QVERIFY(result.resampling.has_value());
        QVERIFY(result.resampling->columns[0].largest <= 0.01);
        QCOMPARE(result.result.sign, SignConvention::Command);
        QVERIFY(isEven(result.result));
        const auto lines = conversionReport(*conversion, request);
        QVERIFY(contains(lines, "csv holds feedback values, softmc holds command values"));
        QVERIFY(contains(lines, "resampled from 3 points to 5 points"));
        QVERIFY(contains(lines, "half their difference is up to 0.5 um"));
        QVERIFY(contains(lines, "compared at"));
    }

    void directionsThatTheTargetCannotHoldMustBeChosen()
    {
        NeutralTable table = exampleTable(1, SignConvention::Feedback);
        table.columns.push_back(table.columns[0]);
        table.columns[0].direction = Direction::Positive;
        table.columns[1].direction = Direction::Negative;
        const std::array tables{table};
        const auto conversion =
            convertTables(tables, requestFor(isg_ssfk::format(), calibration_csv::format()));
        VERIFY_ERROR(conversion, ErrorCode::FormatCannotHold);
        QVERIFY(sentence(conversion.error()).find("mean") != std::string::npos);
    }

    /// Of profiles, measuring systems or maps of a program; together they would move the axis by
    /// their sum.
    void tablesOfWhichOneCountsAreNotWrittenWhereTheyAreAdded_data()
    {
        QTest::addColumn<int>("index");
        const auto formats = tableFormats();
        for (int i = 0; i < static_cast<int>(formats.size()); ++i) {
            const TableFormat& format = *formats[static_cast<std::size_t>(i)];
            if (format.facts.addsTables && format.write && format.facts.mostTables != 1)
                QTest::newRow(std::string(format.facts.name).c_str()) << i;
        }
    }
    void tablesOfWhichOneCountsAreNotWrittenWhereTheyAreAdded()
    {
        QFETCH(const int, index);
        const TableFormat& format = *tableFormats()[static_cast<std::size_t>(index)];
        NeutralTable table =
            exampleTable(format.facts.fewestDimensions, calibration_csv::format().facts.sign);
        nameAxes(table, format);
        std::vector tables{table, table};
        const ConversionRequest request = requestFor(calibration_csv::format(), format);
        const auto refused = convertTables(tables, request);
        VERIFY_ERROR(refused, ErrorCode::FormatCannotHold);
        QVERIFY2(test::mentions(sentence(refused.error()), "two tables for axis"),
            sentence(refused.error()).c_str());
        QVERIFY(test::mentions(sentence(refused.error()), "choose one of them"));
        VERIFY_RESULT(convertTables(std::span(tables).first(1), request));

        for (NeutralTable& added : tables)
            added.sign = format.facts.sign;
        const auto copied = convertTables(tables, requestFor(format, format));
        VERIFY_RESULT(copied);
        QCOMPARE(copied->written.held.size(), std::size_t{2});
        QVERIFY(!contains(copied->remarks, "as if it were alone"));
    }

    void columnsOfWhichOneCountsAreNotWrittenWhereTheyAreAdded()
    {
        NeutralTable table = exampleTable(2, SignConvention::Feedback);
        nameAxes(table, aerotech_2d::format());
        table.columns[0].target = "3";
        table.columns.push_back(table.columns[0]);
        table.columns[1].target = "4";
        const ConversionRequest request =
            requestFor(calibration_csv::format(), aerotech_2d::format());
        VERIFY_RESULT(convertTables(std::span(&table, 1), request));
        table.columns[1].target = "3";
        VERIFY_ERROR(convertTables(std::span(&table, 1), request), ErrorCode::FormatCannotHold);

        NeutralTable pair = exampleTable(1, SignConvention::Feedback);
        pair.columns.push_back(pair.columns[0]);
        pair.columns[0].direction = Direction::Positive;
        pair.columns[1].direction = Direction::Negative;
        VERIFY_RESULT(convertTables(
            std::span(&pair, 1), requestFor(calibration_csv::format(), siemens_cec::format())));
    }

    /// The columns of zeros beside them, which the format adds, are for the same axis.
    void tablesForDifferentAxesAreWrittenTogether()
    {
        NeutralTable first = exampleTable(2, SignConvention::Feedback);
        nameAxes(first, aerotech_2d::format());
        NeutralTable second = first;
        first.columns[0].target = "3";
        second.columns[0].target = "4";
        VERIFY_RESULT(convertTables(std::array{first, second},
            requestFor(calibration_csv::format(), aerotech_2d::format())));
    }

    /// One number for all axes is a statement about a file of one.
    void aSettingDoesNotAddTheTablesOfDifferentAxes()
    {
        NeutralTable first = exampleTable(1, SignConvention::Command);
        nameAxes(first, aerotech_1d::format());
        NeutralTable second = first;
        second.axes[0].name = second.columns[0].target = "2";
        ConversionRequest request = requestFor(aerotech_1d::format(), aerotech_1d::format());
        VERIFY_RESULT(convertTables(std::array{first, second}, request));
        request.writing.settings["axis"] = "3";
        VERIFY_ERROR(convertTables(std::array{first, second}, request), ErrorCode::InvalidArgument);
        VERIFY_RESULT(convertTables(std::array{first, first}, request));
    }

    /// Each moves the place where the other one is looked up.
    void aSignOfAddedTablesIsSaidToBeConvertedOneByOne()
    {
        NeutralTable table = exampleTable(1, SignConvention::Command);
        nameAxes(table, aerotech_1d::format());
        ConversionRequest request = requestFor(aerotech_1d::format(), siemens_cec::format());
        request.writing.settings = {{"input-axis", "X1"}, {"output-axis", "X1"}};
        request.targetSign = SignConvention::Feedback;
        const auto converted = convertTables(std::array{table, table}, request);
        VERIFY_RESULT(converted);
        QVERIFY2(contains(converted->remarks, "the controller adds the tables for 1: the sign"),
            test::joined(converted->remarks).c_str());
    }

    void aTableWithoutValuesIsRefusedBeforeAnythingIsMadeOfIt()
    {
        NeutralTable table = exampleTable(1, SignConvention::Feedback);
        table.columns.clear();
        const std::array tables{table};
        for (const TableFormat* format : tableFormats()) {
            if (!format->write)
                continue;
            VERIFY_ERROR(convertTables(tables, requestFor(calibration_csv::format(), *format)),
                ErrorCode::InvalidArgument);
            if (format->facts.fewestDimensions == 1)
                VERIFY_ERROR(checkHolds(format->facts, tables), ErrorCode::InvalidArgument);
        }
    }

    void anOverruledSignIsUsedAndSaid()
    {
        const std::array tables{exampleTable(1, SignConvention::Command)};
        ConversionRequest request = requestFor(softmc::format(), calibration_csv::format());
        request.sourceSign = SignConvention::Feedback;
        const auto conversion = convertTables(tables, request);
        VERIFY_RESULT(conversion);
        const auto& values = conversion->tables.front().result.columns.front().values;
        QVERIFY(test::largestDifference(values, tables[0].columns[0].values) < 1e-9);
        QVERIFY(contains(conversionReport(*conversion, request), "as you say"));
    }

    void anAssumedSignMustBeStated()
    {
        const std::array tables{exampleTable(1, SignConvention::Feedback)};
        ConversionRequest out = requestFor(calibration_csv::format(), siemens_cec::format());
        out.targetSign.reset();
        const auto refused = convertTables(tables, out);
        VERIFY_ERROR(refused, ErrorCode::SignNotStated);
        QVERIFY(test::mentions(sentence(refused.error()), "siemens-cec"));
        QVERIFY(test::mentions(sentence(refused.error()), "--to-sign"));
        for (const SignConvention sign : {SignConvention::Feedback, SignConvention::Command}) {
            out.targetSign = sign;
            const auto stated = convertTables(tables, out);
            VERIFY_RESULT(stated);
            QVERIFY(contains(conversionReport(*stated, out), "values, as you say"));
        }

        ConversionRequest in = requestFor(siemens_cec::format(), calibration_csv::format());
        in.sourceSign.reset();
        const auto unstated = convertTables(tables, in);
        VERIFY_ERROR(unstated, ErrorCode::SignNotStated);
        QVERIFY(test::mentions(sentence(unstated.error()), "with --sign, or as sign"));
    }

    void withinOneFormatAnAssumedSignIsKept()
    {
        std::array tables{exampleTable(1, SignConvention::Command)};
        nameAxes(tables[0], siemens_cec::format());
        ConversionRequest request = requestFor(siemens_cec::format(), siemens_cec::format());
        request.sourceSign.reset();
        request.targetSign.reset();
        const auto kept = convertTables(tables, request);
        VERIFY_RESULT(kept);
        QVERIFY(test::largestDifference(
                    kept->tables[0].result.columns[0].values, tables[0].columns[0].values)
            < 1e-9);
        // One of both stated: the other one counts as well.
        request.targetSign = SignConvention::Feedback;
        VERIFY_ERROR(convertTables(tables, request), ErrorCode::SignNotStated);
    }

    /// What a person says of the sign of a file says it of the controller, too.
    void withinOneFormatTheSignIsStatedOnce()
    {
        const std::array tables{exampleTable(1, SignConvention::Feedback)};
        for (const SignConvention sign : {SignConvention::Feedback, SignConvention::Command}) {
            ConversionRequest request = requestFor(siemens_cec::format(), siemens_cec::format());
            request.sourceSign = sign;
            request.targetSign.reset();
            const auto conversion = convertTables(tables, request);
            VERIFY_RESULT(conversion);
            QVERIFY(test::largestDifference(conversion->tables.front().result.columns[0].values,
                        tables[0].columns[0].values)
                < 1e-12);
        }
    }

    void valuesWithoutAUnitAreInThatOfTheirPositions_data() { addFormats(); }
    void valuesWithoutAUnitAreInThatOfTheirPositions()
    {
        QFETCH(const int, index);
        const TableFormat& format = *tableFormats()[static_cast<std::size_t>(index)];
        NeutralTable stated = inMicrometres(format);
        NeutralTable silent = stated;
        silent.columns[0].unit.clear();
        ConversionRequest request = requestFor(calibration_csv::format(), format);
        const auto settings = formatSettings(format.facts, true);
        if (std::ranges::find(settings, "position-unit", &FormatSetting::key) != settings.end())
            request.writing.settings["position-unit"] = "mm";
        const auto one = convertTables(std::span(&stated, 1), request);
        const auto other = convertTables(std::span(&silent, 1), request);
        VERIFY_RESULT(one);
        VERIFY_RESULT(other);
        QCOMPARE(other->written.bytes, one->written.bytes);
        if (&format != &tam_table::format())
            QVERIFY(contains(conversionReport(*other, request), "as the positions are"));
    }

    void valuesOfAnotherAxisNeedAUnitWherePositionsHaveSeveral()
    {
        NeutralTable table = tableOverTwoUnits();
        table.columns[0].unit.clear();
        table.columns[0].target = "Z";
        const ConversionRequest request = requestFor(calibration_csv::format(), softmc::format());
        const auto refused = convertTables(std::span(&table, 1), request);
        VERIFY_ERROR(refused, ErrorCode::InvalidArgument);
        QVERIFY2(test::mentions(sentence(refused.error()), "the positions are in um, mm"),
            sentence(refused.error()).c_str());
        QVERIFY(test::mentions(sentence(refused.error()), "value-unit"));
        table.columns[0].unit = "um";
        VERIFY_RESULT(convertTables(std::span(&table, 1), request));
        table.columns[0].unit.clear();
        table.axes[1].unit = "degC";
        VERIFY_RESULT(convertTables(std::span(&table, 1), request));
    }

    /// It has no units: a drive takes the values in that of its axis.
    void aTableOfTheDriveNeedsToKnowTheUnitOfItsAxis()
    {
        NeutralTable table = tableOverTwoUnits();
        ConversionRequest request = requestFor(calibration_csv::format(), tam_table::format());
        table.columns[0].target = "other";
        const auto refused = convertTables(std::span(&table, 1), request);
        VERIFY_ERROR(refused, ErrorCode::InvalidArgument);
        QVERIFY(test::mentions(sentence(refused.error()), "--value-unit"));
        table.columns[0].target = "#2";
        const auto own = convertTables(std::span(&table, 1), request);
        VERIFY_RESULT(own);
        QCOMPARE(own->tables.front().result.columns[0].unit, std::string("mm"));
        table.columns[0].target = "other";
        table.axes[0].unit = "mm";
        VERIFY_RESULT(convertTables(std::span(&table, 1), request));
        table.axes[0].unit = "deg"; // values of another axis may be angles, too
        table.columns[0].unit = "um";
        const auto angles = convertTables(std::span(&table, 1), request);
        VERIFY_ERROR(angles, ErrorCode::InvalidArgument);
        QVERIFY2(test::mentions(sentence(angles.error()), "in um and the positions in deg, mm,"),
            sentence(angles.error()).c_str());
        // The unit of the values may be another one than that of the axis.
        QVERIFY(sentence(angles.error()).ends_with("such as --value-unit mm"));
    }

    /// A temperature that comes first is nothing that a correction could be in.
    void valuesOverATemperatureAndALengthAreInTheUnitOfTheLength()
    {
        NeutralTable table = tableOverTwoUnits();
        table.axes[0].unit = "degC";
        table.axes[1].unit = "mm";
        table.columns[0].target = "other";
        table.columns[0].unit = "um";
        const double before = table.columns[0].values.front();
        const auto converted = convertTables(
            std::span(&table, 1), requestFor(calibration_csv::format(), tam_table::format()));
        VERIFY_RESULT(converted);
        const CompensationColumn& column = converted->tables.front().result.columns[0];
        QCOMPARE(column.unit, std::string("mm"));
        QCOMPARE(std::abs(column.values.front()), std::abs(before) / 1000.0);
    }

    /// The controller adds one to the other.
    void valuesWithAUnitNeedThatOfTheirPositions_data() { addFormats(); }
    void valuesWithAUnitNeedThatOfTheirPositions()
    {
        QFETCH(const int, index);
        const TableFormat& format = *tableFormats()[static_cast<std::size_t>(index)];
        NeutralTable table = inMicrometres(format);
        for (SourceAxis& axis : table.axes)
            axis.unit.clear();
        const auto refused =
            convertTables(std::span(&table, 1), requestFor(calibration_csv::format(), format));
        VERIFY_ERROR(refused, ErrorCode::InvalidArgument);
        QVERIFY(test::mentions(sentence(refused.error()), "position-unit"));
    }

    /// Over a rotary axis they may be lengths as well as angles.
    void valuesOfAnotherAxisOverAnglesKeepTheirUnknownUnit()
    {
        NeutralTable table = exampleTable(1, SignConvention::Feedback);
        nameAxes(table, siemens_cec::format());
        table.axes[0].unit = "rad";
        table.columns[0].target = "Z";
        table.columns[0].unit.clear();
        const auto conversion = convertTables(
            std::span(&table, 1), requestFor(calibration_csv::format(), softmc::format()));
        VERIFY_RESULT(conversion);
        QCOMPARE(conversion->tables.front().result.columns[0].unit, std::string());
    }

    void theValuesOfAnotherAxisGetTheUnitOfTheFirstSource_data()
    {
        QTest::addColumn<QString>("name");
        for (const char* name : {"power-pmac", "pmac-1d", "softmc", "rapidcode"})
            QTest::newRow(name) << name;
    }
    void theValuesOfAnotherAxisGetTheUnitOfTheFirstSource()
    {
        QFETCH(const QString, name);
        const auto format = formatNamed(name.toStdString());
        VERIFY_RESULT(format);
        NeutralTable small = exampleTable(1, SignConvention::Feedback);
        nameAxes(small, **format);
        small.columns[0].target = "3";
        NeutralTable large = small;
        large.columns[0].unit = "um";
        for (double& value : large.columns[0].values)
            value *= 1000.0;
        ConversionRequest request = requestFor(calibration_csv::format(), **format);
        const auto one = convertTables(std::span(&small, 1), request);
        const auto other = convertTables(std::span(&large, 1), request);
        VERIFY_RESULT(one);
        VERIFY_RESULT(other);
        QCOMPARE(other->written.bytes, one->written.bytes);
    }

    void endsThatNoLongerGoOnAreSaidWithTheirNumber()
    {
        NeutralTable table = exampleTable(2, SignConvention::Command);
        nameAxes(table, calibration_csv::format());
        for (std::size_t i = 0; i < table.pointCount(); ++i)
            table.columns[0].values[i] = 0.001 * static_cast<double>(i % 5);
        table.columns[0].target = "other";
        const auto conversion = convertTables(
            std::vector{table}, requestFor(kmotion_geo::format(), calibration_csv::format()));
        VERIFY_RESULT(conversion);
        QVERIFY2(contains(conversion->remarks,
                     "the controller of kmotion-geo goes on as in the last cell, and that of csv "
                     "holds the end values"),
            test::joined(conversion->remarks).c_str());
        QVERIFY2(contains(conversion->remarks, "differ by at most 0.001 mm"),
            test::joined(conversion->remarks).c_str());
        const auto other = convertTables(
            std::vector{table}, requestFor(softmc::format(), calibration_csv::format()));
        VERIFY_RESULT(other);
        QVERIFY(!contains(other->remarks, "beyond the ends"));
        table.columns[0].target = "3";
        const auto rolling =
            convertTables(std::vector{table}, requestFor(kmotion_geo::format(), pmac_2d::format()));
        VERIFY_RESULT(rolling);
        QVERIFY2(contains(rolling->remarks, "and that of pmac-2d begins again at the other end"),
            test::joined(rolling->remarks).c_str());
    }

    void aDriveGetsValuesInTheUnitOfThePositions()
    {
        NeutralTable table = exampleTable(1, SignConvention::Feedback);
        table.columns[0].unit = "um";
        const std::array tables{table};
        const auto conversion =
            convertTables(tables, requestFor(isg_ssfk::format(), calibration_csv::format()));
        VERIFY_RESULT(conversion);
        const CompensationColumn& column = conversion->tables.front().result.columns.front();
        QCOMPARE(column.unit, std::string("mm"));
        QVERIFY(std::abs(column.values[1] - table.columns[0].values[1] / 1000.0) < 1e-9);
        QVERIFY(contains(conversion->remarks, "the values were in um and are now in mm"));
    }

    void aModuloAxisBecomesAPlainOneWhenAsked()
    {
        NeutralTable table = exampleTable(1, SignConvention::Feedback);
        table.axes[0].wrap = 40.0;
        const std::array tables{table};
        ConversionRequest request = requestFor(isg_ssfk::format(), calibration_csv::format());
        VERIFY_ERROR(convertTables(tables, request), ErrorCode::FormatCannotHold);
        request.dropsWrap = true;
        VERIFY_RESULT(convertTables(tables, request));
    }

    void roundingIsReported()
    {
        std::array tables{exampleTable(1, SignConvention::Feedback)};
        nameAxes(tables[0], isg_ssfk::format());
        tables[0].columns[0].values[1] += 0.00003; // the file has steps of 0.0001 mm
        ConversionRequest request = requestFor(calibration_csv::format(), isg_ssfk::format());
        const auto conversion = convertTables(tables, request);
        VERIFY_RESULT(conversion);
        const double rounding = conversion->tables.front().valueRounding.front();
        QVERIFY2(rounding > 0.0 && rounding <= 0.5e-4, qPrintable(QString::number(rounding)));
        QVERIFY(contains(conversionReport(*conversion, request), "rounded"));
    }

    /// A PMAC has whole counts for the length of a table alone, so that each of its positions lies
    /// further off than the one before.
    void whatAFileDoesToPositionsThatItMovesIsReported_data()
    {
        QTest::addColumn<double>("first");
        QTest::addColumn<double>("rounding");
        QTest::newRow("from 0") << 0.0 << 0.6; // at 76.5 mm, in place of 75.9
        QTest::newRow("behind the positive positions") << -50.6 << 0.4;
    }
    void whatAFileDoesToPositionsThatItMovesIsReported()
    {
        QFETCH(const double, first);
        QFETCH(const double, rounding);
        NeutralTable table =
            test::tableOf(SignConvention::Feedback, {test::evenAxis("1", "mm", first, 25.3, 4)},
                {test::columnOf("1", "mm", {0, 0.03001, 0, 0.02})});
        table.columns[0].filled = {3};
        ConversionRequest request = requestFor(calibration_csv::format(), pmac_1d::format());
        request.targetSign = SignConvention::Feedback;
        request.writing.settings = {{"counts-per-unit", "1000"}, {"source-counts-per-unit", "0.5"}};
        const auto moved = convertTables(std::span(&table, 1), request);
        VERIFY_RESULT(moved);
        const TableConversion& conversion = moved->tables[0];
        QCOMPARE(conversion.positionRounding.size(), std::size_t{1});
        QVERIFY(std::abs(conversion.positionRounding[0] - rounding) < 1e-9);
        QCOMPARE(conversion.valueRounding.size(), std::size_t{1});
        QVERIFY(std::abs(conversion.valueRounding[0] - 1e-5) < 1e-12);
        const CompensationColumn& held = conversion.result.columns[0];
        QCOMPARE(held.filled.size(), std::size_t{1});
        QVERIFY(std::abs(held.values[held.filled[0]] - 0.02) < 1e-12);
        const auto lines = conversionReport(*moved, request);
        QVERIFY2(contains(lines, "the positions of the file are rounded by up to 0."),
            test::joined(lines).c_str());
        QVERIFY(contains(lines, "the values of the file are rounded by up to 1e-05 mm"));
    }

    void aTableOfWhichNothingIsLeftIsReported()
    {
        NeutralTable table = test::tableOf(SignConvention::Feedback,
            {test::evenAxis("1", "mm", 0, 10, 2), test::evenAxis("2", "mm", 0, 10, 2)},
            {test::columnOf("3", "mm", {0, 0.001, 0.002, 0.003})});
        ConversionRequest request = requestFor(calibration_csv::format(), pmac_2d::format());
        request.writing.settings = {{"counts-per-unit", "3"}, {"source-counts-per-unit", "3.3333"}};
        const auto lost = convertTables(std::span(&table, 1), request);
        VERIFY_RESULT(lost);
        const auto lines = conversionReport(*lost, request);
        QVERIFY2(contains(lines, "the values of the file are rounded by up to 0.003 mm"),
            test::joined(lines).c_str());
        QVERIFY2(contains(lines, "the positions of the file are rounded by up to 0.0501 mm"),
            test::joined(lines).c_str());
    }

    /// A distance that the positions do not give back to the last bit is what the file states.
    void aDistanceThatIsStatedIsKeptToTheLastBit()
    {
        CompensationTable table;
        table.name = "X";
        table.grid.axes = {{.name = {}, .unit = {}, .start = 0, .distance = 0, .size = 3}};
        table.grid.axes[0].distance = std::nextafter(10.0, 11.0);
        table.values = {0.0F, 0.5F, 0.25F};
        NeutralTable source = neutralTable({table.grid, {table}, {}});
        ConversionRequest request = requestFor(tam_table::format(), tam_table::format());
        request.targets = {"#1"};
        request.lookupAt = LookupAt::Encoder;
        const auto distanceOf = [](const Conversion& conversion) {
            const auto data = calibrationData(conversion.written.held.front());
            return data ? data->grid.axes[0].distance : 0.0;
        };
        const auto kept = convertTables(std::span(&source, 1), request);
        VERIFY_RESULT(kept);
        QCOMPARE(kept->tables[0].positionRounding, std::vector{0.0});
        QVERIFY(distanceOf(*kept) == table.grid.axes[0].distance);

        for (double& knot : source.axes[0].knots)
            knot *= 2.0;
        const auto moved = convertTables(std::span(&source, 1), request);
        VERIFY_RESULT(moved);
        QCOMPARE(distanceOf(*moved), 20.0);
    }

    /// Both columns move the place where they are looked up.
    void oneColumnOfSeveralIsConvertedAsTheWholeFileIs_data()
    {
        QTest::addColumn<bool>("toDrive");
        QTest::addColumn<bool>("isResampled");
        for (const bool toDrive : {true, false})
            for (const bool isResampled : {false, true})
                QTest::addRow(
                    "%s the drive%s", toDrive ? "to" : "from", isResampled ? ", resampled" : "")
                    << toDrive << isResampled;
    }
    void oneColumnOfSeveralIsConvertedAsTheWholeFileIs()
    {
        QFETCH(const bool, toDrive);
        QFETCH(const bool, isResampled);
        const std::vector whole{tableThatMovesBoth(toDrive)};
        const TableFormat& other = aerotech_2d::format();
        ConversionRequest request = toDrive ? requestFor(other, calibration_csv::format())
                                            : requestFor(calibration_csv::format(), other);
        request.adjustment.scale = 2.0;
        if (isResampled)
            request.resampling = WantedDeviation{0.01, ResamplingMethod::Linear};
        const auto all = convertTables(whole, request);
        VERIFY_RESULT(all);
        const std::vector<NeutralTable> columns = separateColumns(whole);
        QCOMPARE(columns.size(), 2U);
        for (std::size_t n = 0; n < columns.size(); ++n) {
            request.beside = sourcesBeside(whole, n);
            QVERIFY(request.beside);
            const auto one = convertTables(std::span(columns).subspan(n, 1), request);
            VERIFY_RESULT(one);
            const TableConversion& table = one->tables[0];
            QVERIFY(!table.result.columns.empty()); // Aerotech files have one for each source
            QVERIFY(test::largestDifference(
                        table.result.columns[0].values, all->tables[0].result.columns[n].values)
                < 1e-12);
            QCOMPARE(table.difference.columns.size(), 1U);
            QVERIFY(std::abs(table.difference.columns[0].largest
                        - all->tables[0].difference.columns[n].largest)
                < 1e-9);
            request.beside.reset();
            const auto alone = convertTables(std::span(columns).subspan(n, 1), request);
            VERIFY_RESULT(alone);
            QVERIFY(test::largestDifference(
                        alone->tables[0].result.columns[0].values, table.result.columns[0].values)
                > 1e-4);
        }
    }

    /// The column that is written says how many points are enough.
    void theColumnsBesideOneAreBroughtOntoItsGrid()
    {
        NeutralTable table = tableThatMovesBoth(true);
        for (std::size_t i = 0; i < table.pointCount(); ++i)
            table.columns[0].values[i] = 0.05 * static_cast<double>(i / 5); // a plane
        const std::vector whole{table};
        const std::vector<NeutralTable> columns = separateColumns(whole);
        ConversionRequest request = requestFor(aerotech_2d::format(), calibration_csv::format());
        request.beside = sourcesBeside(whole, 0);
        request.resampling = WantedDeviation{0.01, ResamplingMethod::Linear};
        const auto fitted = convertTables(std::span(columns).first(1), request);
        VERIFY_RESULT(fitted);
        QCOMPARE(knotCounts(fitted->tables[0].result), (std::vector<std::size_t>{2, 2}));
        request.resampling =
            ResamplingRequest{{AxisRequest{.points = 2}, AxisRequest{.points = 2}}};
        const auto asked = convertTables(std::span(columns).first(1), request);
        VERIFY_RESULT(asked);
        QCOMPARE(fitted->tables[0].result, asked->tables[0].result);
        request.beside.reset();
        const auto alone = convertTables(std::span(columns).first(1), request);
        VERIFY_RESULT(alone);
        QVERIFY(test::largestDifference(alone->tables[0].result.columns[0].values,
                    fitted->tables[0].result.columns[0].values)
            > 1e-4);
    }

    void theColumnsOfAFileAreImportedAsTheWholeFileIsConverted()
    {
        const TableImport import = imported(QStringLiteral("g.cal"),
            ":START2D 2 1 1 2 100 100 3\n:START2D POSUNIT=METRIC CORUNIT=METRIC/1000\n"
            "0 0  100 -50  200 40\n300 10 -400 600 100 0\n0 500 200 -300 100 100\n:END\n",
            {});
        QVERIFY(import.data);
        QCOMPARE(import.data->tables.size(), 2U);
        // the fixed point of e = -c(x + e) at 100, 100
        QVERIFY(std::abs(import.data->tables[0].values[4] - 0.39506513F) < 1e-6F);
    }

    /// The comments of a program stand with its first table.
    void everyTableOfAFileIsForTheDriveThatTheFileNames()
    {
        const auto program = siemens_eec::format().read(
            "; drive: Mill, serial number 7\n"
            "$AA_ENC_COMP[0,0,X1]=0\n$AA_ENC_COMP[0,1,X1]=0.001\n$AA_ENC_COMP_STEP[0,X1]=10\n"
            "$AA_ENC_COMP_MIN[0,X1]=0\n$AA_ENC_COMP_MAX[0,X1]=10\n"
            "$AA_ENC_COMP[0,0,Y1]=0\n$AA_ENC_COMP[0,1,Y1]=0.002\n$AA_ENC_COMP_STEP[0,Y1]=10\n"
            "$AA_ENC_COMP_MIN[0,Y1]=0\n$AA_ENC_COMP_MAX[0,Y1]=10\nM17\n",
            {});
        VERIFY_RESULT(program);
        QCOMPARE(program->tables.size(), 2U);
        for (const NeutralTable& table : separateColumns(program->tables)) {
            const auto drive = measuredDriveInNotes(table.notes);
            VERIFY_RESULT(drive);
            QCOMPARE(*drive, std::optional(7));
        }
    }

    /// Of two columns for one axis nobody knows which is in use.
    void aColumnForAChoiceMovesNoOther()
    {
        NeutralTable table = tableThatMovesBoth(false);
        table.columns.push_back(table.columns[1]);
        const std::vector whole{table};
        const std::vector<NeutralTable> columns = separateColumns(whole);
        ConversionRequest request = requestFor(calibration_csv::format(), softmc::format());
        const auto alone = convertTables(std::span(columns).first(1), request);
        VERIFY_RESULT(alone);
        request.beside = sourcesBeside(whole, 0);
        const auto beside = convertTables(std::span(columns).first(1), request);
        VERIFY_RESULT(beside);
        QCOMPARE(beside->tables[0].result, alone->tables[0].result);
        request.beside = sourcesBeside(whole, 1);
        QCOMPARE(request.beside->columns.size(), 2U);
        VERIFY_RESULT(convertTables(std::span(columns).subspan(1, 1), request));
    }

    /// Its controller applies the numbers as they are, finer than its file would be written.
    void whatAPersonSaysOfATableDoesNotRoundIt()
    {
        NeutralTable table = test::commandTable({test::evenAxis("1", "mm", 0, 10, 3)},
            {test::columnOf("1", "mm", {0, 4e-5, -3e-5}),
                test::columnOf("1", "mm", {4.5e-5, 14.5e-5, 26e-5})});
        table.columns[0].direction = Direction::Positive;
        table.columns[1].direction = Direction::Negative;
        ConversionRequest request = requestFor(isg_ssfk::format(), isg_ssfk::format());
        request.direction = DirectionChoice::Positive;
        const auto positive = tableAsStated(table, request);
        VERIFY_RESULT(positive);
        QCOMPARE(positive->table.columns.size(), 1U);
        QCOMPARE(positive->table.columns[0].values, table.columns[0].values);
        request.direction = DirectionChoice::Mean;
        request.adjustment.scale = 10.0;
        const auto mean = tableAsStated(table, request);
        VERIFY_RESULT(mean);
        QVERIFY(std::abs(mean->table.columns[0].values[1] - 92.5e-5) < 1e-12);
        QVERIFY(contains(mean->remarks, "multiplied by 10"));
    }

    /// Of two directions that differ the one that is chosen is 0, and of a curve the points on it;
    /// the source is compared with the same shift.
    void aTableIsZeroWhereThatIsAskedForAsItIsWritten_data()
    {
        QTest::addColumn<int>("direction"); // -1: none
        QTest::addColumn<int>("method"); // -1: the grid stays
        QTest::newRow("positive") << int(DirectionChoice::Positive) << -1;
        QTest::newRow("negative") << int(DirectionChoice::Negative) << -1;
        QTest::newRow("mean") << int(DirectionChoice::Mean) << -1;
        QTest::newRow("spline") << -1 << int(ResamplingMethod::NaturalSpline);
        QTest::newRow("cubic") << -1 << int(ResamplingMethod::MonotoneCubic);
        QTest::newRow("both") << int(DirectionChoice::Positive)
                              << int(ResamplingMethod::NaturalSpline);
    }
    void aTableIsZeroWhereThatIsAskedForAsItIsWritten()
    {
        QFETCH(int, direction);
        QFETCH(int, method);
        NeutralTable table = test::commandTable({test::evenAxis("X", "mm", -15, 10, 4)},
            {test::columnOf("X", "mm", {0.01, 0.002, 0.012, -0.02})});
        table.sign = SignConvention::Feedback;
        if (direction >= 0) {
            table.columns.push_back(test::columnOf("X", "um", {14, 7, 18, -13}));
            table.columns[0].direction = Direction::Positive;
            table.columns[1].direction = Direction::Negative;
        }
        ConversionRequest request =
            requestFor(calibration_csv::format(), calibration_csv::format());
        request.adjustment.zero = {0.0};
        if (direction >= 0)
            request.direction = static_cast<DirectionChoice>(direction);
        if (method >= 0)
            request.resampling = ResamplingRequest{
                {AxisRequest{.points = 7}}, static_cast<ResamplingMethod>(method)};
        const auto made = convertTables(std::span(&table, 1), request);
        VERIFY_RESULT(made);
        const std::vector<double> home{0.0};
        const NeutralTable& result = made->tables[0].result;
        QCOMPARE(result.columns.size(), 1U);
        QVERIFY(std::abs(ControllerLookup(result, 0, {}).at(home)) < 1e-12);
        QVERIFY(contains(made->remarks, "are shifted by"));
        if (method < 0)
            QVERIFY(made->tables[0].difference.columns[0].largest < 1e-9);
        if (direction < 0)
            return;
        // The reversal of the source is the same as before.
        const NeutralTable& source = made->tables[0].source;
        const double before = table.columns[1].values[2] / 1000.0 - table.columns[0].values[2];
        const double after = source.columns[1].values[2] / 1000.0 - source.columns[0].values[2];
        QVERIFY(std::abs(after - before) < 1e-12);
    }

    /// The grid that is asked for ends before the position: what the source has there is 0.
    void theZeroMayBeOutsideOfTheGridThatIsWritten()
    {
        NeutralTable table = test::commandTable({test::evenAxis("X", "mm", 0, 10, 4)},
            {test::columnOf("X", "mm", {0.01, 0.002, 0.012, -0.02})});
        table.sign = SignConvention::Feedback;
        ConversionRequest request =
            requestFor(calibration_csv::format(), calibration_csv::format());
        request.adjustment.zero = {30.0};
        request.resampling =
            ResamplingRequest{{AxisRequest{.points = 3, .start = 0.0, .end = 20.0}}};
        const auto made = convertTables(std::span(&table, 1), request);
        VERIFY_RESULT(made);
        QVERIFY(std::abs(made->tables[0].result.columns[0].values[0] - 0.03) < 1e-12);
    }

    /// In the turn of the source, also where the table becomes a linear one.
    void theZeroOfAModuloAxisMayBeInAnotherTurn()
    {
        NeutralTable table = test::commandTable({test::evenAxis("X", "mm", 0, 10, 4)},
            {test::columnOf("X", "mm", {0.01, 0.002, 0.012, -0.02})});
        table.sign = SignConvention::Feedback;
        table.axes[0].wrap = 40.0;
        ConversionRequest request =
            requestFor(calibration_csv::format(), calibration_csv::format());
        request.dropsWrap = true;
        request.adjustment.zero = {50.0};
        const auto made = convertTables(std::span(&table, 1), request);
        VERIFY_RESULT(made);
        QVERIFY(std::abs(made->tables[0].result.columns[0].values[1]) < 1e-12);
    }

    void theSignThatIsStatedOfATableIsThatOfItsNumbers()
    {
        const NeutralTable table = exampleTable(1, SignConvention::Command);
        ConversionRequest request = requestFor(softmc::format(), softmc::format());
        request.sourceSign = SignConvention::Feedback;
        const auto stated = tableAsStated(table, request);
        VERIFY_RESULT(stated);
        QCOMPARE(stated->table.sign, SignConvention::Feedback);
        QCOMPARE(stated->table.columns[0].values, table.columns[0].values);
        request.targetSign = SignConvention::Command;
        const auto converted = tableAsStated(table, request);
        VERIFY_RESULT(converted);
        QCOMPARE(converted->table.sign, SignConvention::Command);
        QVERIFY(converted->table.columns[0].values[1] < 0.0);
        ConversionRequest assumed = requestFor(isg_ssfk::format(), isg_ssfk::format());
        assumed.from = &pmac_1d::format();
        assumed.sourceSign.reset();
        assumed.targetSign = SignConvention::Feedback;
        VERIFY_ERROR(tableAsStated(table, assumed), ErrorCode::SignNotStated);
    }

    /// The file of a table that is not closed has a point more, and begins at position 0.
    void roundingIsReportedWhereTheFileHasFurtherPoints()
    {
        ConversionRequest request = requestFor(calibration_csv::format(), pmac_1d::format());
        request.targetSign = SignConvention::Feedback;
        request.writing.settings["counts-per-unit"] = "1000";
        for (const double start : {0.0, -20.0}) {
            std::array tables{
                test::tableOf(SignConvention::Feedback, {test::evenAxis("1", "mm", start, 10, 4)},
                    {test::columnOf("1", "mm", {0, 0.1234, 0, 0.03})})};
            tables[0].columns[0].filled = {1};
            const auto conversion = convertTables(tables, request);
            VERIFY_RESULT(conversion);
            const TableConversion& table = conversion->tables.front();
            QCOMPARE(table.result.pointCount(), 5U);
            QCOMPARE(table.positionRounding, std::vector{0.0});
            QCOMPARE(table.valueRounding.size(), 1U);
            // an entry is a sixteenth of a count
            const double rounding = 0.1234 - std::round(0.1234 * 16000) / 16000;
            QVERIFY2(std::abs(table.valueRounding[0] - std::abs(rounding)) < 1e-12,
                qPrintable(QString::number(table.valueRounding[0])));
            const std::uint32_t filled = start == 0.0 ? 1 : 3;
            QCOMPARE(table.result.columns[0].filled, std::vector{filled});
            QVERIFY(contains(conversionReport(*conversion, request), "values of the file are"));
        }
    }

    void roundingOfEachColumnHasItsOwnUnit()
    {
        NeutralTable table = exampleTable(1, SignConvention::Feedback);
        table.columns.push_back(table.columns[0]);
        table.columns[0].unit = "mm";
        table.columns[0].values[1] = 1.0 / 3.0;
        table.columns[1].target = "Z";
        table.columns[1].unit = "arcsec";
        table.columns[1].values[1] = 2.0 / 3.0;
        TableConversion conversion;
        conversion.result = table;
        conversion.valueRounding = {0.02, 0.25};
        conversion.positionRounding = {0.5};
        const std::vector<Text> lines = conversionReport(
            {{}, {conversion}, {}}, requestFor(calibration_csv::format(), isg_ssfk::format()));
        QVERIFY(contains(lines, "values of the file are rounded by up to 0.02 mm"));
        QVERIFY(contains(lines, "values of the file are rounded by up to 0.25 arcsec"));
        QVERIFY(contains(lines, "positions of the file are rounded by up to"));
    }
};

AXISCOMP_TEST(TestConversion)

} // namespace tst_conversion

#include "tst_conversion.moc"
