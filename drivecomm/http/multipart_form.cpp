// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/http/multipart_form.h"

#include <random>

namespace axiscomp::drivecomm {

namespace {

/// 160 random bits: that they occur in a file by chance need not be looked for.
std::string randomBoundary()
{
    constexpr std::string_view letters = "0123456789abcdef";
    std::random_device device;
    std::string boundary = "axiscomp-";
    for (int i = 0; i < 5; ++i) {
        for (std::uint32_t bits = device(), digit = 0; digit < 8; ++digit, bits >>= 4)
            boundary += letters[bits & 0xF];
    }
    return boundary;
}

/// A name in quotation marks, as browsers write it.
std::string quotedName(const std::string& name)
{
    std::string result = "\"";
    for (const char c : name) {
        if (c == '"')
            result += "%22";
        else if (c == '\r' || c == '\n')
            result += c == '\r' ? "%0D" : "%0A";
        else
            result += c;
    }
    return result + '"';
}

} // namespace

MultipartForm::MultipartForm(const std::string& textField, const std::string& text,
    const std::string& fileField, const std::string& fileName, ByteView file)
    : m_boundary(randomBoundary())
    , m_file(file)
{
    const std::string disposition = "Content-Disposition: form-data; name=";
    const std::string shortName = fileName.substr(fileName.rfind('/') + 1);
    m_head = "--" + m_boundary + "\r\n" + disposition + quotedName(textField) + "\r\n\r\n" + text
        + "\r\n--" + m_boundary + "\r\n" + disposition + quotedName(fileField) + "; filename="
        + quotedName(shortName) + "\r\nContent-Type: application/octet-stream\r\n\r\n";
    m_tail = "\r\n--" + m_boundary + "--\r\n";
}

std::string MultipartForm::contentType() const
{
    return "multipart/form-data; boundary=" + m_boundary;
}

} // namespace axiscomp::drivecomm
