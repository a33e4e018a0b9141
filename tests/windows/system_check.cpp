// SPDX-License-Identifier: GPL-3.0-or-later
//
// What core and the programs ask of the operating system, checked without Qt, so that it can be
// built for a system for which Debian has none: build/windows-core/bin/system_check.exe. The same
// rules hold for Linux in tests/core/io, which has more of them.
//     system_check                 every check; prints what fails
//     system_check hold FILE       locks a file until standard input ends
//     system_check try FILE        says "free" or "taken"
#include "app/common/input_stream.h"
#include "app/common/interrupt.h"
#include "app/common/system_process.h"
#include "core/base/portable_math.h"
#include "core/base/sha256.h"
#include "core/capture/run_file.h"
#include "core/io/file_lock.h"
#include "core/io/local_file.h"
#include "core/io/system.h"
#include "core/metrology/measuring_plan.h"
#include "core/store/store_folder.h"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <functional>
#include <thread>

namespace {

using namespace axiscomp;
namespace fs = std::filesystem;

/// What a check found wrong.
struct Failed {
    std::string what;
};

void expect(bool isTrue, const std::string& what)
{
    if (!isTrue)
        throw Failed{what};
}

template <typename T> void expectReason(const Result<T>& result, const std::string& reason)
{
    expect(!result, "this should have failed: " + reason);
    const std::string found = result.error().context.english("reason");
    expect(found == reason, "\"" + found + "\" instead of \"" + reason + "\"");
}

std::string contentOf(const fs::path& file)
{
    const auto bytes = loadFile(file, 100'000'000);
    return bytes ? std::string(asText(*bytes)) : "(" + sentence(bytes.error()) + ")";
}

std::size_t entriesOf(const fs::path& folder)
{
    return filesIn(folder).size();
}

void aFileIsReplacedWhole(const fs::path& folder)
{
    const fs::path file = folder / pathFromText("Größe µ.bin");
    Bytes bytes(5'000'011);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        bytes[i] = static_cast<std::byte>(i * 2654435761U >> 13 & 0xffU);
    expect(saveFile(file, bytes).has_value(), "a large file is saved");
    expect(loadFile(file, bytes.size()) == bytes, "it is loaded as it was saved");
    for (const std::size_t threads : {1U, 4U}) {
        const auto content = loadContent(file, bytes.size(), threads);
        expect(content && std::ranges::equal(content->view(), bytes), "by several threads, too");
    }
    expect(saveFile(file, asBytes("a\r\nb\n\x1a")).has_value(), "it is replaced");
    expect(contentOf(file) == "a\r\nb\n\x1a", "line ends and Ctrl-Z stay");
    expect(entriesOf(folder) == 1, "no temporary file is left");
    expect(!loadFile(file, 5) && loadFile(file, 6), "the limit holds");
    expect(removeFile(file).has_value() && removeFile(file).has_value(), "removed, and once more");
    expect(entriesOf(folder) == 0, "the folder is empty");
}

void aReaderSeesTheOldOrTheNewFile(const fs::path& folder)
{
    const fs::path file = folder / "file";
    const Bytes first(200'000, std::byte{'1'});
    const Bytes second(100'000, std::byte{'2'});
    expect(saveFile(file, first).has_value(), "saved");
    std::atomic<bool> isDone{false};
    std::atomic<int> torn{0};
    std::thread reader([&] {
        while (!isDone) {
            const auto loaded = loadFile(file, 1'000'000);
            if (loaded && *loaded != first && *loaded != second)
                ++torn;
        }
    });
    std::string failure;
    for (int i = 0; i < 30; ++i) {
        if (const auto saved = saveFile(file, i % 2 == 0 ? second : first); !saved)
            failure = sentence(saved.error());
    }
    isDone = true;
    reader.join();
    expect(failure.empty(), "a replacement fails beside a reader: " + failure);
    expect(torn == 0, "no reader sees a mixture");
}

void whatCannotBeWrittenIsNamed(const fs::path& folder)
{
    expect(saveFile(folder / "file", asBytes("x")).has_value(), "saved");
    expectReason(saveFile(folder, asBytes("x")), "it is a folder");
    expectReason(
        saveFile(folder / "file" / "inner", asBytes("x")), "a part of the path is not a folder");
    expectReason(saveFile(folder / std::string(300, 'x'), asBytes("x")), "the name is too long");
    const auto missing = saveFile(folder / "no" / "file", asBytes("x"));
    expectReason(missing, "the folder " + (folder / "no").string() + " does not exist");
    expectReason(loadFile(folder, 10), "it is a folder");
    expectReason(loadFile(folder / "missing", 10), "it does not exist");
    expectReason(loadFile(folder / "no" / "missing", 10), "it does not exist");
    fs::permissions(folder / "file", fs::perms::owner_read | fs::perms::group_read);
    const auto state = system::stateOf(folder / "file");
    expect(state && state->kind == system::FileKind::Ordinary && state->size == 1, "its state");
    fs::permissions(folder / "file", fs::perms::owner_all);
    expect(entriesOf(folder) == 1, "nothing else was made");
}

void namesMayBeLong(const fs::path& folder)
{
    fs::path deep = folder;
    for (int i = 0; i < 4; ++i) {
        deep /= std::string(100, 'n');
        expect(makePrivateFolder(deep).has_value(), "a folder is made");
        expect(makePrivateFolder(deep).has_value(), "one that is there is none the worse");
    }
    const fs::path file = deep / "file";
    expect(saveFile(file, asBytes("deep")).has_value(), "a file is saved");
    expect(contentOf(file) == "deep", "and loaded");
    expect(system::identityOf(file).has_value(), "it has an identity");
    expect(removeFile(file).has_value(), "and removed");
}

void oneHolderOfALock(const fs::path& folder)
{
    const fs::path file = folder / "lock";
    expect(!FileLock::isHeld(file) && isMissing(file), "asking makes nothing");
    {
        auto first = FileLock::tryAcquire(file, folder);
        expect(first && *first, "free");
        const auto second = FileLock::tryAcquire(file, folder);
        expect(second && !*second, "taken in the same program");
        expect(FileLock::isHeld(file), "held");
        const auto third = FileLock::acquire(file, std::chrono::milliseconds{50}, folder);
        expectReason(third, "another program is using it; try again when that one has finished");
        FileLock moved = std::move(**first);
        const auto fourth = FileLock::tryAcquire(file, folder);
        expect(fourth && !*fourth, "taken by whom it was moved to");
    }
    expect(!FileLock::isHeld(file), "not held");
    const auto again = FileLock::tryAcquire(file, folder);
    expect(again && *again, "free again");
}

MeasuringPlan smallPlan()
{
    MeasuringPlanRequest request;
    request.from = 0.0;
    request.to = 10.0;
    request.count = 3;
    request.cycles = 1;
    return makeMeasuringPlan(request).value();
}

void valuesAreKeptOneByOne(const fs::path& folder)
{
    const fs::path file = folder / pathFromText("Läufe.csv");
    const MeasuringPlan plan = smallPlan();
    const RunOrigin origin{"off", "typed", "2026-05-01"};
    const auto valueOf = [&](std::size_t n) {
        return CapturedValue{plan.steps[n], 0.001, 1.0, 0.0, std::chrono::seconds(1)};
    };
    {
        auto runs = RunFile::open(file, plan, origin);
        expect(runs.has_value(), "a file is begun");
        expect(runs->append(valueOf(0)).has_value() && runs->append(valueOf(1)).has_value(), "two");
        expectReason(
            RunFile::open(file, plan, origin), "another program is writing measured values to it");
        expect(contentOf(file).ends_with("\n"), "others can read it meanwhile");
        expect(runs->removeLast().has_value(), "the last value is taken off");
    }
    const std::string whole = contentOf(file);
    expect(saveFile(file, asBytes(whole + "5,+,1,0.00")).has_value(), "half a line");
    auto again = RunFile::open(file, plan, origin);
    expect(again && again->taken() == 1, "it goes on where it ended");
    expect(contentOf(file) == whole, "half a line is cut off");
    expect(again->append(valueOf(1)).has_value(), "and goes on");
}

void pathsOfThisComputerAreFound(const fs::path& folder)
{
    std::error_code ignored;
    expect(system::stateFolder().is_absolute(), "the folder of the user");
    expect(fs::is_directory(system::programFolder(), ignored), "the folder of this program");
    const auto fileSystem = system::fileSystemOf(folder);
    expect(fileSystem && fileSystem->kind != system::FileSystemFacts::Kind::Network
            && !fileSystem->isReadOnly && fileSystem->freeBytes > 0,
        "this folder is on this computer, and takes files");
    expect(!system::fileSystemOf(folder / "missing"), "of nothing there is nothing to say");
    const auto temporary = system::makeTemporaryFolder(folder);
    expect(temporary && fs::is_directory(*temporary, ignored), "a temporary folder");
    expect(isMissing(folder / "missing") && !isMissing(folder), "what is missing");
    expect(saveFile(folder / "a", asBytes("a")) && saveFile(folder / "b", asBytes("b")), "saved");
    expect(system::identityOf(folder / "a") == system::identityOf(folder / "." / "a"), "the same");
    expect(system::identityOf(folder / "a") != system::identityOf(folder / "b"), "not the same");
    {
        const auto opened = system::File::open(folder / "a", system::File::Purpose::Read);
        expect(opened && opened->identity() == system::identityOf(folder / "a"), "the open one");
    }
    expect(renameFile(folder / "a", folder / "b").has_value(), "renamed over another one");
    expect(contentOf(folder / "b") == "a" && isMissing(folder / "a"), "it is the one");
    expect(checkOrdinaryFile(folder / "b").has_value(), "a file is one");
    expect(!checkOrdinaryFile(folder), "a folder is none");
    const auto before = system::timeSinceStart();
    std::this_thread::sleep_for(std::chrono::milliseconds{20});
    expect(system::timeSinceStart() - before >= std::chrono::milliseconds{10}, "time passes");
}

void textsHaveTheirBits(const fs::path& /*folder*/)
{
    expect(system::fromGbk("\xb1\xed\xd6\xd0") == "表中", "Chinese text is read");
    expect(!system::fromGbk("\xb1"), "half a character is none");
    expect(sha256Of(asBytes("abc"))
            == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad",
        "SHA-256 of FIPS 180");
    expect(portable::sin(8.85) == 0x1.165916bc22613p-1, "the bits of a sine");
    expect(portable::pow(10.0, -2.3) == 0x1.487543c6a9257p-8, "the bits of a power");
}

/// Standard input of the checks ends at once.
void anInterruptEndsWaiting(const fs::path& /*folder*/)
{
    app::Interrupt interrupt;
    int heard = 0;
    interrupt.setListener([&heard](int count) { heard = count; });
    expect(!interrupt.stopped(), "not yet");
    std::string text;
    const auto early = app::InputStream::standardInput().waitForInput(
        interrupt, false, std::chrono::steady_clock::now() + std::chrono::milliseconds{30}, text);
    expect(early && *early == app::Input::None, "a moment passes");
    std::thread other([&interrupt] { interrupt.request(); });
    interrupt.wait();
    other.join();
    expect(interrupt.stopped() && heard == 1, "it is heard once");
    const auto late = app::InputStream::standardInput().readMore(interrupt, text);
    expect(!late && late.error().code == ErrorCode::Cancelled, "and nothing is read after it");
}

struct Check {
    const char* name;
    void (*run)(const fs::path& folder);
};

constexpr Check checks[] = {{"a file is replaced whole", aFileIsReplacedWhole},
    {"a reader sees the old or the new file", aReaderSeesTheOldOrTheNewFile},
    {"what cannot be written is named", whatCannotBeWrittenIsNamed},
    {"names may be long", namesMayBeLong}, {"one holder of a lock", oneHolderOfALock},
    {"values are kept one by one", valuesAreKeptOneByOne},
    {"paths of this computer are found", pathsOfThisComputerAreFound},
    {"texts have their bits", textsHaveTheirBits},
    {"an interrupt ends waiting", anInterruptEndsWaiting}};

int runChecks()
{
    int failures = 0;
    for (const Check& check : checks) {
        const auto folder =
            system::makeTemporaryFolder(std::filesystem::temp_directory_path()).value();
        try {
            check.run(folder);
        } catch (const Failed& failed) {
            std::printf("FAIL %s: %s\n", check.name, failed.what.c_str());
            ++failures;
        }
        std::error_code ignored;
        fs::remove_all(system::nativeName(folder), ignored);
    }
    std::printf("%zu checks, %d failures\n", std::size(checks), failures);
    return failures == 0 ? 0 : 1;
}

int hold(const fs::path& file)
{
    const auto lock = FileLock::tryAcquire(file, file);
    if (!lock || !*lock)
        return 1;
    static_cast<void>(app::writeAll(app::Stream::Output, "held\n"));
    app::Interrupt interrupt;
    std::string text;
    while (app::InputStream::standardInput().readMore(interrupt, text).value_or(false)) { }
    return 0;
}

int tryLock(const fs::path& file)
{
    const auto lock = FileLock::tryAcquire(file, file);
    const bool isFree = lock && *lock;
    static_cast<void>(app::writeAll(app::Stream::Output, isFree ? "free\n" : "taken\n"));
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    app::ProgramArguments arguments(argc, argv);
    const std::string what = arguments.count() == 3 ? arguments.values()[1] : "";
    if (what == "hold")
        return hold(pathFromText(arguments.values()[2]));
    if (what == "try")
        return tryLock(pathFromText(arguments.values()[2]));
    return runChecks();
}
