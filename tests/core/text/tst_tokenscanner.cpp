// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/token_scanner.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <memory>
#include <random>

namespace tst_tokenscanner {

using namespace axiscomp;

namespace {

/// A text in memory of exactly its size: the sanitizers see what is read beyond it.
class ExactText {
public:
    explicit ExactText(std::string_view text)
        : m_characters(new char[text.size()])
        , m_size(text.size())
    {
        std::ranges::copy(text, m_characters.get());
    }
    [[nodiscard]] std::string_view text() const { return {m_characters.get(), m_size}; }

private:
    std::unique_ptr<char[]> m_characters;
    std::size_t m_size;
};

/// The place of a piece and the piece, for each.
using Pieces = std::vector<std::pair<std::size_t, std::string>>;

Pieces piecesOf(const std::vector<Token>& tokens)
{
    Pieces pieces;
    for (const Token& token : tokens)
        pieces.emplace_back(token.column, token.text);
    return pieces;
}

/// Character by character, as a person would write it down.
Pieces tokensOneByOne(std::string_view line, std::string_view separators)
{
    Pieces pieces;
    bool isOpen = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (separators.find(line[i]) != std::string_view::npos) {
            isOpen = false;
            continue;
        }
        if (!isOpen)
            pieces.emplace_back(i + 1, "");
        pieces.back().second += line[i];
        isOpen = true;
    }
    return pieces;
}

Pieces cellsOneByOne(std::string_view line, char separator)
{
    Pieces pieces;
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= line.size(); ++i) {
        if (i < line.size() && line[i] != separator)
            continue;
        std::string cell(line.substr(begin, i - begin));
        std::size_t column = begin + 1;
        for (; !cell.empty() && (cell[0] == ' ' || cell[0] == '\t'); ++column)
            cell.erase(0, 1);
        while (!cell.empty() && (cell.back() == ' ' || cell.back() == '\t'))
            cell.pop_back();
        pieces.emplace_back(column, cell);
        begin = i + 1;
    }
    return pieces;
}

/// The line as a part of a text that goes on for so many characters; those are separators, digits
/// and ends of lines, of which nothing may be seen.
Token lineIn(const ExactText& text, std::size_t size)
{
    return {text.text().substr(0, size), 7, 1, text.text().data() + text.text().size()};
}

constexpr std::string_view behind = ";1, \t\n9.5e7,;' 0123456789 0123456789 0123456789 0123456789";

} // namespace

class TestTokenScanner : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void piecesAreThoseThatAPersonFinds()
    {
        std::mt19937 random(3); // NOLINT: the same lines every time
        std::vector<Token> found;
        constexpr std::string_view characters = " \t,;'1a.";
        for (int round = 0; round < 20'000; ++round) {
            std::string line(random() % 200, ' ');
            const std::size_t kinds = 1 + random() % characters.size();
            for (char& c : line)
                c = characters[characters.size() - 1 - random() % kinds];
            const ExactText text(line + std::string(behind.substr(0, random() % behind.size())));
            const Token token = lineIn(text, line.size());
            splitTokens(token, " \t,", found);
            QCOMPARE(piecesOf(found), tokensOneByOne(line, " \t,"));
            splitCells(token, ',', found);
            QCOMPARE(piecesOf(found), cellsOneByOne(line, ','));
            QCOMPARE(withoutComment(token, ";'").text,
                std::string_view(line).substr(0, std::string_view(line).find_first_of(";'")));
            QCOMPARE(firstToken(token, " \t,;").text,
                std::string_view(line).substr(0, std::string_view(line).find_first_of(" \t,;")));
        }
    }

    void aPieceMayBeginAndEndAnywhere()
    {
        std::vector<Token> found;
        for (std::size_t begin = 0; begin < 200; ++begin) {
            for (const std::size_t size : {1U, 2U, 15U, 16U, 17U, 63U, 64U, 65U, 128U}) {
                const std::string line = std::string(begin, ' ') + std::string(size, 'x');
                for (const std::size_t more : {0U, 1U, 15U, 16U, 17U, 50U}) {
                    const ExactText text(line + std::string(behind.substr(0, more)));
                    const Token token = lineIn(text, line.size());
                    splitTokens(token, " \t", found);
                    QCOMPARE(piecesOf(found), (Pieces{{begin + 1, std::string(size, 'x')}}));
                    QCOMPARE(found[0].line, std::size_t{7});
                    splitCells(token, ',', found);
                    QCOMPARE(piecesOf(found), (Pieces{{begin + 1, std::string(size, 'x')}}));
                }
            }
        }
    }

    void aLineEndsWhereItsEndStands_data()
    {
        QTest::addColumn<QByteArray>("end");
        QTest::newRow("LF") << QByteArray("\n");
        QTest::newRow("CRLF") << QByteArray("\r\n");
        QTest::newRow("CR") << QByteArray("\r");
    }
    void aLineEndsWhereItsEndStands()
    {
        QFETCH(QByteArray, end);
        for (std::size_t size = 0; size < 140; ++size) {
            const std::string one(size, '1');
            const ExactText text(
                one + end.toStdString() + end.toStdString() + "2" + end.toStdString());
            TextLines lines(text.text());
            const std::array<std::string, 3> due{one, "", "2"};
            for (std::size_t n = 0; n < due.size(); ++n) {
                const auto line = lines.next();
                QVERIFY(line);
                QCOMPARE(std::string(line->text), due[n]);
                QCOMPARE(line->line, n + 1);
            }
            QVERIFY(!lines.next());
        }
    }

    void aNumberIsReadToItsEndAndNotBeyond()
    {
        for (const std::string number : {"0", "-1.25", "1e3", "12345678", "0.123456789",
                 "-0.0029876543219876543", "1.7976931348623157e308"}) {
            const auto due = numberOf(number);
            QVERIFY(due);
            for (std::size_t more = 0; more <= behind.size(); ++more) {
                for (const std::string_view following : {behind, std::string_view("7777777777")}) {
                    const ExactText text(number + std::string(following.substr(0, more)));
                    double value = 0.0;
                    QVERIFY(isNumber(lineIn(text, number.size()), value));
                    QCOMPARE(value, *due);
                    // a piece of a number is a number of its own
                    const Token first = lineIn(text, 1);
                    QCOMPARE(isNumber(first, value), number[0] != '-');
                }
            }
        }
    }

    void aKeyMayHaveBlanksBeforeItsColon()
    {
        for (const char* comment : {"sign: command", " Sign :  command ,,", "SIGN\t:command; "}) {
            const auto stated = statedIn(comment, "sign:");
            QVERIFY2(stated, comment);
            QCOMPARE(std::string(*stated), std::string("command"));
        }
        for (const char* comment : {"signs: command", "sign command: x", "sign", "sig: x", ""})
            QVERIFY2(!statedIn(comment, "sign:"), comment);
        QVERIFY(behindKey("target : Z", "target:") == std::string_view(" Z"));
    }

    void whatIsNoNumberSaysWhereAndWhat()
    {
        const ExactText text("  1.5x, 2,3 nan 1e400 1e-400");
        std::vector<Token> tokens;
        splitTokens({text.text(), 3, 1, text.text().data() + text.text().size()}, " ", tokens);
        DiagnosticList diagnostics(10);
        std::vector<double> numbers{7.0};
        readNumbers(tokens, AXISCOMP_TEXT("Error", "a correction"), numbers, diagnostics);
        QCOMPARE(numbers, (std::vector<double>{7.0, 0.0, 0.0, 0.0, 0.0, 0.0}));
        const std::vector<Diagnostic> problems = diagnostics.take();
        QCOMPARE(problems.size(), std::size_t{4});
        const std::array<std::pair<std::size_t, std::string>, 4> due{
            {{3, "1.5x,"}, {9, "2,3"}, {13, "nan"}, {17, "1e400"}}};
        for (std::size_t n = 0; n < due.size(); ++n) {
            QCOMPARE(problems[n].code, DiagnosticCode::NotANumber);
            QCOMPARE(problems[n].line, std::size_t{3});
            QCOMPARE(problems[n].column, due[n].first);
            QCOMPARE(problems[n].found.english(), due[n].second);
            QCOMPARE(problems[n].expected.english(), std::string("a correction"));
        }
    }
};

AXISCOMP_TEST(TestTokenScanner)

} // namespace tst_tokenscanner

#include "tst_tokenscanner.moc"
