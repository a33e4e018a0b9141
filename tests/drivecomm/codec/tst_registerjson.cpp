// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/codec/error_json.h"
#include "drivecomm/codec/register_json.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace tst_registerjson {

using namespace axiscomp;
using namespace axiscomp::drivecomm;
using namespace axiscomp::test;

class RegisterJsonTest final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void writesValuesShortAndExact_data();
    void writesValuesShortAndExact();
    void singlesSurviveReadersThatOnlyKnowDoubles();
    void takesNullForNotANumber();
    void knowsWhatATypeCanHold_data();
    void knowsWhatATypeCanHold();
    void namesThePlaceOfAFault_data();
    void namesThePlaceOfAFault();
    void bringsErrorsAcross_data();
    void bringsErrorsAcross();
    void takesUnknownErrorsAsRefusals();
};

void RegisterJsonTest::writesValuesShortAndExact_data()
{
    QTest::addColumn<RegisterValue>("value");
    QTest::addColumn<QString>("json");
    const auto row = [](const RegisterValue& value, const char* json) {
        QTest::addRow("%s (%d)", json, static_cast<int>(value.index())) << value << json;
    };
    row(true, "true");
    row(false, "false");
    row(std::int32_t{-2147483647 - 1}, "-2147483648");
    row(std::uint32_t{4294967295U}, "4294967295");
    row(0.1F, "0.1");
    row(0.1, "0.1");
    row(12.5F, "12.5");
    row(-0.0F, "-0.0");
    row(-0.0, "-0.0");
    row(1e300, "1e+300");
    row(1.0 / 3.0, "0.3333333333333333");
    row(std::numeric_limits<float>::max(), "3.4028235e+38");
    row(std::numeric_limits<double>::infinity(), "null");
    row(std::numeric_limits<float>::quiet_NaN(), "null");
    row(std::string("Small1"), "\"Small1\"");
    row(std::string("a\"b\\\n"), R"("a\"b\\\n")");
}

void RegisterJsonTest::writesValuesShortAndExact()
{
    QFETCH(RegisterValue, value);
    QFETCH(QString, json);
    QCOMPARE(valueJson(value), json.toStdString());
}

void RegisterJsonTest::singlesSurviveReadersThatOnlyKnowDoubles()
{
    std::mt19937 random(20240229); // NOLINT(cert-msc51-cpp): the same numbers in every run
    for (int i = 0; i < 200'000; ++i) {
        const float value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
        if (!std::isfinite(value))
            continue;
        const std::string json = valueJson(value);
        const double asDouble = std::stod(json);
        QCOMPARE(std::bit_cast<std::uint32_t>(static_cast<float>(asDouble)),
            std::bit_cast<std::uint32_t>(value));
        QVERIFY(json.size() <= 24);
    }
}

void RegisterJsonTest::takesNullForNotANumber()
{
    const auto readings =
        parseReadings(R"([{"path":"a","address":1,"type":"Double","value":null}])");
    VERIFY_RESULT(readings);
    QVERIFY(std::isnan(std::get<double>(readings->front().value)));
    QVERIFY(!parseReadings(R"([{"path":"a","address":1,"type":"Int32","value":null}])"));
    QVERIFY(!parseReadings(R"([{"path":"a","address":1,"type":"Table","value":null}])"));
}

void RegisterJsonTest::knowsWhatATypeCanHold_data()
{
    QTest::addColumn<QString>("type");
    QTest::addColumn<JsonValue>("value");
    QTest::addColumn<bool>("fits");
    const auto row = [](const char* type, const JsonValue& value, bool fits) {
        QTest::addRow("%s %s", type, describe(value).c_str()) << type << value << fits;
    };
    using Natural = std::uint64_t;
    using Integer = std::int64_t;
    row("Boolean", true, true);
    row("Boolean", Natural{1}, false);
    row("Boolean", std::string("true"), false);
    row("Int32", Natural{2147483647}, true);
    row("Int32", Natural{2147483648}, false);
    row("Int32", Integer{-2147483648LL}, true);
    row("Int32", Integer{-2147483649LL}, false);
    row("Int32", 1.0, false);
    row("UInt32", Natural{4294967295}, true);
    row("UInt32", Natural{4294967296}, false);
    row("UInt32", Integer{-1}, false);
    row("UInt32", nullptr, false);
    row("Single", Natural{1}, true);
    row("Single", 1e38, true);
    row("Single", 1e39, false);
    row("Single", -1e39, false);
    row("Single", 1e-60, true);
    row("Single", std::string("1"), false);
    row("Double", 1e308, true);
    row("Double", true, false);
    row("SourceTable", std::string("Small1"), true);
    row("SourceTable", Natural{1}, false);
    row("SourceTable", nullptr, false);
}

void RegisterJsonTest::knowsWhatATypeCanHold()
{
    QFETCH(QString, type);
    QFETCH(JsonValue, value);
    QFETCH(bool, fits);
    QCOMPARE(typedValue(type.toStdString(), value).has_value(), fits);
}

void RegisterJsonTest::namesThePlaceOfAFault_data()
{
    QTest::addColumn<QString>("json");
    QTest::addColumn<QString>("place");
    QTest::newRow("no JSON") << "[{"
                             << "not JSON";
    QTest::newRow("no array") << "1"
                              << "array";
    QTest::newRow("no object") << R"([{"path":"a","value":1}, 2])"
                               << "[1] ";
    QTest::newRow("path") << R"([{"path":2,"value":1}])"
                          << "[0].path";
    QTest::newRow("value") << R"([{"path":"a","value":{}}])"
                           << "[0].value";
    QTest::newRow("deep") << QString(100, QLatin1Char('[')) << "not JSON";
}

void RegisterJsonTest::namesThePlaceOfAFault()
{
    QFETCH(QString, json);
    QFETCH(QString, place);
    const auto writes = parseWrites(json.toStdString());
    VERIFY_ERROR(writes, ErrorCode::DriveRejected);
    QVERIFY(QString::fromStdString(writes.error().context.english("reason")).contains(place));
}

void RegisterJsonTest::bringsErrorsAcross_data()
{
    QTest::addColumn<ErrorCode>("code");
    QTest::addColumn<int>("status");
    QTest::newRow("DriveRejected") << ErrorCode::DriveRejected << 400;
    QTest::newRow("Unauthorized") << ErrorCode::Unauthorized << 401;
    QTest::newRow("UnknownRegister") << ErrorCode::UnknownRegister << 404;
    QTest::newRow("UnknownFile") << ErrorCode::UnknownFile << 404;
    QTest::newRow("NotAllowedNow") << ErrorCode::NotAllowedNow << 409;
    QTest::newRow("TooLargeForSlot") << ErrorCode::TooLargeForSlot << 413;
    QTest::newRow("TableRefused") << ErrorCode::TableRefused << 422;
    QTest::newRow("FlashWear") << ErrorCode::FlashWear << 503;
}

void RegisterJsonTest::bringsErrorsAcross()
{
    QFETCH(ErrorCode, code);
    QFETCH(int, status);
    QCOMPARE(httpStatus(code), status);
    const Text reason = AXISCOMP_TEXT("Error", "because \"of\" {this}")
                            .with("this", AXISCOMP_TEXT("Error", "that"));
    const ErrorContext context{{"reason", reason}, {"path", Verbatim{"Axes[0]/Nix"}},
        {"nearest", Verbatim{"Axes[0]/Nx"}}, {"seconds", 583}};
    const auto error = parseErrorJson(errorJson({code, context, {}}));
    QVERIFY(error);
    QCOMPARE(error->code, code);
    QCOMPARE(error->context, context);
}

void RegisterJsonTest::takesUnknownErrorsAsRefusals()
{
    const auto error = parseErrorJson(R"({"error":{"code":"OnFire","message":"hot"}})");
    QVERIFY(error);
    QCOMPARE(error->code, ErrorCode::DriveRejected);
    QCOMPARE(sentence(*error), std::string("the drive refused: hot"));
    // What only this program can find out, no drive can claim.
    const auto claimed = parseErrorJson(R"({"error":{"code":"VerifyMismatch","message":"x"}})");
    QVERIFY(claimed);
    QCOMPARE(claimed->code, ErrorCode::DriveRejected);
    // Nor a text that cannot be read: then the message counts.
    const auto odd = parseErrorJson(R"({"error":{"message":"hot","text":{"words":"cold"}}})");
    QVERIFY(odd);
    QCOMPARE(odd->context.find("reason")->value(), Argument(Text(Verbatim{"hot"})).value());
    for (const char* other : {"", "[]", "{}", "null", R"({"error":"x"})", R"({"error":{}})"})
        QVERIFY(!parseErrorJson(other));
}

AXISCOMP_TEST(RegisterJsonTest)

} // namespace tst_registerjson

#include "tst_registerjson.moc"
