#include "app/store/store_driver.hpp"

#include "app/store/store_error.hpp"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <sys/stat.h>
#include <unistd.h>

namespace app {

namespace {

constexpr haddr_t kMaxAddress = (haddr_t{1} << 62) - 1;

/// HDF5 knows the first member, and hands out pointers to it.
struct DriverFile {
    H5FD_t base;
    QuietFile* quiet;
    haddr_t end_of_address; ///< given out by HDF5
    haddr_t end_of_file;    ///< written, or there when opened
};

DriverFile& self(H5FD_t* file) { return *reinterpret_cast<DriverFile*>(file); }
const DriverFile& self(const H5FD_t* file)
{
    return *reinterpret_cast<const DriverFile*>(file);
}

void note(QuietFile& quiet, int error)
{
    if (quiet.error == 0) quiet.error = error;
}

H5FD_t* open_file(const char*, unsigned, hid_t access, haddr_t)
{
    const void* info = H5Pget_driver_info(access);
    if (info == nullptr) return nullptr;
    auto* file = new (std::nothrow) DriverFile{};
    if (file == nullptr) return nullptr;
    std::memcpy(&file->quiet, info, sizeof file->quiet);
    struct stat about {};
    if (::fstat(file->quiet->descriptor, &about) != 0) {
        note(*file->quiet, errno);
        delete file;
        return nullptr;
    }
    file->end_of_file = static_cast<haddr_t>(about.st_size);
    return &file->base;
}

herr_t close_file(H5FD_t* file)
{
    delete &self(file);
    return 0;
}

herr_t query(const H5FD_t*, unsigned long* flags)
{
    *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_ACCUMULATE_METADATA |
             H5FD_FEAT_DATA_SIEVE | H5FD_FEAT_AGGREGATE_SMALLDATA;
    return 0;
}

haddr_t end_of_address(const H5FD_t* file, H5FD_mem_t) { return self(file).end_of_address; }

herr_t set_end_of_address(H5FD_t* file, H5FD_mem_t, haddr_t address)
{
    self(file).end_of_address = address;
    return 0;
}

haddr_t end_of_file(const H5FD_t* file, H5FD_mem_t) { return self(file).end_of_file; }

herr_t read_file(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, size_t size, void* buffer)
{
    auto* bytes = static_cast<char*>(buffer);
    std::size_t done = 0;
    while (done < size) {
        const ssize_t n = ::pread(self(file).quiet->descriptor, bytes + done, size - done,
                                  static_cast<off_t>(address + done));
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) note(*self(file).quiet, errno);
        if (n < 0) return -1;
        if (n == 0) break;
        done += static_cast<std::size_t>(n);
    }
    std::memset(bytes + done, 0, size - done); // beyond the end of the file
    return 0;
}

herr_t write_file(H5FD_t* file, H5FD_mem_t, hid_t, haddr_t address, size_t size,
                  const void* buffer)
{
    DriverFile& f = self(file);
    // after the first error nothing more is written: the file is of no use
    if (f.quiet->error == 0)
        note(*f.quiet, write_at(f.quiet->descriptor, buffer, size, address));
    f.end_of_file = std::max(f.end_of_file, address + size);
    return 0;
}

herr_t truncate_file(H5FD_t* file, hid_t, hbool_t)
{
    DriverFile& f = self(file);
    if (f.end_of_address == f.end_of_file) return 0;
    if (f.quiet->error == 0 &&
        ::ftruncate(f.quiet->descriptor, static_cast<off_t>(f.end_of_address)) != 0)
        note(*f.quiet, errno);
    f.end_of_file = f.end_of_address;
    return 0;
}

H5FD_class_t driver_class()
{
    H5FD_class_t driver{};
#if H5_VERSION_GE(1, 14, 0)
    driver.version = H5FD_CLASS_VERSION;
    driver.value = static_cast<H5FD_class_value_t>(511); // 256 to 511 are free
#endif
    driver.name = "drystone";
    driver.maxaddr = kMaxAddress;
    driver.fc_degree = H5F_CLOSE_STRONG;
    driver.fapl_size = sizeof(QuietFile*);
    driver.open = open_file;
    driver.close = close_file;
    driver.query = query;
    driver.get_eoa = end_of_address;
    driver.set_eoa = set_end_of_address;
    driver.get_eof = end_of_file;
    driver.read = read_file;
    driver.write = write_file;
    driver.truncate = truncate_file;
    const H5FD_mem_t two_lists[] = H5FD_FLMAP_DICHOTOMY;
    std::copy(std::begin(two_lists), std::end(two_lists), driver.fl_map);
    return driver;
}

} // namespace

void use_quiet_file(hid_t access, QuietFile& file)
{
    static const H5FD_class_t driver = driver_class();
    static const hid_t registered = H5FDregister(&driver);
    QuietFile* const info = &file;
    if (registered < 0 || H5Pset_driver(access, registered, &info) < 0)
        throw StoreError("HDF5: the file driver cannot be set");
}

} // namespace app
