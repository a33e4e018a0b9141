// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/text_file.h"

#include "core/text/utf8.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

namespace axiscomp {

namespace {

constexpr std::uint64_t everyByte(std::uint8_t byte)
{
    return 0x0101010101010101U * byte;
}

struct ByteKinds {
    bool nonAscii = false;
    bool nul = false;
};

ByteKinds byteKinds(std::string_view text)
{
    std::uint64_t high = 0;
    std::uint64_t zero = 0;
    std::size_t i = 0;
    for (; i + 8 <= text.size(); i += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, text.data() + i, 8);
        high |= word;
        zero |= (word - everyByte(0x01)) & ~word;
    }
    for (; i < text.size(); ++i) {
        high |= static_cast<unsigned char>(text[i]);
        zero |= text[i] == '\0' ? everyByte(0x80) : 0;
    }
    return {(high & everyByte(0x80)) != 0, (zero & everyByte(0x80)) != 0};
}

std::size_t lineAt(std::string_view text, std::size_t offset)
{
    std::size_t line = 1;
    for (std::size_t i = 0; i < offset; ++i) {
        const bool loneReturn = text[i] == '\r' && text.substr(i + 1, 1) != "\n";
        line += text[i] == '\n' || loneReturn ? 1 : 0;
    }
    return line;
}

/// UTF-16 without a byte-order mark: every other byte of Latin text is NUL, and only those.
bool looksLikeUtf16(std::string_view text)
{
    const std::string_view head = text.substr(0, 256);
    std::array<std::size_t, 2> zeros{};
    for (std::size_t i = 0; i < head.size(); ++i)
        zeros[i % 2] += head[i] == '\0' ? 1 : 0;
    const auto [few, many] = std::minmax(zeros[0], zeros[1]);
    return head.size() >= 4 && few == 0 && many * 10 >= head.size() * 4;
}

bool looksBinary(std::string_view text)
{
    const std::string_view head = text.substr(0, 4096);
    const auto isControl = [](char c) {
        return (c >= 0 && c < ' ' && (c < '\t' || c > '\r')) || c == '\x7f';
    };
    const auto controls = static_cast<std::size_t>(std::ranges::count_if(head, isControl));
    return controls >= 3 && controls * 32 > head.size();
}

/// Windows-1252, 0x80 to 0x9f; the five unused bytes become the replacement character.
constexpr std::array<char16_t, 32> windows1252{0x20AC, 0xFFFD, 0x201A, 0x0192, 0x201E, 0x2026,
    0x2020, 0x2021, 0x02C6, 0x2030, 0x0160, 0x2039, 0x0152, 0xFFFD, 0x017D, 0xFFFD, 0xFFFD, 0x2018,
    0x2019, 0x201C, 0x201D, 0x2022, 0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0xFFFD,
    0x017E, 0x0178};

void appendUtf8(std::string& text, char16_t code)
{
    const auto put = [&text](unsigned value) { text += static_cast<char>(value); };
    if (code < 0x80) {
        put(code);
    } else if (code < 0x800) {
        put(0xC0U | (code >> 6U));
        put(0x80U | (code & 0x3FU));
    } else {
        put(0xE0U | (code >> 12U));
        put(0x80U | ((code >> 6U) & 0x3FU));
        put(0x80U | (code & 0x3FU));
    }
}

struct Format {
    std::string_view magic;
    TextPattern name;
};
using namespace std::string_view_literals;
constexpr TextPattern utf16Text = AXISCOMP_TEXT("Error", "UTF-16 text");
constexpr std::array formats{
    Format{"\xFF\xFE"sv, utf16Text},
    Format{"\xFE\xFF"sv, utf16Text},
    Format{"PK\x03\x04"sv, AXISCOMP_TEXT("Error", "a spreadsheet workbook or ZIP archive")},
    Format{"\xD0\xCF\x11\xE0"sv, AXISCOMP_TEXT("Error", "an old Excel workbook")},
    Format{"%PDF-"sv, AXISCOMP_TEXT("Error", "a PDF document")},
    Format{"\x1F\x8B"sv, AXISCOMP_TEXT("Error", "a compressed file (gzip)")},
    Format{"\x89PNG"sv, AXISCOMP_TEXT("Error", "a picture")},
    Format{"TAMT\x01\x00"sv, AXISCOMP_TEXT("Error", "a TAM table")},
};

} // namespace

TextInspection::TextInspection(
    std::string_view text, const std::stop_token& stop, DiagnosticList& diagnostics)
    : m_diagnostics(diagnostics)
    , m_body(text)
{
    if (m_body.starts_with("\xEF\xBB\xBF"))
        m_body.remove_prefix(3);
    if (!refuseForeignFormat(text) && !refuseNul(stop) && !m_ascii)
        decideEncoding();
}

bool TextInspection::refuse(const TextPattern& what, std::size_t line)
{
    m_diagnostics.error(
        DiagnosticCode::NotText, line, 0, what, AXISCOMP_TEXT("Error", "a text file"));
    return true;
}

bool TextInspection::refuseForeignFormat(std::string_view text)
{
    const auto format = std::ranges::find_if(
        formats, [text](const Format& candidate) { return text.starts_with(candidate.magic); });
    if (format != formats.end())
        return refuse(format->name);
    if (looksLikeUtf16(m_body))
        return refuse(utf16Text);
    return looksBinary(m_body) && refuse(AXISCOMP_TEXT("Error", "a binary file"));
}

bool TextInspection::refuseNul(const std::stop_token& stop)
{
    constexpr std::size_t chunk = std::size_t{1} << 20U;
    for (std::size_t begin = 0; begin < m_body.size() && !stop.stop_requested(); begin += chunk) {
        const ByteKinds kinds = byteKinds(m_body.substr(begin, chunk));
        m_ascii = m_ascii && !kinds.nonAscii;
        const std::size_t nul = kinds.nul ? m_body.find('\0', begin) : std::string_view::npos;
        if (nul != std::string_view::npos)
            return refuse(AXISCOMP_TEXT("Error", "a NUL byte"), lineAt(m_body, nul));
    }
    return false;
}

void TextInspection::decideEncoding()
{
    const std::size_t invalid = findInvalidUtf8(m_body);
    if (invalid == std::string_view::npos)
        return;
    m_encoding = Encoding::Windows1252;
    constexpr std::string_view digits = "0123456789ABCDEF";
    const auto byte = static_cast<unsigned char>(m_body[invalid]);
    m_diagnostics.warning(DiagnosticCode::Encoding, lineAt(m_body, invalid), 0,
        AXISCOMP_TEXT("Error", "the byte 0x{byte} ({character})")
            .with("byte", std::string{digits[byte >> 4U], digits[byte & 15U]})
            .with("character", toUtf8(m_body.substr(invalid, 1), m_encoding)),
        Verbatim{"UTF-8"});
}

std::string toUtf8(std::string_view bytes, Encoding encoding)
{
    if (encoding == Encoding::Utf8)
        return cleanText(bytes);
    std::string text;
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        const bool special = byte >= 0x80 && byte < 0xA0;
        appendUtf8(text, special ? windows1252[byte - 0x80U] : char16_t{byte});
    }
    return cleanText(text);
}

std::string excerpt(std::string_view bytes, Encoding encoding)
{
    constexpr std::size_t longest = 40;
    const std::string text = toUtf8(bytes.substr(0, 4 * longest), encoding);
    std::string_view kept = text;
    if (text.size() > longest || bytes.size() > 4 * longest)
        kept = cutAtCharacter(text, longest);
    return kept.size() == text.size() ? text : std::string(kept) + "…";
}

std::string_view trimmed(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos)
        return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

} // namespace axiscomp
