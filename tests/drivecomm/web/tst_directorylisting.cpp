// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/web/directory_listing.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

namespace tst_directorylisting {

using namespace axiscomp;
using namespace axiscomp::drivecomm;
using namespace axiscomp::test;

class DirectoryListingTest final : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { failOnWarnings(); }

    void readsThePageHoweverItIsWritten_data();
    void readsThePageHoweverItIsWritten();
    void rejectsWhatIsNoDirectory_data();
    void rejectsWhatIsNoDirectory();
    void bringsAListAcrossAsJson();
};

namespace {

const DriveFile small{"tables/small1.TAMtbl", 304, 63360};

QByteArray table(const char* rows)
{
    return QByteArray("<table><tr><th>File</th><th>actual size</th><th>maximum size</th></tr>")
        + rows + "</table>";
}

} // namespace

void DirectoryListingTest::readsThePageHoweverItIsWritten_data()
{
    QTest::addColumn<QByteArray>("html");
    QTest::newRow("plain") << table(
        "<tr><td>tables/small1.TAMtbl</td><td>304</td><td>63360</td></tr>");
    QTest::newRow("with a link") << table(
        "<tr><td><a href='/files/x'>tables/small1.TAMtbl</a><td>304<td>63360");
    QTest::newRow("upper case without end tags")
        << QByteArray("<TABLE><TR><TD>FILE<TD>ACTUAL SIZE<TD>MAXIMUM SIZE"
                      "<TR><TD>tables/small1.TAMtbl<TD>304<TD>63360</TABLE>");
    QTest::newRow("columns in another order")
        << QByteArray("<table><tr><th>Maximum size<th>File<th>Date<th>Actual size<tr><td>63360"
                      "<td>tables/small1.TAMtbl<td>today<td>304</table>");
    QTest::newRow("units and groups")
        << table("<tr><td>tables/small1.TAMtbl</td><td>304&nbsp;bytes</td><td>63'360 B</td></tr>");
    QTest::newRow("groups with a thin blank")
        << table("<tr><td>tables/small1.TAMtbl</td><td>304</td><td>63&#8239;360</td></tr>");
    QTest::newRow("a table around it") << QByteArray("<table><tr><td><b>Menu</b></td><td>")
            + table("<tr><td>tables/small1.TAMtbl</td><td>304</td><td>63360</td></tr>")
            + "</td></tr></table>";
    QTest::newRow("a table before it") << QByteArray("<table><tr><th>Name</th></tr></table>")
            + table("<tr><td>tables/small1.TAMtbl</td><td>304</td><td>63360</td></tr>");
    QTest::newRow("a title row above")
        << QByteArray("<table><tr><th colspan=3>Directory</th></tr>"
                      "<tr><th>File</th><th>Actual size</th><th>Max. size</th>"
                      "</tr><tr><td>tables/small1.TAMtbl</td><td>304</td>"
                      "<td>63360</td></tr></table>");
    QTest::newRow("comments, scripts and references")
        << QByteArray("<!-- <table><tr><th>File --><script>if (1 < 2) '<table>'</script>")
            + table("<!-- x --><tr><td>tables&#47;small1&#x2E;TAMtbl</td><td>304</td>"
                    "<td>63360</td></tr>");
}

void DirectoryListingTest::readsThePageHoweverItIsWritten()
{
    QFETCH(QByteArray, html);
    const auto files = parseDirectoryPage(html.toStdString());
    VERIFY_RESULT(files);
    QCOMPARE(files->size(), std::size_t{1});
    QCOMPARE(files->front(), small);
}

void DirectoryListingTest::rejectsWhatIsNoDirectory_data()
{
    QTest::addColumn<QByteArray>("html");
    QTest::addColumn<QString>("expected");
    QTest::newRow("nothing") << QByteArray("") << "Directory page";
    QTest::newRow("another page") << QByteArray("<h1>Login</h1>") << "Directory page";
    QTest::newRow("other columns") << QByteArray(
        "<table><tr><th>Name</th><th>Size</th></tr><tr><td>a</td><td>1</td></tr></table>")
                                   << "File, actual size and maximum size";
    QTest::newRow("a column twice") << QByteArray(
        "<table><tr><th>File<th>File<th>actual<th>maximum<tr><td>a<td>b<td>1<td>2</table>")
                                    << "Directory page";
    QTest::newRow("no files") << table("") << "at least one file";
    QTest::newRow("a cell is missing") << table("<tr><td>a</td><td>1</td></tr>") << "in each row";
    QTest::newRow("a size in words") << table("<tr><td>a<td>some<td>1") << "sizes in bytes";
    QTest::newRow("a size in kB") << table("<tr><td>a<td>1 kB<td>63 kB") << "sizes in bytes";
    QTest::newRow("a broken number") << table("<tr><td>a<td>1.5<td>63") << "sizes in bytes";
    QTest::newRow("odd groups") << table("<tr><td>a<td>1<td>1234 567") << "sizes in bytes";
    QTest::newRow("a negative size") << table("<tr><td>a<td>-1<td>63") << "sizes in bytes";
    QTest::newRow("beyond 32 bits") << table("<tr><td>a<td>1<td>4294967296") << "sizes in bytes";
    QTest::newRow("larger than its maximum")
        << table("<tr><td>a<td>64<td>63") << "up to its maximum";
    QTest::newRow("a file twice") << table("<tr><td>a<td>1<td>2<tr><td>a<td>1<td>2") << "once";
    QTest::newRow("a file without a name") << table("<tr><td><td>1<td>2") << "file paths";
    QTest::newRow("a file with blanks") << table("<tr><td>a b<td>1<td>2") << "without blanks";
}

void DirectoryListingTest::rejectsWhatIsNoDirectory()
{
    QFETCH(QByteArray, html);
    QFETCH(QString, expected);
    const auto files = parseDirectoryPage(html.toStdString());
    VERIFY_ERROR(files, ErrorCode::Protocol);
    const QString said = QString::fromStdString(files.error().context.english("expected"));
    QVERIFY2(said.contains(expected), qPrintable(said));
    QVERIFY(!files.error().context.english("quote").empty());
}

void DirectoryListingTest::bringsAListAcrossAsJson()
{
    const std::vector<DriveFile> files{small, {"tables/large1.TAMtbl", 0, 4294967295U}};
    const auto again = parseDirectoryJson(directoryJson(files));
    VERIFY_RESULT(again);
    QCOMPARE(*again, files);
}

AXISCOMP_TEST(DirectoryListingTest)

} // namespace tst_directorylisting

#include "tst_directorylisting.moc"
