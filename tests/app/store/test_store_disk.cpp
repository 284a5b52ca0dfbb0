#include "app/store/hdf5/hdf5_file.hpp"
#include "app/store/store.hpp"

#include "app/child_process.hpp"
#include "tests/app/store/store_scene.hpp"
#include "tests/scenes/temporary_folder.hpp"

#include <catch2/catch.hpp>

#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <thread>
#include <unistd.h>

namespace fs = std::filesystem;
using app::Store;
using app::StoreError;
using app::StoreReader;
using Catch::Matchers::Contains;
using scenes::check_rows;
using scenes::start_child;
using scenes::store_head;
using scenes::store_rows;
using scenes::wait_for;

namespace {

void limit_file_size(rlim_t bytes)
{
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{bytes, RLIM_INFINITY};
    ::setrlimit(RLIMIT_FSIZE, &limit);
}

bool says(const std::function<void()>& work, const std::string& words)
{
    try {
        work();
    } catch (const StoreError& error) {
        return std::string(error.what()).find(words) != std::string::npos;
    }
    return false;
}

std::string hdf5_with_layout(const fs::path& path, std::optional<std::uint64_t> layout)
{
    app::hdf5::File file = app::hdf5::create_file(path);
    if (layout) app::hdf5::put_attribute(file, "/", "layout", *layout);
    app::hdf5::close_file(std::move(file));
    return scenes::read_text(path);
}

/// Where the first chunk of a dataset lies, and its size [byte].
std::pair<std::size_t, std::size_t> first_chunk(const fs::path& path, const char* dataset)
{
    const app::hdf5::File file = app::hdf5::open_file(path);
    const hid_t d = H5Dopen2(file.id.get(), dataset, H5P_DEFAULT), space = H5Dget_space(d);
    unsigned mask = 0;
    haddr_t at = 0;
    hsize_t size = 0;
    const herr_t found = H5Dget_chunk_info(d, space, 0, nullptr, &mask, &at, &size);
    H5Sclose(space);
    H5Dclose(d);
    REQUIRE(found >= 0);
    return {at, size};
}

/// A small file system of its own, for root.
class SmallDisk {
  public:
    explicit SmallDisk(const fs::path& at) : at_(at)
    {
        fs::create_directory(at);
        mounted = ::mount("tmpfs", at.c_str(), "tmpfs", 0, "size=1m") == 0;
    }
    ~SmallDisk()
    {
        if (mounted) ::umount2(at_.c_str(), MNT_DETACH);
    }
    bool mounted = false;

  private:
    fs::path at_;
};

} // namespace

TEST_CASE(
    "store: a limit of file size stops it at any size with a reason, without a crash at exit",
    "[app][store_disk]")
{
    const scenes::TemporaryFolder folder;
    const fs::path file = folder.path / "a.h5";
    {
        Store store(file, store_head(300));
        store.append(store_rows(0, 100));
    }
    const auto largest = static_cast<rlim_t>(fs::file_size(app::part_of(file, 1)));
    int refused = 0;
    for (rlim_t limit = 0; limit < largest; limit += largest / 60) {
        const pid_t child = start_child([&] {
            Store store(file, store_head(300)); // its head is there already
            limit_file_size(limit);
            if (!says([&] { store.compact(); }, "ulimit -f")) return 2;
            std::exit(0); // as a program ends: HDF5 cleans up
        });
        const int code = wait_for(child);
        REQUIRE((code == 0 || code == 2));
        if (code == 0) ++refused;
        REQUIRE(!fs::exists(file.string() + ".tmp"));
        REQUIRE(check_rows(file) == 300);
        if (code == 2) break; // was done
    }
    CHECK(refused >= 10);
    Store(file, store_head(300)).compact();
    CHECK(check_rows(file) == 300);
}

TEST_CASE("store: a batch that does not fit is not there at all and can be tried again",
          "[app][store_disk]")
{
    const scenes::TemporaryFolder folder;
    const fs::path file = folder.path / "a.h5";
    const pid_t child = start_child([&] {
        Store store(file, store_head(30));
        store.append(store_rows(0, 10));
        const auto more = store_rows(10, 20);
        for (rlim_t limit = 0; limit < 20000; limit += 700) {
            limit_file_size(limit);
            if (!says([&] { store.append(more); }, "ulimit -f")) return 2;
            if (store.size() != 30 || store.status(more[0].key)) return 3;
            if (std::distance(fs::directory_iterator(app::parts_of(file)), {}) != 1) return 4;
        }
        limit_file_size(RLIM_INFINITY);
        store.append(more); // space was made
        std::exit(0);
    });
    CHECK(wait_for(child) == 0);
    CHECK(check_rows(file) == 60);
}

TEST_CASE(
    "store: a full disk is said, the file stays good, and the study goes on after space is "
    "made",
    "[app][store_disk]")
{
    const scenes::TemporaryFolder folder;
    const SmallDisk disk(folder.path / "disk");
    if (!disk.mounted) {
        WARN("skipped: no right to mount");
        return;
    }
    const fs::path file = folder.path / "disk" / "a.h5", ballast = folder.path / "disk" / "x";
    const pid_t child = start_child([&] {
        std::ofstream(ballast) << std::string(600000, 'x');
        Store store(file, store_head(3000));
        std::uint32_t i = 0;
        if (!says(
                [&] {
                    for (; i < 3000; i += 10) store.append(store_rows(i, i + 10));
                },
                "make space there"))
            return 2;
        if (check_rows(file) != 3 * i) return 3;
        if (!says([&] { store.compact(); }, "make space there")) return 4;
        if (check_rows(file) != 3 * i) return 5;
        fs::remove(ballast);
        store.compact();
        store.append(store_rows(i, i + 1));
        if (check_rows(file) != 3 * i + 3) return 6;
        std::exit(0);
    });
    CHECK(wait_for(child) == 0);
    CHECK(check_rows(file) > 100);
}

TEST_CASE("store: parts that find no room to be merged stay", "[app][store_disk]")
{
    const scenes::TemporaryFolder folder;
    const fs::path file = folder.path / "a.h5", blocked = file.string() + ".tmp";
    const pid_t child = start_child([&] {
        app::StoreOptions options;
        options.most_parts = 3;
        Store store(file, store_head(30), options);
        fs::create_directory(blocked); // cannot be replaced by a file
        for (std::uint32_t i = 0; i < 30; ++i) store.append(store_rows(i, i + 1));
        if (!says([&] { store.compact(); }, blocked.string())) return 2;
        fs::remove(blocked);
        return 0;
    });
    CHECK(wait_for(child) == 0);
    CHECK(check_rows(file) == 90);
    CHECK(app::part_numbers(file).size() == 30);
}

TEST_CASE("store: a folder of parts that is removed while a study runs is said and survived",
          "[app][store_disk]")
{
    const scenes::TemporaryFolder folder;
    const fs::path file = folder.path / "a.h5";
    {
        Store store(file, store_head(30));
        store.append(store_rows(0, 10));
        fs::remove_all(app::parts_of(file));
        const auto more = store_rows(10, 20);
        CHECK_THROWS_WITH(store.append(more), Contains("may have been removed or moved"));
        CHECK_THROWS_WITH(store.compact(), Contains("walls are missing in"));
    }
    Store store(file, store_head(30));
    CHECK(store.size() == 0);
    store.append(store_rows(0, 30));
    store.compact();
    CHECK(check_rows(file) == 90);
}

TEST_CASE("store: a folder of parts that becomes a link while a study runs is not written into",
          "[app][store_disk]")
{
    const scenes::TemporaryFolder folder;
    const fs::path file = folder.path / "a.h5", other = folder.path / "other";
    fs::create_directory(other);
    Store store(file, store_head(30));
    store.append(store_rows(0, 10));
    fs::rename(app::parts_of(file), folder.path / "away");
    fs::create_directory_symlink(other, app::parts_of(file));
    const auto more = store_rows(10, 20);
    CHECK_THROWS_WITH(store.append(more), Contains("must be a folder of its own"));
    CHECK(fs::is_empty(other));
    fs::remove(app::parts_of(file));
    fs::rename(folder.path / "away", app::parts_of(file));
    store.append(more);
    store.compact();
    CHECK(check_rows(file) == 60);
}

TEST_CASE(
    "store: nothing is written through a symbolic link, but a linked file is gone on with",
    "[app][store_disk]")
{
    const scenes::TemporaryFolder folder;
    const fs::path file = folder.path / "a.h5", precious = folder.path / "precious";
    std::ofstream(precious) << "precious";
    fs::create_directory(folder.path / "other");
    SECTION("lock") { fs::create_symlink(precious, app::lock_of(file)); }
    SECTION("parts") { fs::create_symlink(folder.path / "other", app::parts_of(file)); }
    SECTION("nothing there") { fs::create_symlink("none", app::parts_of(file)); }
    SECTION("new file")
    {
        fs::create_symlink(precious, file.string() + ".tmp");
        Store(file, store_head(9)).append(store_rows(0, 9));
        CHECK(check_rows(file) == 27);
        fs::remove_all(app::parts_of(file));
        fs::create_symlink(precious, app::lock_of(file));
    }
    SECTION("part")
    {
        Store(file, store_head(9)).append(store_rows(0, 1));
        fs::create_symlink(precious, app::part_of(file, 2).string() + ".tmp");
        Store(file, store_head(9)).append(store_rows(1, 9));
        CHECK(check_rows(file) == 27);
        fs::create_symlink(precious, app::lock_of(file));
    }
    CHECK_THROWS_AS(Store(file, store_head(9)), StoreError);
    CHECK(scenes::read_text(precious) == "precious");
    CHECK(fs::is_empty(folder.path / "other"));

    fs::create_directory(folder.path / "disk");
    const fs::path target = folder.path / "disk" / "b.h5", link = folder.path / "b.h5";
    Store(target, store_head(9)).append(store_rows(0, 3));
    fs::create_symlink(target, link);
    Store store(link, store_head(9));
    CHECK_THROWS_WITH(Store(target, store_head(9)), Contains("is held by"));
    store.append(store_rows(3, 9));
    CHECK(check_rows(link) == 27);
    store.compact();
    CHECK(fs::is_symlink(link));
    CHECK(check_rows(target) == 27);
}

TEST_CASE("store: a folder that cannot be written is said, reading works there",
          "[app][store_disk]")
{
    const scenes::TemporaryFolder folder;
    const fs::path file = folder.path / "a.h5";
    {
        Store store(file, store_head(30));
        store.append(store_rows(0, 10));
        store.compact();
        store.append(store_rows(10, 20));
    }
    ::chmod(folder.path.c_str(), 0555);
    const pid_t child = start_child([&] {
        if (::geteuid() == 0 && ::seteuid(65534) != 0) return 77; // root may write everywhere
        if (!says([&] { Store(file, store_head(30)); }, "choose a folder that can be written"))
            return 2;
        if (!says([&] { Store(folder.path / "new.h5", store_head(30)); }, "can be written"))
            return 3;
        return check_rows(file) == 60 ? 0 : 4;
    });
    CHECK(wait_for(child) == 0);
    ::chmod(folder.path.c_str(), 0755);
}

TEST_CASE("store: a second process is refused and told of the first, until that ends",
          "[app][store_disk]")
{
    const scenes::TemporaryFolder folder;
    const fs::path file = folder.path / "a.h5";
    int ready[2];
    REQUIRE(::pipe(ready) == 0);
    const pid_t child = start_child([&] {
        Store store(file, store_head(30));
        store.append(store_rows(0, 10));
        if (::write(ready[1], "x", 1) != 1) return 1;
        for (;;) ::pause();
        return 0;
    });
    char byte = 0;
    REQUIRE(::read(ready[0], &byte, 1) == 1);
    CHECK_THROWS_WITH(Store(file, store_head(30)),
                      Contains("held by process " + std::to_string(child) + " on "));
    CHECK(check_rows(file) == 30); // readers need no lock
    ::kill(child, SIGKILL);
    CHECK(wait_for(child) == -SIGKILL);
    const Store store(file, store_head(30));
    CHECK(store.size() == 30);
    CHECK_THROWS_WITH(Store(file, store_head(30)),
                      Contains("held by process " + std::to_string(::getpid())));
    ::close(ready[0]);
    ::close(ready[1]);
}

/// Writes a file of ten walls that is whole. @return its bytes
static std::string ten_walls(const fs::path& file)
{
    Store(file, store_head(30)).append(store_rows(0, 10));
    Store(file, store_head(30)).compact();
    return scenes::read_text(file);
}

TEST_CASE(
    "store: files of something else, damaged or of another layout are refused with a reason",
    "[app][store_disk]")
{
    const scenes::TemporaryFolder folder;
    const fs::path file = folder.path / "a.h5";
    std::string bytes = ten_walls(file);
    std::string words;
    SECTION("empty") { bytes.clear(), words = "is empty"; }
    SECTION("text") { bytes = "[wall]\n", words = "not the file of a study"; }
    SECTION("cut") { bytes.resize(bytes.size() - 1), words = "truncated file"; }
    SECTION("flipped")
    {
        const auto [at, size] =
            first_chunk(file, GENERATE("/walls/level", "/levels/vertical_stress", "/identity"));
        bytes[at + size / 2] ^= 1, words = "is damaged: cannot ";
    }
    SECTION("of version 0.1.0")
    {
        bytes = hdf5_with_layout(folder.path / "old.h5", 1);
        words = "has layout 1, this program knows 2; use the version";
    }
    SECTION("HDF5 of something else")
    {
        bytes = hdf5_with_layout(folder.path / "other.h5", {});
        words = "HDF5 file, but not of a study";
    }
    std::ofstream(file, std::ios::binary) << bytes;
    CHECK_THROWS_WITH(StoreReader(file), Contains(words));
    CHECK_THROWS_WITH(Store(file, store_head(30)), Contains(words));
    CHECK(scenes::read_text(file) == bytes);
}

TEST_CASE("store: a bit flipped in the numbers of a wall is refused when they are read",
          "[app][store_disk]")
{
    const scenes::TemporaryFolder folder;
    const fs::path file = folder.path / "a.h5";
    std::string bytes = ten_walls(file);
    const auto [at, size] =
        first_chunk(file, GENERATE("/walls/inputs", "/responses/peak_force", "/curves/force"));
    bytes[at + size / 2] ^= 1;
    std::ofstream(file, std::ios::binary) << bytes;
    StoreReader reader(file);
    CHECK_THROWS_WITH(reader.for_each_row([](const app::WallRow&) {}),
                      Contains("is damaged: cannot "));
}

TEST_CASE("store: folders, pipes and missing files are refused", "[app][store_disk]")
{
    const scenes::TemporaryFolder folder;
    ::mkfifo((folder.path / "pipe").c_str(), 0600);
    fs::create_directory(folder.path / "folder");
    CHECK_THROWS_WITH(StoreReader(folder.path / "pipe"), Contains("not a regular file"));
    CHECK_THROWS_WITH(StoreReader(folder.path / "folder"), Contains("not a regular file"));
    CHECK_THROWS_WITH(StoreReader(folder.path / "none"), Contains("no such file"));
    CHECK_THROWS_WITH(Store(folder.path / "none" / "a.h5", store_head(1)),
                      Contains("its folder is not there"));
}

TEST_CASE("store: what HDF5 says of an error is in ours alone, whatever the thread",
          "[app][store_disk]")
{
    const scenes::TemporaryFolder folder;
    const fs::path said = folder.path / "stderr";
    CHECK_THROWS_AS(app::hdf5::open_file(folder.path / "none.h5"), StoreError);
    const int screen = ::dup(2), file = ::creat(said.c_str(), 0600);
    ::dup2(file, 2);
    bool refused = false;
    std::thread([&] {
        refused = says(
            [&] {
                static_cast<void>(app::hdf5::create_file(folder.path / "removed" / "part.h5"));
            },
            "its folder is not there");
    }).join();
    ::dup2(screen, 2);
    ::close(screen);
    ::close(file);
    CHECK(refused);
    CHECK(scenes::read_text(said).empty());
}
