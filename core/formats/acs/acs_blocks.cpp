// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/acs/acs_blocks.h"

#include "core/text/token_scanner.h"

namespace axiscomp::acs {

bool Blocks::take(std::string_view word, std::size_t statement)
{
    const auto is = [word](std::string_view name) { return sameLetters(word, name); };
    if (is("IF")) {
        open(Kind::Condition, statement);
    } else if (is("ELSE") || is("ELSEIF")) {
        if (isIn(Kind::Condition)) {
            closeLast(statement);
            open(Kind::Condition, statement);
        }
    } else if (is("LOOP") || is("WHILE")) {
        open(Kind::Loop, statement);
    } else if (is("BLOCK")) {
        open(Kind::Plain, statement);
    } else if (is("SWITCH")) {
        open(Kind::Switch, statement);
    } else if (is("CASE") || is("DEFAULT")) {
        return takeCase(statement);
    } else if (is("END")) {
        if (isInside() && !isIn(Kind::Routine))
            closeLast(statement);
    } else if (is("ON")) {
        close(statement);
        open(Kind::Routine, statement);
    } else if (is("RET")) {
        if (isIn(Kind::Routine))
            closeLast(statement);
    } else {
        return false;
    }
    return true;
}

/// END ends a case, too; without it the next case goes on.
bool Blocks::takeCase(std::size_t statement)
{
    if (!isIn(Kind::Switch) && !isIn(Kind::Case))
        return false;
    if (isIn(Kind::Case))
        closeLast(statement);
    open(Kind::Case, statement);
    return true;
}

void Blocks::open(Kind kind, std::size_t statement)
{
    Open opened{kind, branch(), loop()};
    if (kind != Kind::Plain) {
        opened.branch = m_branches.size();
        m_branches.push_back({statement});
    }
    if (kind == Kind::Loop && opened.loop == none)
        opened.loop = opened.branch;
    m_open.push_back(opened);
}

void Blocks::closeLast(std::size_t statement)
{
    if (!isIn(Kind::Plain))
        m_branches[m_open.back().branch].end = statement;
    m_open.pop_back();
}

void Blocks::close(std::size_t statement)
{
    while (isInside())
        closeLast(statement);
}

bool Blocks::isWithin(std::size_t branch, std::size_t statement) const
{
    return branch == none
        || (m_branches[branch].begin <= statement && statement < m_branches[branch].end);
}

} // namespace axiscomp::acs
