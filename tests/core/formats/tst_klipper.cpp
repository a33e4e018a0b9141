// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

namespace tst_klipper {

using namespace axiscomp;
using test::problemLines;

namespace {

const TableFormat& format = klipper::format();

/// As SAVE_CONFIG writes it, behind other settings.
const std::string autosaved = "[printer]\nkinematics: corexy\n\n"
                              "[bed_mesh]\nspeed: 120\nmesh_min: 10, 20 # settings, no table\n\n"
                              "#*# <---------------------- SAVE_CONFIG ---------------------->\n"
                              "#*# DO NOT EDIT THIS BLOCK OR BELOW.\n"
                              "#*#\n"
                              "#*# [bltouch]\n"
                              "#*# z_offset = 2.290\n"
                              "#*#\n"
                              "#*# [bed_mesh default]\n"
                              "#*# version = 1\n"
                              "#*# points =\n"
                              "#*# \t  -0.100000, 0.000000, 0.100000\n"
                              "#*# \t  0.200000, 0.300000, 0.400000\n"
                              "#*# x_count = 3\n"
                              "#*# y_count = 2\n"
                              "#*# mesh_x_pps = 2\n"
                              "#*# mesh_y_pps = 2\n"
                              "#*# algo = bicubic\n"
                              "#*# tension = 0.2\n"
                              "#*# min_x = 10.0\n"
                              "#*# max_x = 110.0\n"
                              "#*# min_y = 20.0\n"
                              "#*# max_y = 220.0\n"
                              "#*#\n"
                              "#*# [extruder]\n"
                              "#*# control = pid\n";

/// A section with some entries replaced: "" leaves an entry out.
std::string section(std::map<std::string, std::string> changed, std::string name = "default")
{
    std::map<std::string, std::string> entries{{"max_x", "100"}, {"max_y", "50"}, {"min_x", "0"},
        {"min_y", "0"}, {"points", "\n  1, 2\n  3, 4"}, {"x_count", "2"}, {"y_count", "2"}};
    for (const auto& [key, value] : changed)
        entries[key] = value;
    std::string text = "[bed_mesh " + name + "]\n";
    for (const auto& [key, value] : entries)
        if (!value.empty())
            text += key + " = " + value + "\n";
    return text;
}

void describe(test::FormatSample& sample)
{
    sample.facts = "command is read in program code; 2 to 2 dimensions, even knots; "
                   "points any, columns 1, tables any, bytes 67108864; holds names units";
    sample.text = autosaved;
    sample.comment = "# ";
    sample.spareBytes = autosaved.size() - autosaved.find("20.0\n#*#\n#*# [ext") - 1;
    sample.applies({{{110, 20}, 0.1}, {{10, 220}, 0.2}, {{85, 120}, (0.05 + 0.35) / 2},
        {{0, 0}, -0.1}, {{1000, 1000}, 0.4}, {{60, -5}, 0.0}});
    sample.recognises(Recognition::Certain, {autosaved, section({})});
    sample.recognises(Recognition::No, {"[bed_mesh]\nspeed = 1\n", "0 1\n1 1\n"});
    sample.warning("an unknown entry of the profile, and one of another section",
        "[probe]\nspeed = 5\n" + section({{"temperature", "60"}}),
        {"11:1 UnknownKey temperature|"});

    const auto row = sample.problemRow();
    row("no profile", "[bed_mesh]\nspeed = 1\n", "0:0 Syntax |a section [bed_mesh NAME]");
    row("no points", section({{"points", ""}}), "1:0 Syntax bed_mesh default|an entry points");
    row("points without heights", section({{"points", "\n"}}),
        "1:0 MissingPoint 0 lines of points|2, as y_count says");
    row("no count", section({{"x_count", ""}}), "1:0 Syntax bed_mesh default|an entry x_count");
    row("no maximum", section({{"max_y", ""}}), "1:0 Syntax bed_mesh default|an entry max_y");
    row("count is none", section({{"y_count", "2.5"}}), "10:11 NotANumber 2.5|a number of");
    row("one point", section({{"x_count", "1"}}), "9:11 TooFewPoints x_count = 1|at least 2");
    row("negative", section({{"x_count", "-3"}}), "9:11 TooFewPoints x_count = -3|");
    row("a thousand million points",
        section({{"x_count", "1000000000"}, {"y_count", "1000000000"}}),
        "1:0 MissingPoint 2 lines of points|1000000000, as y_count says");
    row("line too short", section({{"points", "\n  1, 2\n  3"}}),
        "8:0 ColumnCount 1 height|2, as x_count says");
    row("line too long", section({{"points", "\n  1, 2, 3\n  3, 4"}}),
        "7:0 ColumnCount 3 heights|2, as x_count says");
    row("too few lines", section({{"points", "\n  1, 2"}}),
        "1:0 MissingPoint 1 line of points|2, as y_count says");
    row("too many lines", section({{"points", "\n  1, 2\n  3, 4\n  5, 6"}}),
        "1:0 Contradiction 3 lines of points|2, as y_count says");
    row("height is none", section({{"points", "\n  1, x\n  3, 4"}}),
        "7:6 NotANumber x|a height in mm");
    row("height is not finite", section({{"points", "\n  1, nan\n  3, 4"}}),
        "7:6 NotANumber nan|a height in mm");
    row("height is missing", section({{"points", "\n  1,\n  3, 4"}}),
        "7:5 NotANumber |a height in mm");
    row("minimum is none", section({{"min_x", "left"}}), "4:9 NotANumber left|a position");
    row("no range", section({{"min_x", "100"}}),
        "2:0 NotMonotonic max_x = 100 after min_x = 100|a maximum above the minimum");
    row("positions without a difference",
        section({{"min_x", "1e17"}, {"max_x", "100000000000000016"}, {"x_count", "3"},
            {"points", "\n  1, 2, 3\n  3, 4, 5"}}),
        "0:0 NotFinite positions of X|numbers that a computer can tell");
    row("another version", section({{"version", "2"}}),
        "9:11 Contradiction version 2|1; the firmware");
    row("entry twice", section({}) + "min_x = 3\n", "11:1 Contradiction a second min_x|");
    row("profile twice", section({}) + section({}),
        "11:2 Contradiction a second section for the profile default|");
    row("no entry", section({}) + "heights\n", "11:1 Syntax heights|an entry such as");
    row("continued entry", section({}) + "  5, 6\n", "11:3 Syntax 5, 6|an entry such as");
    row("cut off", autosaved.substr(0, autosaved.find("0.400000")),
        "14:0 Syntax bed_mesh default|an entry x_count");
}

} // namespace

class TestKlipper : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aProfileThatWasSavedIsRead()
    {
        READ_TABLE(table, format, autosaved, {});
        QCOMPARE(problemLines(*reading_table), std::string());
        QCOMPARE(table.name, std::string("default"));
        QCOMPARE(table.axes[0].knots, (std::vector<double>{10, 60, 110}));
        QCOMPARE(table.axes[1].knots, (std::vector<double>{20, 220}));
        QCOMPARE(table.axes[0].name + table.axes[1].name, std::string("XY"));
        QCOMPARE(table.columns[0].target, std::string("Z"));
        QCOMPARE(table.columns[0].unit, std::string("mm"));
    }

    void theLinesAreThoseOfYBeginningAtItsMinimum()
    {
        READ_TABLE(table, format, autosaved, {});
        QCOMPARE(table.columns[0].values, (std::vector<double>{-0.1, 0, 0.1, 0.2, 0.3, 0.4}));
        QVERIFY(!ownAxis(table, table.columns[0])); // looked up at X and Y, which stay
    }

    void aProfileInThePlainPartIsRead()
    {
        const std::string text = "[bed_mesh default]\r\n# comment\r\nversion: 1 ; comment\r\n"
                                 "points: 1, 2\r\n  3, 4 # comment\r\n\r\nx_count: 2\r\n"
                                 "y_count: 2\r\nmin_x: 0\r\nmax_x: 1\r\nmin_y: 0\r\nmax_y: 1\r\n";
        READ_TABLE(table, format, text, {});
        QCOMPARE(problemLines(*reading_table), std::string());
        QCOMPARE(table.columns[0].values, (std::vector<double>{1, 2, 3, 4}));
    }

    void aPlainProfileEndsWhereSaveConfigBegins()
    {
        const auto reading =
            format.read(section({}, "plain") + autosaved.substr(autosaved.find("#*#")), {});
        VERIFY_RESULT(reading);
        QCOMPARE(problemLines(*reading), std::string());
        QCOMPARE(reading->tables.size(), std::size_t(2));
        QCOMPARE(reading->tables[0].name, std::string("plain"));
        QCOMPARE(reading->tables[0].columns[0].values, (std::vector<double>{1, 2, 3, 4}));
        QCOMPARE(reading->tables[1].name, std::string("default"));
    }

    void olderFilesAddAnOffset()
    {
        READ_TABLE(table, format, section({{"x_offset", "5"}, {"y_offset", "-1"}}), {});
        QCOMPARE(table.axes[0].knots, (std::vector<double>{5, 105}));
        QCOMPARE(table.axes[1].knots, (std::vector<double>{-1, 49}));
    }

    /// 0.1 + 5 * ((110.3 - 0.1) / 5) is less than 110.3.
    void theLastPointsAreExactlyAtTheMaxima()
    {
        READ_TABLE(table, format,
            section({{"points", "\n  1, 2, 3, 4, 5, 6\n  1, 2, 3, 4, 5, 6"}, {"x_count", "6"},
                {"min_x", "0.1"}, {"max_x", "110.3"}}),
            {});
        QCOMPARE(table.axes[0].knots.size(), std::size_t{6});
        QVERIFY(table.axes[0].knots.back() == 110.3);
    }

    void eachProfileIsATable()
    {
        const auto reading = format.read(section({}) + section({}, "hot bed"), {});
        VERIFY_RESULT(reading);
        QCOMPARE(problemLines(*reading), std::string());
        QCOMPARE(reading->tables.size(), std::size_t(2));
        QCOMPARE(reading->tables[1].name, std::string("hot bed"));
    }

    void twoMegabytesAreReadWhole()
    {
        std::string points;
        for (int y = 0; y < 500; ++y) {
            points += "\n  ";
            for (int x = 0; x < 500; ++x)
                points += (x == 0 ? "0.012" : ", -0.012");
        }
        READ_TABLE(table, format,
            section({{"points", points}, {"x_count", "500"}, {"y_count", "500"}}), {});
        QCOMPARE(table.pointCount(), std::size_t(250000));
    }
};

AXISCOMP_TEST(TestKlipper)
AXISCOMP_FORMAT(format, describe)

} // namespace tst_klipper

#include "tst_klipper.moc"
