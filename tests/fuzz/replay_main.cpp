// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

std::vector<std::filesystem::path> filesOf(const std::filesystem::path& folder)
{
    std::vector<std::filesystem::path> files;
    std::error_code error;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, error)) {
        if (entry.is_regular_file(error))
            files.push_back(entry.path());
    }
    std::ranges::sort(files);
    return files;
}

} // namespace

/// Runs a fuzzer's code over every file of a folder; a fault ends the program with a signal.
int main(int argc, char** argv)
{
    if (argc != 2) {
        std::fprintf(stderr, "usage: %s CORPUS-FOLDER\n", argv[0]);
        return 2;
    }
    const auto files = filesOf(argv[1]);
    for (const auto& file : files) {
        std::ifstream stream(file, std::ios::binary);
        const std::vector<char> bytes(std::istreambuf_iterator<char>(stream), {});
        if (stream.bad() || !stream.is_open()) {
            std::fprintf(stderr, "%s cannot be read\n", file.c_str());
            return 1;
        }
        // named before it runs, so that a crash can be traced to its file
        std::printf("%s\n", file.c_str());
        std::fflush(stdout);
        // from the heap and of the exact size, so that AddressSanitizer sees a read behind the end
        const std::vector<std::uint8_t> input(bytes.begin(), bytes.end());
        static_cast<void>(LLVMFuzzerTestOneInput(input.data(), input.size()));
    }
    std::printf("%zu files\n", files.size());
    if (files.empty())
        std::fprintf(stderr, "there is no file in %s\n", argv[1]);
    return files.empty() ? 1 : 0;
}
