// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/off.h"
#include "boxwood/mesh/off/off_body.h"

namespace boxwood {

MeshData parse_off(const MeshSource& source, const ReadOptions& options) {
    const std::string name = source.name();
    TextScanner scanner(source.bytes);
    const OffHeader header = read_off_header(scanner, name, options.limits);
    return header.is_binary ? read_off_binary(header, source, scanner.rest(), options.limits)
                            : read_off_text(header, source, scanner, options.limits);
}

}  // namespace boxwood
