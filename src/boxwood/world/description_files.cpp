// SPDX-License-Identifier: Apache-2.0
#include "boxwood/world/description_files.h"

#include "boxwood/mesh/side_file.h"

namespace boxwood {

namespace fs = std::filesystem;

fs::path DescriptionFiles::find(const JsonReader& value, const fs::path& folder) const {
    const std::string name = value.string();
    // In the data folder, which the caller names, a file may be anywhere below it too.
    const fs::path relative = fs::path(name).is_absolute() ? fs::path(name) : folder / name;
    if (const auto refusal = refusal_of(root_, relative.string(), options_.allow_outside_files))
        value.fail(*refusal);
    std::error_code ignored;
    if (fs::exists(root_ / relative, ignored)) return root_ / relative;
    if (!data_.empty() && !refusal_of(data_, name, options_.allow_outside_files) &&
        fs::exists(data_ / name, ignored))
        return data_ / name;
    value.fail(data_.empty() ? "a file beside the scene"
                             : "a file beside the scene or in the data folder");
}

}  // namespace boxwood
