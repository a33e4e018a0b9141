// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QHash>
#include <QRegularExpression>
#include <QString>
#include <QStringList>

namespace axiscomp::test {

/// A whole file of a format, by the format's name; empty: there is none here.
inline QString controllerFile(const QString& format)
{
    static const QHash<QString, QString> files{
        {QStringLiteral("csv"),
            QStringLiteral("X [mm],Y [mm],Table 1 [mm]\n0,0,0\n100,0,0.01\n0,50,0.02\n"
                           "100,50,0.03\n")},
        {QStringLiteral("acs-1d"),
            QStringLiteral("GLOBAL REAL STATIC XMAP(3)\nXMAP(0) = 0\nXMAP(1) = -0.01\n"
                           "XMAP(2) = -0.02\nERRORUNMAP 0, 0\n"
                           "ERRORMAP1D 0, 0, 0, 100, XMAP\nERRORMAPON 0, 0\nSTOP\n")},
        {QStringLiteral("acs-2d"),
            QStringLiteral("GLOBAL REAL STATIC M0(2)(3)\nM0(0)(0) = 0\nM0(0)(1) = -0.01\n"
                           "M0(0)(2) = -0.02\nM0(1)(0) = 0\nM0(1)(1) = -0.01\nM0(1)(2) = 0.02\n"
                           "CONNECT RPOS(0) = APOS(0) + MAP2(APOS(0), APOS(1), M0, 0, 100, 0, 50)\n"
                           "DEPENDS 0, (0,1)\nSTOP\n")},
        {QStringLiteral("aerotech-1d"),
            QStringLiteral(":START 1 SAMPLEDIST=100 POSUNIT=METRIC CORUNIT=PRIMARY\n"
                           ":START OFFSET=0 HOMEOFFSET=3\n0 -0.01 -0.02\n:END\n")},
        {QStringLiteral("aerotech-2d"),
            QStringLiteral(":START2D 2 1 1 2 10 5 3\n:START2D POSUNIT=METRIC CORUNIT=METRIC/1000\n"
                           ":START2D OFFSETCOL=5\n1 -1 2 -2 3 -3\n4 -4 5 -5 6 -6\n:END\n")},
        {QStringLiteral("fanuc"),
            QStringLiteral("%\nN03620P1000\nN10999P2\nN11000P-1\nN11001P1\nN11002P-2\n%\n")},
        {QStringLiteral("heidenhain-com"),
            QStringLiteral("BEGIN AXIS_Y.COM MM\n"
                           "NR   AXISPOS       BACKLASH      X             Y             Z\n"
                           "0    +0.0000                                   +0.0000\n"
                           "1    +100.0000                                 +0.0100\n"
                           "2    +200.0000                                 +0.0200\n[END]\n")},
        {QStringLiteral("heidenhain-com-530"),
            QStringLiteral("BEGIN AXIS-Y.COM  DATUM:-90.0000 DISTANCE:+6.5536\n"
                           "NR                  X          Y          Z\n"
                           "0       -90.0000               +0.0000\n"
                           "1       -83.4464               +0.0021\n"
                           "2       -76.8928               +0.0035\n[END]\n")},
        {QStringLiteral("icube"), QStringLiteral("position,offset\n0,0\n100,-0.01\n200,-0.02\n")},
        {QStringLiteral("isg-crosscomp"),
            QStringLiteral("kopf.achs_nr 1\nkw.crosscomp.unit 1\nkw.crosscomp.last_index 2\n"
                           "kw.crosscomp.master_ax_nr 2\nkw.crosscomp.max_points 3\n"
                           "kw.crosscomp.table[0].setpoint 0\nkw.crosscomp.table[0].correction 0\n"
                           "kw.crosscomp.table[1].setpoint 1000\n"
                           "kw.crosscomp.table[1].correction -100\n"
                           "kw.crosscomp.table[2].setpoint 2000\n"
                           "kw.crosscomp.table[2].correction -200\nEnd\n")},
        {QStringLiteral("isg-crosscomp2"),
            QStringLiteral("kopf.achs_nr 3\nkw.crosscomp2.unit 1\nkw.crosscomp2.grid RECTANGULAR\n"
                           "kw.crosscomp2.interval1 100000\nkw.crosscomp2.interval2 100000\n"
                           "kw.crosscomp2.last_index_master1 1\n"
                           "kw.crosscomp2.start_position_master1 0\n"
                           "kw.crosscomp2.master1_ax_nr 1\nkw.crosscomp2.last_index_master2 1\n"
                           "kw.crosscomp2.start_position_master2 0\n"
                           "kw.crosscomp2.master2_ax_nr 2\nkw.crosscomp2.table[0][0].correction 0\n"
                           "kw.crosscomp2.table[0][1].correction -10\n"
                           "kw.crosscomp2.table[1][0].correction 20\n"
                           "kw.crosscomp2.table[1][1].correction -30\nEnd\n")},
        {QStringLiteral("isg-ssfk"),
            QStringLiteral("kopf.achs_nr 1\nkopf.log_achs_nr 1\nkw.ssfk.unit 1\n"
                           "kw.ssfk.bilateral 1\nkw.ssfk.modulo 0\nkw.ssfk.interval 1000\n"
                           "kw.ssfk.kw_startpos 0\nkw.ssfk.kw_nr_max 2\nkw.ssfk.table[0].pos 0\n"
                           "kw.ssfk.table[1].pos 100\nkw.ssfk.table[0].neg 0\n"
                           "kw.ssfk.table[1].neg 100\nEnd\n")},
        {QStringLiteral("klipper"),
            QStringLiteral("#*# [bed_mesh default]\n#*# version = 1\n#*# points =\n"
                           "#*# \t 0.0125, 0.02, -0.005\n#*# \t 0.01, 0.0, -0.001\n"
                           "#*# x_count = 3\n#*# y_count = 2\n#*# min_x = 10.0\n"
                           "#*# max_x = 110.0\n#*# min_y = 5.0\n#*# max_y = 95.0\n"
                           "#*# x_offset = 1.5\n")},
        {QStringLiteral("klipper-twist"),
            QStringLiteral("[axis_twist_compensation]\ncalibrate_start_x: 20\n"
                           "calibrate_end_x: 200\n#*# [axis_twist_compensation]\n"
                           "#*# z_compensations = -0.05, -0.005, 0.056\n"
                           "#*# compensation_start_x = 30.0\n"
                           "#*# compensation_end_x = 210.0\n")},
        {QStringLiteral("kmotion-geo"),
            QStringLiteral("2,3\n20,10\n-20,5\n0,0,-19.9,5,0.1\n0,1,0,5,0\n0,2,20,5,0\n"
                           "1,0,-20,15,0\n1,1,0,15,0\n1,2,20,15.1,0\n")},
        {QStringLiteral("kmotion-linear"),
            QStringLiteral("5\n2\n-180\n0,-180\n1,-178.1\n2,-176.2\n3,-174.1\n4,-172\n")},
        {QStringLiteral("linuxcnc"),
            QStringLiteral("0 0 0\n100 100.01 100.02\n200 200.02 200.03\n")},
        {QStringLiteral("pmac-1d"),
            QStringLiteral("CLOSE\nDELETE COMP\n#1\nDEFINE COMP 4,#1D,#2,4000\n160 -80\n32\n0\n")},
        {QStringLiteral("pmac-2d"),
            QStringLiteral("#3\nDEFINE COMP 2.3,#1D,#2D,#3,3000,4000\n16 32 0\n48 64 80 48\n"
                           "0 16 32 0\n")},
        {QStringLiteral("power-pmac"),
            QStringLiteral("CompTable[0].Source[0] = 1;\nCompTable[0].Nx[0] = 4;\n"
                           "CompTable[0].X0[0] = -100000;\nCompTable[0].Dx[0] = 200000;\n"
                           "CompTable[0].Target[0] = Motor[1].CompPos.a;"
                           "CompTable[0].Target[1] = Motor[1].CompPos2.a;\n"
                           "CompTable[0].Sf[0] = 1; CompTable[0].Ctrl = 7;\n"
                           "CompTable[0].Data[0] = 0,12.5,-3\nCompTable[0].Data[3] = 4,8\n"
                           "Sys.CompEnable = 1\n")},
        {QStringLiteral("rapidcode"),
            QStringLiteral("# RapidCode compensator table, the first axis fastest\n"
                           "# name = Table 1\n# input.1.axis = X\n# input.1.unit = mm\n"
                           "# input.1.min = 0\n# input.1.max = 200\n# input.1.delta = 100\n"
                           "# input.2.axis = Y\n# input.2.unit = mm\n# input.2.min = 0\n"
                           "# input.2.max = 100\n# input.2.delta = 100\n# output.unit = mm\n"
                           "# output.counts-per-unit = 1000\n0,-10,-20\n0,-10,-20\n")},
        {QStringLiteral("reprap"),
            QStringLiteral("RepRapFirmware height map file v2 generated at 2024-01-01 00:00\n"
                           "axis0,axis1,min0,max0,min1,max1,radius,spacing0,spacing1,num0,num1\n"
                           "X,Y,0.00,100.00,0.00,50.00,-1.00,50.00,50.00,3,2\n"
                           "  0.010,  0.020,  0.030\n -0.010,  0.001, -0.020\n")},
        {QStringLiteral("siemens-cec"),
            QStringLiteral("CHANDATA(1)\n$AN_CEC[0,0]=0\n$AN_CEC[0,1]=-0.01\n$AN_CEC[0,2]=-0.02\n"
                           "$AN_CEC_INPUT_AXIS[0]=(X)\n$AN_CEC_OUTPUT_AXIS[0]=(X)\n"
                           "$AN_CEC_STEP[0]=100\n$AN_CEC_MIN[0]=0\n$AN_CEC_MAX[0]=200\n"
                           "$AN_CEC_IS_MODULO[0]=0\n$AN_CEC_DIRECTION[0]=0\n"
                           "$AN_CEC_MULT_BY_TABLE[0]=0\nM17\n")},
        {QStringLiteral("siemens-eec"),
            QStringLiteral("CHANDATA(1)\n$AA_ENC_COMP[0,0,X]=0\n$AA_ENC_COMP[0,1,X]=0.01\n"
                           "$AA_ENC_COMP[0,2,X]=0.02\n$AA_ENC_COMP_STEP[0,X]=100\n"
                           "$AA_ENC_COMP_MIN[0,X]=0\n$AA_ENC_COMP_MAX[0,X]=200\n"
                           "$AA_ENC_COMP_IS_MODULO[0,X]=0\nM17\n")},
        {QStringLiteral("twincat-nc"),
            QStringLiteral("stPar : ST_PositionCompensationTableParameter := (MinPosition:=0.0,\n"
                           "MaxPosition:=20.0, NoOfTableElements:=3,\n"
                           "Direction:=WorkDirectionBoth, Modulo:=FALSE);\n"
                           "stTab : ARRAY[0..2] OF ST_PositionCompensationTableElement := [\n"
                           "(Position:=0.0, Compensation:=0.0),\n"
                           "(Position:=10.0, Compensation:=0.1),\n"
                           "(Position:=20.0, Compensation:=0.2)];\n")},
        {QStringLiteral("softmc"), QStringLiteral("1 3\n0 0\n100 -0.01\n200 -0.02\n")},
        {QStringLiteral("weihong"),
            QStringLiteral(";unit=mm\n[X]\n0, 0.027, 0.083\n100, 0.025, 0.077\n"
                           "200, 0.015, 0.068\n")},
    };
    return files.value(format);
}

/// A text with one thing wrong: lines that are missing, twice or cut off, and other words in place
/// of each of its words.
inline QStringList damagedTexts(const QString& text)
{
    const QStringList lines = text.split(u'\n', Qt::SkipEmptyParts);
    QStringList damaged{{}, QStringLiteral("x\n"), text + text};
    const auto add = [&damaged](
                         const QStringList& changed) { damaged += changed.join(u'\n') + u'\n'; };
    QStringList reversed(lines.rbegin(), lines.rend());
    add(reversed);
    static const QRegularExpression word(QStringLiteral("[^\\s=,.\\[\\]()]+(\\.\\d+)?"));
    for (qsizetype i = 0; i < lines.size(); ++i) {
        QStringList changed = lines;
        changed.removeAt(i);
        add(changed);
        add(lines.first(i + 1));
        changed = lines;
        changed.insert(i, lines[i]);
        add(changed);
        for (auto words = word.globalMatch(lines[i]); words.hasNext();) {
            const QRegularExpressionMatch match = words.next();
            for (const char* other : {"", "x", "-7.5", "-1", "0", "1", "2", "5", "99", "1e9",
                     "1e308", "99999999999", "7 7", "ENGLISH", "PRIMARY/0", "#9", "#33", "#1D"}) {
                changed = lines;
                changed[i].replace(
                    match.capturedStart(), match.capturedLength(), QString::fromLatin1(other));
                add(changed);
            }
        }
    }
    return damaged;
}

} // namespace axiscomp::test
