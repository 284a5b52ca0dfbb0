#include "app/drawing/trace/picture.hpp"

#include "app/drawing/trace/smooth_edges.hpp"
#include "app/text/number_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace app {
namespace {

// Limits of what counts as bright stones on dark mortar; docs/drawings.md tells the user.
constexpr int kGreyDifference = 24;     // between the colours of a grey pixel, of 255
constexpr double kGreyShare = 0.98;     // of the pixels must be grey
constexpr double kLeastContrast = 80.0; // between the two mean greys
constexpr double kSpread = 40.0;        // of a pixel from the mean grey of its class
constexpr double kSpreadShare = 0.90;   // of the pixels must be within
constexpr int kBlack = 8;               // mortar where each stone has its own colour
constexpr double kLeastCover = 0.3;     // of the picture must be stones
constexpr double kFewNarrow = 2.0;      // stones may be as narrow as edges in any picture
constexpr double kMostNarrow = 0.1;     // of the stones of a picture with smooth edges

struct Colour {
    int red = 0, green = 0, blue = 0;
    [[nodiscard]] int grey() const { return (red + green + blue) / 3; }
    [[nodiscard]] bool is_grey() const
    {
        return std::max({red, green, blue}) - std::min({red, green, blue}) <= kGreyDifference;
    }
    [[nodiscard]] int code() const { return red << 16 | green << 8 | blue; }
    [[nodiscard]] bool is_opening() const { return code() == kOpeningColour; }
};

/// A magenta that a conversion of colours has changed a little.
bool is_nearly_opening(int code)
{
    constexpr int kNear = 32; // of 255, a free choice
    const int red = code >> 16, green = code >> 8 & 255, blue = code & 255;
    return code != kOpeningColour && red >= 255 - kNear && green <= kNear &&
           blue >= 255 - kNear;
}

/// Black where the pixel is more transparent than not.
Colour colour_of(const Picture& picture, std::size_t pixel)
{
    const std::uint8_t* p = picture.rgba.data() + 4 * pixel;
    return p[3] < 128 ? Colour{} : Colour{p[0], p[1], p[2]};
}

struct TwoGreys {
    bool are = false;
    double dark = 0.0, bright = 0.0; ///< mean greys
    bool openings = false;           ///< there are two greys, and openings
};

/// Greys divided where the variance between the classes is largest (Otsu 1979, IEEE Trans. SMC
/// 9, 62-66).
TwoGreys two_greys(const Picture& picture, std::size_t pixels)
{
    std::array<double, 256> histogram{};
    std::size_t grey = 0, openings = 0;
    for (std::size_t i = 0; i < pixels; ++i) {
        const Colour c = colour_of(picture, i);
        openings += c.is_opening() ? 1 : 0;
        if (c.is_opening()) continue;
        grey += c.is_grey() ? 1 : 0;
        histogram[c.grey()] += 1.0;
    }
    const double n = static_cast<double>(pixels - openings);
    double sum = 0.0;
    for (std::size_t g = 0; g < 256; ++g) sum += static_cast<double>(g) * histogram[g];
    TwoGreys best;
    double most = 0.0, below = 0.0, sum_below = 0.0;
    for (std::size_t g = 0; g < 255; ++g) {
        below += histogram[g];
        sum_below += static_cast<double>(g) * histogram[g];
        if (below == 0.0 || below == n) continue;
        const double dark = sum_below / below, bright = (sum - sum_below) / (n - below);
        const double variance = below * (n - below) * (bright - dark) * (bright - dark);
        if (variance <= most) continue;
        most = variance;
        best = {false, dark, bright, false};
    }
    double near = 0.0;
    for (std::size_t g = 0; g < 256; ++g) {
        const double value = static_cast<double>(g);
        if (std::min(std::abs(value - best.dark), std::abs(value - best.bright)) <= kSpread)
            near += histogram[g];
    }
    best.are = static_cast<double>(grey) >= kGreyShare * n &&
               best.bright - best.dark >= kLeastContrast && near >= kSpreadShare * n;
    best.openings = best.are && openings > 0;
    return best;
}

/// A number for each pixel: pixels of one stone have the same one. kMortar for mortar, and in a
/// grey picture with openings for the mixed colours of their edges.
std::vector<int> kinds_of(const Picture& picture, std::size_t pixels, const TwoGreys& greys)
{
    std::vector<int> kind(pixels);
    const double middle = 0.5 * (greys.dark + greys.bright);
    for (std::size_t i = 0; i < pixels; ++i) {
        const Colour c = colour_of(picture, i);
        const bool black = std::max({c.red, c.green, c.blue}) <= kBlack;
        if (c.is_opening())
            kind[i] = kOpeningColour;
        else if (greys.openings && !c.is_grey())
            kind[i] = kMortar;
        else if (greys.are)
            kind[i] = c.grey() > middle ? 0 : kMortar;
        else
            kind[i] = black ? kMortar : c.code();
    }
    return kind;
}

struct Pieces {
    std::size_t dirt = 0;       ///< pieces that were too small
    std::size_t edges = 0;      ///< pieces of mixed colours
    std::size_t covered = 0;    ///< pixels of stones
    std::size_t open = 0;       ///< pixels of openings
    std::size_t openings = 0;   ///< of the labels
    std::size_t narrow = 0;     ///< stones no wider than an edge may be
    std::size_t narrow_at = 0;  ///< the first pixel of the first of them
    std::size_t magenta = 0;    ///< stones of a colour that is nearly that of an opening
    std::size_t magenta_at = 0; ///< the first pixel of the first of them
};

/// @param coloured a colour may be a mixture of others
Pieces number_pieces(const DrawingFrame& frame, Labels& labels, const std::vector<int>& kind,
                     double least_pixels, bool coloured)
{
    std::vector<char> seen(labels.label.size());
    const std::vector<char> inner = coloured ? inner_pixels(labels, kind) : std::vector<char>();
    Pieces pieces;
    for (std::size_t i = 0; i < labels.label.size(); ++i) {
        if (seen[i] || kind[i] == kMortar) continue;
        const std::vector<std::size_t> piece = connected(labels, kind, i, seen);
        if (static_cast<double>(piece.size()) < least_pixels) {
            ++pieces.dirt;
            continue;
        }
        const bool opening = kind[i] == kOpeningColour;
        if (coloured && !opening && is_smooth_edge(labels, kind, inner, piece)) {
            ++pieces.edges;
            continue;
        }
        if (coloured && !opening &&
            std::ranges::none_of(piece, [&](std::size_t p) { return inner[p]; }) &&
            pieces.narrow++ == 0)
            pieces.narrow_at = i;
        if (coloured && is_nearly_opening(kind[i]) && pieces.magenta++ == 0)
            pieces.magenta_at = i;
        if (labels.stones >= static_cast<int>(kMostBlocks)) {
            refuse(frame, 0,
                   "has more than " + std::to_string(kMostBlocks) +
                       " stones; take a picture of a part of the wall");
        }
        for (const std::size_t pixel : piece) labels.label[pixel] = labels.stones;
        (opening ? pieces.open : pieces.covered) += piece.size();
        pieces.openings += opening ? 1 : 0;
        labels.is_opening.push_back(opening ? 1 : 0);
        ++labels.stones;
    }
    return pieces;
}

std::string place_of(std::size_t pixel, const Labels& labels)
{
    const auto columns = static_cast<std::size_t>(labels.columns);
    return "pixel (" + std::to_string(pixel % columns) + ", " +
           std::to_string(pixel / columns) + ")";
}

} // namespace

Labels find_stones(const DrawingFrame& frame, const Picture& picture, PixelSize pixel,
                   double dirt, std::vector<std::string>& notes)
{
    constexpr double kLeastPixels = 16.0; // fewer have no shape
    Labels labels{picture.columns, picture.rows, 0, {}, {}};
    const std::size_t pixels = picture.rgba.size() / 4;
    labels.label.assign(pixels, kMortar);
    const double pixel_area = pixel.width * pixel.height;
    const TwoGreys greys = two_greys(picture, pixels);
    const double least = std::max(kLeastPixels, dirt / pixel_area);
    const Pieces pieces =
        number_pieces(frame, labels, kinds_of(picture, pixels, greys), least, !greys.are);
    const double covered = static_cast<double>(pieces.covered),
                 wall = static_cast<double>(pixels - pieces.open),
                 share = covered / std::max(1.0, wall);
    const std::size_t stones = static_cast<std::size_t>(labels.stones) - pieces.openings;
    const double most_narrow = std::max(kFewNarrow, kMostNarrow * static_cast<double>(stones));
    if (pieces.edges > 0 && static_cast<double>(pieces.narrow) > most_narrow) {
        refuse(frame, 0,
               "has smooth edges, and " + std::to_string(pieces.narrow) + " of " +
                   counted(stones, "stone", "stones") + " would be at most " +
                   std::to_string(kWidestEdge) + " pixels wide, such as the one at " +
                   place_of(pieces.narrow_at, labels) +
                   "; paint them without smooth edges, or white on black");
    }
    if (share < kLeastCover) {
        refuse(frame, 0,
               "was taken as " +
                   std::string(greys.are ? "bright stones on dark mortar"
                                         : "stones of one colour each") +
                   ", and stones cover " + fixed(100.0 * share, 1) +
                   " % of it; paint the stones white on black, or each in one colour of its "
                   "own with black mortar; of a photograph write \"drystone stones " +
                   frame.file + "\" first");
    }
    notes.push_back(
        greys.are
            ? "The picture has bright stones (grey " + fixed(greys.bright, 0) +
                  " of 255) on dark mortar (" + fixed(greys.dark, 0) + ")."
            : "In the picture each connected area of one colour is a stone; black is mortar.");
    notes.push_back(counted(stones, "stone covers ", "stones cover ") +
                    number(covered * pixel_area, 5) + " m2 of " + number(wall * pixel_area, 5) +
                    " m2 (" + fixed(100.0 * share, 1) +
                    " %); the mortar between them was divided at its middle.");
    if (pieces.openings > 0) {
        const bool one = pieces.openings == 1;
        notes.push_back(counted(pieces.openings, "magenta area of ", "magenta areas of ") +
                        number(static_cast<double>(pieces.open) * pixel_area, 5) + " m2 " +
                        (one ? "is an opening." : "are openings."));
    }
    if (pieces.edges > 0) {
        notes.push_back(
            counted(pieces.edges, "area", "areas") + " of at most " +
            std::to_string(kWidestEdge) + " pixels in width, of " +
            (pieces.edges == 1 ? "a colour" : "colours") + " mixed of those on both sides, " +
            (pieces.edges == 1 ? "was" : "were") + " taken as smooth edges, not as stones.");
    }
    if (pieces.narrow > 0) {
        notes.push_back(counted(pieces.narrow, "stone is", "stones are") + " at most " +
                        std::to_string(kWidestEdge) + " pixels wide, such as the one at " +
                        place_of(pieces.narrow_at, labels) + ".");
    }
    if (pieces.magenta > 0) {
        notes.push_back(counted(pieces.magenta, "stone is", "stones are") +
                        " nearly magenta, such as the one at " +
                        place_of(pieces.magenta_at, labels) +
                        "; an opening is exactly (255, 0, 255).");
    }
    if (pieces.dirt > 0) {
        notes.push_back(counted(pieces.dirt, "area", "areas") + " smaller than " +
                        number(least * pixel_area * 1e4, 3) + " cm2 " +
                        (pieces.dirt == 1 ? "was" : "were") + " taken as dirt" +
                        (pieces.edges > 0 ? ", or as parts of such edges." : "."));
    }
    return labels;
}

} // namespace app
