#pragma once
/// Records of strong motion in the formats in which networks hand them out.

#include "ground/ground_motion.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ground {

inline constexpr double kGravity = 9.80665; ///< [m/s2]

/// One component as its file gives it.
struct Record {
    GroundMotion motion;
    std::string format;                ///< "PEER AT2"
    std::string unit;                  ///< of the values in the file: "cm/s2"
    std::string component;             ///< as the file names it; may be empty
    int line = 0;                      ///< of the first value, from 1
    std::optional<double> stated_peak; ///< largest acceleration as the head states it [m/s2]
    std::vector<std::string> remarks;  ///< sentences without a full stop
};

struct ReadOptions {
    /// Unit of the values, in place of the one that the file states: "g", "m/s2", "cm/s2",
    /// "mm/s2", "g/10". Empty: the file's.
    std::string unit;
};

/// Value of a unit of acceleration [m/s2]: g, g/10, m/s2, cm/s2 (Gal), mm/s2, in the spellings
/// of the formats ("CM/SEC/SEC").
/// @return 0 if the text is no unit of acceleration
[[nodiscard]] double acceleration_unit(std::string_view text);

/// All components of acceleration in a text. The format is found from the content: AT2 (PEER,
/// old and new heads), CSMIP and USC V2, CSMIP V1, GeoNet V2A, USGS SMC, COSMOS V2c, ESM ASC,
/// K-NET and KiK-net ASCII, USGS text (SAMPLES/SEC=), or two columns of time [s] and
/// acceleration (in g where nothing is said).
/// @param path names the text in messages
/// @throws RecordError no known format, empty, binary, fewer or more values than stated, NaN,
/// unequal or wrong time steps, units that are unknown or missing where they matter, a peak
/// that is not the one that the head states
[[nodiscard]] std::vector<Record> parse_records(const std::string& path, std::string_view text,
                                                const ReadOptions& options = {});

/// The same of a file of at most 256 MiB.
[[nodiscard]] std::vector<Record> read_records(const std::string& path,
                                               const ReadOptions& options = {});

} // namespace ground
