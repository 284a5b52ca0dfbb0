#include "app/commands.hpp"
#include "app/drawing/outlines/drawing_file.hpp"
#include "app/output/result_folder.hpp"
#include "app/photograph/stones_picture.hpp"
#include "app/text/config_error.hpp"
#include "app/text/number_text.hpp"

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <string>

namespace app {
namespace {

constexpr std::string_view kStonesList = "drystone_stones_files.txt";

StoneMethod method_of(const Command& command)
{
    if (command.method.empty()) return StoneMethod::best;
    const auto at = std::ranges::find(kStoneMethods, command.method);
    if (at == kStoneMethods.end())
        throw ConfigError("drystone", 0, "--method",
                          in_quotes(command.method) + " finds no stones; " +
                              suggestion(command.method, kStoneMethods));
    return static_cast<StoneMethod>(at - kStoneMethods.begin());
}

Picture read_photograph(const DrawingFrame& frame)
{
    const std::string extension = std::filesystem::path(frame.file).extension().string();
    const auto is = [&](const char* other) { return boost::iequals(extension, other); };
    if (is(".png")) return read_png(frame, read_drawing_bytes(frame.file));
    if (is(".jpg") || is(".jpeg")) return read_jpeg(frame, read_drawing_bytes(frame.file));
    refuse(frame, 0, "is no photograph that can be read; save it as .jpg or .png");
}

double share_of_stone(const Labels& labels)
{
    const auto stone = std::ranges::count_if(
        labels.label, [&](int l) { return l != kMortar && !labels.is_opening[l]; });
    return static_cast<double>(stone) / static_cast<double>(labels.label.size());
}

void say(const FoundStones& found, const std::filesystem::path& folder)
{
    const Labels& labels = found.labels;
    const auto openings = static_cast<std::size_t>(std::ranges::count(labels.is_opening, 1));
    std::cout << counted(static_cast<std::size_t>(labels.stones) - openings, "stone", "stones")
              << (openings > 0 ? " and " + counted(openings, "opening", "openings")
                               : std::string())
              << " by " << kStoneMethods[static_cast<std::size_t>(found.method)] << ", on "
              << fixed(100.0 * share_of_stone(labels), 0) << " % of " << labels.columns << " x "
              << labels.rows << " pixels\n"
              << "look at " << (folder / "found.png").string() << "; correct "
              << (folder / "stones.png").string()
              << ": a colour for each stone, black mortar, magenta openings\n"
              << "then write into [wall] of a study, with the true width of what the picture "
                 "shows in place of the ?; it is "
              << number(1.0 * labels.rows / labels.columns, 3) << " times as high as wide:\n"
              << "  geometry = " << std::filesystem::absolute(folder / "stones.png").string()
              << "\n  picture_width = ? m\n  picture_height = ? m\n";
}

/// A free choice: in smaller pictures of known walls joints are lost and stones are joined.
std::string small_note(const Picture& picture)
{
    constexpr int kSmall = 300; // [pixels]
    if (std::max(picture.columns, picture.rows) >= kSmall) return "";
    return "note: the photograph has only " + std::to_string(picture.columns) + " x " +
           std::to_string(picture.rows) +
           " pixels, in which joints are lost and stones joined; take one of 700 or more\n";
}

} // namespace

int stones_command(const Command& command)
{
    const StoneMethod method = method_of(command);
    if (const std::string note =
            check_results(command.out, {"stones.png", "found.png"}, kStonesList);
        !command.quiet)
        std::cerr << note;
    DrawingFrame frame;
    frame.file = command.words.front();
    const Picture picture = read_photograph(frame);
    if (!command.quiet) std::cerr << small_note(picture);
    const FoundStones found = find_photographed(frame, picture, method);
    write_results(command.out,
                  {{"stones.png", png_of(painted_picture(found.labels))},
                   {"found.png", png_of(found_picture(found))}},
                  kStonesList);
    say(found, command.out);
    return 0;
}

} // namespace app
