#pragma once

#include "app/input/command.hpp"

#include <filesystem>
#include <string>

namespace app {

/// "runs/paper.h5", shard 3 of 16: "runs/paper_03_of_16.h5"
[[nodiscard]] inline std::filesystem::path shard_file(const std::filesystem::path& out,
                                                      Shard shard)
{
    if (shard.count == 1) return out;
    std::string index = std::to_string(shard.index + 1);
    const std::string count = std::to_string(shard.count);
    index.insert(0, count.size() - index.size(), '0');
    std::filesystem::path file = out;
    file.replace_filename(out.stem().string() + "_" + index + "_of_" + count +
                          out.extension().string());
    return file;
}

} // namespace app
