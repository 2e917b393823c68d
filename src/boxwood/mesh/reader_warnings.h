// SPDX-License-Identifier: Apache-2.0
// Kinds of faults that several formats have, under one name.
#pragma once

namespace boxwood {

inline constexpr const char* kNotFinite = "vertices that aren't finite";
inline constexpr const char* kBeyondFloat = "vertices beyond the range of float";
inline constexpr const char* kFewCorners = "faces of fewer than three corners, skipped";
inline constexpr const char* kTrailingLines = "lines after the end of the mesh, ignored";
inline constexpr const char* kTrailingBytes = "bytes after the end of the mesh, ignored";

}  // namespace boxwood
