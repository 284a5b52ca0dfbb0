#include "app/output/atomic_output.hpp"

#include "tests/scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <csignal>
#include <cstddef>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <sys/stat.h>

namespace fs = std::filesystem;
using Catch::Matchers::Contains;
using scenes::read_text;

namespace {

std::ptrdiff_t entries_in(const fs::path& folder)
{
    return std::distance(fs::directory_iterator(folder), fs::directory_iterator());
}

/// Stands for a full disk: writing beyond `bytes` fails.
class FileSizeLimit {
  public:
    explicit FileSizeLimit(rlim_t bytes)
    {
        ::getrlimit(RLIMIT_FSIZE, &before_);
        rlimit limit = before_;
        limit.rlim_cur = bytes;
        ::setrlimit(RLIMIT_FSIZE, &limit);
        handler_ = std::signal(SIGXFSZ, SIG_IGN);
    }
    ~FileSizeLimit()
    {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }

  private:
    rlimit before_{};
    void (*handler_)(int) = nullptr;
};

} // namespace

TEST_CASE("atomic output: a file holds what was written, and nothing else is left",
          "[app][atomic_output]")
{
    const scenes::TemporaryFolder folder;
    const std::string content(300000, 'x');
    app::write_file(folder.path / "a.csv", "old");
    app::write_file(folder.path / "a.csv", content);
    CHECK(read_text(folder.path / "a.csv") == content);
    CHECK(entries_in(folder.path) == 1);
}

TEST_CASE("atomic output: a file is as readable for others as the umask allows",
          "[app][atomic_output]")
{
    const scenes::TemporaryFolder folder;
    const mode_t before = ::umask(022);
    app::write_file(folder.path / "a.csv", "1\n");
    ::umask(before);
    CHECK(fs::status(folder.path / "a.csv").permissions() == static_cast<fs::perms>(0644));
}

TEST_CASE("atomic output: a failure half-way leaves the old file and no temporary",
          "[app][atomic_output]")
{
    const scenes::TemporaryFolder folder;
    const fs::path path = folder.path / "a.csv";
    app::write_file(path, "old");
    {
        const FileSizeLimit full(1000);
        CHECK_THROWS_WITH(app::write_file(path, std::string(5000, 'x')),
                          Contains("cannot write '" + path.string() + "': File too large"));
    }
    CHECK(read_text(path) == "old");
    CHECK(entries_in(folder.path) == 1);
}

TEST_CASE("atomic output: a file written piece by piece is there once it is finished, else not "
          "at all",
          "[app][atomic_output]")
{
    const scenes::TemporaryFolder folder;
    const fs::path path = folder.path / "a.csv";
    app::write_file(path, "old");
    const auto reader_that_throws = [&] {
        app::NewFile file(path);
        file.add("new");
        throw std::runtime_error("the file that is read is damaged");
    };
    CHECK_THROWS_WITH(reader_that_throws(), Contains("is damaged"));
    CHECK(read_text(path) == "old");
    CHECK(entries_in(folder.path) == 1);
    {
        app::NewFile file(path);
        file.add("one\n");
        file.add("two\n");
        CHECK(read_text(path) == "old");
        file.finish();
    }
    CHECK(read_text(path) == "one\ntwo\n");
    CHECK(entries_in(folder.path) == 1);
}

TEST_CASE("atomic output: a folder that is missing is named with the reason",
          "[app][atomic_output]")
{
    const scenes::TemporaryFolder folder;
    const fs::path path = folder.path / "none" / "a.csv";
    CHECK_THROWS_WITH(app::write_file(path, "1"),
                      "cannot write '" + path.string() + "': No such file or directory");
}

TEST_CASE("atomic output: devices and folders are not replaced", "[app][atomic_output]")
{
    const scenes::TemporaryFolder folder;
    const fs::path pipe =
        folder.path / "pipe"; // stands for /dev/null, which a bug would replace
    REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    CHECK_THROWS_WITH(app::write_file(pipe, "1"), Contains("not a regular file"));
    CHECK(fs::is_fifo(pipe));
    fs::create_directory(folder.path / "sub");
    CHECK_THROWS_WITH(app::write_file(folder.path / "sub", "1"),
                      Contains("not a regular file"));
    CHECK(entries_in(folder.path) == 2);
}

TEST_CASE("atomic output: a folder is made with its parents, or the reason is named",
          "[app][atomic_output]")
{
    const scenes::TemporaryFolder folder;
    app::make_folder(folder.path / "a" / "b");
    app::make_folder(folder.path / "a" / "b"); // there already: fine
    CHECK(fs::is_directory(folder.path / "a" / "b"));
    app::write_file(folder.path / "file", "1");
    for (const fs::path& bad : {folder.path / "file", folder.path / "file" / "b"})
        CHECK_THROWS_WITH(app::make_folder(bad),
                          "cannot create folder '" + bad.string() + "': Not a directory");
}
