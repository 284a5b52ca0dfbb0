#include "app/drawing/outlines/drawing_file.hpp"
#include "app/drawing/outlines/drawing_formats.hpp"
#include "app/drawing/outlines/sheet_frames.hpp"
#include "app/text/config_error.hpp"
#include "dem/scene/drawn_layout.hpp"

#include <boost/algorithm/string/case_conv.hpp>

#include <algorithm>
#include <array>
#include <locale>
#include <string>
#include <string_view>
#include <utility>

namespace app {
namespace {

std::string extension_of(const std::filesystem::path& path)
{
    std::string extension = path.extension().string();
    boost::to_lower(extension, std::locale::classic());
    return extension;
}

void check_options(const std::string& file, const DrawingOptions& options)
{
    if (!(options.unit >= 1e-6 && options.unit <= 1e3)) {
        throw ConfigError(file, 0, "", "the length of a unit must be in [1e-6, 1000] m");
    }
    if (!(options.snap >= 0.0 && options.snap <= 0.1)) {
        throw ConfigError(file, 0, "", "wall.snap must be in [0, 100] mm");
    }
}

/// The remedy for a file of another format.
std::string remedy_for(const std::string& extension)
{
    struct Other {
        std::string_view extension, remedy;
    };
    constexpr std::string_view kFindStones =
        "find the stones of a photograph by \"drystone stones\" first";
    constexpr std::array kOthers = {Other{".jpg", kFindStones},
                                    Other{".jpeg", kFindStones},
                                    Other{".gif", "save it as PNG"},
                                    Other{".bmp", "save it as PNG"},
                                    Other{".tif", "save it as PNG"},
                                    Other{".tiff", "save it as PNG"},
                                    Other{".webp", "save it as PNG"},
                                    Other{".dwg", "save it as ASCII DXF"},
                                    Other{".pdf", "save it as DXF or SVG"}};
    const auto other = std::ranges::find(kOthers, extension, &Other::extension);
    return other != kOthers.end() ? std::string(other->remedy)
                                  : "give a .dxf, .json, .svg or .png file";
}

} // namespace

bool is_picture(const std::filesystem::path& path) { return extension_of(path) == ".png"; }

bool has_polylines(const std::filesystem::path& path)
{
    const std::string extension = extension_of(path);
    return extension == ".dxf" || extension == ".svg";
}

Drawing fit_blocks(const std::string& file, int line, std::span<const DrawnBlock> blocks)
{
    RawDrawing raw;
    raw.frame.file = file;
    raw.frame.snap_given = false;
    for (const DrawnBlock& b : blocks) raw.outlines.push_back({b.outline, b.layer, line});
    return fit_drawing(std::move(raw), 2.0 * dem::kTouching);
}

Drawing read_drawing(const std::filesystem::path& path, const DrawingOptions& options)
{
    const std::string extension = extension_of(path);
    const DrawingFrame frame{path.string(),      options.unit, extension == ".svg",    {},
                             options.unit_given, true,         options.close_outlines, {}};
    check_options(frame.file, options);
    const double snap = options.snap;
    const auto fitted = [&](RawDrawing drawing) {
        take_out_frames(drawing, snap);
        divide_outlines(drawing, snap);
        return fit_drawing(std::move(drawing), snap);
    };
    if (extension == ".dxf") return fitted(read_dxf(frame, read_drawing_bytes(path), snap));
    if (extension == ".json")
        return fit_drawing(read_json_drawing(frame, read_drawing_bytes(path), snap), snap);
    if (extension == ".svg") return fitted(read_svg(frame, read_drawing_bytes(path), snap));
    if (is_picture(path)) return read_picture(frame, read_drawing_bytes(path), options);
    throw ConfigError(frame.file, 0, "",
                      "is not a drawing that can be read; " + remedy_for(extension));
}

} // namespace app
