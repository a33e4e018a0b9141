// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/exit_codes.h"

namespace axiscomp::app {

// Without a default label, so that the compiler names a code that is missing here.
ExitCode exitCode(ErrorCode code)
{
    switch (code) {
    case ErrorCode::Cancelled:
        return ExitCode::Stopped;
    case ErrorCode::NothingToWrite:
    case ErrorCode::NothingUnfinished:
        return ExitCode::Done;
    case ErrorCode::FileNotWritable:
    case ErrorCode::TableNotKept:
        return ExitCode::OtherFailure;

    case ErrorCode::InvalidArgument:
    case ErrorCode::UnknownFormat:
    case ErrorCode::FormatAmbiguous:
    case ErrorCode::FormatCannotHold:
    case ErrorCode::ResamplingImpossible:
    case ErrorCode::TableNotFound:
    case ErrorCode::InvalidEndpoint:
    case ErrorCode::AxisNotFound:
    case ErrorCode::AxisAmbiguous:
    case ErrorCode::SourceMissing:
    case ErrorCode::SourceSurplus:
    case ErrorCode::SourceNotFound:
    case ErrorCode::SourceWrongType:
    case ErrorCode::SourceOtherDrive:
    case ErrorCode::SourceRepeated:
    case ErrorCode::DimensionMismatch:
    case ErrorCode::SlotNotFound:
        return ExitCode::Usage;

    case ErrorCode::FileNotReadable:
    case ErrorCode::FileTooLarge:
    case ErrorCode::InvalidCalibration:
    case ErrorCode::SignNotConvertible:
    case ErrorCode::InvalidTable:
    case ErrorCode::InvalidProfile:
    case ErrorCode::InvalidConfiguration:
    case ErrorCode::InvalidBackup:
        return ExitCode::InputFile;

    case ErrorCode::Unauthorized:
    case ErrorCode::DriveRejected:
    case ErrorCode::UnknownRegister:
    case ErrorCode::UnknownFile:
    case ErrorCode::NotAllowedNow:
    case ErrorCode::TooLargeForSlot:
    case ErrorCode::TableRefused:
    case ErrorCode::CompensationError:
    case ErrorCode::NoCompensation:
    case ErrorCode::TableTooLarge:
    case ErrorCode::SlotInUse:
    case ErrorCode::NoFreeSlot:
    case ErrorCode::NoTable:
    case ErrorCode::CompensationActive:
    case ErrorCode::NotHomed:
    case ErrorCode::OtherDrive:
        return ExitCode::DriveRefused;

    case ErrorCode::NotConnected:
    case ErrorCode::ConnectionLost:
    case ErrorCode::Timeout:
    case ErrorCode::Protocol:
    case ErrorCode::CertificateRejected:
    case ErrorCode::OutcomeUnknown:
        return ExitCode::NoConnection;

    case ErrorCode::ChangedMeanwhile:
    case ErrorCode::VerifyMismatch:
    case ErrorCode::ProofFailed:
    case ErrorCode::RollbackFailed:
        return ExitCode::ReadBackDiffers;

    case ErrorCode::FlashWear:
        return ExitCode::FlashWear;
    }
    return ExitCode::OtherFailure;
}

} // namespace axiscomp::app
