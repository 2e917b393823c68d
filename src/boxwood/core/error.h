// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace boxwood {

/// The text on one line, whatever was quoted from a file or stands in a file's name.
inline std::string one_line(std::string text) {
    for (char& c : text) {
        if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = '?';
    }
    return text;
}

/// What every failure of the library is thrown as. The message is one line without a full stop.
class Error : public std::runtime_error {
public:
    explicit Error(const std::string& message) : std::runtime_error(one_line(message)) {}
};

/// An argument that breaks a documented precondition.
class InvalidInput : public Error {
public:
    using Error::Error;
};

/// Work that was given up halfway, because its caller asked for that.
class Cancelled : public Error {
public:
    using Error::Error;
};

/// The text at a bearable length.
inline std::string shortened(const std::string& text) {
    constexpr std::size_t kLongest = 400;
    return text.size() > kLongest ? text.substr(0, kLongest) + " ..." : text;
}

/// A file that doesn't hold what its format demands: "file:line: found ..., expected ...".
class ParseError : public Error {
public:
    /// The place is a line number, a JSON path or whatever finds the fault in the file; an empty
    /// place is left out.
    ParseError(const std::string& file, const std::string& place, const std::string& message)
        : Error(file + (place.empty() ? "" : ":" + place) + ": " + shortened(message)) {}
    ParseError(const std::string& file, std::size_t line, const std::string& message)
        : ParseError(file, std::to_string(line), message) {}
};

/// A file that can't be opened, read or written: "file: reason".
class IoError : public Error {
public:
    IoError(const std::string& file, const std::string& reason)
        : Error((file.empty() ? "''" : file) + ": " + reason) {}
};

}  // namespace boxwood
