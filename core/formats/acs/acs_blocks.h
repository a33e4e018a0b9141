// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

namespace axiscomp::acs {

/// The blocks of a program: from IF, LOOP, WHILE, SWITCH or BLOCK to END, and from ON to RET. A
/// branch is a part of the program that the controller runs only where a condition holds, or
/// several times: all of them but BLOCK. Statements are known by their numbers.
class Blocks {
public:
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

    /// Takes a word that opens, divides or closes a block. False: it is another word.
    bool take(std::string_view word, std::size_t statement);
    /// All blocks end here, as where another buffer begins.
    void close(std::size_t statement);

    [[nodiscard]] bool isInside() const { return !m_open.empty(); }
    /// The innermost branch; none outside of all.
    [[nodiscard]] std::size_t branch() const { return isInside() ? m_open.back().branch : none; }
    /// The branch of the outermost LOOP or WHILE; none outside of all.
    [[nodiscard]] std::size_t loop() const { return isInside() ? m_open.back().loop : none; }
    /// Whether the statement stands in the branch; none is the whole program.
    [[nodiscard]] bool isWithin(std::size_t branch, std::size_t statement) const;

private:
    enum class Kind { Condition, Loop, Plain, Switch, Case, Routine };
    struct Open {
        Kind kind;
        std::size_t branch;
        std::size_t loop;
    };
    struct Branch {
        std::size_t begin;
        std::size_t end = none; ///< behind its last statement
    };

    [[nodiscard]] bool isIn(Kind kind) const { return isInside() && m_open.back().kind == kind; }
    void open(Kind kind, std::size_t statement);
    void closeLast(std::size_t statement);
    [[nodiscard]] bool takeCase(std::size_t statement);

    std::vector<Open> m_open;
    std::vector<Branch> m_branches;
};

} // namespace axiscomp::acs
