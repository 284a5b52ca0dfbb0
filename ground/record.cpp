#include "ground/record.hpp"

#include "ground/record_error.hpp"
#include "ground/record_text.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace ground {
namespace {

using Reader = std::vector<Record> (*)(const RecordText&, const ReadOptions&);

bool has(const RecordText& text, std::string_view word, std::size_t many = 100)
{
    return find_line(text, word, 0, many) < text.lines.size();
}

/// nullptr if nothing in the text is like a record.
Reader reader_of(const RecordText& text)
{
    const std::string first = lower(text.lines.front().substr(0, 200));
    const bool corrected = first.find("corrected accelerogram") != std::string::npos;
    if (text.lines.size() > 1 && corrected && !first.empty() && first[0] >= '0' &&
        first[0] <= '9' && text.lines[1].starts_with('*'))
        return smc_records;
    if (has(text, "SAMPLING_INTERVAL_S:")) return esm_records;
    if (has(text, "Sampling Freq", 17) && has(text, "Scale Factor", 17)) return knet_records;
    if (has(text, "acceleration pts")) return cosmos_records;
    if (has(text, "points of acc")) return v2_records;
    if (corrected && has(text, "mm/s/s", 30)) return v2a_records;
    if (corrected && has(text, "units of uncor", 30)) return v1_records;
    if (has(text, "samples/sec", 20)) return usgs_records;
    if (has(text, "NPTS")) return at2_records;
    for (const std::string_view line : text.lines)
        if (all_numbers(line)) return column_records;
    return nullptr;
}

} // namespace

double acceleration_unit(std::string_view text)
{
    std::string unit = lower(stripped(text));
    const auto replace = [&](std::string_view from, std::string_view to) {
        for (std::size_t at; (at = unit.find(from)) != std::string::npos;)
            unit.replace(at, from.size(), to);
    };
    std::erase_if(unit, [](char c) { return c == ' ' || c == '^' || c == '*'; });
    replace("sec", "s");
    replace("cms/", "cm/");
    replace("\xE2\x81\xBB", "-"); // superscript minus and 2, dot of a product
    replace("\xC2\xB2", "2");
    replace("\xC2\xB7", "");
    replace("\xB2", "2"); // the same in Latin-1
    replace("\xB7", "");
    replace(".s-2", "/s2");
    if (unit == "ms-2" || unit == "cms-2" || unit == "mms-2")
        unit.replace(unit.find("s-2"), 3, "/s2");
    replace("/s/s", "/s2");
    if (unit == "g") return kGravity;
    if (unit == "g/10") return 0.1 * kGravity;
    if (unit == "m/s2") return 1.0;
    if (unit == "cm/s2" || unit == "gal") return 1e-2;
    if (unit == "mm/s2") return 1e-3;
    return 0.0;
}

std::vector<Record> parse_records(const std::string& path, std::string_view text,
                                  const ReadOptions& options)
{
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
        throw RecordError(path, 0, "is empty; give a record of strong motion");
    if (const std::size_t nul = text.find('\0'); nul != std::string_view::npos)
        throw RecordError(path, 0,
                          "is binary; give a record as text (AT2, V1, V2, V2A, SMC, ESM ASC, "
                          "COSMOS, K-NET or two columns)");
    const RecordText lines = lines_of(path, text);
    const Reader read = reader_of(lines);
    if (read == nullptr)
        throw RecordError(path, 0,
                          "is in no format known here; give AT2, V1, V2, V2A, SMC, ESM ASC, "
                          "COSMOS V2c, K-NET or KiK-net ASCII, or two columns, time [s] and "
                          "acceleration");
    std::vector<Record> all = read(lines, options);
    if (all.empty())
        throw RecordError(path, 1,
                          "no component of acceleration was found; get the file again");
    if (all.size() > 1)
        for (std::size_t i = 0; i < all.size(); ++i) {
            const std::string& name = all[i].component;
            all[i].motion.name += " " + (name.empty() ? std::to_string(i + 1) : name);
        }
    return all;
}

std::vector<Record> read_records(const std::string& path, const ReadOptions& options)
{
    constexpr std::uintmax_t kMost = std::uintmax_t{256} << 20;
    std::error_code error;
    if (std::filesystem::is_directory(path, error))
        throw RecordError(path, 0, "is a directory; give a record");
    std::ifstream in(path, std::ios::binary);
    if (!in)
        throw RecordError(path, 0,
                          std::string("cannot be read (") + std::strerror(errno) +
                              "); give a record of strong motion");
    std::string text;
    std::array<char, 1 << 16> block{};
    while (in.read(block.data(), block.size()) || in.gcount() > 0) {
        text.append(block.data(), static_cast<std::size_t>(in.gcount()));
        if (text.size() > kMost)
            throw RecordError(path, 0, "is larger than 256 MiB; cut the record");
    }
    return parse_records(path, text, options);
}

} // namespace ground
