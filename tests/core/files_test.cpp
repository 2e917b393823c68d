// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/files.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <iterator>
#include <utility>

#include "boxwood/core/error.h"
#include "temp_dir.h"

namespace boxwood {
namespace {

namespace fs = std::filesystem;

std::ptrdiff_t entries(const TempDir& dir) {
    return std::distance(fs::directory_iterator(dir.path()), fs::directory_iterator());
}

/// The message of what is thrown, which has to be an IoError.
template <class Action>
std::string io_error_of(const Action& action) {
    try {
        action();
    } catch (const IoError& error) {
        return error.what();
    }
    return "no IoError";
}

TEST(MappedFile, holds_the_whole_file) {
    const TempDir dir;
    const std::string content = std::string("a\0b\n", 4) + std::string(100'000, 'x');
    const MappedFile file(dir.write("file", content));
    EXPECT_EQ(file.text(), content);
}

TEST(MappedFile, empty_file_is_empty_text) {
    const TempDir dir;
    EXPECT_EQ(MappedFile(dir.write("empty", "")).text(), "");
}

TEST(MappedFile, moves) {
    const TempDir dir;
    MappedFile first(dir.write("first", "one"));
    MappedFile second(std::move(first));
    EXPECT_EQ(second.text(), "one");
    MappedFile third(dir.write("third", "three"));
    third = std::move(second);
    EXPECT_EQ(third.text(), "one");
}

TEST(MappedFile, missing_file_is_an_io_error_that_names_it) {
    const TempDir dir;
    const std::string message = io_error_of([&] { MappedFile file(dir / "missing"); });
    EXPECT_EQ(message, (dir / "missing").string() + ": No such file or directory");
}

TEST(MappedFile, directory_is_an_io_error) {
    const TempDir dir;
    const std::string message = io_error_of([&] { MappedFile file(dir.path()); });
    EXPECT_EQ(message, dir.path().string() + ": found a directory, expected a file");
}

TEST(MappedFile, pipe_is_an_io_error_and_nothing_to_wait_for) {
    const TempDir dir;
    ASSERT_EQ(mkfifo((dir / "pipe").c_str(), 0600), 0);
    const std::string message = io_error_of([&] { MappedFile file(dir / "pipe"); });
    EXPECT_EQ(message, (dir / "pipe").string() + ": found a device or a pipe, expected a file");
}

TEST(OutputFile, appears_when_committed) {
    const TempDir dir;
    OutputFile file(dir / "out");
    file.write("some ");
    file.write("text");
    EXPECT_FALSE(fs::exists(dir / "out"));
    file.commit();
    EXPECT_EQ(content_of(dir / "out"), "some text");
    EXPECT_EQ(entries(dir), 1);
}

TEST(OutputFile, leaves_nothing_behind_without_commit) {
    const TempDir dir;
    {
        OutputFile file(dir / "out");
        file.write(std::string(1'000'000, 'x'));
        EXPECT_EQ(entries(dir), 1);
    }
    EXPECT_EQ(entries(dir), 0);
}

TEST(OutputFile, old_file_stays_without_commit_and_goes_with_it) {
    const TempDir dir;
    dir.write("out", "old");
    {
        OutputFile file(dir / "out");
        file.write("new");
    }
    EXPECT_EQ(content_of(dir / "out"), "old");
    OutputFile file(dir / "out");
    file.write("new");
    EXPECT_EQ(content_of(dir / "out"), "old");
    file.commit();
    EXPECT_EQ(content_of(dir / "out"), "new");
    EXPECT_EQ(entries(dir), 1);
}

TEST(OutputFile, missing_folder_is_an_io_error_that_names_the_file) {
    const TempDir dir;
    const fs::path path = dir / "missing" / "out";
    const std::string message = io_error_of([&] { OutputFile file(path); });
    EXPECT_EQ(message, path.string() + ": No such file or directory");
}

TEST(OutputFile, folder_is_an_io_error_at_once) {
    const TempDir dir;
    const std::string message = io_error_of([&] { OutputFile file(dir.path()); });
    EXPECT_EQ(message, dir.path().string() + ": found a directory, expected a file to write");
}

TEST(OutputFile, failed_commit_leaves_nothing_behind) {
    const TempDir dir;
    {
        OutputFile file(dir / "out");
        file.write("text");
        fs::create_directory(dir / "out");  // no file can be renamed to this
        EXPECT_THROW(file.commit(), IoError);
    }
    EXPECT_EQ(entries(dir), 1);
    EXPECT_TRUE(fs::is_directory(dir / "out"));
}

TEST(OutputFile, full_disk_is_an_io_error) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
    const TempDir dir;
    // The file beside its place is a link to a disk that is always full.
    const fs::path temporary = dir / ("out." + std::to_string(getpid()) + ".partial");
    fs::create_symlink("/dev/full", temporary);
    {
        OutputFile file(dir / "out");
        EXPECT_THROW(
            {
                file.write(std::string(100'000, 'x'));
                file.commit();
            },
            IoError);
    }
    EXPECT_EQ(entries(dir), 0);
}

}  // namespace
}  // namespace boxwood
