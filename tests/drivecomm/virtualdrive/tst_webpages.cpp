// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/drivecomm/web/web_site.h"
#include "tests/support/test_registry.h"

#include <QRegularExpression>
#include <QTest>

#include <set>

namespace tst_webpages {

using namespace axiscomp;
using namespace axiscomp::drivecomm;
using namespace axiscomp::test;

class WebPagesTest final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void showsPagesThatAPersonCanUse_data();
    void showsPagesThatAPersonCanUse();
    void everyLinkLeadsSomewhere();
    void showsNamesAsText();
    void letsAPersonCompensateAnAxisByHand();
    void formsLeaveEmptyFieldsAlone();
    void formsTakeASourceInEverySpelling_data();
    void formsTakeASourceInEverySpelling();
    void formsSetAllOrNone();
    void formsLeadBackToTheirPage();
    void answersInTheFormThatIsWanted_data();
    void answersInTheFormThatIsWanted();
};

void WebPagesTest::showsPagesThatAPersonCanUse_data()
{
    QTest::addColumn<QString>("target");
    QTest::addColumn<QStringList>("says");
    QTest::newRow("start") << "/"
                           << QStringList{QStringLiteral("Front-1"),
                                  QStringLiteral("serial number 1559"), QStringLiteral("Directory"),
                                  QStringLiteral("Transfer"),
                                  QStringLiteral("Compensation of axis 0 (X)"),
                                  QStringLiteral("Compensation of axis 1 (Y)"),
                                  QStringLiteral("Small1"), QStringLiteral("Large2")};
    QTest::newRow("directory") << "/directory"
                               << QStringList{QStringLiteral("File"), QStringLiteral("actual size"),
                                      QStringLiteral("maximum size"),
                                      QStringLiteral("tables/small1.TAMtbl"),
                                      QStringLiteral("63360"),
                                      QStringLiteral("tables/large2.TAMtbl"),
                                      QStringLiteral("2096976")};
    QTest::newRow("transfer") << "/transfer"
                              << QStringList{QStringLiteral("Filepath in drive"),
                                     QStringLiteral("Select from PC"), QStringLiteral("Start")};
    QTest::newRow("top of the registers")
        << "/registers?prefix="
        << QStringList{QStringLiteral("General"), QStringLiteral("Axes[0]"),
               QStringLiteral("Axes[1]"), QStringLiteral("Application")};
    QTest::newRow("a folder of registers")
        << "/registers?prefix=Axes[0]/Parameters/Compensations/Axis"
        << QStringList{QStringLiteral("Table"), QStringLiteral("Dim1Source"),
               QStringLiteral("Small1"), QStringLiteral("unchanged")};
    QTest::newRow("many registers") << "/registers?prefix=Application/Variables"
                                    << QStringList{QStringLiteral("Floats[0]"),
                                           QStringLiteral("Floats[255]"), QStringLiteral("Single")};
    QTest::newRow("chosen registers")
        << QString::fromStdString(registersOf({stateOfX, tableOfX}))
        << QStringList{QStringLiteral("Disabled"), QStringLiteral("SourceTable")};
}

void WebPagesTest::showsPagesThatAPersonCanUse()
{
    QFETCH(QString, target);
    QFETCH(QStringList, says);
    Site site;
    const auto reply = site.client.Get(target.toStdString(), {{"Accept", htmlOnly}});
    QVERIFY(reply);
    QCOMPARE(reply->status, 200);
    QCOMPARE(reply->get_header_value("Content-Type"), std::string("text/html; charset=utf-8"));
    const QString text = QString::fromStdString(htmlText(reply->body));
    for (const QString& each : says)
        QVERIFY2(text.contains(each), qPrintable(each));
    const QString html = QString::fromStdString(reply->body);
    for (const char* part : {"<!DOCTYPE html>", "<html lang=\"en\">", "<title>", "<h1>", "<main>",
             "prefers-color-scheme", "color-scheme: light dark"})
        QVERIFY2(html.contains(QLatin1String(part)), part);
    // Every field has a name for those who do not see it.
    QRegularExpression fields(QStringLiteral("<(input|select)([^>]*)>"));
    for (auto all = fields.globalMatch(html); all.hasNext();) {
        const QString attributes = all.next().captured(2);
        const QRegularExpression id(QStringLiteral("id=\"([^\"]+)\""));
        const QString label =
            QStringLiteral("<label for=\"%1\">").arg(id.match(attributes).captured(1));
        QVERIFY(attributes.contains(QStringLiteral("aria-label=\"")) || html.contains(label));
    }
}

void WebPagesTest::everyLinkLeadsSomewhere()
{
    Site site;
    std::set<std::string> seen{"/"};
    std::vector<std::string> open{"/"};
    const QRegularExpression link(QStringLiteral("href=\"([^\"]+)\""));
    while (!open.empty()) {
        const std::string target = open.back();
        open.pop_back();
        const auto reply = site.client.Get(target, {{"Accept", htmlOnly}});
        QVERIFY2(reply, target.c_str());
        QVERIFY2(reply->status == 200, target.c_str());
        for (auto all = link.globalMatch(QString::fromStdString(reply->body)); all.hasNext();) {
            const std::string next = all.next()
                                         .captured(1)
                                         .replace(QStringLiteral("&amp;"), QStringLiteral("&"))
                                         .toStdString();
            if (seen.insert(next).second)
                open.push_back(next);
        }
    }
    QVERIFY(seen.size() > 50);
    QVERIFY(seen.contains("/registers?prefix=Axes%5B1%5D/Signals/Homing"));
    QVERIFY(seen.contains("/files/" + small1));
}

void WebPagesTest::showsNamesAsText()
{
    Site site({}, "<b>&\"'</b>");
    for (const char* target : {"/", "/directory", "/nix<script>"}) {
        const auto reply = site.client.Get(target, {{"Accept", htmlOnly}});
        QVERIFY(reply);
        QVERIFY(reply->body.find("<b>") == std::string::npos);
        QVERIFY(reply->body.find("<script>") == std::string::npos);
        QVERIFY(reply->body.find("&lt;b&gt;&amp;&quot;&#39;&lt;/b&gt;") != std::string::npos);
    }
}

void WebPagesTest::letsAPersonCompensateAnAxisByHand()
{
    Site site;
    const auto post = [&site](const std::string& form) {
        const auto reply = site.client.Post("/registers", form, formType);
        return reply ? reply->status : 0;
    };
    const auto done = site.client.Post("/transfer", transferForm(small1, tableFile(200)));
    QVERIFY(done);
    QCOMPARE(done->status, 200);
    QVERIFY(textOf(done).find("tables/small1.TAMtbl now has 928 bytes") != std::string::npos);
    QCOMPARE(post(tableOfX + "=Small1&" + source1OfX + "=" + masterX), 200);
    QCOMPARE(post(activationOfX + "=Evaluate"), 200);
    QCOMPARE(site.value(stateOfX), RegisterValue("Evaluating"));
    QCOMPARE(post("Application/Tables/Small1/Header/Persistent=true"), 200);
    QCOMPARE(post("Application/Tables/Small1/Command=Commit"), 200);
    QCOMPARE(post("General/Commands/SaveParameters=Save"), 200);
    QCOMPARE(post("General/Commands/Reboot=Reboot"), 200);
    QCOMPARE(site.drive.download(small1)->size(), std::size_t{928});
    QCOMPARE(site.value(tableOfX), RegisterValue("Small1"));
    QCOMPARE(site.value(stateOfX), RegisterValue("Disabled"));
}

void WebPagesTest::formsLeaveEmptyFieldsAlone()
{
    Site site;
    const auto reply = site.client.Post(
        "/registers", variable0 + "=&" + variable1 + "=2.5&" + tableOfX + "=", formType);
    QVERIFY(reply);
    QCOMPARE(reply->status, 200);
    QVERIFY(textOf(reply).find(variable1 + " 2.5") != std::string::npos);
    QVERIFY(textOf(reply).find(variable0) == std::string::npos);
    QCOMPARE(site.value(variable1), RegisterValue(2.5F));
    const auto nothing = site.client.Post("/registers", variable0 + "=", formType);
    QVERIFY(nothing);
    QCOMPARE(nothing->status, 400);
}

void WebPagesTest::formsTakeASourceInEverySpelling_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<int>("status");
    QTest::newRow("path") << QString::fromStdString(masterX) << 200;
    QTest::newRow("dots") << "Axes[0].Signals.PositionController.MasterPosition" << 200;
    QTest::newRow("URI") << QStringLiteral("tam://mc/Front-1/") + QString::fromStdString(masterX)
                         << 200;
    QTest::newRow("encoded") << "Axes%5B0%5D%2FSignals%2FPositionController%2FMasterPosition"
                             << 200;
    QTest::newRow("decimal") << "@decimal" << 200;
    QTest::newRow("hexadecimal") << "@hex" << 200;
    QTest::newRow("unknown") << "Axes[0]/Nix" << 404;
    QTest::newRow("no path") << "tam://mc/" << 404;
}

void WebPagesTest::formsTakeASourceInEverySpelling()
{
    QFETCH(QString, text);
    QFETCH(int, status);
    Site site;
    const std::uint32_t address = site.drive.readRegisters({masterX})->front().address;
    if (text.startsWith(u'@'))
        text =
            text == u"@hex" ? QStringLiteral("0x%1").arg(address, 0, 16) : QString::number(address);
    const auto reply =
        site.client.Post("/registers", source1OfX + "=" + text.toStdString(), formType);
    QVERIFY(reply);
    QCOMPARE(reply->status, status);
    QCOMPARE(site.value(source1OfX), RegisterValue(status == 200 ? address : std::uint32_t{0}));
}

void WebPagesTest::formsSetAllOrNone()
{
    Site site;
    const auto reply = site.client.Post(
        "/registers", variable0 + "=1&" + tableOfX + "=Small99&" + variable1 + "=2", formType);
    QVERIFY(reply);
    QCOMPARE(reply->status, 400);
    QVERIFY(textOf(reply).find("Small99") != std::string::npos);
    QCOMPARE(site.value(variable0), RegisterValue(0.0F));
    QCOMPARE(site.value(variable1), RegisterValue(0.0F));
}

void WebPagesTest::formsLeadBackToTheirPage()
{
    Site site;
    const std::string page = "/registers?prefix=Application/Variables";
    const auto backOf = [&site](const std::string& referer) {
        const auto reply = site.client.Post("/registers",
            {{"Referer", referer}, {"Host", "127.0.0.1:1"}}, variable0 + "=1", formType);
        const QRegularExpression back(QStringLiteral("href=\"([^\"]+)\">Back"));
        return back.match(QString::fromStdString(reply ? reply->body : "")).captured(1);
    };
    QCOMPARE(backOf("http://127.0.0.1:1" + page), QString::fromStdString(page));
    QCOMPARE(backOf("https://127.0.0.1:1/?a=1&b=<"), QStringLiteral("/?a=1&amp;b=&lt;"));
    QCOMPARE(backOf("http://evil.example/http://127.0.0.1:1/x"), QStringLiteral("/"));
    QCOMPARE(backOf("javascript:alert(1)"), QStringLiteral("/"));
    QCOMPARE(backOf(""), QStringLiteral("/"));
}

void WebPagesTest::answersInTheFormThatIsWanted_data()
{
    QTest::addColumn<QString>("target");
    QTest::addColumn<QString>("accept");
    QTest::addColumn<QString>("type");
    const QString html = QStringLiteral("text/html; charset=utf-8");
    const QString json = QStringLiteral("application/json");
    const QString registers = QString::fromStdString(registersOf({stateOfX}));
    const QString browser = QString::fromStdString(htmlOnly);
    QTest::newRow("directory, browser") << "/directory" << browser << html;
    QTest::newRow("directory, curl") << "/directory"
                                     << "*/*" << html;
    QTest::newRow("directory, program") << "/directory"
                                        << "application/json" << json;
    QTest::newRow("directory, rather JSON") << "/directory"
                                            << "text/html;q=0.5, application/json" << json;
    QTest::newRow("directory, rather a page") << "/directory"
                                              << "application/json;q=0.1, text/*" << html;
    QTest::newRow("registers, browser") << registers << browser << html;
    QTest::newRow("registers, curl") << registers << "*/*" << json;
    QTest::newRow("registers, nothing said") << registers << "" << json;
    QTest::newRow("registers, program") << registers << "application/json" << json;
    QTest::newRow("registers, no page please") << registers << "*/*;q=0.3, text/html;q=0" << json;
    QTest::newRow("unknown page, browser") << "/nix" << browser << html;
    QTest::newRow("unknown page, program") << "/nix"
                                           << "application/json" << json;
    QTest::newRow("unknown register, curl") << "/registers?path=nix"
                                            << "*/*" << json;
    QTest::newRow("unknown register, browser") << "/registers?path=nix" << browser << html;
    QTest::newRow("unknown folder, browser") << "/registers?prefix=nix" << browser << html;
}

void WebPagesTest::answersInTheFormThatIsWanted()
{
    QFETCH(QString, target);
    QFETCH(QString, accept);
    QFETCH(QString, type);
    Site site;
    const auto reply = site.client.Get(target.toStdString(), {{"Accept", accept.toStdString()}});
    QVERIFY(reply);
    QCOMPARE(reply->get_header_value("Content-Type"), type.toStdString());
}

AXISCOMP_TEST(WebPagesTest)

} // namespace tst_webpages

#include "tst_webpages.moc"
