// SPDX-License-Identifier: Apache-2.0
// What README.md shows works: its program is the one of tests/consumer, its commands run, its links
// lead somewhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

const fs::path kRoot = BOXWOOD_SOURCE_DIR;

std::string read(const fs::path& path) {
    std::ifstream in(path);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// What stands in README.md between ```language and ```.
std::string code_block(const std::string& language) {
    const std::string text = read(kRoot / "README.md");
    const std::string fence = "```" + language + "\n";
    const std::size_t begin = text.find(fence) + fence.size();
    return text.substr(begin, text.find("```", begin) - begin);
}

TEST(Readme, program_is_the_consumer_that_is_built_and_run) {
    const std::string program = read(kRoot / "tests/consumer/main.cpp");
    EXPECT_EQ(code_block("cpp"), program.substr(program.find('\n') + 1));
}

TEST(Readme, commands_run_in_the_order_shown) {
    const fs::path scratch = fs::path(testing::TempDir()) / "boxwood_readme";
    fs::remove_all(scratch);
    fs::create_directories(scratch);
    fs::create_directory_symlink(kRoot / "examples", scratch / "examples");
    const std::string prefix =
        "cd '" + scratch.string() + "' && PATH='" BOXWOOD_PROGRAM_DIR "':$PATH && ";

    std::istringstream lines(code_block("sh"));
    std::size_t commands = 0;
    for (std::string line; std::getline(lines, line); ++commands) {
        ASSERT_TRUE(line.starts_with("boxwood ")) << line;
        EXPECT_EQ(std::system((prefix + "( " + line + "\n) >/dev/null").c_str()), 0) << line;
    }
    EXPECT_GT(commands, 3u);
    EXPECT_TRUE(fs::exists(scratch / "raytrace.png"));
    fs::remove_all(scratch);
}

/// Every page of the project, at its root or under docs/ and examples/.
std::vector<fs::path> pages() {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(kRoot)) found.push_back(entry.path());
    for (const char* folder : {"docs", "examples"})
        for (const auto& entry : fs::recursive_directory_iterator(kRoot / folder))
            found.push_back(entry.path());
    found.erase(std::remove_if(found.begin(), found.end(),
                               [](const fs::path& path) { return path.extension() != ".md"; }),
                found.end());
    return found;
}

TEST(Pages, links_lead_somewhere) {
    const std::regex link(R"(\]\(([^)#:\s]+)(#[^)]*)?\))");
    EXPECT_GT(pages().size(), 5u);
    for (const fs::path& page : pages()) {
        const std::string text = read(page);
        for (std::sregex_iterator i(text.begin(), text.end(), link); i != std::sregex_iterator();
             ++i)
            EXPECT_TRUE(fs::exists(page.parent_path() / (*i)[1].str())) << page << ": " << (*i)[1];
    }
}

/// The map names folders and files that are there.
TEST(Hacking, paths_of_the_map_exist) {
    const std::string text = read(kRoot / "HACKING.md");
    const std::regex row(R"re(\n\| `([^`]+)` \|[^|\n]*\| ([^|\n]*) \|)re");
    const std::regex name("`([^`]+)`");
    std::size_t rows = 0;
    for (std::sregex_iterator i(text.begin(), text.end(), row); i != std::sregex_iterator(); ++i) {
        const fs::path folder = kRoot / (*i)[1].str();
        EXPECT_TRUE(fs::is_directory(folder)) << folder;
        ++rows;
        const std::string starts = (*i)[2];
        for (std::sregex_iterator j(starts.begin(), starts.end(), name);
             j != std::sregex_iterator(); ++j) {
            const std::string file = (*j)[1];
            EXPECT_TRUE(fs::exists(folder / file) || fs::exists(kRoot / file)) << folder / file;
        }
    }
    EXPECT_GT(rows, 10u);
}

}  // namespace
