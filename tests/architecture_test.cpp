// SPDX-License-Identifier: Apache-2.0
// The rules of docs/adr/0001-architecture.md, checked line by line: who may include whom, who
// touches files, who knows an instruction set, who prints. One table holds them all. Each rule
// brings lines that break it and lines that don't, so that no rule is there in name only.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// One line of one file, as it stands and without comments and what its strings hold.
struct Line {
    std::string path;  ///< from the root of the project, as in "src/boxwood/core/box.h"
    std::size_t number = 0;
    std::string text;
    std::string code;
};

/// From the ground up. A folder includes itself and what lies on the floors below.
const std::vector<std::vector<std::string>> kFloors = {
    {"core"}, {"mesh", "tree", "image"}, {"build", "query", "world"}, {"scene"}, {"render"}};

std::optional<std::size_t> floor_of(const std::string& folder) {
    for (std::size_t floor = 0; floor < kFloors.size(); ++floor)
        for (const std::string& name : kFloors[floor])
            if (name == folder) return floor;
    return std::nullopt;
}

const std::regex& compiled(const char* pattern) {
    static std::map<const char*, std::regex> cache;
    const auto found = cache.find(pattern);
    return found != cache.end() ? found->second : cache.emplace(pattern, pattern).first->second;
}

bool matches(const std::string& text, const char* pattern) {
    return std::regex_search(text, compiled(pattern));
}

/// What the first group of the pattern matches; empty when nothing does.
std::string capture(const std::string& text, const char* pattern) {
    std::smatch match;
    return std::regex_search(text, match, compiled(pattern)) ? match[1].str() : std::string();
}

/// "boxwood/mesh/off.h" for a line that includes it, in brackets or quotes.
std::string included(const Line& line) {
    return capture(line.text, R"re(^\s*#\s*include\s*[<"]([^>"]+)[>"])re");
}

/// "mesh" for boxwood/mesh/off.h, with or without src/ in front.
std::string folder_of(const std::string& path) {
    return capture(path, "^(?:src/)?boxwood/([^/]+)/");
}

bool is_library(const Line& line) { return line.path.starts_with("src/"); }
bool is_core_files(const Line& line) { return matches(line.path, R"(/core/files\.(h|cpp)$)"); }

/// Lines to try a rule on, as they would stand in that file.
std::vector<Line> lines_of(const char* path, const std::vector<const char*>& texts,
                           std::size_t number = 2) {
    std::vector<Line> lines;
    lines.reserve(texts.size());
    for (const char* text : texts) lines.push_back({path, number, text, text});
    return lines;
}

struct Rule {
    const char* text;
    bool (*is_broken_by)(const Line&);
    std::vector<Line> bad;
    std::vector<Line> good;
};

const std::vector<Rule>& rules() {
    static const std::vector<Rule> kRules = {
        {"a folder of the library stands on one of the floors",
         [](const Line& line) {
             return is_library(line) && line.number == 1 && !floor_of(folder_of(line.path));
         },
         lines_of("src/boxwood/util/misc.h", {""}, 1), lines_of("src/boxwood/core/box.h", {""}, 1)},

        {"a folder includes itself and the floors below, never a neighbour or what is above",
         [](const Line& line) {
             const std::string from = folder_of(line.path);
             const std::string to = folder_of(included(line));
             return is_library(line) && !to.empty() && from != to && floor_of(to) >= floor_of(from);
         },
         lines_of("src/boxwood/build/median.cpp",
                  {"#include \"boxwood/query/any_hit.h\"", "#include \"boxwood/world/demo.h\"",
                   "#include \"boxwood/scene/scene.h\"", "#  include <boxwood/render/film.h>"}),
         lines_of("src/boxwood/build/median.cpp",
                  {"#include \"boxwood/build/median.h\"", "#include \"boxwood/tree/tree.h\"",
                   "#include \"boxwood/core/box.h\"", "#include <vector>"})},

        {"what is compiled for other machines includes of TBB only what tests/portable stands in "
         "for",
         [](const Line& line) {
             const std::string header = included(line), folder = folder_of(line.path);
             const bool is_portable = folder == "core" || folder == "mesh" || folder == "tree" ||
                                      folder == "build" || folder == "query";
             return is_library(line) && is_portable && header.starts_with("tbb/") &&
                    !fs::exists(fs::path(BOXWOOD_SOURCE_DIR) / "tests/portable" / header);
         },
         lines_of("src/boxwood/query/wide_hits.cpp", {"#include <tbb/concurrent_vector.h>"}),
         {{"src/boxwood/query/wide_hits.cpp", 1, "#include <tbb/parallel_for.h>", ""},
          {"src/boxwood/scene/scene.cpp", 1, "#include <tbb/concurrent_vector.h>", ""}}},

        {"the library includes its own headers as \"boxwood/FOLDER/FILE\", and none of an app's",
         [](const Line& line) {
             return is_library(line) && matches(line.text, R"re(^\s*#\s*include\s*")re") &&
                    !floor_of(folder_of(included(line)));
         },
         lines_of("src/boxwood/mesh/off.cpp", {"#include \"off.h\"", "#include \"cli/commands.h\"",
                                               "#include \"boxwood/apps/commands.h\""}),
         lines_of("src/boxwood/mesh/off.cpp", {"#include \"boxwood/mesh/off.h\""})},

        {"only mesh, tree, image, world, scene and saved trees touch files, by "
         "boxwood/core/files.h",
         [](const Line& line) {
             return is_library(line) && !is_core_files(line) &&
                    !matches(line.path, "^src/boxwood/(mesh|tree|image|world|scene)/") &&
                    line.path != "src/boxwood/query/wide_tree_file.cpp" &&
                    included(line) == "boxwood/core/files.h";
         },
         lines_of("src/boxwood/render/render.cpp", {"#include \"boxwood/core/files.h\""}),
         lines_of("src/boxwood/image/write_png.cpp", {"#include \"boxwood/core/files.h\""})},

        {"only boxwood/core/files opens files itself",
         [](const Line& line) {
             return is_library(line) && !is_core_files(line) &&
                    (matches(included(line), R"(^(fstream|cstdio|stdio\.h|fcntl\.h)$)") ||
                     matches(line.code, R"(\bf?open(64|at)?\s*\(|\b[io]?fstream\b|\bFILE\b)"));
         },
         lines_of(
             "src/boxwood/mesh/read_off.cpp",
             {"#include <fstream>", "#include <cstdio>", "auto* file = std::fopen(name, mode);",
              "std::ifstream in(path);", "const int file = open(path, O_RDONLY);"}),
         lines_of("src/boxwood/mesh/read_off.cpp",
                  {"const MappedFile file(path);", "bool is_open() const;"})},

        {"only core/simd*.h knows an instruction set",
         [](const Line& line) {
             return !matches(line.path, R"(^src/boxwood/core/simd[^/]*\.h$)") &&
                    matches(included(line),
                            R"(^([a-z0-9]*intrin\.h|arm_[a-z0-9]+\.h|wasm_simd128\.h|hwy/.*)$)");
         },
         lines_of("src/boxwood/query/closest_hit.cpp",
                  {"#include <immintrin.h>", "#include <arm_neon.h>", "#include <wasm_simd128.h>",
                   "#include <hwy/highway.h>"}),
         lines_of("src/boxwood/core/simd_avx2.h", {"#include <immintrin.h>"})},

        {"the library never prints: it returns values and throws errors",
         [](const Line& line) {
             return is_library(line) &&
                    (included(line) == "iostream" ||
                     matches(line.code, R"(\bstd::(cout|cerr|clog)\b|\bfmt::print(ln)?\s*\()"
                                        R"(|\b(v?f?printf|f?puts|putchar|perror)\s*\()"));
         },
         lines_of("src/boxwood/world/demo.cpp",
                  {"std::cout << name;", "std::cerr << name;", "printf(name);",
                   "std::fprintf(stderr, name);", "fmt::print(name);", "#include <iostream>"}),
         lines_of("src/boxwood/world/demo.cpp", {"std::snprintf(buffer, size, format);"})},

        {"the library never ends the program: it throws errors",
         [](const Line& line) {
             return is_library(line) &&
                    matches(line.code, R"((^|[^\w.>:])(std::|::)?)"
                                       R"((exit|_Exit|_exit|quick_exit|abort|terminate)\s*\()");
         },
         lines_of("src/boxwood/core/error.h",
                  {"exit(1);", "if (failed) std::abort();", "std::terminate();", "::_exit(1);"}),
         lines_of("src/boxwood/core/error.h", {"on_exit(handler);", "loop.exit();"})},

        {"the library keeps to what every supported compiler has: no <format>, bit_cast, ranges",
         [](const Line& line) {
             return is_library(line) &&
                    (matches(included(line), "^(format|ranges)$") ||
                     matches(
                         line.code,
                         R"(\bstd::(bit_cast|ranges|views|format|make_unique_for_overwrite)\b)"));
         },
         lines_of("src/boxwood/mesh/inspect.cpp",
                  {"#include <format>", "std::ranges::sort(edges);", "std::bit_cast<int>(x);",
                   "std::make_unique_for_overwrite<int[]>(n);"}),
         lines_of("src/boxwood/mesh/inspect.cpp",
                  {"std::sort(edges.begin(), edges.end());", "#include <fmt/format.h>"})},

        {"a file starts with the licence line",
         [](const Line& line) {
             return line.number == 1 &&
                    !matches(line.text, R"(^(//|#) SPDX-License-Identifier: Apache-2\.0$)");
         },
         lines_of("src/boxwood/core/box.h", {"#pragma once", ""}, 1),
         lines_of("src/boxwood/core/box.h", {"// SPDX-License-Identifier: Apache-2.0"}, 1)},

        {"no file names a place on somebody's machine",
         [](const Line& line) {
             return matches(line.text,
                            R"((^|[^\w.<>/:)~-])/(home|root|Users|tmp|work|opt|usr|var|mnt)/)");
         },
         lines_of("src/boxwood/world/demo.cpp", {"// see /home/me/scene.json", "\"/tmp/x.off\""}),
         lines_of("src/boxwood/world/demo.cpp", {"// see examples/home/scene.json"})},
    };
    return kRules;
}

std::string message(const Line& line, const Rule& rule) {
    return line.path + ":" + std::to_string(line.number) + ": " + rule.text + "\n    " + line.text;
}

/// Where the comment or literal ends that starts at that place; the same place when none does.
std::size_t end_of_hidden(const std::string& text, std::size_t start) {
    const auto after = [&](const std::string& end, std::size_t from) {
        const std::size_t found = text.find(end, from);
        return found == std::string::npos ? text.size() : found + end.size();
    };
    const std::string two = text.substr(start, 2);
    if (two == "//") return std::min(text.find('\n', start), text.size());
    if (two == "/*") return after("*/", start + 2);
    if (two == "R\"") {
        const std::size_t open = text.find('(', start);
        return after(")" + text.substr(start + 2, open - start - 2) + "\"", open);
    }
    const char quote = text[start];
    const bool separates_digits = start > 0 && std::isalnum(text[start - 1]);
    if (quote != '"' && (quote != '\'' || separates_digits)) return start;
    std::size_t end = start + 1;
    while (end < text.size() && text[end] != quote) end += text[end] == '\\' ? 2 : 1;
    return std::min(end + 1, text.size());
}

/// The text of a C++ file without its comments, strings and characters; lines keep their numbers.
std::string code_of(const std::string& text) {
    std::string code;
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t end = end_of_hidden(text, i);
        if (end == i) code += text[i++];
        for (; i < end; ++i)
            if (text[i] == '\n') code += '\n';
    }
    return code;
}

std::vector<std::string> split_lines(const std::string& text) {
    std::vector<std::string> lines(1);
    for (const char c : text)
        if (c == '\n')
            lines.emplace_back();
        else
            lines.back() += c;
    return lines;
}

std::vector<Line> read_lines(const fs::path& root, const fs::path& file) {
    std::ifstream in(file);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    const std::vector<std::string> texts = split_lines(text);
    const std::vector<std::string> codes =
        file.extension() == ".py" ? texts : split_lines(code_of(text));
    std::vector<Line> lines;
    for (std::size_t i = 0; i < texts.size(); ++i)
        lines.push_back(
            {file.lexically_relative(root).generic_string(), i + 1, texts[i], codes[i]});
    return lines;
}

std::vector<Line> lines_below(const std::vector<const char*>& folders) {
    const fs::path root = BOXWOOD_SOURCE_DIR;
    std::vector<Line> lines;
    for (const char* folder : folders) {
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            const fs::path extension = entry.path().extension();
            if (extension != ".h" && extension != ".cpp" && extension != ".py") continue;
            const std::vector<Line> more = read_lines(root, entry.path());
            lines.insert(lines.end(), more.begin(), more.end());
        }
    }
    return lines;
}

/// Types that are defined twice under one name, outside of unnamed namespaces. Each file compiles,
/// yet the program mixes them up.
std::vector<std::string> types_defined_twice(const std::vector<Line>& lines) {
    std::map<std::string, std::string> places;
    std::vector<std::string> twice, namespaces;
    for (const Line& line : lines) {
        if (line.number == 1) namespaces.clear();
        if (matches(line.code, R"(^namespace\b[^;=]*\{$)"))
            namespaces.push_back(capture(line.code, R"(^namespace (.*\S)? ?\{$)"));
        if (matches(line.text, R"(^\}  // namespace)") && !namespaces.empty())
            namespaces.pop_back();
        const std::string type =
            capture(line.code,
                    R"(^(?:struct|class|enum class) (?:alignas\([^)]*\) )?([A-Z]\w*)(?: .*)?\{)");
        if (type.empty()) continue;
        std::string name;
        bool is_private = false;
        for (const std::string& space : namespaces) {
            is_private = is_private || space.empty();
            name += space + "::";
        }
        const std::string place = line.path + ":" + std::to_string(line.number);
        if (is_private) continue;
        const auto [first, is_new] = places.emplace(name + type, place);
        // In one file they are alternatives.
        if (!is_new && !first->second.starts_with(line.path + ":"))
            twice.push_back(place + ": " + type + " is there already: " + first->second);
    }
    return twice;
}

TEST(Architecture, no_two_types_have_one_name) {
    for (const std::string& fault :
         types_defined_twice(lines_below({"src", "apps", "python", "tests", "bench"})))
        ADD_FAILURE() << fault;
}

TEST(Architecture, types_of_one_name_are_found) {
    const auto file = [](const char* path, const std::vector<const char*>& texts) {
        std::vector<Line> lines;
        for (const char* text : texts) lines.push_back({path, lines.size() + 1, text, text});
        return lines;
    };
    std::vector<Line> lines =
        file("a.h", {"namespace a {", "struct Box {", "};", "}  // namespace a"});
    const auto with = [&](const std::vector<const char*>& texts) {
        std::vector<Line> all = lines, more = file("b.h", texts);
        all.insert(all.end(), more.begin(), more.end());
        return types_defined_twice(all).size();
    };
    EXPECT_EQ(with({"namespace a {", "class Box : public Thing {"}), 1u);
    EXPECT_EQ(with({"namespace a {", "struct alignas(16) Box {"}), 1u);
    EXPECT_EQ(with({"namespace a {", "struct Box;"}), 0u);
    EXPECT_EQ(with({"namespace a {", "namespace {", "struct Box {"}), 0u);
    EXPECT_EQ(with({"namespace a::b {", "struct Box {"}), 0u);
    EXPECT_EQ(with({"namespace a {", "    struct Box {"}), 0u);
}

TEST(Architecture, every_line_keeps_every_rule) {
    const std::vector<Line> lines = lines_below({"src", "apps"});
    ASSERT_GT(lines.size(), 1000u) << "these can't be all the sources";
    for (const Line& line : lines)
        for (const Rule& rule : rules())
            if (rule.is_broken_by(line)) ADD_FAILURE() << message(line, rule);
}

TEST(Architecture, every_rule_catches_its_bad_lines_and_passes_its_good_ones) {
    for (const Rule& rule : rules()) {
        EXPECT_FALSE(rule.bad.empty() || rule.good.empty()) << rule.text;
        for (const Line& line : rule.bad)
            EXPECT_TRUE(rule.is_broken_by(line)) << message(line, rule);
        for (const Line& line : rule.good)
            EXPECT_FALSE(rule.is_broken_by(line)) << message(line, rule);
    }
}

TEST(Architecture, comments_and_strings_are_no_code) {
    EXPECT_EQ(code_of("a; // exit(1)\n/* exit(2)\n */ b(\"\\\"exit(3)\", 'x', 1'000);"),
              "a; \n\n b(, , 1'000);");
    EXPECT_EQ(code_of("f(R\"x(\" )\" exit(4)\n)x\");"), "f(\n);");
}

}  // namespace
