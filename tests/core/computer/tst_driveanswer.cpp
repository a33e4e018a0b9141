// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/computer/drive_answer.h"
#include "core/drive/forwarding_link.h"
#include "core/drive/looking_link.h"
#include "drivecomm/profile/profile_loader.h"
#include "drivecomm/virtualdrive/demo_link.h"
#include "tests/support/scripted_link.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTemporaryDir>

#include <algorithm>

namespace tst_driveanswer {

using namespace axiscomp;
using namespace std::chrono_literals;

namespace {

const std::string address = "http://192.168.1.20";

Error errorOf(ErrorCode code)
{
    return Error{code, {{"endpoint", address}, {"reason", Verbatim{"refused"}}}, {}};
}

DriveAnswer answered()
{
    DriveAnswer answer;
    answer.endpoint = address;
    answer.profile = "generic";
    answer.drive = DriveIdentity{"Mill", 1559, 2};
    return answer;
}

AxisSummary axisIn(CompensationState state, CompensationFault fault)
{
    AxisSummary row;
    row.status.emplace();
    row.status->axis.state = state;
    row.status->fault = fault;
    row.status->error = "NotHomed";
    return row;
}

/// Is lost after so many exchanges.
class LinkThatIsLost final : public ForwardingLink<LinkThatIsLost> {
public:
    LinkThatIsLost(std::unique_ptr<DriveLink> link, int exchanges)
        : ForwardingLink(std::move(link))
        , m_left(exchanges)
    {
    }

private:
    friend ForwardingLink;
    template <typename Call>
    auto around(const Exchange& exchange, const Call& call) -> decltype(call(exchange))
    {
        if (m_left-- <= 0)
            return tl::unexpected(errorOf(ErrorCode::ConnectionLost));
        return call(exchange);
    }

    int m_left;
};

std::vector<Finding> findingsOf(const DriveAnswer& answer)
{
    return driveFindings({answer}).findings;
}

} // namespace

/// What a drive answers is looked at within one deadline, and nothing is written to it.
class TestDriveAnswer final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void nothingIsWrittenThroughALinkThatLooks();
    void allExchangesShareOneDeadline();
    void aTimeoutSaysTheWholeTime();
    void theDemoDriveAnswersAll();
    void whatDoesNotAnswerSaysWhereToLook();
    void anUnknownCertificateSaysHowToTrustIt();
    void whatStopsInTheMiddleSaysBoth();
    void axesThatWereReadStayWhenTheDriveIsLost();
    void anAxisInErrorSaysWhatToDo();
    void anErrorOfTheDriveIsSaidOnce();
    void withoutADriveItSaysHowToGiveOne();
};

void TestDriveAnswer::nothingIsWrittenThroughALinkThatLooks()
{
    std::atomic<int> requests = 0;
    LookingLink link(std::make_unique<test::ScriptedLink>(
                         address, [](const Exchange&) { return DriveIdentity{}; }, requests),
        1h);
    const std::vector<RegisterWrite> writes{{"a", RegisterValue{}}};
    VERIFY_ERROR(link.writeRegisters(writes, {}), ErrorCode::NotAllowedNow);
    VERIFY_ERROR(link.upload("a", {}, {}), ErrorCode::NotAllowedNow);
    QCOMPARE(requests.load(), 0);
    VERIFY_ERROR(link.listFiles({}), ErrorCode::DriveRejected); // that goes through
    QCOMPARE(requests.load(), 1);
}

void TestDriveAnswer::allExchangesShareOneDeadline()
{
    std::atomic<int> requests = 0;
    std::vector<std::chrono::milliseconds> given;
    LookingLink link(std::make_unique<test::ScriptedLink>(
                         address,
                         [&](const Exchange& exchange) {
                             given.push_back(exchange.timeout);
                             return DriveIdentity{};
                         },
                         requests),
        1h);
    const Exchange patient{.timeout = 24h, .stop = {}, .progress = {}};
    for (int n = 0; n < 3; ++n)
        VERIFY_RESULT(link.identify(patient));
    QVERIFY(given.front() <= 1h);
    QVERIFY(std::ranges::is_sorted(given, std::greater<>{}));
    VERIFY_RESULT(link.identify({.timeout = 5ms, .stop = {}, .progress = {}}));
    QVERIFY(given.back() == 5ms);
}

void TestDriveAnswer::aTimeoutSaysTheWholeTime()
{
    std::atomic<int> requests = 0;
    int asked = 0;
    const auto silent = [&](const Exchange&) -> Result<DriveIdentity> {
        ++asked;
        return fail(ErrorCode::Timeout, {{"endpoint", address}, {"seconds", Quantity{"0.001"}}});
    };
    const auto said = [&](std::chrono::milliseconds together) {
        LookingLink link(std::make_unique<test::ScriptedLink>(address, silent, requests), together);
        const auto drive = link.identify({.timeout = 24h, .stop = {}, .progress = {}});
        return drive ? std::string() : sentence(drive.error());
    };
    QCOMPARE(said(90min), address + " did not answer within 5400 s");
    QCOMPARE(asked, 1);
    QCOMPARE(said(0ms), address + " did not answer within 0 s"); // and is not asked any more
    QCOMPARE(asked, 1);
}

void TestDriveAnswer::theDemoDriveAnswersAll()
{
    const QTemporaryDir folder;
    const std::filesystem::path root =
        std::filesystem::path(folder.path().toStdString()) / "axiscomp";
    const DriveProfile& profile = drivecomm::genericProfile();
    const DriveAnswer answer = askDrive("demo:", "demo:",
        {.linkFactory = [&](const std::string&) { return drivecomm::makeDemoLink(profile); },
            .profile = profile,
            .storeRoot = root,
            .timeLimit = 1h});
    QVERIFY2(!answer.error, answer.error ? sentence(*answer.error).c_str() : "");
    QVERIFY(answer.drive && answer.drive->axes == 2);
    const auto findings = findingsOf(answer);
    QCOMPARE(findings.size(), std::size_t{3});
    for (const Finding& finding : findings)
        QVERIFY2(finding.grade == Grade::Ok, finding.found.english().c_str());
    const std::string active = findings[1].found.english();
    QVERIFY2(active.find(", table Small1 with CRC ") != std::string::npos, active.c_str());
    QVERIFY(!std::filesystem::exists(root));
}

void TestDriveAnswer::whatDoesNotAnswerSaysWhereToLook()
{
    DriveAnswer answer;
    answer.endpoint = address;
    answer.error = errorOf(ErrorCode::NotConnected);
    QCOMPARE(findingsOf(answer).size(), std::size_t{1});
    const Finding finding = findingsOf(answer).front();
    QCOMPARE(finding.grade, Grade::Problem);
    QCOMPARE(finding.name.english(), address);
    QVERIFY(finding.wayOut.english().find(address + " in a browser") != std::string::npos);
    answer.endpoint = "serial:/dev/ttyUSB0";
    answer.error = errorOf(ErrorCode::Timeout);
    QVERIFY(findingsOf(answer).front().wayOut.english().find("--any-baud") != std::string::npos);
    answer.error = errorOf(ErrorCode::Unauthorized); // its sentence has the way out
    QVERIFY(findingsOf(answer).front().wayOut.isEmpty());
}

void TestDriveAnswer::anUnknownCertificateSaysHowToTrustIt()
{
    const auto wayOut = [](const char* hasChanged) {
        DriveAnswer answer;
        answer.endpoint = "https://drive";
        answer.error = Error{ErrorCode::CertificateRejected,
            {{"endpoint", answer.endpoint}, {"reason", Verbatim{"it is self-signed"}},
                {"fingerprint", Verbatim{"AB:CD"}}, {"hasChanged", Verbatim{hasChanged}}},
            {}};
        return findingsOf(answer).front().wayOut.english();
    };
    const std::string unknown = wayOut("no");
    QVERIFY2(unknown.find("axiscomp axes --drive https://drive --trust-certificate AB:CD`")
            != std::string::npos,
        unknown.c_str());
    QCOMPARE(wayOut("yes"), "");
}

void TestDriveAnswer::whatStopsInTheMiddleSaysBoth()
{
    DriveAnswer answer = answered();
    answer.error = errorOf(ErrorCode::ConnectionLost);
    const Finding finding = findingsOf(answer).front();
    QCOMPARE(finding.grade, Grade::Problem);
    const std::string found = finding.found.english();
    QVERIFY2(found.find("Mill, serial number 1559") == 0, found.c_str());
    QVERIFY2(found.find("was lost") != std::string::npos, found.c_str());
}

void TestDriveAnswer::axesThatWereReadStayWhenTheDriveIsLost()
{
    const QTemporaryDir folder;
    const DriveProfile& profile = drivecomm::genericProfile();
    std::vector<std::size_t> axes;
    for (int exchanges = 1; axes.empty() || axes.back() < 2; ++exchanges) {
        QVERIFY(exchanges < 100);
        const DriveAnswer answer = askDrive("demo:", "demo:",
            {.linkFactory = [&](const std::string&) -> Result<std::unique_ptr<DriveLink>> {
                 AXISCOMP_TRY(auto link, drivecomm::makeDemoLink(profile));
                 return std::make_unique<LinkThatIsLost>(std::move(link), exchanges);
             },
                .profile = profile,
                .storeRoot = folder.path().toStdString(),
                .timeLimit = 1h});
        QVERIFY(answer.drive);
        QCOMPARE(answer.error.has_value(), answer.axes.size() < 2);
        axes.push_back(answer.axes.size());
    }
    QVERIFY(std::ranges::find(axes, std::size_t{1}) != axes.end());
}

void TestDriveAnswer::anAxisInErrorSaysWhatToDo()
{
    DriveAnswer answer = answered();
    answer.axes.push_back(axisIn(CompensationState::Error, CompensationFault::NotHomed));
    const Finding finding = findingsOf(answer).back();
    QCOMPARE(finding.grade, Grade::Problem);
    QVERIFY(finding.found.english().find("must be homed first") != std::string::npos);
    answer.axes = {AxisSummary{}};
    QCOMPARE(findingsOf(answer).back().grade, Grade::Note); // no compensation
    answer.axes.front().problem = errorOf(ErrorCode::UnknownRegister);
    QCOMPARE(findingsOf(answer).back().grade, Grade::Problem);
}

void TestDriveAnswer::anErrorOfTheDriveIsSaidOnce()
{
    DriveAnswer answer = answered();
    answer.axes = {AxisSummary{}};
    for (int n = 0; n < 2; ++n) {
        answer.axes.push_back(axisIn(CompensationState::Disabled, CompensationFault::None));
        answer.axes.back().status->hasDriveError = true;
        answer.axes.back().status->driveError = "OverTemperature";
    }
    const auto findings = findingsOf(answer);
    const auto said = std::ranges::count_if(findings,
        [](const Finding& finding) { return finding.found.english() == "OverTemperature"; });
    QCOMPARE(said, 1);
}

void TestDriveAnswer::withoutADriveItSaysHowToGiveOne()
{
    const FindingSection none = driveFindings({});
    QCOMPARE(none.findings.size(), std::size_t{1});
    QCOMPARE(none.findings.front().grade, Grade::Note);
    QVERIFY(none.findings.front().wayOut.english().find("--drive") != std::string::npos);
}

AXISCOMP_TEST(TestDriveAnswer)

} // namespace tst_driveanswer

#include "tst_driveanswer.moc"
