// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

namespace tst_klippertwist {

using namespace axiscomp;
using test::problemLines;

namespace {

const TableFormat& format = klipper_twist::format();

/// As SAVE_CONFIG writes it, behind the settings of the module.
const std::string autosaved = "[axis_twist_compensation]\n"
                              "calibrate_start_x: 20 # of the nozzle\n"
                              "calibrate_end_x: 200\n"
                              "calibrate_y: 112.5\n\n"
                              "#*# <---------------------- SAVE_CONFIG ---------------------->\n"
                              "#*# DO NOT EDIT THIS BLOCK OR BELOW.\n"
                              "#*#\n"
                              "#*# [axis_twist_compensation]\n"
                              "#*# z_compensations = -0.050833, -0.005208, 0.056042\n"
                              "#*# compensation_start_x = 30.0\n"
                              "#*# compensation_end_x = 210.0\n"
                              "#*#\n"
                              "#*# [extruder]\n"
                              "#*# control = pid\n";
const auto with = test::changing(autosaved);

const std::string mesh = "#*# [bed_mesh default]\n#*# version = 1\n#*# points =\n#*# \t 0, 1\n"
                         "#*# \t 1, 2\n#*# x_count = 2\n#*# y_count = 2\n#*# min_x = 0\n"
                         "#*# max_x = 1\n#*# min_y = 0\n#*# max_y = 1\n";

void describe(test::FormatSample& sample)
{
    sample.facts = "feedback is read in program code; 1 to 1 dimensions, even knots; "
                   "points any, columns 1, tables 2, bytes 67108864; holds names units";
    sample.text = autosaved;
    sample.comment = "# ";
    const std::size_t needed = autosaved.find("210.0") + 3;
    sample.spareBytes = autosaved.size() - needed;
    sample.warnedBytes = needed - autosaved.find("-0.005208"); // two values, and other ends
    sample.applies({{{75}, -0.0280205}, {{120}, -0.005208}, {{165}, 0.025417},
        {{240}, 0.076458666666667}, {{0}, -0.066041333333333}});
    sample.recognises(Recognition::Certain, {autosaved, autosaved + "[bed_mesh]\nspeed: 120\n"});
    sample.recognises(Recognition::No,
        {autosaved + mesh, mesh, "[axis_twist_compensation]\ncalibrate_start_x: 20\n",
            "z_compensations = 1, 2\n"});
    // The ends, as earlier firmware had them.
    const std::string between = with("#*# compensation_start_x = 30.0\n"
                                     "#*# compensation_end_x = 210.0\n",
        "");
    sample.warning("ends of an earlier firmware", between,
        {"2:0 Assumption calibrate_start_x and calibrate_end_x as the ends of z_compensations|"
         "compensation_start_x and compensation_end_x"});
    sample.applies({{{110}, -0.005208}, {{20}, -0.050833}}, between);
    sample.warning("ends of the first firmware",
        "[axis_twist_compensation]\nz_compensations: 1,\n  2,\n  4\nstart_x: 0\nend_x = 10\n",
        {"5:0 Assumption start_x and end_x as the ends"});
    sample.warning("values between commas without blanks",
        with("-0.050833, -0.005208, 0.056042", "-0.050833,0.005208,0.056042"), {});
    sample.warning("an entry twice",
        autosaved
            + "#*# [axis_twist_compensation]\n"
              "#*# compensation_end_x = 390\n",
        {"17:5 Assumption a second compensation_end_x|each entry once"});
    sample.applies({{{210}, -0.005208}},
        autosaved
            + "#*# [axis_twist_compensation]\n"
              "#*# compensation_end_x = 390\n");

    const auto row = sample.problemRow();
    row("no section", "[printer]\nkinematics: corexy\n",
        "0:0 Syntax |a section [axis_twist_compensation] with z_compensations or zy_compensations");
    row("no values", "[axis_twist_compensation]\ncalibrate_start_x: 20\n", "1:0 Syntax |a section");
    row("no ends", "[axis_twist_compensation]\nz_compensations: 1, 2\nstart_x: 1\n",
        "1:0 Syntax axis_twist_compensation|entries compensation_start_x and compensation_end_x");
    row("one value", with("-0.050833, -0.005208, 0.056042", "-0.05"),
        "10:0 TooFewPoints 1 value|at least 2");
    row("an empty list", with("-0.050833, -0.005208, 0.056042", ""),
        "1:0 TooFewPoints 0 values|at least 2");
    row("a value that is none", with("-0.005208", "-0.005208mm"),
        "10:34 NotANumber -0.005208mm|a value in mm");
    row("decimal commas", with("-0.050833, -0.005208, 0.056042", "-0,05, -0,005, 0,056"),
        "10:23 NotANumber -0,05|decimal points, and a comma with a blank between the values");
    row("a value is missing", with("-0.005208,", ","), "10:34 NotANumber |a value in mm");
    row("start is end", with("= 210.0", "= 30"), "12:0 NotMonotonic 30 after 30|an end above");
    row("an end that is none", with("= 210.0", "= right"), "12:26 NotANumber right|a position");
    row("no entry", with("#*# compensation_start_x = 30.0", "#*# compensation"),
        "11:5 Syntax compensation|an entry such as");
}

} // namespace

class TestKlipperTwist : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theListsOfBothAxesAreTables()
    {
        const std::string text = autosaved
            + "#*# [axis_twist_compensation]\n#*# zy_compensations = 0.5, 0.25\n"
              "#*# compensation_start_y = 5\n#*# compensation_end_y = 15\n";
        const auto reading = format.read(text, {});
        VERIFY_RESULT(reading);
        QVERIFY2(problemLines(*reading).starts_with(
                     "warning 0:0 Assumption several tables of X to Z, Y to Z|their sum"),
            problemLines(*reading).c_str());
        QCOMPARE(reading->tables.size(), std::size_t{2});
        const NeutralTable& x = reading->tables[0];
        const NeutralTable& y = reading->tables[1];
        QCOMPARE(x.axes[0].name + y.axes[0].name, std::string("XY"));
        QCOMPARE(x.columns[0].target + y.columns[0].target, std::string("ZZ"));
        QCOMPARE(x.axes[0].knots, (std::vector<double>{30, 120, 210}));
        QCOMPARE(y.axes[0].knots, (std::vector<double>{5, 15}));
        QCOMPARE(x.axes[0].unit + x.columns[0].unit, std::string("mmmm"));
        QVERIFY(!ownAxis(x, x.columns[0]));
    }

    /// More than half of the public files have both: then the mesh is what is meant.
    void besideAMeshTheMeshIsMeant()
    {
        const FormatGuess guess = guessFormat(autosaved + mesh, "printer.cfg");
        QVERIFY(guess.isCertain);
        QCOMPARE(guess.formats.front(), &klipper::format());
        QVERIFY(guessFormat(autosaved, "printer.cfg").formats.front() == &format);
        READ_TABLE(table, format, autosaved + mesh, {});
        QCOMPARE(table.pointCount(), std::size_t{3});
    }
};

AXISCOMP_TEST(TestKlipperTwist)
AXISCOMP_FORMAT(format, describe)

} // namespace tst_klippertwist

#include "tst_klippertwist.moc"
