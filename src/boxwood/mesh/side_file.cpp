// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/side_file.h"

#include <algorithm>
#include <charconv>

namespace boxwood {

namespace fs = std::filesystem;

namespace {

/// "http" of "http://host/file".
bool has_scheme(const std::string& name) {
    const std::size_t colon = name.find(':');
    if (colon == name.npos || colon < 2) return false;  // one letter: a drive
    return std::all_of(name.begin(), name.begin() + static_cast<std::ptrdiff_t>(colon), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '+' || c == '-' || c == '.';
    });
}

bool leads_out(const fs::path& relative) {
    return relative.empty() || relative.is_absolute() || *relative.begin() == "..";
}

}  // namespace

std::optional<std::string> refusal_of(const fs::path& folder, const std::string& name,
                                      bool allow_outside) {
    // The system would take a zero byte for the end of the name.
    if (name.empty() || name.find('\0') != name.npos) return "a file's name";
    if (has_scheme(name)) return "the name of a file here, as nothing is fetched";
    if (allow_outside) return std::nullopt;
    const std::string refusal = "a file in the folder of the file that names it or below";
    const fs::path path(name);
    if (path.is_absolute() || leads_out(path.lexically_normal())) return refusal;
    std::error_code error;
    const fs::path root = fs::weakly_canonical(folder.empty() ? fs::path(".") : folder, error);
    if (error) return refusal;
    const fs::path target = fs::weakly_canonical(root / path, error);
    if (error || leads_out(target.lexically_relative(root))) return refusal;
    return std::nullopt;
}

std::string percent_decoded(std::string_view uri) {
    std::string result;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        unsigned char byte = 0;
        const char* const digits = uri.data() + i + 1;
        if (uri[i] == '%' && i + 2 < uri.size() &&
            std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
            result += static_cast<char>(byte);
            i += 2;
        } else {
            result += uri[i];
        }
    }
    return result;
}

}  // namespace boxwood
