// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/text_file.h"

#include "core/base/parallel.h"
#include "core/text/utf8.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>

namespace axiscomp {

namespace {

struct ByteKinds {
    bool nonAscii = false;
    bool nul = false;
};

/// Sixteen at a time, which each of our processors does in one go.
using SixteenBytes [[gnu::vector_size(16)]] = unsigned char;

ByteKinds byteKinds(std::string_view text)
{
    SixteenBytes all{};
    SixteenBytes zeros{};
    std::size_t i = 0;
    for (; i + sizeof all <= text.size(); i += sizeof all) {
        SixteenBytes bytes;
        std::memcpy(&bytes, text.data() + i, sizeof bytes);
        all |= bytes;
        zeros |= bytes == 0;
    }
    for (; i < text.size(); ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        all[0] |= byte;
        zeros[0] |= byte == 0 ? 1 : 0;
    }
    ByteKinds kinds;
    for (std::size_t n = 0; n < sizeof all; ++n) {
        kinds.nonAscii = kinds.nonAscii || all[n] >= 0x80;
        kinds.nul = kinds.nul || zeros[n] != 0;
    }
    return kinds;
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

bool isUtf16(std::string_view text)
{
    return text.starts_with("\xFF\xFE"sv) || text.starts_with("\xFE\xFF"sv) || looksLikeUtf16(text);
}

TextInspection::TextInspection(std::string_view text, const std::stop_token& stop,
    DiagnosticList& diagnostics, std::size_t threads)
    : m_diagnostics(diagnostics)
    , m_body(text)
{
    if (m_body.starts_with("\xEF\xBB\xBF"))
        m_body.remove_prefix(3);
    if (!refuseForeignFormat(text) && !refuseNul(stop, threads) && !m_ascii)
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

bool TextInspection::refuseNul(const std::stop_token& stop, std::size_t threads)
{
    constexpr std::size_t piece = std::size_t{1} << 20U;
    std::atomic<bool> nonAscii = false;
    std::atomic<bool> nul = false;
    shareWork((m_body.size() + piece - 1) / piece, threads, [&](std::size_t index) {
        if (stop.stop_requested())
            return;
        const ByteKinds kinds = byteKinds(m_body.substr(index * piece, piece));
        if (kinds.nonAscii)
            nonAscii = true;
        if (kinds.nul)
            nul = true;
    });
    m_ascii = !nonAscii;
    return nul && refuse(AXISCOMP_TEXT("Error", "a NUL byte"), lineAt(m_body, m_body.find('\0')));
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
    const auto isBlank = [](char c) { return c == ' ' || c == '\t'; };
    while (!text.empty() && isBlank(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back()))
        text.remove_suffix(1);
    return text;
}

} // namespace axiscomp
