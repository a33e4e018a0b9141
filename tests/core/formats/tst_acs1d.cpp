// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/sign_conversion.h"
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

#include <algorithm>

namespace tst_acs1d {

using namespace axiscomp;
using test::applied;
using test::changed;
using test::hasProblem;
using test::problemLines;

namespace {

const TableFormat& format = acs_1d::format();

/// As public programs have it, with numbers of docs/formats.md's kind.
const std::string program = "! map of the laser\n"
                            "GLOBAL REAL STATIC XMAP(5)\n"
                            "Base = -66\n"
                            "Step = 20\n"
                            "XMAP(0)= 0 ;  ! comment\n"
                            "XMAP(1)=0.0021\n"
                            "XMAP(2)=0.0035\n"
                            "XMAP(3)=-0.0012\n"
                            "XMAP(4)=-0.0042\n"
                            "ERRORUNMAP 0, 0\n"
                            "ERRORMAP1D 0, 0, Base, Step, XMAP\n"
                            "ERRORMAPON 0, 0\n";
const auto with = test::changing(program);

const std::string values = "XMAP(0) = 0\nXMAP(1) = 0.0021\nXMAP(2) = 0.0035\n"
                           "XMAP(3) = -0.0012\nXMAP(4) = -0.0042\n";
const std::string connected = values
    + "MFLAGS(0).#DEFCON = 0\n"
      "CONNECT RPOS(0) = APOS(0) + MAP(APOS(0), XMAP, -66, 20)\nDEPENDS 0, 0\n";

const FormatSettings inMillimetres{{"position-unit", "mm"}};

NeutralTable exampleTable()
{
    return test::commandTable({test::evenAxis("0", "mm", -66, 20, 5)},
        {test::columnOf("0", "mm", {0, 0.0021, 0.0035, -0.0012, -0.0042})});
}

void describeWriting(test::FormatSample& sample)
{
    sample.writing = test::writingWith({{"axis", "0"}});
    sample
        .writes(
            "the command", {changed(exampleTable(), [](NeutralTable& t) { t.notes = {"a note"}; })})
        .as("! a note\nGLOBAL REAL STATIC ERRORMAP(5)\nERRORMAP(0) = 0\nERRORMAP(1) = 0.0021\n"
            "ERRORMAP(2) = 0.0035\nERRORMAP(3) = -0.0012\nERRORMAP(4) = -0.0042\n"
            "ERRORUNMAP 0, 0\nERRORMAP1D 0, 0, -66, 20, ERRORMAP\nERRORMAPON 0, 0\nSTOP\n")
        .remarking({"must not have declared the array ERRORMAP", "ERRORMAPOFF",
            "ERRORUNMAP 0, 0 removes"});
    sample.writes("CONNECT", {exampleTable()})
        .with({{"axis", "0"}, {"form", "connect"}, {"name", "Map_2"}, {"declare", "no"}})
        .as("Map_2(0) = 0\nMap_2(1) = 0.0021\nMap_2(2) = 0.0035\nMap_2(3) = -0.0012\n"
            "Map_2(4) = -0.0042\nMFLAGS(0).#DEFCON = 0\n"
            "CONNECT RPOS(0) = APOS(0) + MAP(APOS(0), Map_2, -66, 20)\nDEPENDS 0, 0\nSTOP\n")
        .remarking({"must have declared the array Map_2", "replaces an error map"});
    sample.writes("another axis and zone", {exampleTable()})
        .with({{"axis", "12"}, {"zone", "3"}})
        .containing({"ERRORUNMAP 12, 3\n", "ERRORMAP1D 12, 3, -66", "ERRORMAPON 12, 3\n"})
        .becoming(changed(
            exampleTable(), [](NeutralTable& t) { t.axes[0].name = t.columns[0].target = "12"; }));
    const auto tiny = test::commandTable(
        {test::evenAxis("0", "mm", 0.1, 0.1, 3)}, {test::columnOf("0", "mm", {1e-7, -2, 0})});
    sample.writes("small numbers without an exponent, distances without noise", {tiny})
        .containing({"ERRORMAP(0) = 0.0000001\n", ", 0.1, 0.1, ERRORMAP\n"})
        .within(0, 1e-15);
    const auto micrometres = changed(exampleTable(), [](NeutralTable& t) {
        t.columns[0].unit = "um";
        t.columns[0].values = {0, 2.1, 3.5, -1.2, -4.2};
    });
    sample.writes("values in the unit of the positions", {micrometres})
        .becoming(exampleTable())
        .within(1e-15, 0)
        .remarking({"positions and values are in mm"});
    sample.refuses("another axis",
        {changed(exampleTable(), [](NeutralTable& t) { t.columns[0].target = "other"; })},
        ErrorCode::FormatCannotHold, "corrects an axis by its own position");
    const auto refusesSetting = [&](const char* name, const char* key, const char* value) {
        FormatSettings given{{"axis", "0"}};
        given[key] = value;
        sample.refuses(name, {exampleTable()}, ErrorCode::InvalidArgument, key, given);
    };
    refusesSetting("an axis below 0", "axis", "-1");
    refusesSetting("a zone below 0", "zone", "-2");
    refusesSetting("a name with a digit first", "name", "2MAP");
    refusesSetting("a name with a blank", "name", "MY MAP");
    refusesSetting("a word of the language", "name", "connect");
    refusesSetting("a word that ends a block", "name", "End");
}

void describeBranches(test::FormatSample& sample)
{
    const auto row = sample.problemRow();
    const auto in = [&](const char* name, const std::string& open, const std::string& close) {
        row(std::string("an element within ") + name,
            with("XMAP(2)=0.0035", open + "\nXMAP(2)=0.0035\n" + close),
            std::to_string(8 + std::ranges::count(open, '\n'))
                + ":9 Syntax 0.0035|a number outside of IF, ELSE, SWITCH, LOOP, WHILE and ON; ");
    };
    in("IF", "if (FAULT(0).#LL = 1)", "end");
    in("ELSE", "IF CH = 1\nELSE", "END");
    in("ELSEIF", "IF CH = 1\nELSEIF CH = 2", "END");
    in("LOOP", "LOOP 3", "END");
    in("WHILE", "WHILE(I<3)", "END");
    in("ON", "ON MFLAGS(0).#HOME", "RET");
    in("a case", "SWITCH (CH)\nCASE 1:\nI = 1\nCASE 2:", "END\nEND");
    in("a block of IF", "IF 0; BLOCK", "END; END");
    in("IF in ON", "ON 1; IF 0; RET", "END; RET");
    row("a base within IF", with("Step = 20", "IF MFLAGS(0).#HOME\nBase = -56\nEND\nStep = 20"),
        "14:18 NotANumber Base|a name that got a number outside of IF, ELSE, SWITCH, LOOP, WHILE "
        "and ON; only the controller knows whether that of line 5 counts");
    row("a zone within WHILE", "WHILE 1; Zone = 0; END\n" + with("1D 0, 0", "1D 0, Zone"),
        "12:15 NotANumber Zone|a name that got a number outside of IF");
    row("a base of the other branch",
        "IF CH = 1\nBase = -66\nELSE\n" + with("Base = -66\n", "") + "END\n",
        "13:18 NotANumber Base|a name that got a number outside of IF");
    row("a base that the loop changes", "LOOP 2\n" + program + "Base = Base + 100\nEND\n",
        "12:18 NotANumber Base|one number; line 14 gives it another one for the next pass");
    row("other numbers in other subroutines",
        "Base = 1\nSTOP\nYComp:\nBase = 2\nRET\nXComp:\n" + with("Base = -66\n", ""),
        "16:18 NotANumber Base|one number; another part of the program gives it another one in "
        "line 4");
    row("other numbers in ON",
        "Base = 1\nGOTO XComp\nON S_ST.#DC\nBase = 1.5\nRET\nXComp:\n" + with("Base = -66\n", ""),
        "16:18 NotANumber Base|one number; another part of the program");
}

void describeBlocks(test::FormatSample& sample)
{
    const auto reads = [&](const char* name, const std::string& text) {
        sample.warning(name, text, {});
        sample.applies({{{-51}, 0.001575}, {{100}, -0.0042}}, text);
    };
    reads("a map in the branch of its numbers",
        "IF Comp = 1\n" + program + "ELSE\nBase = 0\nDISP \"off\"\nEND\n");
    reads("a map in a branch, its numbers outside",
        with("ERRORUNMAP", "IF Comp = 1; LOOP 1\nERRORUNMAP") + "END; END\n");
    reads("a number behind blocks that have ended",
        with("XMAP(2)=0.0035",
            "IF 0; I=1; ELSE I=2; LOOP 2; I=3; END; END; BLOCK; XMAP(2)=0.0035; END"));
    reads("a number behind the cases of SWITCH",
        with("XMAP(2)", "SWITCH (CH); CASE 1: I=1; END; DEFAULT: I=2; END; END; XMAP(2)"));
    reads("a number behind ON", with("XMAP(2)", "ON CH; IF I; RET; END; RET; XMAP(2)"));
    reads("waiting and homing elsewhere",
        "#1\nAUTOEXEC:\nWHILE 1\n  TILL HomeRequest\n  IF ^MST(0).#ENABLED\n    ENABLE 0\n"
        "    TILL MST(0).#ENABLED, 1000\n  ELSEIF FAULT(0).#LL | FAULT(0).#RL\n    GOTO Failed\n"
        "  END\n  HomeRequest = 0\nEND\nFailed:\nSTOP\nON ^HomeRequest\nBLOCK\n  IF S_ST.#DC\n"
        "    STOPDC\n  END\nEND\nRET\n#2\n"
            + program);
    reads("a subroutine with numbers of its own", "Base = 5\nSTOP\nXComp:\n" + program + "RET\n");
    reads("a subroutine with a number of the main program",
        "Base = -66\nCALL XComp\nSTOP\nXComp:\n" + with("Base = -66\n", ""));
    reads("labels that the program runs through",
        "Main: Base = -66\nSTOP 8\nXComp:\n" + with("Base = -66\n", "")
            + "STOP\nYComp: Base = 7\nRET\n");
}

void describeSecondNumbers(test::FormatSample& sample)
{
    const auto twice = [&](const char* name, const std::string& text, const char* line) {
        sample.warning(name, text, {line});
    };
    twice("a step twice", with("Step = 20", "Step = 10\nStep = 20"),
        "5:8 DuplicateValue Step a second time|each value once; the last one counts");
    sample.applies({{{-51}, 0.001575}}, with("Step = 20", "Step = 10\nStep = 20"));
    twice("an axis twice", with("ERRORMAP1D 0", "Axis = 1; Axis = 0\nERRORMAP1D Axis"),
        "11:18 DuplicateValue Axis a second time|");
    twice("an axis twice, named three times",
        "A = 1; A = 0\n"
            + test::with(
                connected, "RPOS(0) = APOS(0) + MAP(APOS(0)", "RPOS(A) = APOS(A) + MAP(APOS(A)"),
        "1:12 DuplicateValue A a second time|");
    sample.warning("the same step twice", with("Step = 20", "Step = 20; Step = 20.0"), {});
}

void describeChanges(test::FormatSample& sample)
{
    const auto row = sample.problemRow();
    for (const std::string statement : {"COPY(YMAP, XMAP)", "dshift(xmap, 1)",
             "DC/c XMAP, 5, 1, FPOS(0)", "INPUT XMAP", "Correct(XMAP)", "ECIN(242, XMAP(0))",
             "XMAP(1) += 7", "XMAP(1)++", "--XMAP(1)", "XMAP(2).0 = 1"})
        row("behind the elements: " + statement, with("ERRORUNMAP", statement + "\nERRORUNMAP"),
            "10:1 NotANumber " + statement
                + "|numbers for the elements of XMAP alone; what else changes the array behind");
    for (const std::string statement :
        {"Step += 20", "step /= 2", "Step++", "++Step", "Step.1 = 1", "READ Step", "Ask(0, Step)"})
        row("before the map: " + statement, with("XMAP(0)", statement + "\nXMAP(0)"),
            "12:24 NotANumber Step|a name that got a number; in line 5 it gets something that is "
            "not computed here");
    sample.warning("an array is copied before its elements",
        with("XMAP(0)", "COPY(YMAP, XMAP); XMAP(3)++\nXMAP(0)"), {});
    sample.warning("statements that use numbers and change none",
        with("ERRORUNMAP",
            "DISP XMAP(0), Step; WRITE XMAP; PTP/e 0, Base; ENABLE (Base); WAIT Step\n"
            "TILL XMAP(0); SET FPOS(0) = Base; VEL(Base) = Step; FDEF(Base).#SLL = 0; IMM "
            "ACC(0)=5\n"
            "I = MAX(XMAP) + Step; IF XMAP(0) > Base; END; COPY(YMAP, ZMAP); Ask(XMAP(0) + Step)\n"
            "ERRORUNMAP"),
        {});
}

void describeProblems(test::FormatSample& sample)
{
    const auto row = sample.problemRow();
    row("no map", values, "0:0 Syntax |a statement ERRORMAP1D, or CONNECT with MAP");
    row("the whole array is scaled behind its elements", program + "XMAP=XMAP*0.001\n",
        "13:6 NotANumber XMAP*0.001|numbers for the elements of XMAP alone");
    row("the whole array is filled behind its elements", program + "FILL(0, xmap)\n",
        "13:1 NotANumber FILL(0, xmap)|numbers for the elements of XMAP alone");
    row("the whole array is read behind its elements", program + "READ XMAP\n",
        "13:1 NotANumber READ XMAP|numbers for the elements of XMAP alone");
    row("an index is missing", with("XMAP(2)=0.0035\n", ""),
        "10:30 MissingPoint no XMAP(2)|a number for each element");
    row("a huge index", with("XMAP(4)", "XMAP(2000000000)"), "2:20 Contradiction XMAP(5)|XMAP(2");
    row("a huge index of an array that is declared elsewhere",
        test::with(with("XMAP(4)", "XMAP(2000000000)"), "GLOBAL REAL STATIC XMAP(5)", ""),
        "11:30 MissingPoint no XMAP(4)|");
    row("declared too small", with("XMAP(5)", "XMAP(4)"), "2:20 Contradiction XMAP(4)|XMAP(5)");
    row("declared with two indices", with("XMAP(5)", "XMAP(5)(2)"),
        "2:20 Contradiction XMAP with another number of indices|XMAP(5)");
    row("a long name of an array",
        "A" + std::string(1000, 'B') + "(1)=1\nERRORMAP1D 0,0,0,1,A" + std::string(1000, 'B')
            + "\nERRORMAPON 0,0\n",
        "2:20 MissingPoint no A" + std::string(39, 'B') + "…(0)|");
    row("an expression", with("=0.0035", "=0.0007*5"), "7:9 NotANumber 0.0007*5|a number with");
    row("half a number", with("=0.0035", "=0.0035mm"), "7:9 NotANumber 0.0035mm|");
    row("a decimal comma", with("=0.0035", "=0,0035"),
        "7:9 NotANumber 0,0035|a number with a decimal point");
    row("no finite number", with("=0.0035", "=1e999"), "7:9 NotANumber 1e999|");
    row("two signs", with("=-0.0012", "=--0.0012"), "8:9 NotANumber --0.0012|");
    row("an index that is computed", with("XMAP(2)", "XMAP(I+1)"), "7:6 NotANumber I+1|an index");
    row("a negative index", with("XMAP(2)", "XMAP(-1)"), "7:6 NotANumber -1|an index");
    row("two indices", with("XMAP(2)", "XMAP(2)(0)"), "7:12 Syntax 0.0035|one index of XMAP");
    row("an array of whole numbers", with("REAL", "INT"),
        "6:9 Contradiction 0.0021|a whole number, since XMAP is declared INT");
    row("an array without elements", with("Step, XMAP", "Step, YMAP"),
        "11:30 Syntax YMAP|an array");
    row("a number for an array", with("Step, XMAP", "Step, 5"), "11:30 Syntax 5|an array");
    row("one element", "A(0)=1\nERRORMAP1D 0,0,0,1,A\nERRORMAPON 0,0\n", "2:0 TooFewPoints 1 pos");
    row("a name without a value", with("Base = -66\n", ""),
        "10:18 NotANumber Base|a number, or a name that got one before");
    row("a name that gets its value later",
        test::with(with("Base = -66\n", ""), "ERRORMAPON", "Base=1\nERRORMAPON"),
        "10:18 NotANumber Base|a number, or a name that got one before");
    row("a name that is computed", with("Step = 20", "Step = 2*pi"),
        "11:24 NotANumber Step|a name that got a number; in line 4");
    row("a name that is computed in the end", with("Step = 20", "Step = 20\nStep=Step+1"),
        "12:24 NotANumber Step|a name that got a number; in line 5");
    row("an expression for the step", with("Base, Step", "Base, 2*pi"),
        "11:24 NotANumber 2*pi|a number with a decimal point, or a name");
    row("a whole number with decimals", with("Step = 20", "INT Step\nStep = 2.5"),
        "12:24 NotANumber Step|a whole number, since it is declared INT; in line 5");
    row("a step of 0", with("Step = 20", "Step = 0"), "11:1 LimitExceeded a step of 0|");
    row("a step below 0", with("Step = 20", "Step = - 20"), "11:1 LimitExceeded a step of -20|");
    row("a name that is not an axis", with("1D 0, 0", "1D X, 0"), "11:12 NotANumber X|");
    row("part of an axis", with("1D 0, 0", "1D 0.5, 0"), "11:12 LimitExceeded 0.5|a whole");
    row("another number of arguments", with("Base, Step, XMAP", "Base, XMAP"),
        "11:1 Syntax ERRORMAP1D 0, 0, Base, XMAP|ERRORMAP1D axis, zone, base, step, array");
    for (const char* command :
        {"ERRORMAPN1D", "ERRORMAPA1D", "ERRORMAP2D", "ERRORMAPN2D", "ERRORMAPA2D"})
        row(command, program + command + " 0, 0, Base, Step, XMAP\n",
            ("13:1 Syntax " + std::string(command) + ", which is not supported|").c_str());
    for (const char* function : {"MAPN", "MAPB", "MAPS"})
        row(function, program + "CONNECT RPOS(0)=APOS(0)+" + function + "(APOS(0), XMAP)\n",
            ("13:25 Syntax " + std::string(function) + ", which is not supported|").c_str());
    const auto connectRow = [&](const char* name, const char* from, const char* to) {
        const std::string text = test::with(connected, from, to);
        const std::size_t begin = text.find("CONNECT");
        row(name, text, "7:1 Syntax " + text.substr(begin, 20)); // the rest is cut off
    };
    connectRow("subtracted", "APOS(0) + MAP", "APOS(0) - MAP");
    connectRow("more than the sum", "-66, 20)", "-66, 20) + 1");
    connectRow("by another axis", "MAP(APOS(0)", "MAP(APOS(1)");
    connectRow("by another position", "MAP(APOS(0)", "MAP(RPOS(0)");
    connectRow("added to another axis", "= APOS(0)", "= APOS(1)");
    connectRow("other arguments", "XMAP, -66, 20", "XMAP, -66");
    row("only a map over two axes", "CONNECT RPOS(0) = APOS(0) + MAP2(APOS(0), APOS(1), M)\n",
        "1:29 Syntax a map over two axes (MAP2)|the format acs-2d");
    row("other numbers in other buffers",
        "#1\nBase = 1\n#2\nBase = 2\n#3\n" + with("Base = -66\n", ""),
        "15:18 NotANumber Base|one number; other buffers give it another one in line 4");
    row("a local name of another buffer",
        "#1\nLOCAL REAL Base\nBase = 1\n#2\n" + with("Base = -66\n", ""),
        "14:18 NotANumber Base|a number, or a name that got one before");
}

void describeSwitchedOff(test::FormatSample& sample)
{
    const auto ends = [&](const char* name, const std::string& text, const char* line) {
        sample.warning(name, text, {line});
    };
    ends("switched off and removed", program + "ERRORMAPOFF 0, 0\nERRORUNMAP 0, 0\n",
        "13:1 Assumption \"ERRORMAPOFF 0, 0\", which switches a table of the file off|tables that "
        "are in use; this one does not act on the machine");
    ends("removed", program + "errorunmap 0, 0\n", "13:1 Assumption \"errorunmap 0, 0\", which");
    const std::string inZone1 = test::with(
        with("ERRORMAP1D 0, 0", "ERRORMAP1D 0, 1"), "ERRORMAPON 0, 0", "ERRORMAPON 0, 1");
    ends("a zone above 0", inZone1 + "ERRORMAPOFF 0, 1\n", "13:1 Assumption \"ERRORMAPOFF 0, 1\"");
    ends("all zones of the axis", program + "ERRORMAPOFF 0\n", "13:1 Assumption \"ERRORMAPOFF 0\"");
    ends("switched off, on and off", program + "ERRORMAPOFF 0,0;ERRORMAPON 0,0\nERRORMAPOFF 0,0\n",
        "14:1 Assumption \"ERRORMAPOFF 0,0\"");
    ends("another connection", connected + "CONNECT RPOS(0) = APOS(0)\n",
        "9:1 Assumption \"CONNECT RPOS(0) = APOS(0)\"");
    ends("the own connection", connected + "MFLAGS(0).17 = 1\n",
        "9:1 Assumption \"MFLAGS(0).17 = 1\"");
    ends("the own connection by name", connected + "AXISDEF X=0\nmflags(X).#defcon=1\n",
        "10:1 Assumption \"mflags(X).#defcon=1\"");
    const auto acts = [&](const char* name, const std::string& text) {
        sample.warning(name, text, {});
    };
    acts("switched off before", "ERRORMAPOFF 0, 0\n" + program);
    acts("switched on again", program + "ERRORMAPOFF 0, 0\nERRORMAPON 0, 0\n");
    acts("another zone and another axis", program + "ERRORMAPOFF 0, 1\nERRORUNMAP 1, 0\n");
    acts("zone 0 and a map of zone 1", inZone1 + "ERRORMAPOFF 0, 0\n");
    acts("switched off in another buffer", "#1\n" + program + "#2\nERRORMAPOFF 0, 0\n");
    acts("the connection of another axis", connected + "CONNECT RPOS(1) = APOS(1)\n");
    acts("other flags", connected + "MFLAGS(0).17 = 0\nMFLAGS(0).8 = 1\nMFLAGS(1).17 = 1\n");
    acts("one of both ways",
        connected + "ERRORMAP1D 0, 0, -66, 20, XMAP\nERRORMAPON 0, 0\nCONNECT RPOS(0) = APOS(0)\n");
}

void describe(test::FormatSample& sample)
{
    sample.facts = "command is read in program code; 1 to 1 dimensions, even knots; points any, "
                   "columns 1, tables 1, bytes 67108864; holds notes";
    sample.reading = test::readingWith(inMillimetres);
    sample.text = program;
    sample.comment = "! ";
    sample.spareBytes = 1;
    sample.warnedBytes = 16;
    sample.applies({{{-51}, 0.001575}, {{-10}, -0.00026}, {{100}, -0.0042}, {{-1000}, 0}});
    sample.applies({{{-51}, 0.001575}, {{100}, -0.0042}}, connected);
    sample.recognises(Recognition::Certain,
        {program, connected, "errormap1d(0)\n",
            "connect rpos ( 1 )=apos(1)+map (apos(1),m,0,1)\n"});
    sample.recognises(Recognition::No,
        {values, "! ERRORMAP1D 0, 0, 0, 1, A\n", "DISP \"; ERRORMAP1D 0\"\n", "ERRORUNMAP 0, 0\n",
            "CONNECT RPOS(0) = APOS(0)\n", "ERRORMAP2D 0, 0\n", "ERRORMAPON 0, 0\n",
            "CONNECT RPOS(0) = APOS(0) + MAP2(APOS(0), APOS(1), M)\n"});
    sample.recognises(Recognition::Possible,
        {program + "CONNECT RPOS(0) = APOS(0) + MAP2(APOS(0), APOS(1), M)\n"});
    sample.warning("the whole array is filled before its elements",
        with("XMAP(0)= 0", "FILL(7, XMAP); XMAP = 0; XMAP(0)= 0"), {});
    sample.warning("declared longer", with("XMAP(5)", "XMAP(47)"),
        {"2:20 Assumption XMAP(47) with elements for XMAP(5)|a value for each element"});
    sample.applies({{{-51}, 0.001575}, {{100}, -0.0042}}, with("XMAP(5)", "XMAP(47)"));
    sample.warning("an element twice", with("ERRORUNMAP", "XMAP(4)=-0.004\nERRORUNMAP"),
        {"10:9 DuplicatePoint XMAP(4) a second time|each element once; the last"});
    sample.applies({{{100}, -0.004}}, with("ERRORUNMAP", "XMAP(4)=-0.004\nERRORUNMAP"));
    sample.warning("not switched on", with("ERRORMAPON 0, 0\n", "ERRORMAPON 0, 1\n"),
        {"11:1 Assumption no ERRORMAPON 0, 0|"});
    sample.warning("another map of the axis",
        program + "A(0)=1\nA(1)=2\nERRORMAP1D 0, 1, 0, 1, A\nERRORMAPON 0, 1\n",
        {"15:1 Assumption another map of axis 0, besides that of line 11|one map"});
    sample.warning("a map over two axes besides",
        program + "CONNECT RPOS(0) = APOS(0) + MAP2(APOS(0), APOS(1), M)\n",
        {"13:29 LeftOut a map over two axes (MAP2)|the format acs-2d"});
    sample.warning(
        "no unit", program, {"0:0 UnitNotGiven numbers without a unit"}, FormatSettings{});
    describeSwitchedOff(sample);
    describeBranches(sample);
    describeBlocks(sample);
    describeSecondNumbers(sample);
    describeChanges(sample);
    describeProblems(sample);
    describeWriting(sample);
}

TableReading readIt(const std::string& text)
{
    return format.read(text, test::readingWith(inMillimetres)).value();
}

} // namespace

class TestAcs1d : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theExampleIsRead()
    {
        READ_TABLE(table, format, program, test::readingWith(inMillimetres));
        COMPARE_TABLES(table, exampleTable(), 0.0);
        QCOMPARE(table.name, std::string("XMAP"));
        QCOMPARE(table.notes, (std::vector<std::string>{"map of the laser"}));
    }

    void bothWaysSayTheSame()
    {
        READ_TABLE(table, format, connected, test::readingWith(inMillimetres));
        COMPARE_TABLES(table, exampleTable(), 0.0);
    }

    /// A template uses the same array in both ways.
    void theSameMapInBothWaysIsOneTable()
    {
        QCOMPARE(readIt(connected + program).tables.size(), std::size_t(1));
    }

    /// "The last one counts" is said of a map that has it, not beside the reason why there is none.
    void aSecondNumberOfAMapThatIsRefusedIsNoWarning()
    {
        const std::string twice = with("Step = 20", "Step = 10\nStep = 20");
        const auto saysIt = [](const std::string& text) {
            return hasProblem(readIt(text), DiagnosticCode::DuplicateValue, 5);
        };
        QVERIFY2(saysIt(twice), "not said of a map that is read");
        QVERIFY2(!saysIt(test::with(twice, "Step = 20", "Step = -20")), "said of a step below 0");
        QVERIFY2(!saysIt(test::with(twice, "ERRORMAP1D 0", "ERRORMAP1D Foo")),
            "said of a map of an axis that is not known");
        QVERIFY2(!saysIt(test::with(twice, "XMAP(0)", "YMAP(0)")),
            "said of a map whose array has no first element");
        QVERIFY2(
            saysIt(test::with(twice, "ERRORMAPON", "ERRORMAP1D Foo, 0, 0, 1, XMAP\nERRORMAPON")),
            "not said of a map that is read, because another one is refused");
    }

    /// Each of two buffers may have an array of its own by the same name.
    void localArraysOfOneNameAreTwoMaps()
    {
        const TableReading reading = readIt("#1\nLOCAL REAL M(2)\nM(0)=0;M(1)=1\n"
                                            "ERRORMAP1D 0,0,0,5,M;ERRORMAPON 0,0\n"
                                            "#2\nLOCAL REAL M(2)\nM(0)=0;M(1)=-1\n"
                                            "ERRORMAP1D 0,0,0,5,M;ERRORMAPON 0,0\n");
        QVERIFY2(hasProblem(reading, DiagnosticCode::Assumption, 8), problemLines(reading).c_str());
        QCOMPARE(reading.tables.size(), std::size_t(2));
        QCOMPARE(reading.tables[0].columns[0].values, (std::vector<double>{0, 1}));
        QCOMPARE(reading.tables[1].columns[0].values, (std::vector<double>{0, -1}));
    }

    void blanksSmallLettersAndSeveralStatementsInALineAreAccepted()
    {
        const std::string text = "base=- 66;step = +20 ; xmap ( 4 ) = - .0042;XMAP(1)=21e-4\n"
                                 "  Xmap(0)=0;\tXMAP( 2)=0.0035;XMAP(3)= -0.0012;;\n"
                                 "errormap1d 0,0,BASE,STEP,xMap;ERRORMAPON 0,0\n";
        READ_TABLE(table, format, text, test::readingWith(inMillimetres));
        COMPARE_TABLES(table, exampleTable(), 0.0);
        QVERIFY2(reading_table->diagnostics.empty(), problemLines(*reading_table).c_str());
    }

    /// As the program of a machine is saved: declarations in buffer A, much else, and names of
    /// axes.
    void aSavedProgramIsRead()
    {
        const std::string text = "#/ Controller version = 2.70\n#/ Date = 1/2/2024\n#2\n"
                                 "! homing\nAXISDEF X=0, Y=1\nIF MFLAGS(X).8 = 0\n"
                                 "  ENABLE X; JOG/v X, -10\n  TILL FAULT(X).#LL\nEND\n"
                                 "DISP \"ERRORMAP1D; XMAP(0) = 5 ! no\", XMAP(0)\n"
                                 "I = 0; WHILE I < 5; I = I + 1; END\nV2(0)(1)(2) = 3\n"
                                 "#5\nLOCAL REAL Base, Step ; INT I\n"
            + test::with(
                test::with(program, "GLOBAL REAL STATIC XMAP(5)\n", ""), "0, 0, Base", "X, 0, Base")
            + "#A\nAXISDEF X=0,Y=1\nglobal real static OTHER(3),XMAP(5)\nGLOBAL INT I2\n";
        READ_TABLE(table, format, text, test::readingWith(inMillimetres));
        QVERIFY2(reading_table->diagnostics.empty(), problemLines(*reading_table).c_str());
        QCOMPARE(table.axes[0].name, std::string("X"));
        QCOMPARE(table.columns[0].target, std::string("X"));
        QCOMPARE(table.columns[0].values, exampleTable().columns[0].values);
        QCOMPARE(format.recognise(text), Recognition::Certain);
    }

    void theSizeInBufferAIsThatOfTheArray()
    {
        const TableReading reading = readIt("#1\n" + with("GLOBAL REAL STATIC XMAP(5)\n", "")
            + "#A\nGLOBAL REAL STATIC XMAP(47)\n");
        QVERIFY2(
            hasProblem(reading, DiagnosticCode::Assumption, 14), problemLines(reading).c_str());
        QCOMPARE(reading.tables.size(), std::size_t(1));
        const TableReading other = readIt("#1\n" + with("GLOBAL REAL STATIC XMAP(5)\n", "")
            + "#2\nLOCAL REAL XMAP(3)\nXMAP(0) = 7\n");
        QVERIFY2(other.diagnostics.empty(), problemLines(other).c_str());
        QCOMPARE(other.tables[0].columns[0].values, exampleTable().columns[0].values);
    }

    void aProgramOfSeveralAxesHasSeveralTables()
    {
        const TableReading reading = readIt(program
            + "Base = 0; Step = 5; YMAP(0)=1; YMAP(1)=2\nERRORMAP1D 1, 0, Base, Step, YMAP\n"
              "ERRORMAPON 1, 0\n");
        QVERIFY2(reading.diagnostics.empty(), problemLines(reading).c_str());
        QCOMPARE(reading.tables.size(), std::size_t(2));
        COMPARE_TABLES(reading.tables[0], exampleTable(), 0.0);
        QCOMPARE(reading.tables[1].name, std::string("YMAP"));
        QCOMPARE(reading.tables[1].axes[0].name, std::string("1"));
        QCOMPARE(reading.tables[1].axes[0].knots, (std::vector<double>{0, 5}));
    }

    void theCommandBecomesAnError()
    {
        const auto feedback =
            convertSign(exampleTable(), SignConvention::Feedback, format.facts.behaviour);
        VERIFY_RESULT(feedback);
        QCOMPARE(applied(format, feedback->table, {-66}), 0.0);
        const auto exact = convertSign(exampleTable(), SignConvention::Feedback,
            format.facts.behaviour, ConvertedKnots::Exact);
        VERIFY_RESULT(exact);
        QVERIFY(std::abs(applied(format, exact->table, {-45.9979}) + 0.0021) < 1e-15);
        QVERIFY(std::abs(applied(format, exact->table, {-46}) + 0.002099779523150) < 1e-15);
    }

    void anErrorBecomesTheCommand()
    {
        const auto table = test::tableOf(SignConvention::Feedback,
            {test::evenAxis("0", "mm", 0, 10, 3)}, {test::columnOf("0", "mm", {0, 0.001, 0.002})});
        const auto command = convertSign(table, SignConvention::Command, format.facts.behaviour);
        VERIFY_RESULT(command);
        const std::vector<double>& found = command->table.columns[0].values;
        QVERIFY(
            test::largestDifference(found, {0, -0.000999900009999, -0.001999800019998}) < 1e-15);
    }
};

AXISCOMP_TEST(TestAcs1d)
AXISCOMP_FORMAT(format, describe)

} // namespace tst_acs1d

#include "tst_acs1d.moc"
