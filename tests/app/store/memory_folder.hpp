#pragma once
/// A folder of its own in memory where there is such a thing: a test that replaces files a
/// thousand times need not wait for the disk each time. A kill does not ask whether the disk
/// has it either.

#include <filesystem>
#include <stdexcept>
#include <stdlib.h> // mkdtemp is POSIX
#include <string>

namespace scenes {

class MemoryFolder {
  public:
    MemoryFolder()
    {
        const std::filesystem::path memory = "/dev/shm";
        std::error_code ignored;
        const bool there = std::filesystem::is_directory(memory, ignored) &&
                           std::filesystem::space(memory, ignored).available > (32u << 20);
        std::string name =
            ((there ? memory : std::filesystem::temp_directory_path()) / "drystone-XXXXXX")
                .string();
        if (::mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
        path = name;
    }
    ~MemoryFolder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
    MemoryFolder(const MemoryFolder&) = delete;
    MemoryFolder& operator=(const MemoryFolder&) = delete;

    std::filesystem::path path;
};

} // namespace scenes
