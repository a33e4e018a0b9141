// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/profile/profile_loader.h"
#include "tests/drivecomm/profile/changed_profile.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTemporaryDir>
#include <QTest>

#include <fstream>

namespace tst_profileloader {

using namespace axiscomp;
using namespace axiscomp::drivecomm;
using namespace axiscomp::drivecomm::test;

class TestProfileLoader : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { axiscomp::test::failOnWarnings(); }

    void theBuiltInProfileIsTheOneOfTheSpecification()
    {
        const DriveProfile& profile = genericProfile();
        QCOMPARE(profile.name, "generic");
        QVERIFY(profile.layout == genericTableLayout());
        QCOMPARE(profile.registers.table, "Axes[{axis}]/Parameters/Compensations/Axis/Table");
        QCOMPARE(profile.registers.deviceNameWords, 7);
        QCOMPARE(profile.registers.axisNameWords, 4);
        QCOMPARE(profile.enums.activationAddToEncoders, "AddToEncoders");
        QCOMPARE(profile.sourceTypes, (std::vector<std::string>{"Single", "Double"}));
        QVERIFY(profile.writesAtOneInstant && profile.readsAtOneInstant);
        QCOMPARE(profile.flashWear.operations, 8);
        QVERIFY(profile.flashWear.window == std::chrono::minutes(10));
        QCOMPARE(profile.flashWear.ratedCycles, 100000U);
        QCOMPARE(profile.web.files, "/files/");
    }

    void theBuiltInProfileHasTheTenSlots()
    {
        const auto& slots = genericProfile().tableSlots;
        QCOMPARE(slots.size(), std::size_t{10});
        for (std::size_t i = 0; i < slots.size(); ++i) {
            const bool isLarge = i >= 8;
            const std::string number = std::to_string(isLarge ? i - 7 : i + 1);
            QCOMPARE(slots[i].name, (isLarge ? "Large" : "Small") + number);
            QCOMPARE(
                slots[i].file, (isLarge ? "tables/large" : "tables/small") + number + ".TAMtbl");
            QCOMPARE(slots[i].maximumSize, isLarge ? 2096976U : 63360U);
        }
    }

    void rangesOfTheShortlistAreWrittenOut()
    {
        const auto& list = genericProfile().sourceShortlist;
        QCOMPARE(list.size(), std::size_t{5 + 16 + 16});
        QCOMPARE(list[1], "Axes[{axis}]/Signals/PositionController/Encoders[0]/Position");
        QCOMPARE(list[2], "Axes[{axis}]/Signals/PositionController/Encoders[1]/Position");
        QCOMPARE(list.back(), "Application/Parameters/Floats[15]");
        const auto several =
            changedProfile(put("/sourceShortlist", {"A[0..1]/B[8..10]", "C[7..7]"}));
        VERIFY_RESULT(several);
        QCOMPARE(several->sourceShortlist,
            (std::vector<std::string>{"A[0]/B[8]", "A[0]/B[9]", "A[0]/B[10]", "A[1]/B[8]",
                "A[1]/B[9]", "A[1]/B[10]", "C[7]"}));
    }

    void everyTextOfTheProfileArrives()
    {
        // each register and enum value gets a text of its own, so that a mixed-up row shows
        json document = genericJson();
        for (auto& [key, value] : document["registers"].items()) {
            if (value.is_string())
                value = "Own-" + key + "/" + value.get<std::string>();
        }
        for (auto& [key, value] : document["enums"].items())
            value = "Own-" + key;
        const auto profile = parseProfile(document.dump(), "own.json");
        VERIFY_RESULT(profile);
        const RegisterPaths& paths = profile->registers;
        QVERIFY(paths.deviceName.starts_with("Own-deviceName/"));
        QVERIFY(paths.serialNumber.starts_with("Own-serialNumber/"));
        QVERIFY(paths.driveError.starts_with("Own-driveError/"));
        QVERIFY(paths.saveParameters.starts_with("Own-saveParameters/"));
        QVERIFY(paths.reboot.starts_with("Own-reboot/"));
        QVERIFY(paths.axisName.starts_with("Own-axisName/"));
        QVERIFY(paths.positionUnit.starts_with("Own-positionUnit/"));
        QVERIFY(paths.table.starts_with("Own-table/"));
        QVERIFY(paths.source.starts_with("Own-source/"));
        QVERIFY(paths.coggingTable.starts_with("Own-coggingTable/"));
        QVERIFY(paths.activation.starts_with("Own-activation/"));
        QVERIFY(paths.state.starts_with("Own-state/"));
        QVERIFY(paths.error.starts_with("Own-error/"));
        QVERIFY(paths.output.starts_with("Own-output/"));
        QVERIFY(paths.index.starts_with("Own-index/"));
        QVERIFY(paths.homingState.starts_with("Own-homingState/"));
        QVERIFY(paths.tablePersistent.starts_with("Own-tablePersistent/"));
        QVERIFY(paths.tableDimensions.starts_with("Own-tableDimensions/"));
        QVERIFY(paths.tableSize.starts_with("Own-tableSize/"));
        QVERIFY(paths.tableStart.starts_with("Own-tableStart/"));
        QVERIFY(paths.tableDistance.starts_with("Own-tableDistance/"));
        QVERIFY(paths.tableElements.starts_with("Own-tableElements/"));
        QVERIFY(paths.tableCrc.starts_with("Own-tableCrc/"));
        QVERIFY(paths.tableCommand.starts_with("Own-tableCommand/"));
        QVERIFY(paths.tableEraseCount.starts_with("Own-tableEraseCount/"));
        const RegisterEnums& enums = profile->enums;
        QCOMPARE(enums.tableDisabled, "Own-tableDisabled");
        QCOMPARE(enums.activationDisabled, "Own-activationDisabled");
        QCOMPARE(enums.activationEvaluate, "Own-activationEvaluate");
        QCOMPARE(enums.activationAddToEncoders, "Own-activationAddToEncoders");
        QCOMPARE(enums.stateDisabled, "Own-stateDisabled");
        QCOMPARE(enums.stateEvaluating, "Own-stateEvaluating");
        QCOMPARE(enums.stateRamping, "Own-stateRamping");
        QCOMPARE(enums.stateActive, "Own-stateActive");
        QCOMPARE(enums.stateError, "Own-stateError");
        QCOMPARE(enums.errorNone, "Own-errorNone");
        QCOMPARE(enums.homingDone, "Own-homingDone");
        QCOMPARE(enums.saveParametersSave, "Own-saveParametersSave");
        QCOMPARE(enums.rebootReboot, "Own-rebootReboot");
        QCOMPARE(enums.tableCommandCommit, "Own-tableCommandCommit");
        QCOMPARE(enums.tableCommandDelete, "Own-tableCommandDelete");
        QCOMPARE(enums.driveErrorNone, "Own-driveErrorNone");
        QCOMPARE(enums.driveErrorFlashWear, "Own-driveErrorFlashWear");
    }

    void aLayoutOfAnotherDriveIsRead()
    {
        const auto profile = changedProfile(put("/layout",
            {{"byteOrder", "big"}, {"headerSize", 40}, {"fastestDimension", "last"}, {"version", 7},
                {"fields",
                    {{"size", {{"offset", 4}, {"type", "u16[3]"}}},
                        {"version", {{"offset", 2}, {"type", "u8"}}},
                        {"start", {{"offset", 10}, {"type", "f32"}, {"count", 3}}},
                        {"distance", {{"offset", 22}, {"type", "f32[3]"}}}}}}));
        VERIFY_RESULT(profile);
        const TableLayout& layout = profile->layout;
        QVERIFY(!layout.littleEndian);
        QVERIFY(!layout.dimension1Fastest);
        QCOMPARE(layout.headerSize, 40U);
        QCOMPARE(layout.version, 7U);
        QVERIFY(layout.place(TableField::Size) == (FieldPlace{4, FieldType::U16, 3}));
        QVERIFY(layout.place(TableField::Start) == (FieldPlace{10, FieldType::F32, 3}));
        QVERIFY(!layout.place(TableField::Magic).has_value());
        QVERIFY(layout.magic.empty());
    }

    void theDescriptionIsFree()
    {
        VERIFY_RESULT(changedProfile(without("", "description")));
        VERIFY_RESULT(changedProfile(put("/description", "two\nlines")));
        verifyInvalid(changedProfile(put("/description", 5)), "description", "text is expected");
    }

    void aProfileIsLoadedFromAFile()
    {
        const QTemporaryDir folder;
        const std::filesystem::path file =
            folder.filePath(QStringLiteral("own.json")).toStdString();
        std::ofstream(file) << genericProfileJson;
        const auto profile = loadProfile(file);
        VERIFY_RESULT(profile);
        QCOMPARE(profile->name, "generic");

        std::ofstream(file) << "{}";
        verifyInvalid(loadProfile(file), "name", "missing", file.string());
        std::ofstream(file) << std::string((1 << 20) + 1, ' ');
        VERIFY_ERROR(loadProfile(file), ErrorCode::FileTooLarge);
        VERIFY_ERROR(loadProfile(file.string() + "x"), ErrorCode::FileNotReadable);
        VERIFY_ERROR(loadProfile(file.parent_path()), ErrorCode::FileNotReadable);
    }
};

AXISCOMP_TEST(TestProfileLoader)

} // namespace tst_profileloader

#include "tst_profileloader.moc"
