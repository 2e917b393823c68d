// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/file_content.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <string>

#include "boxwood/mesh/generate.h"
#include "boxwood/mesh/mesh_file.h"
#include "boxwood/mesh/off.h"
#include "error_of.h"
#include "temp_dir.h"

namespace boxwood {
namespace {

std::string gzip(std::string_view text) {
    z_stream stream = {};
    deflateInit2(&stream, 9, Z_DEFLATED, MAX_WBITS + 16, 9, Z_DEFAULT_STRATEGY);
    std::string packed(deflateBound(&stream, text.size()) + 64, '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
    stream.avail_in = static_cast<uInt>(text.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<uInt>(packed.size());
    deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

class FileContentOf : public testing::Test {
protected:
    std::string content(std::string_view bytes, const Limits& limits = {}) {
        return std::string(FileContent(dir_.write("file", bytes), limits).bytes());
    }
    /// The complaint without the file's name.
    std::string complaint(std::string_view bytes, const Limits& limits = {}) {
        const std::string text = error_of([&] { content(bytes, limits); });
        const std::string name = "ParseError " + (dir_ / "file").string() + ":";
        return text.starts_with(name) ? text.substr(name.size()) : text;
    }

    TempDir dir_;
    const std::string long_text_ = std::string(3'000'000, 'a') + "b";
};

TEST_F(FileContentOf, plain_and_packed_files_is_the_same) {
    for (const std::string& text : {std::string(), std::string("a"), long_text_}) {
        EXPECT_EQ(content(text), text);
        EXPECT_EQ(content(gzip(text)), text);
    }
}

TEST_F(FileContentOf, several_packed_parts_is_all_of_them) {
    EXPECT_EQ(content(gzip("one ") + gzip("") + gzip("two")), "one two");
}

TEST_F(FileContentOf, damaged_packed_files_is_an_error) {
    const std::string packed = gzip(long_text_);
    for (const std::size_t size : {2, 9, 11, 100}) {
        EXPECT_EQ(complaint(packed.substr(0, size)),
                  "byte " + std::to_string(size) + ": the packed data ends, expected more of it");
    }
    std::string wrong_sum = packed;
    wrong_sum[wrong_sum.size() - 6] ^= 1;
    EXPECT_NE(complaint(wrong_sum).find("found damaged gzip data (incorrect data check)"),
              std::string::npos);
    EXPECT_NE(complaint(packed + "more").find("found bytes that aren't packed"), std::string::npos);
}

TEST_F(FileContentOf, files_beyond_the_limit_is_an_error_found_before_memory_is_spent) {
    const std::string bomb = gzip(std::string(std::size_t{1} << 27, '\0'));
    ASSERT_LT(bomb.size(), 200'000u);
    EXPECT_NE(complaint(bomb, {.max_bytes = 1 << 20})
                  .find("the packed data holds more than 1048576 bytes, expected at most that"),
              std::string::npos);
    EXPECT_EQ(complaint("12345", {.max_bytes = 4}), " found 5 bytes, expected at most 4");
    EXPECT_EQ(content(gzip("1234"), {.max_bytes = 4}), "1234");
}

TEST_F(FileContentOf, a_packed_mesh_is_the_mesh) {
    const TriangleMesh mesh = generate_icosphere(300);
    write_off(dir_ / "mesh.off", mesh);
    for (const char* name : {"mesh.off.gz", "MESH.OFF.GZ"}) {
        const TriangleMesh read = read_mesh(dir_.write(name, gzip(content_of(dir_ / "mesh.off"))));
        EXPECT_EQ(read.vertices, mesh.vertices);
        EXPECT_EQ(read.faces, mesh.faces);
    }
}

}  // namespace
}  // namespace boxwood
