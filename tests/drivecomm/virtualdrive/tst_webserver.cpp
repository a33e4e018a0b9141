// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/codec/error_json.h"
#include "drivecomm/codec/register_json.h"
#include "tests/drivecomm/web/web_site.h"
#include "tests/support/test_registry.h"

#include <QElapsedTimer>
#include <QTest>

namespace tst_webserver {

using namespace axiscomp;
using namespace axiscomp::drivecomm;
using namespace axiscomp::test;

class WebFrontTest final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void refuses_data();
    void refuses();
    void takesASingleRegister();
    void readsRegistersAtOneInstant();
    void sendsFilesWithLengthAndTag();
    void answersHeadLikeGetWithoutABody();
    void filesComeFromTheDirectoryOnly_data();
    void filesComeFromTheDirectoryOnly();
    void refusesBodiesThatAreTooLarge_data();
    void refusesBodiesThatAreTooLarge();
    void asksForThePassword_data();
    void asksForThePassword();
    void aGuesserOfPasswordsHasToWait();
    void keepsOtherSitesOut_data();
    void keepsOtherSitesOut();
};

void WebFrontTest::refuses_data()
{
    QTest::addColumn<QString>("method");
    QTest::addColumn<QString>("target");
    QTest::addColumn<QString>("type");
    QTest::addColumn<QString>("body");
    QTest::addColumn<int>("status");
    QTest::addColumn<QString>("code");
    const auto row = [](const char* name, const char* method, const std::string& target,
                         const char* type, const std::string& body, int status, const char* code) {
        QTest::newRow(name) << method << QString::fromStdString(target) << type
                            << QString::fromStdString(body) << status << code;
    };
    const char* json = "application/json";
    const char* rejected = "DriveRejected";
    const std::string variable = "/registers/" + variable0;
    row("unknown page", "GET", "/nix", "", "", 404, "UnknownFile");
    row("unknown file", "GET", "/files/nix", "", "", 404, "UnknownFile");
    row("unknown register", "GET", "/registers?path=nix", "", "", 404, "UnknownRegister");
    row("no register named", "GET", "/registers", "", "", 400, rejected);
    row("path and prefix", "GET", "/registers?path=a&prefix=b", "", "", 400, rejected);
    row("two prefixes", "GET", "/registers?prefix=a&prefix=b", "", "", 400, rejected);
    row("another question", "GET", "/registers?address=12", "", "", 400, rejected);
    row("65 registers", "GET", registersOf(std::vector(65, variable0)), "", "", 400, rejected);
    row("no JSON", "PUT", "/registers", json, "Table=Small1", 400, rejected);
    row("no array", "PUT", "/registers", json, "{}", 400, rejected);
    row("nothing to write", "PUT", "/registers", json, "[]", 400, rejected);
    row("deep JSON", "PUT", "/registers", json, std::string(20'000, '['), 400, rejected);
    row("no path", "PUT", "/registers", json, R"([{"value":1}])", 400, rejected);
    row("no value", "PUT", "/registers", json, R"([{"path":"a"}])", 400, rejected);
    row("an array as value", "PUT", "/registers", json, R"([{"path":"a","value":[1]}])", 400,
        rejected);
    row("writes an unknown register", "PUT", "/registers", json, R"([{"path":"a","value":1}])", 404,
        "UnknownRegister");
    row("another type of body", "PUT", "/registers", "text/plain", "[]", 415, rejected);
    row("a form as PUT", "PUT", "/registers", formType.c_str(), "a=1", 415, rejected);
    row("single: no value", "PUT", variable, json, "{}", 400, rejected);
    row("single: text for a number", "PUT", variable, json, R"({"value":"1"})", 400, rejected);
    row("single: beyond a float", "PUT", variable, json, R"({"value":1e60})", 400, rejected);
    row("single: unknown", "PUT", "/registers/nix", json, R"({"value":1})", 404, "UnknownRegister");
    row("single: read-only", "PUT", "/registers/" + stateOfX, json, R"({"value":"Active"})", 400,
        rejected);
    row("JSON as form", "POST", "/registers", json, "[]", 415, rejected);
    row("transfer without a form", "POST", "/transfer", json, "{}", 415, rejected);
    row("transfer without fields", "POST", "/transfer", "multipart/form-data; boundary=b",
        "--b--\r\n", 400, rejected);
    row("transfer of a broken form", "POST", "/transfer", "multipart/form-data; boundary=b",
        "--c\r\nhello", 400, rejected);
    row("transfer without a file", "POST", "/transfer", "multipart/form-data; boundary=b",
        "--b\r\nContent-Disposition: form-data; name=\"filepath\"\r\n\r\n" + small1
            + "\r\n--b\r\nContent-Disposition: form-data; name=\"file\"; filename=\"\"\r\n"
              "Content-Type: application/octet-stream\r\n\r\n\r\n--b--\r\n",
        400, rejected);
    row("transfer without a path", "POST", "/transfer", "multipart/form-data; boundary=b",
        "--b\r\nContent-Disposition: form-data; name=\"filepath\"\r\n\r\n "
        "\r\n--b\r\nContent-Disposition: form-data; name=\"file\"; filename=\"a\"\r\n"
        "Content-Type: application/octet-stream\r\n\r\nabc\r\n--b--\r\n",
        400, rejected);
    row("POST to a page", "POST", "/", json, "{}", 405, rejected);
    row("POST to the directory", "POST", "/directory", json, "{}", 405, rejected);
    row("DELETE", "DELETE", "/files/" + small1, json, "{}", 405, rejected);
    row("PATCH", "PATCH", "/registers", json, "[]", 405, rejected);
    row("OPTIONS", "OPTIONS", "/transfer", "", "", 405, rejected);
}

void WebFrontTest::refuses()
{
    QFETCH(QString, method);
    QFETCH(QString, target);
    QFETCH(QString, type);
    QFETCH(QString, body);
    QFETCH(int, status);
    QFETCH(QString, code);
    Site site;
    httplib::Request request;
    request.method = method.toStdString();
    request.path = target.toStdString();
    request.body = body.toStdString();
    request.set_header("Accept", "application/json");
    if (!type.isEmpty())
        request.set_header("Content-Type", type.toStdString());
    const auto reply = site.client.send(request);
    QVERIFY2(reply, httplib::to_string(reply.error()).c_str());
    QVERIFY2(reply->status == status, reply->body.c_str());
    QCOMPARE(reply->get_header_value("Content-Type"), std::string("application/json"));
    const auto error = parseErrorJson(reply->body);
    QVERIFY2(error, reply->body.c_str());
    QCOMPARE(error->detail, code.toStdString());
    QVERIFY(!error->context.english("reason").empty());
    QCOMPARE(reply->has_header("Allow"), status == 405);
    QVERIFY(site.drive.download(small1)->empty());
    QCOMPARE(site.value(variable0), RegisterValue(0.0F));
    // The connection is as good as before.
    const auto next = site.client.Get("/directory");
    QVERIFY(next);
    QCOMPARE(next->status, 200);
}

void WebFrontTest::takesASingleRegister()
{
    Site site;
    const auto put = [&site](const std::string& path, const char* body) {
        const auto reply =
            site.client.Put("/registers/" + path, body, "application/json; charset=utf-8");
        return reply ? reply->status : 0;
    };
    QCOMPARE(put(variable0, R"({"value": 0.1})"), 204);
    QCOMPARE(site.value(variable0), RegisterValue(0.1F));
    QCOMPARE(put(tableOfX, R"({"value": "Small2"})"), 204);
    QCOMPARE(site.value(tableOfX), RegisterValue("Small2"));
    QCOMPARE(
        put("Axes%5B0%5D/Parameters/Compensations/Axis/Dim2Source", R"({"value": 4294967295})"),
        204);
    QCOMPARE(site.value("Axes[0]/Parameters/Compensations/Axis/Dim2Source"),
        RegisterValue(std::uint32_t{4294967295}));
    QCOMPARE(put("Application/Tables/Small1/Header/Persistent", R"({"value": false})"), 204);
}

void WebFrontTest::readsRegistersAtOneInstant()
{
    Site site;
    const auto reply = site.client.Get(registersOf(std::vector(64, masterX)));
    QVERIFY(reply);
    const auto readings = parseReadings(reply->body);
    VERIFY_RESULT(readings);
    QCOMPARE(readings->size(), std::size_t{64});
    for (const RegisterReading& each : *readings)
        QCOMPARE(each, readings->front());
}

void WebFrontTest::sendsFilesWithLengthAndTag()
{
    Site site;
    const std::string file = tableFile(500);
    VERIFY_RESULT(site.drive.upload(small1, asBytes(file)));
    const auto first = site.client.Get("/files/" + small1);
    QVERIFY(first);
    QVERIFY(first->body == file);
    QCOMPARE(first->get_header_value("Content-Length"), std::to_string(file.size()));
    QCOMPARE(first->get_header_value("Content-Type"), std::string("application/octet-stream"));
    QVERIFY(
        first->get_header_value("Content-Disposition").find("small1.TAMtbl") != std::string::npos);
    const std::string tag = first->get_header_value("ETag");
    QVERIFY(tag.size() > 2 && tag.starts_with('"') && tag.ends_with('"'));
    const auto again = site.client.Get("/files/" + small1, {{"If-None-Match", tag}});
    QVERIFY(again);
    QCOMPARE(again->status, 304);
    QVERIFY(again->body.empty());
    VERIFY_RESULT(site.drive.upload(small1, asBytes(tableFile(500, 0.5F))));
    const auto other = site.client.Get("/files/" + small1, {{"If-None-Match", tag}});
    QVERIFY(other);
    QCOMPARE(other->status, 200);
    QVERIFY(other->get_header_value("ETag") != tag);
}

void WebFrontTest::answersHeadLikeGetWithoutABody()
{
    Site site;
    VERIFY_RESULT(site.drive.upload(small1, asBytes(tableFile(500))));
    for (const std::string& target :
        {std::string("/"), "/files/" + small1, registersOf({stateOfX})}) {
        const auto full = site.client.Get(target);
        const auto head = site.client.Head(target);
        QVERIFY(full && head);
        QCOMPARE(head->status, 200);
        QVERIFY(head->body.empty());
        for (const char* name : {"Content-Length", "Content-Type", "ETag"})
            QCOMPARE(head->get_header_value(name), full->get_header_value(name));
    }
}

void WebFrontTest::filesComeFromTheDirectoryOnly_data()
{
    QTest::addColumn<QString>("path");
    for (const char* path :
        {"../../etc/passwd", "..%2f..%2fetc%2fpasswd", "/etc/passwd",
            "tables/../tables/small1.TAMtbl", "tables/small1.TAMtbl%00", "tables%5csmall1.TAMtbl",
            "tables/SMALL1.TAMtbl", "%2e%2e/", "tables%252fsmall1.TAMtbl", "", "tables/", "%ff%fe"})
        QTest::newRow(path) << path;
}

void WebFrontTest::filesComeFromTheDirectoryOnly()
{
    QFETCH(QString, path);
    Site site;
    VERIFY_RESULT(site.drive.upload(small1, asBytes(tableFile(50))));
    RawClient client(site.server->port());
    client.send(get("/files/" + path.toStdString(), "Connection: close\r\n"));
    QVERIFY(client.receiveAll().startsWith("HTTP/1.1 404 "));
    const auto upload = site.client.Post("/transfer",
        transferForm(QByteArray::fromPercentEncoding(path.toUtf8()).toStdString(), "x"));
    QVERIFY(upload);
    QVERIFY(upload->status == 404 || (path.isEmpty() && upload->status == 400));
}

void WebFrontTest::refusesBodiesThatAreTooLarge_data()
{
    QTest::addColumn<QString>("request");
    QTest::addColumn<int>("size");
    QTest::newRow("transfer") << "POST /transfer HTTP/1.1\r\nHost: 127.0.0.1\r\n"
                                 "Content-Type: multipart/form-data; boundary=b\r\n"
                              << 5'000'000;
    QTest::newRow("registers") << "PUT /registers HTTP/1.1\r\nHost: 127.0.0.1\r\n"
                                  "Content-Type: application/json\r\n"
                               << 300'000;
    QTest::newRow("form") << "POST /registers HTTP/1.1\r\nHost: 127.0.0.1\r\n"
                             "Content-Type: application/x-www-form-urlencoded\r\n"
                          << 300'000;
}

void WebFrontTest::refusesBodiesThatAreTooLarge()
{
    QFETCH(QString, request);
    QFETCH(int, size);
    Site site;
    const std::string head = request.toStdString();
    const bool isForm = head.find("multipart") != std::string::npos;
    std::string body = isForm ? "--b\r\nContent-Disposition: form-data; name=\"file\"\r\n\r\n" : "";
    body.resize(static_cast<std::size_t>(size), 'x');
    body += isForm ? "\r\n--b--\r\n" : "";
    {
        RawClient client(site.server->port());
        client.send(head + "Connection: close\r\nContent-Length: " + std::to_string(body.size())
            + "\r\n\r\n" + body);
        QVERIFY(client.receiveAll().startsWith("HTTP/1.1 413 "));
    }
    RawClient chunks(site.server->port());
    chunks.send(head + "Connection: close\r\nTransfer-Encoding: chunked\r\n\r\n");
    for (std::size_t sent = 0; sent < body.size(); sent += 0x8000) {
        const std::string chunk = body.substr(sent, 0x8000);
        char length[16];
        std::snprintf(length, sizeof length, "%zx\r\n", chunk.size());
        chunks.send(length + chunk + "\r\n");
    }
    chunks.send("0\r\n\r\n");
    QVERIFY(chunks.receiveAll().startsWith("HTTP/1.1 413 "));
    RawClient asking(site.server->port()); // and has not sent the body yet
    asking.send(head + "Connection: close\r\nExpect: 100-continue\r\nContent-Length: "
        + std::to_string(body.size()) + "\r\n\r\n");
    QVERIFY(asking.receiveAll().startsWith("HTTP/1.1 413 "));
    RawClient noLength(site.server->port());
    noLength.send(head + "Connection: close\r\n\r\n");
    QVERIFY(noLength.receiveAll().startsWith("HTTP/1.1 411 "));
}

void WebFrontTest::asksForThePassword_data()
{
    QTest::addColumn<QString>("header");
    QTest::addColumn<int>("status");
    const auto basic = [](const char* text) { return "Basic " + QByteArray(text).toBase64(); };
    QTest::newRow("right") << QString::fromLatin1(basic("anna:secret")) << 200;
    QTest::newRow("nothing") << "" << 401;
    QTest::newRow("wrong password") << QString::fromLatin1(basic("anna:secre")) << 401;
    QTest::newRow("longer password") << QString::fromLatin1(basic("anna:secret1")) << 401;
    QTest::newRow("wrong user") << QString::fromLatin1(basic("Anna:secret")) << 401;
    QTest::newRow("another scheme") << "Bearer anna:secret" << 401;
    QTest::newRow("not encoded") << "Basic anna:secret" << 401;
}

void WebFrontTest::asksForThePassword()
{
    QFETCH(QString, header);
    QFETCH(int, status);
    WebServerOptions options;
    options.user = "anna";
    options.password = "secret";
    Site site(options);
    for (const std::string& target :
        {std::string("/"), "/files/" + small1, registersOf({stateOfX})}) {
        const auto reply = site.client.Get(target, {{"Authorization", header.toStdString()}});
        QVERIFY(reply);
        QCOMPARE(reply->status, status);
        QCOMPARE(reply->has_header("WWW-Authenticate"), status == 401);
    }
    const auto put = site.client.Put("/registers/" + variable0,
        {{"Authorization", header.toStdString()}}, R"({"value":1})", "application/json");
    QVERIFY(put);
    QCOMPARE(put->status, status == 200 ? 204 : 401);
    QCOMPARE(site.value(variable0), RegisterValue(status == 200 ? 1.0F : 0.0F));
}

void WebFrontTest::aGuesserOfPasswordsHasToWait()
{
    WebServerOptions options;
    options.user = "anna";
    options.password = "secret";
    Site site(options);
    const httplib::Headers wrong{
        {"Authorization", "Basic " + QByteArray("anna:x").toBase64().toStdString()}};
    QElapsedTimer timer;
    timer.start();
    for (int i = 0; i < 7; ++i) {
        const auto reply = site.client.Get("/", wrong);
        QVERIFY(reply);
        QCOMPARE(reply->status, 401);
    }
    QVERIFY2(timer.elapsed() >= 2000, qPrintable(QString::number(timer.elapsed())));
}

void WebFrontTest::keepsOtherSitesOut_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("value");
    QTest::addColumn<int>("status");
    QTest::newRow("another origin") << "Origin"
                                    << "http://evil.example" << 403;
    QTest::newRow("another port") << "Origin"
                                  << "http://127.0.0.1:1" << 403;
    QTest::newRow("no origin") << "Origin"
                               << "null" << 403;
    QTest::newRow("the same origin") << "Origin"
                                     << "http://@host" << 200;
    QTest::newRow("cross-site") << "Sec-Fetch-Site"
                                << "cross-site" << 403;
    QTest::newRow("same site, other origin") << "Sec-Fetch-Site"
                                             << "same-site" << 403;
    QTest::newRow("the browser says same") << "Sec-Fetch-Site"
                                           << "same-origin" << 200;
    QTest::newRow("typed by the user") << "Sec-Fetch-Site"
                                       << "none" << 200;
    QTest::newRow("a name that was made to point here") << "Host"
                                                        << "evil.example" << 403;
    QTest::newRow("a name that looks like an address") << "Host"
                                                       << "127.0.0.1.evil.example" << 403;
    QTest::newRow("localhost") << "Host"
                               << "localhost:8080" << 200;
    QTest::newRow("IPv6") << "Host"
                          << "[::1]:8080" << 200;
}

void WebFrontTest::keepsOtherSitesOut()
{
    QFETCH(QString, name);
    QFETCH(QString, value);
    QFETCH(int, status);
    Site site;
    value.replace(QStringLiteral("@host"), QStringLiteral("127.0.0.1:%1").arg(site.server->port()));
    const httplib::Headers headers{{name.toStdString(), value.toStdString()}};
    const auto form = site.client.Post("/registers", headers, variable0 + "=1", formType);
    QVERIFY(form);
    QCOMPARE(form->status, status);
    QCOMPARE(site.value(variable0), RegisterValue(status == 200 ? 1.0F : 0.0F));
    const auto upload = site.client.Post("/transfer", headers, transferForm(small1, tableFile(50)));
    QVERIFY(upload);
    QCOMPARE(upload->status, status);
    QCOMPARE(site.drive.download(small1)->empty(), status == 403);
    // Reading is for everybody who may read, but for names that only pretend to be this computer.
    const auto read = site.client.Get("/directory", headers);
    QVERIFY(read);
    QCOMPARE(read->status, name == u"Host" ? status : 200);
}

AXISCOMP_TEST(WebFrontTest)

} // namespace tst_webserver

#include "tst_webserver.moc"
