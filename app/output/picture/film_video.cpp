#include "app/output/picture/film_video.hpp"

#include "app/output/atomic_output.hpp"
#include "app/output/run_program.hpp"

#include <cstdio>
#include <system_error>

namespace app {
namespace {

namespace fs = std::filesystem;

constexpr int kPicturesPerSecond = 10;
constexpr int kHeld = 12; ///< pictures for which the last one stays

/// A folder that goes away with its pictures.
class Pictures {
  public:
    Pictures(fs::path folder, const std::vector<std::string>& stills)
        : folder_(std::move(folder))
    {
        fs::create_directories(folder_);
        for (std::size_t i = 0; i < stills.size() + kHeld; ++i)
            write_file(folder_ / name(i), stills[std::min(i, stills.size() - 1)]);
    }
    ~Pictures()
    {
        std::error_code ignored;
        fs::remove_all(folder_, ignored);
    }
    Pictures(const Pictures&) = delete;
    Pictures& operator=(const Pictures&) = delete;
    [[nodiscard]] std::string pattern() const { return (folder_ / "%04d.svg").string(); }

  private:
    static std::string name(std::size_t i)
    {
        char text[32];
        std::snprintf(text, sizeof text, "%04zu.svg", i);
        return text;
    }
    fs::path folder_;
};

} // namespace

std::string_view video_mark(const fs::path& file)
{
    return file.extension() == ".gif" ? "GIF89a" : "webm";
}

std::string write_video(const fs::path& file, const std::vector<std::string>& stills)
{
    fs::path part = file; // ffmpeg knows what to write by the ending
    part.replace_filename("." + file.stem().string() + ".part" + file.extension().string());
    fs::path folder = file;
    folder.replace_filename("." + file.stem().string() + ".pictures");
    int code = 0;
    try {
        const Pictures pictures(folder, stills);
        std::vector<std::string> words = {"ffmpeg",
                                          "-nostdin",
                                          "-y",
                                          "-loglevel",
                                          "error",
                                          "-framerate",
                                          std::to_string(kPicturesPerSecond),
                                          "-i",
                                          pictures.pattern()};
        const std::vector<std::string> how =
            file.extension() == ".gif"
                ? std::vector<std::string>{"-vf",
                                           "split[a][b];[a]palettegen=stats_mode=diff[p];"
                                           "[b][p]paletteuse=dither=none"}
                : std::vector<std::string>{"-c:v", "libvpx-vp9", "-pix_fmt", "yuv420p",
                                           "-b:v", "0",          "-crf",     "32"};
        words.insert(words.end(), how.begin(), how.end());
        words.push_back(part.string());
        code = run_program(std::move(words));
    } catch (const std::exception& error) {
        return "no film " + file.string() + ": " + error.what();
    }
    std::error_code failed, ignored;
    if (code == 0) fs::rename(part, file, failed);
    if (code == 0 && !failed) return file.string() + " written";
    fs::remove(part, ignored);
    if (is_missing(code))
        return "no film " + file.string() +
               ": install ffmpeg (Debian: apt install ffmpeg); film.svg moves without it";
    return "no film " + file.string() +
           ": ffmpeg failed; it must read SVG, as Debian's does; film.svg moves without it";
}

} // namespace app
