// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/assimp/assimp_files.h"

#include <assimp/MemoryIOWrapper.h>

#include <algorithm>
#include <string_view>

#include "boxwood/core/error.h"
#include "boxwood/mesh/side_file.h"

namespace boxwood {

namespace fs = std::filesystem;

namespace {

/// "part.bin" of "./part.bin", and "a/b" of "a\b", as files from Windows have it.
std::string plain(std::string name) {
    std::replace(name.begin(), name.end(), '\\', '/');
    return fs::path(name).lexically_normal().string();
}

Assimp::IOStream* stream_over(std::string_view bytes) {
    return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(bytes.data()),
                                      bytes.size());
}

}  // namespace

std::string AssimpFiles::main_file() const {
    fs::path name = source_.path.filename();
    if (name.extension() == ".gz" || name.extension() == ".GZ") name.replace_extension();
    return name.string();
}

bool AssimpFiles::may_open(const std::string& name) const {
    const auto refusal = refusal_of(source_.path.parent_path(), name, options_.allow_outside_files);
    if (refusal && refused_.insert(name).second)
        warnings_.add("files that may not be opened, done without", source_.name(), "",
                      "found the name '" + name + "', expected " + *refusal);
    return !refusal;
}

bool AssimpFiles::Exists(const char* name) const {
    const std::string file = plain(name);
    std::error_code ignored;
    return file == main_file() ||
           (may_open(file) && fs::is_regular_file(source_.path.parent_path() / file, ignored));
}

Assimp::IOStream* AssimpFiles::Open(const char* name, const char* mode) {
    if (mode[0] != 'r') return nullptr;
    if (plain(name) == main_file()) return stream_over(source_.bytes);
    const FileContent* content = side_file(plain(name));
    return content ? stream_over(content->bytes()) : nullptr;
}

void AssimpFiles::Close(Assimp::IOStream* stream) { delete stream; }

const FileContent* AssimpFiles::side_file(const std::string& name) {
    const auto [place, is_new] = side_files_.try_emplace(name);
    const fs::path path = source_.path.parent_path() / name;
    std::error_code ignored;
    // Assimp asks for many files in case they are there.
    if (!is_new || !may_open(name) || !fs::exists(path, ignored)) return place->second.get();
    try {
        place->second = std::make_unique<const FileContent>(path, options_.limits);
    } catch (const Error& error) {
        warnings_.add("files that can't be read, done without", "", "", error.what());
    }
    return place->second.get();
}

}  // namespace boxwood
