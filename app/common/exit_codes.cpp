// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/exit_codes.h"

namespace axiscomp::app {

// Without a default label, so that the compiler names a class that is missing here.
ExitCode exitCode(ErrorCode code)
{
    switch (errorClass(code)) {
    case ErrorClass::NothingToDo:
        return ExitCode::Done;
    case ErrorClass::Stopped:
        return ExitCode::Stopped;
    case ErrorClass::Local:
        return ExitCode::OtherFailure;
    case ErrorClass::Request:
    case ErrorClass::Address:
        return ExitCode::Usage;
    case ErrorClass::InputFile:
        return ExitCode::InputFile;
    case ErrorClass::Refused:
    case ErrorClass::Unauthorized:
        return ExitCode::DriveRefused;
    case ErrorClass::NotConnected:
    case ErrorClass::Lost:
    case ErrorClass::Untrusted:
    case ErrorClass::OutcomeUnknown:
        return ExitCode::NoConnection;
    case ErrorClass::Difference:
        return ExitCode::ReadBackDiffers;
    case ErrorClass::FlashWear:
        return ExitCode::FlashWear;
    }
    return ExitCode::OtherFailure;
}

} // namespace axiscomp::app
