// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "boxwood/core/error.h"

namespace boxwood {

/// Faults of one kind that were tolerated: how many there are, and where the first ones stand.
struct Warning {
    static constexpr std::size_t kShown = 10;

    std::string kind;                ///< "faces of fewer than three corners, skipped"
    std::size_t count = 0;           ///< of all
    std::vector<std::string> shown;  ///< "file:place: found ..." of the first kShown
};

/// What was found wrong with a file and tolerated, kind by kind in the order in which the kinds
/// first came. Memory doesn't grow with the faults.
class Warnings {
public:
    /// The place and what it holds are told as ParseError tells them; without a file, by the
    /// message alone.
    void add(const std::string& kind, const std::string& file, const std::string& place,
             const std::string& message) {
        Warning& warning = of_kind(kind);
        if (warning.count++ < Warning::kShown)
            warning.shown.push_back(
                one_line((file.empty() ? "" : file + (place.empty() ? "" : ":" + place) + ": ") +
                         shortened(message)));
    }
    void add(const std::string& kind, const std::string& file, std::size_t line,
             const std::string& message) {
        add(kind, file, std::to_string(line), message);
    }

    /// The same, for faults that may be as many as a file's faces: describe() gives the place and
    /// the message, and is called only for those that are shown.
    template <class Describe>
    void add_lazily(const std::string& kind, const std::string& file, const Describe& describe) {
        Warning& warning = of_kind(kind);
        if (warning.count >= Warning::kShown) {
            ++warning.count;
            return;
        }
        const std::pair<std::string, std::string> fault = describe();
        add(kind, file, fault.first, fault.second);
    }

    /// Adds what comes later in the file.
    void append(const Warnings& later) {
        for (const Warning& more : later.kinds_) {
            Warning& warning = of_kind(more.kind);
            warning.count += more.count;
            for (const std::string& text : more.shown) {
                if (warning.shown.size() < Warning::kShown) warning.shown.push_back(text);
            }
        }
    }

    bool is_empty() const { return kinds_.empty(); }
    std::span<const Warning> kinds() const { return kinds_; }
    /// How many faults of a kind there were.
    std::size_t count(const std::string& kind) const {
        for (const Warning& warning : kinds_) {
            if (warning.kind == kind) return warning.count;
        }
        return 0;
    }

private:
    Warning& of_kind(const std::string& kind) {
        for (Warning& warning : kinds_) {
            if (warning.kind == kind) return warning;
        }
        kinds_.push_back({.kind = one_line(kind), .count = 0, .shown = {}});
        return kinds_.back();
    }

    std::vector<Warning> kinds_;
};

}  // namespace boxwood
