// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/web/directory_listing.h"
#include "tests/drivecomm/web/web_link_fixture.h"
#include "tests/support/test_registry.h"

#include <QTest>

namespace tst_linklimits {

using namespace axiscomp;
using namespace axiscomp::drivecomm;
using namespace axiscomp::test;
using namespace std::chrono_literals;

namespace {

constexpr std::size_t mebibyte = std::size_t{1} << 20;

std::vector<DriveFile> manyFiles(int count)
{
    std::vector<DriveFile> files;
    for (int i = 0; i < count; ++i)
        files.push_back({"tables/" + std::to_string(i), 0, 1000});
    return files;
}

/// A JSON array of registers, with blanks up to so many bytes.
std::string registersOfSize(std::size_t bytes)
{
    std::string text = states(stateOfX, stateOfY);
    text.insert(1, bytes - text.size(), ' ');
    return text;
}

} // namespace

/// What a drive may answer at most; how a reply is cut is in tst_httpreplyparser and
/// tst_webanswers.
class LinkLimitsTest final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void takesAThousandFiles();
    void takesAMebibyteOfRegisters();
    void takesSixteenMebibytesOfATree();
    void takesSixteenMebibytesOfAFileItDoesNotKnow();
    void countsAThousandAxes();
    void cutsALongReason_data();
    void cutsALongReason();
};

void LinkLimitsTest::takesAThousandFiles()
{
    const RawResponder good(json(directoryJson(manyFiles(1000))));
    const auto files = webLinkTo(good.url())->listFiles(within(60s));
    VERIFY_RESULT(files);
    QCOMPARE(files->size(), std::size_t{1000});
    const RawResponder bad(json(directoryJson(manyFiles(1001))));
    const auto refused = webLinkTo(bad.url())->listFiles(within(60s));
    VERIFY_ERROR(refused, ErrorCode::Protocol);
    QCOMPARE(refused.error().context.english("expected"), std::string("at most 1000 files"));
}

void LinkLimitsTest::takesAMebibyteOfRegisters()
{
    const RawResponder good(json(registersOfSize(mebibyte)));
    VERIFY_RESULT(webLinkTo(good.url())->readRegisters(twoStates, within(60s)));
    const RawResponder bad(json(registersOfSize(mebibyte + 1)));
    VERIFY_ERROR(webLinkTo(bad.url())->readRegisters(twoStates, within(60s)), ErrorCode::Protocol);
}

void LinkLimitsTest::takesSixteenMebibytesOfATree()
{
    const RawResponder good(json(registersOfSize(16 * mebibyte)));
    const auto all = webLinkTo(good.url())->readTree("Axes", within(60s));
    // The index is a part of the name: both are read, and found to be somewhere else.
    VERIFY_ERROR(all, ErrorCode::Protocol);
    QCOMPARE(all.error().context.english("expected"), std::string("registers below Axes"));
    const RawResponder bad(json(registersOfSize(16 * mebibyte + 1)));
    const auto refused = webLinkTo(bad.url())->readTree("Axes[0]", within(60s));
    VERIFY_ERROR(refused, ErrorCode::Protocol);
    QCOMPARE(refused.error().context.english("expected"), std::string("at most 16777216 bytes"));
}

void LinkLimitsTest::takesSixteenMebibytesOfAFileItDoesNotKnow()
{
    const auto file = [](std::size_t bytes) {
        return always(httpReply("200 OK", "application/octet-stream", std::string(bytes, 'x')));
    };
    const RawResponder good(file(16 * mebibyte));
    const auto bytes = webLinkTo(good.url())->download("logs/all", within(60s));
    VERIFY_RESULT(bytes);
    QCOMPARE(bytes->size(), 16 * mebibyte);
    const RawResponder bad(file(16 * mebibyte + 1));
    VERIFY_ERROR(webLinkTo(bad.url())->download("logs/all", within(60s)), ErrorCode::Protocol);
}

void LinkLimitsTest::countsAThousandAxes()
{
    const RawResponder good(driveWithAxes(1023, Missing::Named));
    const auto identity = webLinkTo(good.url())->identify(within(60s));
    VERIFY_RESULT(identity);
    QCOMPARE(identity->axes, 1023);
    const RawResponder bad(driveWithAxes(1'000'000, Missing::Named));
    const auto refused = webLinkTo(bad.url())->identify(within(60s));
    VERIFY_ERROR(refused, ErrorCode::Protocol);
    QCOMPARE(refused.error().context.english("expected"), std::string("at most 1024 axes"));
}

void LinkLimitsTest::cutsALongReason_data()
{
    QTest::addColumn<QString>("body");
    QTest::addColumn<QString>("type");
    const QString text(900'000, u'\u00b5'); // two bytes each
    QTest::newRow("JSON") << QStringLiteral(R"({"error":{"code":"NotAllowedNow","message":"a%1"}})")
                                 .arg(text.first(400'000))
                          << "application/json";
    QTest::newRow("a page") << text.first(400'000) << "text/html";
}

void LinkLimitsTest::cutsALongReason()
{
    QFETCH(QString, body);
    QFETCH(QString, type);
    const RawResponder drive(
        always(httpReply("409 Conflict", type.toStdString(), body.toStdString())));
    const auto refused = webLinkTo(drive.url())->writeRegisters(oneWrite, within(60s));
    VERIFY_ERROR(refused, ErrorCode::NotAllowedNow);
    const std::string reason = refused.error().context.english("reason");
    QVERIFY2(reason.size() <= 1000, std::to_string(reason.size()).c_str());
    QVERIFY(!reason.empty());
    QVERIFY(!QString::fromStdString(reason).contains(QChar::ReplacementCharacter));
}

AXISCOMP_TEST(LinkLimitsTest)

} // namespace tst_linklimits

#include "tst_linklimits.moc"
