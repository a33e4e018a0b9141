// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace axiscomp {

/// One to four ASCII characters that separate pieces of a text or begin a comment, and where they
/// are in it.
class CharacterSet {
public:
    template <std::size_t Size>
    requires(Size >= 2 && Size <= 5) consteval CharacterSet(
        const char (&characters)[Size]) // NOLINT(google-explicit-constructor)
        : CharacterSet(characters[0])
    {
        for (std::size_t i = 1; i + 1 < Size; ++i) {
            m_packed &= ~(std::uint32_t{0xFF} << 8 * i);
            m_packed |= std::uint32_t{static_cast<unsigned char>(characters[i])} << 8 * i;
        }
    }
    constexpr explicit CharacterSet(char character)
        : m_packed(std::uint32_t{0x01010101} * static_cast<unsigned char>(character))
    {
    }

    [[nodiscard]] constexpr bool contains(char c) const
    {
        return c == character(0) || c == character(1) || c == character(2) || c == character(3);
    }

    /// How many characters among() looks at.
    static constexpr std::size_t blockSize = 64;

    /// Bit i is set where begin[i] is one of these, for i below count, which is at most blockSize.
    /// Memory may be read up to readable, at or behind these characters.
    [[nodiscard]] std::uint64_t among(
        const char* begin, std::size_t count, const char* readable) const
    {
        std::uint64_t found = 0;
        std::size_t i = 0;
#ifdef __SSE2__
        for (; i < count && readable - (begin + i) >= 16; i += 16)
            found |= std::uint64_t{amongSixteen(begin + i)} << i;
#endif
        for (; i < count; ++i)
            found |= std::uint64_t{contains(begin[i])} << i;
        return found & lowestBits(count);
    }

    /// Where the first of them is in a text; its size without one. readable: as above.
    [[nodiscard]] std::size_t findIn(std::string_view text, const char* readable) const
    {
        for (std::size_t at = 0; at < text.size(); at += blockSize)
            if (const std::uint64_t found =
                    among(text.data() + at, std::min(blockSize, text.size() - at), readable))
                return at + static_cast<std::size_t>(std::countr_zero(found));
        return text.size();
    }

    /// The first count bits, at most 64.
    [[nodiscard]] static constexpr std::uint64_t lowestBits(std::size_t count)
    {
        return count < blockSize ? (std::uint64_t{1} << count) - 1 : ~std::uint64_t{0};
    }

private:
    [[nodiscard]] constexpr char character(unsigned n) const
    {
        return static_cast<char>(m_packed >> 8U * n & 0xFFU);
    }
#ifdef __SSE2__
    [[nodiscard]] std::uint32_t amongSixteen(const char* begin) const
    {
        const __m128i text = _mm_loadu_si128(reinterpret_cast<const __m128i*>(begin));
        const auto places = [&](char c) { return _mm_cmpeq_epi8(text, _mm_set1_epi8(c)); };
        const __m128i all = _mm_or_si128(_mm_or_si128(places(character(0)), places(character(1))),
            _mm_or_si128(places(character(2)), places(character(3))));
        return static_cast<std::uint32_t>(_mm_movemask_epi8(all));
    }
#endif

    std::uint32_t m_packed; ///< in one register; a set of fewer than four repeats the first one
};

} // namespace axiscomp
