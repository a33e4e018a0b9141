// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/exit_codes.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QFile>

#include <map>
#include <set>

namespace tst_exitcodes {

using namespace axiscomp;
using app::ExitCode;

namespace {

/// docs/cli.md, "Exit codes", spelled out once more on purpose.
const std::map<ErrorCode, int> expectedCodes{
    {ErrorCode::InvalidArgument, 2},
    {ErrorCode::Cancelled, 130},
    {ErrorCode::FileNotReadable, 3},
    {ErrorCode::FileNotWritable, 1},
    {ErrorCode::FileTooLarge, 3},
    {ErrorCode::InvalidCalibration, 3},
    {ErrorCode::InvalidMeasurement, 3},
    {ErrorCode::UnitMissing, 2},
    {ErrorCode::InstrumentScale, 3},
    {ErrorCode::NoTargets, 3},
    {ErrorCode::MeasurementState, 2},
    {ErrorCode::InvalidTable, 3},
    {ErrorCode::InvalidProfile, 3},
    {ErrorCode::InvalidConfiguration, 3},
    {ErrorCode::InvalidBackup, 3},
    {ErrorCode::InvalidRecord, 3},
    {ErrorCode::UnknownFormat, 2},
    {ErrorCode::FormatAmbiguous, 2},
    {ErrorCode::FormatCannotHold, 2},
    {ErrorCode::SignNotConvertible, 3},
    {ErrorCode::SignNotStated, 2},
    {ErrorCode::TargetNotKnown, 2},
    {ErrorCode::TargetMismatch, 2},
    {ErrorCode::UnitMismatch, 2},
    {ErrorCode::LargeCorrection, 2},
    {ErrorCode::PeriodNotResolved, 2},
    {ErrorCode::NoDataThere, 2},
    {ErrorCode::NotConverged, 1},
    {ErrorCode::TableAmbiguous, 2},
    {ErrorCode::ResamplingImpossible, 2},
    {ErrorCode::TableNotFound, 2},
    {ErrorCode::InvalidEndpoint, 2},
    {ErrorCode::NotConnected, 5},
    {ErrorCode::ConnectionLost, 5},
    {ErrorCode::Timeout, 5},
    {ErrorCode::Protocol, 5},
    {ErrorCode::Unauthorized, 4},
    {ErrorCode::CertificateRejected, 5},
    {ErrorCode::DriveRejected, 4},
    {ErrorCode::UnknownRegister, 4},
    {ErrorCode::UnknownFile, 4},
    {ErrorCode::NotAllowedNow, 4},
    {ErrorCode::TooLargeForSlot, 4},
    {ErrorCode::TableRefused, 4},
    {ErrorCode::FlashWear, 7},
    {ErrorCode::CompensationError, 4},
    {ErrorCode::AxisNotFound, 2},
    {ErrorCode::AxisAmbiguous, 2},
    {ErrorCode::NoCompensation, 4},
    {ErrorCode::SourceMissing, 2},
    {ErrorCode::SourceSurplus, 2},
    {ErrorCode::SourceNotFound, 2},
    {ErrorCode::SourceWrongType, 2},
    {ErrorCode::SourceOtherDrive, 2},
    {ErrorCode::SourceRepeated, 2},
    {ErrorCode::SourceMismatch, 2},
    {ErrorCode::DimensionMismatch, 2},
    {ErrorCode::TableTooLarge, 4},
    {ErrorCode::SlotNotFound, 2},
    {ErrorCode::SlotInUse, 4},
    {ErrorCode::NoFreeSlot, 4},
    {ErrorCode::NoTable, 4},
    {ErrorCode::NothingToWrite, 0},
    {ErrorCode::NothingUnfinished, 0},
    {ErrorCode::NotUndoable, 4},
    {ErrorCode::TableNotKept, 1},
    {ErrorCode::CompensationActive, 4},
    {ErrorCode::NotHomed, 4},
    {ErrorCode::OtherDrive, 4},
    {ErrorCode::ChangedMeanwhile, 6},
    {ErrorCode::VerifyMismatch, 6},
    {ErrorCode::ProofFailed, 6},
    {ErrorCode::OutcomeUnknown, 5},
    {ErrorCode::RollbackFailed, 6},
};

} // namespace

class tst_ExitCodes : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void everyErrorHasItsCode()
    {
        for (const ErrorCode code : allErrorCodes()) {
            const std::string name(errorName(code));
            QVERIFY2(expectedCodes.contains(code), name.c_str());
            QVERIFY2(static_cast<int>(app::exitCode(code)) == expectedCodes.at(code), name.c_str());
        }
    }

    void theUserGuideListsEveryError()
    {
        QFile guide(QStringLiteral(AXISCOMP_SOURCE_FOLDER "/docs/cli.md"));
        QVERIFY(guide.open(QIODevice::ReadOnly));
        std::map<int, QByteArray> rows;
        for (const QByteArray& line : guide.readAll().split('\n')) {
            const QList<QByteArray> cells = line.split('|');
            bool isCode = false;
            const int code = cells.size() == 5 ? cells.at(1).trimmed().toInt(&isCode) : -1;
            if (isCode)
                rows[code] = cells.at(3);
        }
        qsizetype listed = 0;
        for (const auto& [code, names] : rows)
            listed += names.count('`') / 2;
        QCOMPARE(listed, static_cast<qsizetype>(expectedCodes.size()));
        for (const auto& [error, code] : expectedCodes) {
            const QByteArray name =
                '`' + QByteArray::fromStdString(std::string(errorName(error))) + '`';
            QVERIFY2(rows[code].contains(name), name.constData());
        }
    }

    void allCodesOfTheSpecificationAreUsed()
    {
        std::set<int> used{0};
        for (const ErrorCode code : allErrorCodes())
            used.insert(static_cast<int>(app::exitCode(code)));
        QCOMPARE(used, (std::set<int>{0, 1, 2, 3, 4, 5, 6, 7, 130}));
    }
};

AXISCOMP_TEST(tst_ExitCodes)

} // namespace tst_exitcodes

#include "tst_exitcodes.moc"
