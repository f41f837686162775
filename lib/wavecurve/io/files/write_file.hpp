#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

namespace wavecurve::io {

/// Writes a file whole or not at all: to a temporary name beside the target, flushed, synced, then
/// renamed, so that a failure leaves an older file as it was. A link is followed, to a file that is
/// not there yet too. A target that is no regular file (a pipe, /dev/stdout) is written directly.
/// Throws std::system_error naming the path.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// What takes a long text, piece by piece.
using TextSink = std::function<void(std::string_view)>;

/// The same of a text that is larger than the memory: `write` is called once, with what takes its
/// pieces.
void write_file(const std::filesystem::path& path,
                const std::function<void(const TextSink&)>& write);

}  // namespace wavecurve::io
