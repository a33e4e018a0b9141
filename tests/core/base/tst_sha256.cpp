// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/sha256.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QCryptographicHash>

namespace tst_sha256 {

using namespace axiscomp;

class TestSha256 : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }
    void theExamplesOfTheStandardComeOut_data();
    void theExamplesOfTheStandardComeOut();
    void anyLengthGivesWhatQtGives();
};

/// FIPS 180-2, appendix B, and the empty text.
void TestSha256::theExamplesOfTheStandardComeOut_data()
{
    QTest::addColumn<std::string>("text");
    QTest::addColumn<std::string>("digest");
    QTest::newRow("nothing")
        << std::string()
        << std::string("e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    QTest::newRow("one block") << std::string(
        "abc") << std::string("ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    QTest::newRow("two blocks")
        << std::string("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq")
        << std::string("248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    QTest::newRow("a million letters") << std::string(1'000'000,
        'a') << std::string("cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

void TestSha256::theExamplesOfTheStandardComeOut()
{
    QFETCH(std::string, text);
    QFETCH(std::string, digest);
    QCOMPARE(sha256Of(asBytes(text)), digest);
}

void TestSha256::anyLengthGivesWhatQtGives()
{
    std::string text;
    for (int length = 0; length < 300; ++length) {
        const auto expected =
            QCryptographicHash::hash(QByteArray::fromStdString(text), QCryptographicHash::Sha256);
        QCOMPARE(sha256Of(asBytes(text)), expected.toHex().toStdString());
        text.push_back(static_cast<char>(length * 37));
    }
}

AXISCOMP_TEST(TestSha256)

} // namespace tst_sha256

#include "tst_sha256.moc"
