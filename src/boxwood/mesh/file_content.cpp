// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/file_content.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <new>
#include <utility>

#include "boxwood/core/error.h"

namespace boxwood {

namespace {

/// Unpacks what gzip packed, all of its members, one after another.
class Unpacker {
public:
    Unpacker(std::string_view packed, std::string name, std::uint64_t max_bytes)
        : packed_(packed), name_(std::move(name)), max_bytes_(max_bytes) {
        constexpr int kOnlyGzip = 16;
        if (inflateInit2(&stream_, MAX_WBITS + kOnlyGzip) != Z_OK) throw std::bad_alloc();
    }
    ~Unpacker() { inflateEnd(&stream_); }
    Unpacker(const Unpacker&) = delete;
    Unpacker& operator=(const Unpacker&) = delete;

    std::string unpack() {
        std::string result;
        for (;;) {
            const int status = step(result);
            if (status == Z_STREAM_END) {
                if (left() == 0 || !packed_.substr(place()).starts_with("\x1f\x8b")) break;
                inflateReset(&stream_);
            } else if (status == Z_BUF_ERROR) {
                fail("the packed data ends, expected more of it");
            } else if (status != Z_OK) {
                fail(fmt::format("found damaged gzip data ({}), expected to unpack it",
                                 stream_.msg ? stream_.msg : "no further reason"));
            }
        }
        if (left() > 0) fail("found bytes that aren't packed, expected the end of the file");
        return result;
    }

private:
    std::size_t left() const { return packed_.size() - place(); }
    std::size_t place() const { return taken_ - stream_.avail_in; }

    int step(std::string& result) {
        constexpr std::size_t kPiece = std::size_t{1} << 20;
        if (stream_.avail_in == 0) {
            const std::size_t piece = std::min<std::size_t>(packed_.size() - taken_, kPiece);
            stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed_.data() + taken_));
            stream_.avail_in = static_cast<uInt>(piece);
            taken_ += piece;
        }
        // One byte beyond the limit shows that there is more.
        const std::size_t size = result.size();
        const std::size_t room = std::min<std::uint64_t>(
            std::clamp<std::uint64_t>(size, kPiece, std::size_t{1} << 28), max_bytes_ - size + 1);
        result.resize(size + room);
        stream_.next_out = reinterpret_cast<Bytef*>(result.data() + size);
        stream_.avail_out = static_cast<uInt>(room);
        const int status = inflate(&stream_, Z_NO_FLUSH);
        result.resize(size + room - stream_.avail_out);
        if (result.size() > max_bytes_)
            fail(fmt::format("the packed data holds more than {} bytes, expected at most that",
                             max_bytes_));
        return status;
    }

    [[noreturn]] void fail(const std::string& message) const {
        throw ParseError(name_, fmt::format("byte {}", place()), message);
    }

    std::string_view packed_;
    std::string name_;
    std::uint64_t max_bytes_;
    z_stream stream_ = {};
    std::size_t taken_ = 0;
};

}  // namespace

std::string unpack_gzip(std::string_view packed, const std::string& name, std::uint64_t max_bytes) {
    return Unpacker(packed, name, max_bytes).unpack();
}

FileContent::FileContent(const std::filesystem::path& path, const Limits& limits) : file_(path) {
    const std::string_view text = file_.text();
    is_packed_ = text.starts_with("\x1f\x8b");
    if (is_packed_) {
        unpacked_ = unpack_gzip(text, path.string(), limits.max_bytes);
    } else if (text.size() > limits.max_bytes) {
        throw ParseError(
            path.string(), "",
            fmt::format("found {} bytes, expected at most {}", text.size(), limits.max_bytes));
    }
}

}  // namespace boxwood
