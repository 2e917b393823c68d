// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>

namespace boxwood::bench {

/// What reading a file took of memory, in bytes.
struct ReadMemory {
    std::size_t mesh = 0;  ///< the arrays that are left: vertices, triangles, attributes
    std::size_t peak = 0;  ///< how far resident memory grew, less the size of the mapped file
};

/// Reads a file by Boxwood in this process, once, and prints the two numbers. Only the first call
/// of a process is right: memory that was used before isn't fresh.
void print_read_memory(const std::filesystem::path& file);

/// The same in a new process of this program, which must call print_read_memory() when it is run
/// with --memory-of FILE.
ReadMemory read_memory(const std::filesystem::path& file);

/// Seconds for a single thread to map a file and to copy it into memory that is fresh from the
/// system.
double seconds_to_copy_in(const std::filesystem::path& file);

/// Seconds for a single thread to copy a file that has been mapped and touched before into memory
/// that has been touched as well.
double seconds_to_copy_warm(const std::filesystem::path& file);

/// Gives unused memory back to the system, so that the next reader starts as in a new process.
void return_memory();

}  // namespace boxwood::bench
