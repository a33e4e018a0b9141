# SPDX-License-Identifier: GPL-3.0-or-later
"""The errors of axiscomp, with the codes of the command line ("Exit codes" of docs/cli.md)."""

from __future__ import annotations

from typing import Any


class FileWarning(UserWarning):
    """What a file leaves open and is taken for granted, what looks wrong in it, or what of it is lost: a line of `axiscomp`
    with "warning:".

    Given by read, read_all, resample and read_measurement, whose answer has no place for it; others have it in their notes.
    """


class Error(Exception):
    """What `axiscomp` prints as "error: CODE: sentence".

    code         the name that programs compare: "LargeCorrection", "NotConnected", ...
    message      the sentence, in English
    context      what the sentence names, by its keys: {"file": ...}; whole numbers are int (a count, a size, an axis by its
                 index), all else is str
    diagnostics  the places in files that are wrong: {"file", "code", "line", "column", "message"}
    notes        warnings and notes that came before it, and other errors of the same command
    document     the Document of a command that went on after it: apply, plan, axes; else None
    """

    def __init__(
        self,
        code: str,
        message: str,
        context: dict[str, Any] | None = None,
        diagnostics: list[dict[str, Any]] | None = None,
        notes: list[str] | None = None,
    ) -> None:
        # Not that of OSError, which would make an errno and a file name of it.
        Exception.__init__(self, code, message, context or {}, diagnostics or [], notes or [])
        self.code = code
        self.message = message
        self.context = context or {}
        self.diagnostics = diagnostics or []
        self.notes = notes or []
        self.document: Any = None

    def __str__(self) -> str:
        lines = [f"{self.code}: {self.message}"]
        lines += [f"  {d.get('file', '')}:{d['line']}:{d['column']}: {d['message']}" for d in self.diagnostics]
        return "\n".join(lines)


class RequestError(Error, ValueError):
    """What was asked for cannot be."""


class InputFileError(Error, ValueError):
    """A file cannot be read, or says something that is wrong."""


class LocalError(Error, OSError):
    """Something on this computer failed, such as a full disk."""


class StoppedError(Error):
    """The work was stopped before its end; what was changed was put back."""


class NothingToDoError(Error):
    """There is nothing to write, to finish or to undo."""


class DriveError(Error):
    """Of a drive, or of the way to it."""


class AddressError(DriveError, ValueError):
    """This is no address of a drive."""


class NotConnectedError(DriveError, ConnectionError):
    """The drive cannot be reached; nothing was sent."""


class LostError(DriveError, ConnectionError):
    """There was no answer that can be read: the drive may have acted."""


class UnauthorizedError(DriveError):
    """User name or password are missing or wrong."""


class UntrustedError(DriveError):
    """The certificate of the drive is not trusted."""


class RefusedError(DriveError):
    """The drive refused, or a check before a write did; nothing was changed."""


class FlashWearError(DriveError):
    """The drive's flash must not be written to now."""


class DifferenceError(DriveError):
    """The drive has something else than it should: see context["driveHolds"]."""


class OutcomeUnknownError(DriveError):
    """The drive holds the old or the new state, and it cannot be asked which."""
