// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bytes.h"

#include <string>
#include <vector>

namespace axiscomp::drivecomm {

/// The body of a multipart/form-data request with a text field and a file, as a browser sends the
/// Transfer page. The file's bytes are not copied.
class MultipartForm {
public:
    MultipartForm(const std::string& textField, const std::string& text,
        const std::string& fileField, const std::string& fileName, ByteView file);

    static constexpr std::size_t filePiece = 1;
    [[nodiscard]] std::vector<ByteView> pieces() const
    {
        return {asBytes(m_head), m_file, asBytes(m_tail)};
    }
    [[nodiscard]] std::string contentType() const;

private:
    std::string m_boundary;
    std::string m_head;
    ByteView m_file;
    std::string m_tail;
};

} // namespace axiscomp::drivecomm
