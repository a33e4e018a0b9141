// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"
#include "core/base/result.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QFile>
#include <QRegularExpression>
#include <QTest>

#include <set>

namespace tst_error {

using namespace axiscomp;

namespace {

/// The codes of core/base/error.h with the context keys that their comments name.
struct Documented {
    std::string name;
    std::set<std::string> keys;
};

std::vector<Documented> documentedCodes()
{
    QFile header(QStringLiteral(AXISCOMP_SOURCE_FOLDER "/core/base/error.h"));
    if (!header.open(QIODevice::ReadOnly))
        return {};
    const QString text = QString::fromUtf8(header.readAll());
    const qsizetype begin = text.indexOf(QLatin1String("enum class ErrorCode {"));
    QString body = text.mid(begin, text.indexOf(QLatin1String("};"), begin) - begin);
    // a comment that goes on in the next line
    static const QRegularExpression continued(QStringLiteral("\\n\\s*///<"));
    body.replace(continued, QStringLiteral(" "));
    static const QRegularExpression row(
        QStringLiteral("^\\s+(\\w+),\\s*///< (.*)$"), QRegularExpression::MultilineOption);
    static const QRegularExpression explanation(QStringLiteral("\\([^)]*\\)|:.*$"));
    static const QRegularExpression separator(QStringLiteral("[,;]"));
    std::vector<Documented> result;
    for (auto matches = row.globalMatch(body); matches.hasNext();) {
        const auto match = matches.next();
        Documented code{match.captured(1).toStdString(), {}};
        const QString keys = match.captured(2).remove(explanation);
        for (const QString& key : keys.split(separator, Qt::SkipEmptyParts))
            code.keys.insert(key.trimmed().toStdString());
        result.push_back(std::move(code));
    }
    return result;
}

std::set<std::string> placeholdersOf(std::string_view text)
{
    std::set<std::string> result;
    for (std::size_t open = text.find('{'); open != text.npos; open = text.find('{', open + 1))
        result.emplace(text.substr(open + 1, text.find('}', open) - open - 1));
    return result;
}

} // namespace

class TestError : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void everyDocumentedCodeHasItsRowInOrder()
    {
        const auto documented = documentedCodes();
        QVERIFY(!documented.empty());
        QCOMPARE(allErrorCodes().size(), documented.size());
        for (std::size_t i = 0; i < documented.size(); ++i) {
            QCOMPARE(allErrorCodes()[i], static_cast<ErrorCode>(i));
            QCOMPARE(errorName(static_cast<ErrorCode>(i)), documented[i].name);
        }
    }

    void everyPlaceholderIsADocumentedKey()
    {
        for (const Documented& code : documentedCodes()) {
            const auto found = std::ranges::find(allErrorCodes(), code.name, errorName);
            QVERIFY2(found != allErrorCodes().end(), code.name.c_str());
            for (const std::string& placeholder : placeholdersOf(errorPattern(*found).words))
                QVERIFY2(code.keys.contains(placeholder),
                    (code.name + " does not document " + placeholder).c_str());
        }
    }

    void namesAreDifferentAndTemplatesAreWhole()
    {
        std::set<std::string_view> names;
        for (const ErrorCode code : allErrorCodes()) {
            QVERIFY(names.insert(errorName(code)).second);
            const std::string_view text = errorPattern(code).words;
            QVERIFY(!text.empty());
            QVERIFY(!text.ends_with('.'));
            QCOMPARE(std::ranges::count(text, '{'), std::ranges::count(text, '}'));
        }
    }

    void theClassSaysWhatBecameOfTheRequest()
    {
        for (const ErrorCode code :
            {ErrorCode::ConnectionLost, ErrorCode::Timeout, ErrorCode::Protocol})
            QVERIFY(mayHaveArrived(code) && isUnreachable(code) && isLinkFailure(code));
        QVERIFY(!mayHaveArrived(ErrorCode::NotConnected) && isUnreachable(ErrorCode::NotConnected));
        for (const ErrorCode code :
            {ErrorCode::Unauthorized, ErrorCode::CertificateRejected, ErrorCode::InvalidEndpoint})
            QVERIFY(isLinkFailure(code) && !isUnreachable(code) && !mayHaveArrived(code));
        for (const ErrorCode code : {ErrorCode::DriveRejected, ErrorCode::Cancelled})
            QVERIFY(!isLinkFailure(code) && !mayHaveArrived(code));
    }

    void aSentenceHasTheValuesOfItsContext()
    {
        const Error error{
            ErrorCode::Timeout, {{"endpoint", Verbatim{"http://drive"}}, {"seconds", 5}}, {}};
        QCOMPARE(sentence(error), "http://drive did not answer within 5 s");
    }

    void whoIsAskedForAPasswordIsNotToldToSendItInClear()
    {
        const auto said = [](const char* endpoint) {
            return sentence({ErrorCode::Unauthorized, {{"endpoint", Verbatim{endpoint}}}, {}});
        };
        QVERIFY(said("https://drive:8443").ends_with("give them as https://user:password@host"));
        QVERIFY(said("http://drive").ends_with("give them as http://user:password@host"));
        const Error wrong{ErrorCode::Unauthorized,
            {{"endpoint", Verbatim{"https://drive"}}, {"given", Verbatim{"yes"}}}, {}};
        QVERIFY(sentence(wrong).starts_with("https://drive refuses the user name or the password"));
    }

    void theShortFormsHandErrorsOnAndGiveValues()
    {
        const auto number = [](bool isThere) -> Result<int> {
            return isThere ? Result<int>(7) : fail(ErrorCode::UnknownFile);
        };
        int calls = 0;
        const auto twice = [&](bool isThere) -> Result<int> {
            AXISCOMP_TRY(const int first, number(true));
            AXISCOMP_TRY(auto second, number(isThere));
            AXISCOMP_CHECK(number(isThere));
            ++calls;
            return first + second;
        };
        VERIFY_RESULT(twice(true));
        QCOMPARE(*twice(true), 14);
        VERIFY_ERROR(twice(false), ErrorCode::UnknownFile);
        QCOMPARE(calls, 2);
    }

    void failMakesAnErrorAndHandsOneOn()
    {
        const auto first = []() -> Result<int> {
            return fail(ErrorCode::UnknownFile, {{"path", Verbatim{"a"}}}, "detail");
        };
        const auto second = [&]() -> Result<std::string> { return fail(first().error()); };
        const auto result = second();
        VERIFY_ERROR(result, ErrorCode::UnknownFile);
        QCOMPARE(result.error().context.english("path"), "a");
        QCOMPARE(result.error().detail, "detail");
    }
};

AXISCOMP_TEST(TestError)

} // namespace tst_error

#include "tst_error.moc"
