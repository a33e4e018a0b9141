// SPDX-License-Identifier: GPL-3.0-or-later
// Lines are taken apart in blocks of characters: where one ends must make no difference.
#include "core/text/character_set.h"
#include "tests/core/formats/format_checks.h"
#include "tests/support/test_registry.h"

namespace tst_longlines {

using namespace axiscomp;
using test::problemLines;

namespace {

/// A file with a '~' where there may be any number of blanks, and a '?' where a number is wrong;
/// none where it is the line that is.
struct Sample {
    const char* name;
    const TableFormat* format;
    std::string text;
    FormatSettings settings = {};
};

const std::vector<Sample>& samples()
{
    static const std::vector<Sample> all{
        {"softMC", &softmc::format(), "~2 ~2 2\n~0 0~ 1\n10~0~-0.25\n0 5~\t3\n~10~5~?4e-3~\n",
            {{"position-unit", "mm"}, {"value-unit", "mm"}}},
        {"Aerotech", &aerotech_1d::format(),
            ":START 1~SAMPLEDIST=5~POSUNIT=METRIC CORUNIT=METRIC/1000\n"
            "~1,~-2.125~; four, five 6\n~?3~4~' 7 8\n~;9\n:END\n"},
        {"RapidCode", &rapidcode::format(),
            "# RapidCode compensator table\n# input.1.min~=~10\n# input.1.max = 40~\n"
            "# input.1.delta = 10\n# input.1.unit = mm\n# output.unit = mm\n"
            "# output.counts-per-unit =~1000\n~1~,~-20~,?3,4~\n"},
        {"height map", &reprap::format(),
            "RepRapFirmware height map file v2 generated at 2021-04-05 06:07, mean error 0.010, "
            "deviation 0.002\nxmin,xmax,ymin,ymax,radius,xspacing,yspacing,xnum,ynum\n"
            "10.00,~115.00,20.00,220.00,-1.00,50.00~,200.00,3,2\n"
            "~0.100,~-0.200,  0.001~\n~0.300~,~?0.400,~0.500~\n"},
        {"bed mesh", &klipper::format(),
            "[bed_mesh default]\nversion~= 1\npoints =~\n  ~-0.1,~0.0,~0.1 # ~ 7\n"
            "  ~0.2~,~?0.3,0.4~;~8\nx_count = 3\ny_count = 2\nmin_x =~10\nmax_x = 110\n"
            "min_y = 20\nmax_y = 220\n"},
        {"ISG", &isg_crosscomp::format(),
            "~kopf.achs_nr~3\nkw.crosscomp.unit 1~(0.1 um)\nkw.crosscomp.master_ax_nr~1\n"
            "kw.crosscomp.last_index 1\n#~a comment ~ 7\n"
            "kw.crosscomp.table[0].setpoint~0\n~kw.crosscomp.table[~0~].correction 10~a comment\n"
            "kw.crosscomp.table[1].setpoint 100000\nkw.crosscomp.table[1].correction ~?-30~7\n",
            {{"master-kind", "linear"}, {"axis-kind", "linear"}}},
        {"LinuxCNC", &linuxcnc::format(), "0.0~0.1~-0.1\n~1.0 ~0.2 -0.2~\n2.0 0.3 -0.3\n",
            {{"position-unit", "mm"}, {"type", "1"}}},
        {"iCube", &icube::format(), "0;~0.1\n~10 ;~0.2~\n20; ?0.3 ~\n", {{"position-unit", "mm"}}},
    };
    return all;
}

std::string filled(std::string text, std::size_t blanks, const char* fault)
{
    std::string result;
    for (const char c : text)
        result += c == '~' ? std::string(blanks, ' ') : c == '?' ? fault : std::string(1, c);
    return result;
}

/// Where the '?' stands in the text with so many blanks, from 1.
std::pair<std::size_t, std::size_t> placeOfFault(const std::string& text, std::size_t blanks)
{
    const std::string before = filled(text.substr(0, text.find('?')), blanks, "");
    const std::size_t lines = static_cast<std::size_t>(std::ranges::count(before, '\n'));
    return {lines + 1, before.size() - before.rfind('\n')};
}

} // namespace

class TestLongLines : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void blanksOfAnyNumberMakeNoDifference_data()
    {
        addSamples([](const Sample&) { return true; });
    }
    void blanksOfAnyNumberMakeNoDifference()
    {
        QFETCH(int, sample);
        const auto& [name, format, text, settings] = samples()[static_cast<std::size_t>(sample)];
        const TableReadOptions options = test::readingWith(settings);
        READ_TABLE(plain, *format, filled(text, 1, ""), options);
        for (std::size_t blanks = 1; blanks < 2 * CharacterSet::blockSize + 2; ++blanks) {
            for (const char* end : {"\n", "\r\n", "\r"}) {
                std::string file;
                for (const char c : filled(text, blanks, ""))
                    file += c == '\n' ? end : std::string(1, c);
                READ_TABLE(table, *format, file, options);
                COMPARE_TABLES(table, plain, 0.0);
            }
        }
    }

    void aWrongNumberIsNamedWhereItStands_data()
    {
        addSamples([](const Sample& sample) { return sample.text.find('?') != std::string::npos; });
    }
    void aWrongNumberIsNamedWhereItStands()
    {
        QFETCH(int, sample);
        const auto& [name, format, text, settings] = samples()[static_cast<std::size_t>(sample)];
        for (std::size_t blanks = 1; blanks < 2 * CharacterSet::blockSize + 2; ++blanks) {
            const auto reading =
                format->read(filled(text, blanks, "x"), test::readingWith(settings));
            VERIFY_RESULT(reading);
            QVERIFY(reading->tables.empty());
            const auto [line, column] = placeOfFault(text, blanks);
            const std::string due =
                std::to_string(line) + ':' + std::to_string(column) + " NotANumber x";
            QVERIFY2(problemLines(*reading).starts_with(due),
                (problemLines(*reading) + " instead of " + due).c_str());
        }
    }

private:
    static void addSamples(bool (*isOne)(const Sample&))
    {
        QTest::addColumn<int>("sample");
        for (std::size_t n = 0; n < samples().size(); ++n)
            if (isOne(samples()[n]))
                QTest::newRow(samples()[n].name) << static_cast<int>(n);
    }
};

AXISCOMP_TEST(TestLongLines)

} // namespace tst_longlines

#include "tst_longlines.moc"
