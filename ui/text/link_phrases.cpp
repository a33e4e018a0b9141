// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/phrase_book.h"

#include <QtGlobal>

namespace axiscomp::ui {

namespace {

// Drivecomm: connections, what a drive answers, what the virtual drive refuses.
constexpr const char* linkPhraseList[] = {
    QT_TRANSLATE_NOOP("Error", "it was closed before the reply was complete"),
    QT_TRANSLATE_NOOP(
        "Error", "nothing listens there; is the drive switched on, and is the address right?"),
    QT_TRANSLATE_NOOP("Error", "the network does not know the name {name}"),
    QT_TRANSLATE_NOOP("Error", "it has CHANGED and is not the one that was trusted"),
    QT_TRANSLATE_NOOP("Error", "there is no https; try http://, or another port"),
    QT_TRANSLATE_NOOP(
        "Error", "write http://host[:port], https://host[:port], serial:/dev/ttyUSB0 or demo:"),
    QT_TRANSLATE_NOOP(
        "Error", "the host is missing; write http://192.168.1.20 or http://host:8080"),
    QT_TRANSLATE_NOOP("Error", "only host and port belong here, no path"),
    QT_TRANSLATE_NOOP("Error", "port 0 cannot be reached"),
    QT_TRANSLATE_NOOP("Error", "the device must be an absolute path such as serial:/dev/ttyUSB0"),
    QT_TRANSLATE_NOOP("Error", "the only option is baud, as in serial:/dev/ttyUSB0?baud=115200"),
    QT_TRANSLATE_NOOP("Error",
        "you have no permission to use the port, and no group has it; ask the administrator"),
    QT_TRANSLATE_NOOP("Error",
        "you have no permission to use the port; join the group {group} (sudo usermod -aG {name} "
        "$USER) and log in again"),
    QT_TRANSLATE_NOOP("Error", "you have no permission to look into its folder"),
    QT_TRANSLATE_NOOP("Error", "there is no such port; is the cable or the adapter plugged in?"),
    QT_TRANSLATE_NOOP("Error", "the port cannot be used"),
    QT_TRANSLATE_NOOP("Error", "the serial port is gone; was the cable or the adapter unplugged?"),
    QT_TRANSLATE_NOOP("Error", "another program is using the port; close it there"),
    QT_TRANSLATE_NOOP("Error", "this is no serial port ({reason})"),
    QT_TRANSLATE_NOOP("Error", "the port cannot do {speed} baud"),
    QT_TRANSLATE_NOOP("Error", "the reply of a drive at {speed} baud"),
    QT_TRANSLATE_NOOP("Error", "name, serial number, axes and profile"),
    QT_TRANSLATE_NOOP("Error", "the number of lines that follow"),
    QT_TRANSLATE_NOOP(
        "Error", "the line garbles too much; check the cable, or try a lower baud rate"),
    QT_TRANSLATE_NOOP("Error", "no answer to {request}"),
    QT_TRANSLATE_NOOP("Error", "the drive began anew"),
    QT_TRANSLATE_NOOP("Error", "a size of at most {most} and a CRC"),
    QT_TRANSLATE_NOOP("Error", "the CRC-32 is wrong;"),
    QT_TRANSLATE_NOOP("Error", "{count} register(s)"),
    QT_TRANSLATE_NOOP("Error", "{count} address(es)"),
    QT_TRANSLATE_NOOP("Error", "a type and a value"),
    QT_TRANSLATE_NOOP("Error", "an address"),
    QT_TRANSLATE_NOOP("Error", "how many registers there are"),
    QT_TRANSLATE_NOOP("Error", "path, address, type and value"),
    QT_TRANSLATE_NOOP("Error", "the rest of the registers"),
    QT_TRANSLATE_NOOP(
        "Error", "the serial link writes 1 to {most} registers at one instant, not {count}"),
    QT_TRANSLATE_NOOP("Error", "path, size and maximum size"),
    QT_TRANSLATE_NOOP("Error", "it was cancelled"),
    QT_TRANSLATE_NOOP("Error", "one block did not arrive in {count} attempts"),
    QT_TRANSLATE_NOOP("Error", "the receiver did not begin"),
    QT_TRANSLATE_NOOP("Error", "the receiver does not answer"),
    QT_TRANSLATE_NOOP("Error", "the header of the file makes no sense"),
    QT_TRANSLATE_NOOP("Error", "more than one file was sent"),
    QT_TRANSLATE_NOOP("Error", "no file was sent"),
    QT_TRANSLATE_NOOP("Error", "the file is too large"),
    QT_TRANSLATE_NOOP("Error", "the blocks are out of order"),
    QT_TRANSLATE_NOOP("Error", "the sender did not begin"),
    QT_TRANSLATE_NOOP("Error", "the sender does not send any more"),
    QT_TRANSLATE_NOOP("Error", "no reason given"),
    QT_TRANSLATE_NOOP("Error", "a redirect to {address}"),
    QT_TRANSLATE_NOOP("Error", "a redirect to {address}; give its address with https://"),
    QT_TRANSLATE_NOOP("Error", "the answer itself"),
    QT_TRANSLATE_NOOP("Error", "success or a refusal"),
    QT_TRANSLATE_NOOP("Error", "HTTP status {status}"),
    QT_TRANSLATE_NOOP("Error", "HTTP status {status}, {text}"),
    QT_TRANSLATE_NOOP("Error", "HTTP status {status} and {text}"),
    QT_TRANSLATE_NOOP("Error", "an HTTP reply"),
    QT_TRANSLATE_NOOP("Error", "the status line of an HTTP reply"),
    QT_TRANSLATE_NOOP("Error", "a header field of an HTTP reply"),
    QT_TRANSLATE_NOOP("Error", "a head of at most 64 KiB"),
    QT_TRANSLATE_NOOP("Error", "one Content-Length"),
    QT_TRANSLATE_NOOP("Error", "no Transfer-Encoding but chunked"),
    QT_TRANSLATE_NOOP("Error", "the size of a chunk"),
    QT_TRANSLATE_NOOP("Error", "the end of a chunk"),
    QT_TRANSLATE_NOOP("Error", "at most {count} files"),
    QT_TRANSLATE_NOOP("Error", "file paths without blanks"),
    QT_TRANSLATE_NOOP("Error", "an actual size of {path} up to its maximum size"),
    QT_TRANSLATE_NOOP("Error", "the file {path} once"),
    QT_TRANSLATE_NOOP("Error", "a file, its size and its maximum size in each row"),
    QT_TRANSLATE_NOOP("Error", "sizes in bytes"),
    QT_TRANSLATE_NOOP("Error", "a JSON array of files"),
    QT_TRANSLATE_NOOP("Error", "a file with path, size and maximumSize"),
    QT_TRANSLATE_NOOP("Error", "at least one file in the table"),
    QT_TRANSLATE_NOOP(
        "Error", "a Directory page with a table of File, actual size and maximum size"),
    QT_TRANSLATE_NOOP("Error", "a JSON array of registers"),
    QT_TRANSLATE_NOOP("Error", "a JSON array of {count} register(s)"),
    QT_TRANSLATE_NOOP("Error", "a JSON array of {count} register(s), in the order asked for"),
    QT_TRANSLATE_NOOP("Error", "a register with path, address, type and a value of that type"),
    QT_TRANSLATE_NOOP("Error", "registers below {path}"),
    QT_TRANSLATE_NOOP("Error", "{path} of type Int32"),
    QT_TRANSLATE_NOOP("Error", "{path}, or one of {count} others asked for with it"),
    QT_TRANSLATE_NOOP("Error", "at most 1024 axes"),
    QT_TRANSLATE_NOOP("Error", "more"),
    QT_TRANSLATE_NOOP("Error", "status 204 without a body"),
    QT_TRANSLATE_NOOP("Error", "a file with its Content-Length"),
    QT_TRANSLATE_NOOP("Error", "the bytes of {path}"),
    QT_TRANSLATE_NOOP("Error", "a reply"),
    QT_TRANSLATE_NOOP("Error", "flipped bytes"),
    QT_TRANSLATE_NOOP("Error", "the connection was cut"),
    QT_TRANSLATE_NOOP("Error", "the drive rebooted"),
    QT_TRANSLATE_NOOP("Error", "a request reads at most {most} registers, not {count}"),
    QT_TRANSLATE_NOOP("Error", "a request writes 1 to {most} registers, not {count}"),
    QT_TRANSLATE_NOOP("Error", "{path} is written twice in one request"),
    QT_TRANSLATE_NOOP("Error", "{path} is read-only"),
    QT_TRANSLATE_NOOP("Error", "{path} is of type {type}, and cannot be {value}"),
    QT_TRANSLATE_NOOP("Error", "{path} is of type {type}, one of {names}, and cannot be {value}"),
    QT_TRANSLATE_NOOP(
        "Error", "the compensation of {axis} is on, so {what} must stay; deactivate it"),
    QT_TRANSLATE_NOOP("Error", "its homing"),
    QT_TRANSLATE_NOOP("Error", "the table in {slot}"),
    QT_TRANSLATE_NOOP("Error", "there is no table in {slot} that could be persistent"),
    QT_TRANSLATE_NOOP("Error", "there is no table in {slot} that could be committed"),
    QT_TRANSLATE_NOOP("Error", "{path} can have {most} bytes, not {size}"),
    QT_TRANSLATE_NOOP("Error", "the drive's flash failed: {reason}"),
};

} // namespace

std::span<const char* const> linkPhrases()
{
    return linkPhraseList;
}

} // namespace axiscomp::ui
