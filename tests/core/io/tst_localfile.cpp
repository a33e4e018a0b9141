// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/local_file.h"
#include "core/io/system.h"
#include "tests/support/file_content.h"
#include "tests/support/kill_points.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTemporaryDir>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <thread>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace tst_localfile {

using namespace axiscomp;
using axiscomp::test::contentOf;
namespace fs = std::filesystem;

namespace {

void put(const fs::path& file, std::string_view text)
{
    std::ofstream(file, std::ios::binary) << text;
}

mode_t modeOf(const fs::path& file)
{
    struct stat status { };
    return ::stat(file.c_str(), &status) == 0 ? status.st_mode & 0777 : 0;
}

std::size_t entries(const fs::path& folder)
{
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

/// The rights of a user who owns nothing, also when the test runs as root.
class NoPrivileges {
public:
    NoPrivileges() { m_changed = ::geteuid() == 0 && ::seteuid(65534) == 0; }
    ~NoPrivileges()
    {
        if (m_changed && ::seteuid(0) != 0)
            std::abort();
    }
    Q_DISABLE_COPY_MOVE(NoPrivileges)

private:
    bool m_changed = false;
};

class Umask {
public:
    explicit Umask(mode_t mask) : m_old(::umask(mask)) { }
    ~Umask() { ::umask(m_old); }
    Q_DISABLE_COPY_MOVE(Umask)

private:
    mode_t m_old;
};

} // namespace

class TestLocalFile : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        test::failOnWarnings();
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
        m_path = m_folder->path().toStdString();
    }

    void whatIsSavedIsLoaded_data();
    void whatIsSavedIsLoaded();
    void replacingLeavesNothingElse();
    void newFileFollowsTheUmask();
    void oldModeIsKept();
    void symbolicLinkStaysAndItsTargetIsReplaced();
    void danglingLinkMakesItsTarget();
    void relativeLinkIsResolvedFromItsOwnFolder();
    void circleOfLinksIsRefused();
    void fullDiskLeavesTheOldFileWhole();
    void missingFolderIsNamed();
    void folderIsRefused_data();
    void folderIsRefused();
    void whatCannotTakeThePlaceOfTheOldIsReported();
    void readOnlyFileIsRefused();
    void folderWithoutPermissionIsRefused();
    void fileInPlaceOfAFolderIsRefused();
    void tooLongNameIsRefused();
    void deviceIsWrittenDirectly();
    void pipeIsWrittenDirectly();
    void aReaderSeesTheOldOrTheNewFile();
    void missingFileIsNotReadable();
    void loadingAFolderIsRefused();
    void limit_data();
    void limit();
    void pipesAndDevicesAreNotRead();
    void whatIsNoOrdinaryFileIsNotWaitedFor();
    void removingIsIdempotent();
    void temporaryFilesAreRecognised();

private:
    fs::path m_path;
    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestLocalFile::whatIsSavedIsLoaded_data()
{
    QTest::addColumn<std::size_t>("size");
    QTest::newRow("empty") << std::size_t{0};
    QTest::newRow("one byte") << std::size_t{1};
    QTest::newRow("a block") << std::size_t{4096};
    QTest::newRow("a block and a byte") << std::size_t{4097};
    QTest::newRow("several megabytes") << std::size_t{5'000'011};
}

void TestLocalFile::whatIsSavedIsLoaded()
{
    QFETCH(std::size_t, size);
    Bytes bytes(size);
    for (std::size_t i = 0; i < size; ++i)
        bytes[i] = static_cast<std::byte>(i * 2654435761U >> 13 & 0xffU);
    VERIFY_RESULT(saveFile(m_path / "file", bytes));
    const auto loaded = loadFile(m_path / "file", size);
    VERIFY_RESULT(loaded);
    QVERIFY(*loaded == bytes);
    for (const std::size_t threads : {1, 2, 7}) {
        const auto content = loadContent(m_path / "file", size, threads);
        VERIFY_RESULT(content);
        QVERIFY(std::ranges::equal(content->view(), bytes));
    }
    QCOMPARE(fs::file_size(m_path / "file"), size);
}

void TestLocalFile::replacingLeavesNothingElse()
{
    VERIFY_RESULT(saveFile(m_path / "file", asBytes("a long first text")));
    VERIFY_RESULT(saveFile(m_path / "file", asBytes("short")));
    QCOMPARE(contentOf(m_path / "file"), std::string("short"));
    QCOMPARE(entries(m_path), std::size_t{1});
}

void TestLocalFile::newFileFollowsTheUmask()
{
    const Umask umask{027};
    VERIFY_RESULT(saveFile(m_path / "file", asBytes("x")));
    QCOMPARE(modeOf(m_path / "file"), mode_t{0640});
}

void TestLocalFile::oldModeIsKept()
{
    const Umask umask{077};
    put(m_path / "file", "old");
    QCOMPARE(::chmod((m_path / "file").c_str(), 0664), 0);
    VERIFY_RESULT(saveFile(m_path / "file", asBytes("new")));
    QCOMPARE(modeOf(m_path / "file"), mode_t{0664});
}

void TestLocalFile::symbolicLinkStaysAndItsTargetIsReplaced()
{
    fs::create_directory(m_path / "elsewhere");
    put(m_path / "elsewhere" / "target", "old");
    fs::create_symlink(m_path / "elsewhere" / "target", m_path / "second");
    fs::create_symlink("second", m_path / "first");
    VERIFY_RESULT(saveFile(m_path / "first", asBytes("new")));
    QVERIFY(fs::is_symlink(m_path / "first"));
    QVERIFY(fs::is_symlink(m_path / "second"));
    QVERIFY(!fs::is_symlink(m_path / "elsewhere" / "target"));
    QCOMPARE(contentOf(m_path / "elsewhere" / "target"), std::string("new"));
    QCOMPARE(entries(m_path / "elsewhere"), std::size_t{1});
}

void TestLocalFile::danglingLinkMakesItsTarget()
{
    fs::create_symlink(m_path / "target", m_path / "link");
    VERIFY_RESULT(saveFile(m_path / "link", asBytes("new")));
    QVERIFY(fs::is_symlink(m_path / "link"));
    QCOMPARE(contentOf(m_path / "target"), std::string("new"));
}

void TestLocalFile::relativeLinkIsResolvedFromItsOwnFolder()
{
    fs::create_directory(m_path / "inner");
    put(m_path / "target", "old");
    fs::create_symlink("../target", m_path / "inner" / "link");
    VERIFY_RESULT(saveFile(m_path / "inner" / "link", asBytes("new")));
    QCOMPARE(contentOf(m_path / "target"), std::string("new"));
    QCOMPARE(entries(m_path / "inner"), std::size_t{1});
}

void TestLocalFile::circleOfLinksIsRefused()
{
    fs::create_symlink(m_path / "b", m_path / "a");
    fs::create_symlink(m_path / "a", m_path / "b");
    const auto saved = saveFile(m_path / "a", asBytes("x"));
    VERIFY_ERROR(saved, ErrorCode::FileNotWritable);
    QCOMPARE(saved.error().context.english("reason"),
        std::string("its symbolic links lead in a circle"));
    QCOMPARE(entries(m_path), std::size_t{2});
}

void TestLocalFile::fullDiskLeavesTheOldFileWhole()
{
    put(m_path / "file", "old");
    const Bytes bytes(100'000, std::byte{1});
    {
        const test::FileSizeLimit limit{50'000};
        const auto saved = saveFile(m_path / "file", bytes);
        VERIFY_ERROR(saved, ErrorCode::FileNotWritable);
        QCOMPARE(saved.error().context.english("file"), (m_path / "file").string());
        QCOMPARE(saved.error().context.english("reason"),
            std::string("it would be larger than a file may be here"));
    }
    QCOMPARE(contentOf(m_path / "file"), std::string("old"));
    QCOMPARE(entries(m_path), std::size_t{1});
}

void TestLocalFile::missingFolderIsNamed()
{
    const auto saved = saveFile(m_path / "no" / "such" / "file", asBytes("x"));
    VERIFY_ERROR(saved, ErrorCode::FileNotWritable);
    QCOMPARE(saved.error().context.english("reason"),
        "the folder " + (m_path / "no" / "such").string() + " does not exist");
    QCOMPARE(entries(m_path), std::size_t{0});
}

void TestLocalFile::folderIsRefused_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("folder") << QStringLiteral("folder");
    QTest::newRow("folder with a slash") << QStringLiteral("folder/");
    QTest::newRow("missing name with a slash") << QStringLiteral("new/");
}

void TestLocalFile::folderIsRefused()
{
    QFETCH(QString, name);
    fs::create_directory(m_path / "folder");
    const auto saved = saveFile(m_path / name.toStdString(), asBytes("x"));
    VERIFY_ERROR(saved, ErrorCode::FileNotWritable);
    QCOMPARE(saved.error().context.english("reason"), std::string("it is a folder"));
    QCOMPARE(entries(m_path), std::size_t{1});
}

/// The folder has come into being since it was looked at: the renaming fails.
void TestLocalFile::whatCannotTakeThePlaceOfTheOldIsReported()
{
    fs::create_directory(m_path / "folder");
    const std::error_code error = system::replaceFile(m_path / "folder", asBytes("new"));
    QVERIFY2(error == std::errc::is_a_directory, error.message().c_str());
    QCOMPARE(entries(m_path), std::size_t{1});
}

void TestLocalFile::readOnlyFileIsRefused()
{
    put(m_path / "file", "old");
    QCOMPARE(::chmod((m_path / "file").c_str(), 0444), 0);
    QCOMPARE(::chmod(m_path.c_str(), 0777), 0);
    {
        const NoPrivileges user;
        const auto saved = saveFile(m_path / "file", asBytes("new"));
        VERIFY_ERROR(saved, ErrorCode::FileNotWritable);
        QCOMPARE(saved.error().context.english("reason"), std::string("no permission"));
    }
    QCOMPARE(contentOf(m_path / "file"), std::string("old"));
}

void TestLocalFile::folderWithoutPermissionIsRefused()
{
    fs::create_directory(m_path / "folder");
    QCOMPARE(::chmod((m_path / "folder").c_str(), 0555), 0);
    QCOMPARE(::chmod(m_path.c_str(), 0755), 0);
    {
        const NoPrivileges user;
        const auto saved = saveFile(m_path / "folder" / "file", asBytes("new"));
        VERIFY_ERROR(saved, ErrorCode::FileNotWritable);
        QCOMPARE(saved.error().context.english("reason"), std::string("no permission"));
    }
    QCOMPARE(entries(m_path / "folder"), std::size_t{0});
}

void TestLocalFile::fileInPlaceOfAFolderIsRefused()
{
    put(m_path / "file", "old");
    const auto saved = saveFile(m_path / "file" / "inner", asBytes("new"));
    VERIFY_ERROR(saved, ErrorCode::FileNotWritable);
    QCOMPARE(
        saved.error().context.english("reason"), std::string("a part of the path is not a folder"));
}

void TestLocalFile::tooLongNameIsRefused()
{
    const auto saved = saveFile(m_path / std::string(300, 'x'), asBytes("new"));
    VERIFY_ERROR(saved, ErrorCode::FileNotWritable);
    QCOMPARE(saved.error().context.english("reason"), std::string("the name is too long"));
    QCOMPARE(entries(m_path), std::size_t{0});
    VERIFY_RESULT(saveFile(m_path / std::string(255, 'x'), asBytes("new")));
}

void TestLocalFile::deviceIsWrittenDirectly()
{
    fs::create_symlink("/dev/full", m_path / "link");
    const auto saved = saveFile(m_path / "link", asBytes("x"));
    VERIFY_ERROR(saved, ErrorCode::FileNotWritable);
    QCOMPARE(saved.error().context.english("reason"), std::string("the disk is full"));
    VERIFY_RESULT(saveFile("/dev/null", asBytes("x")));
    QVERIFY(fs::is_character_file("/dev/null"));
}

void TestLocalFile::pipeIsWrittenDirectly()
{
    const fs::path pipe = m_path / "pipe";
    QCOMPARE(::mkfifo(pipe.c_str(), 0600), 0);
    std::string received;
    std::thread reader([&] { received = contentOf(pipe); });
    const auto saved = saveFile(pipe, asBytes("through the pipe"));
    reader.join();
    VERIFY_RESULT(saved);
    QCOMPARE(received, std::string("through the pipe"));
    QVERIFY(fs::is_fifo(pipe));
}

void TestLocalFile::aReaderSeesTheOldOrTheNewFile()
{
    const fs::path file = m_path / "file";
    const Bytes first(200'000, std::byte{'1'});
    const Bytes second(100'000, std::byte{'2'});
    VERIFY_RESULT(saveFile(file, first));
    std::atomic<bool> done{false};
    std::atomic<int> torn{0};
    std::thread reader([&] {
        while (!done) {
            const auto loaded = loadFile(file, 1'000'000);
            if (!loaded || (*loaded != first && *loaded != second))
                ++torn;
        }
    });
    bool allSaved = true;
    for (int i = 0; i < 30; ++i)
        allSaved = saveFile(file, i % 2 == 0 ? second : first).has_value() && allSaved;
    done = true;
    reader.join();
    QVERIFY(allSaved);
    QCOMPARE(torn.load(), 0);
}

void TestLocalFile::missingFileIsNotReadable()
{
    const auto loaded = loadFile(m_path / "file", 10);
    VERIFY_ERROR(loaded, ErrorCode::FileNotReadable);
    QCOMPARE(sentence(loaded.error()),
        (m_path / "file").string() + " cannot be read: it does not exist");
}

void TestLocalFile::loadingAFolderIsRefused()
{
    const auto loaded = loadFile(m_path, 10);
    VERIFY_ERROR(loaded, ErrorCode::FileNotReadable);
    QCOMPARE(loaded.error().context.english("reason"), std::string("it is a folder"));
}

void TestLocalFile::limit_data()
{
    QTest::addColumn<quint64>("limit");
    QTest::addColumn<bool>("fits");
    QTest::newRow("one less") << quint64{9999} << false;
    QTest::newRow("exact") << quint64{10000} << true;
    QTest::newRow("one more") << quint64{10001} << true;
    QTest::newRow("none") << quint64{0} << false;
    QTest::newRow("unlimited") << std::numeric_limits<quint64>::max() << true;
}

void TestLocalFile::limit()
{
    QFETCH(quint64, limit);
    QFETCH(bool, fits);
    put(m_path / "file", std::string(10000, 'x'));
    const auto loaded = loadFile(m_path / "file", limit);
    if (fits) {
        VERIFY_RESULT(loaded);
        QCOMPARE(loaded->size(), std::size_t{10000});
    } else {
        VERIFY_ERROR(loaded, ErrorCode::FileTooLarge);
        QCOMPARE(loaded.error().context.english("size"), std::string("10000"));
        QCOMPARE(loaded.error().context.english("limit"), std::to_string(limit));
    }
}

void TestLocalFile::pipesAndDevicesAreNotRead()
{
    const fs::path pipe = m_path / "pipe";
    QCOMPARE(::mkfifo(pipe.c_str(), 0600), 0); // nobody writes into it: opening it would wait
    fs::create_symlink("/dev/zero", m_path / "endless");
    for (const fs::path& file : {pipe, m_path / "endless", fs::path("/dev/zero")}) {
        const auto loaded = loadFile(file, 100'000);
        VERIFY_ERROR(loaded, ErrorCode::FileNotReadable);
        QVERIFY2(sentence(loaded.error()).find("a pipe or a device") != std::string::npos,
            sentence(loaded.error()).c_str());
    }
}

void TestLocalFile::whatIsNoOrdinaryFileIsNotWaitedFor()
{
    QCOMPARE(::mkfifo((m_path / "pipe").c_str(), 0600), 0);
    fs::create_directory(m_path / "folder");
    put(m_path / "file", "x");
    fs::create_symlink("file", m_path / "link");
    for (const char* name : {"pipe", "folder", "link"}) {
        const auto loaded = loadOrdinaryFile(m_path / name, 100);
        VERIFY_ERROR(loaded, ErrorCode::FileNotReadable);
        QCOMPARE(loaded.error().context.english("reason"),
            std::string("it is not an ordinary file; move it away"));
    }
    VERIFY_ERROR(loadOrdinaryFile(m_path / "missing", 100), ErrorCode::FileNotReadable);
    QCOMPARE(loadOrdinaryFile(m_path / "file", 100)->size(), std::size_t{1});
}

void TestLocalFile::removingIsIdempotent()
{
    put(m_path / "file", "x");
    VERIFY_RESULT(removeFile(m_path / "file"));
    QCOMPARE(entries(m_path), std::size_t{0});
    VERIFY_RESULT(removeFile(m_path / "file"));
    VERIFY_ERROR(removeFile(m_path), ErrorCode::FileNotWritable);
}

void TestLocalFile::temporaryFilesAreRecognised()
{
    QVERIFY(isTemporaryFile("/some/where/.axiscomp-123-0.tmp"));
    QVERIFY(!isTemporaryFile("/some/where/table.tmp"));
    QVERIFY(!isTemporaryFile("/some/where/.axiscomp-notes"));
}

AXISCOMP_TEST(TestLocalFile)

} // namespace tst_localfile

#include "tst_localfile.moc"
